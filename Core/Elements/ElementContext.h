// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ElementContext
 * @brief What the arrays of faces, edges and vertices of a mesh are made from.
 *
 * Tables are made when they are first asked for and then shared by all arrays. Not for several
 * threads: functions of arrays fetch their tables first and go parallel then.
 */
#ifndef camaron_ElementContext_h
#define camaron_ElementContext_h

#include "Base/Buffer.h"
#include "Base/Parallel.h"
#include "Cell/CellGeometry.h"
#include "Elements/EdgeFinder.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>  // for parts of the mesh
#include <array>      // for steps
#include <functional> // for progress
#include <optional>   // for the tables
#include <utility>    // for std::move
#include <vector>     // for the tables

class vtkDataSet;

namespace camaron
{
/// Dimensions of cells, as bits.
enum CellDimensions : unsigned
{
  OfPolygons = 1u << 2,
  OfPolyhedra = 1u << 3,
  OfAnyCells = OfPolygons | OfPolyhedra
};

/// Those that a mesh has.
unsigned FindCellDimensions(const MeshView& mesh);

/// How many cells, faces and polygon cells meet at an edge or vertex.
struct ElementUses
{
  LargeVector<Index> Cells;         ///< 2D and 3D cells
  LargeVector<Index> Polygons;      ///< 2D cells
  LargeVector<Index> Faces;         ///< faces of 3D cells, each once, and 2D cells
  LargeVector<Index> BoundaryFaces; ///< faces with one 3D cell
};

/// Dihedral angles that the 3D cells have at every edge, in radian; null where there are none.
struct EdgeAngles
{
  LargeVector<double> Min, Max, Sum;
};

/// Where a mesh is the piece of one, with cells of others: see CompletePieces.
struct ElementSource
{
  vtkDataSet* Piece =
    nullptr; ///< whose points and their data the elements get; the first ones of the mesh
  unsigned Dimensions = 0; ///< CellDimensions that other pieces have
  bool IsComplete = false; ///< cells of all pieces are there at all points of the cells of this one
  ///@{
  /// What is known of all pieces, if it is asked for: see CoincidentPoints.h and MismatchedFaces.h.
  const std::vector<vtkIdType>* CoincidentPoints = nullptr;
  const std::vector<Index>* MismatchedFaces = nullptr;
  ///@}
};

class ElementContext
{
public:
  /**
   * @param mesh whose ghosts and global ids count, whatever the options say of them
   * @param mergeTolerance distance up to which points coincide; 0 for 8 rounding units of their
   * coordinates
   */
  ElementContext(vtkDataSet* mesh, const MeshTopology& topology, EvaluationOptions options,
    double mergeTolerance = 0, const ElementSource& source = {});

  ///@{
  /**
   * Whom to tell how much of all is done, 0 to 1; the answer false stops the work. GoesOn says how
   * much of the present Step is done and whether to go on; once that is false, it stays so, and
   * what is made is worth nothing.
   */
  void SetProgress(std::function<bool(double)> progress) { this->Progress = std::move(progress); }
  bool GoesOn(double done = 0) const;
  ///@}

  /// While this lives, what is done is the part from @a begin to @a end of the step before.
  class Step
  {
  public:
    Step(const ElementContext& context, double begin, double end)
      : Context(context)
      , Outer(context.Range)
    {
      const double size = this->Outer[1] - this->Outer[0];
      context.Range = { this->Outer[0] + begin * size, this->Outer[0] + end * size };
    }
    ~Step() { this->Context.Range = this->Outer; }
    Step(const Step&) = delete;
    void operator=(const Step&) = delete;

  private:
    const ElementContext& Context;
    std::array<double, 2> Outer;
  };

  /// Calls @a function(begin, end) for the cells of the mesh in parallel as long as GoesOn.
  template <typename Function>
  void ForCells(Function&& function) const
  {
    constexpr vtkIdType grain = 1024, numberOfReports = 100, smallest = 1 << 16;
    const vtkIdType size = this->GetMesh().GetNumberOfCells();
    const vtkIdType slab = std::max(smallest, size / numberOfReports + 1);
    for (vtkIdType first = 0;
      first < size && this->GoesOn(static_cast<double>(first) / static_cast<double>(size));
      first += slab)
    {
      ParallelFor(std::min(slab, size - first), grain,
        [&](vtkIdType begin, vtkIdType end) { function(first + begin, first + end); });
    }
  }

  vtkDataSet* GetData() const { return this->Data; }
  /// What the points of the elements and their data are.
  vtkDataSet* GetPiece() const { return this->Source.Piece; }
  const MeshTopology& GetTopology() const { return this->Topology; }
  const MeshView& GetMesh() const { return this->Topology.GetMesh(); }
  const EvaluationOptions& GetOptions() const { return this->Options; }
  /// Whether the mesh has cells of that dimension, 2 or 3.
  bool HasCells(int dimension) const { return (this->Source.Dimensions >> dimension & 1) != 0; }
  unsigned GetDimensions() const { return this->Source.Dimensions; }
  /// Global id of a cell of the mesh; its own if there are none.
  vtkIdType GetGlobalCell(vtkIdType cell) const;
  /// Whether what lies beyond a copy is known wherever elements are kept.
  bool IsComplete() const { return this->Source.IsComplete; }
  /// Whether a cell is a copy of one that belongs to another piece.
  bool IsCopy(vtkIdType cell) const;
  /// DUPLICATECELL if the cell of the smallest global id is a ghost, else 0.
  unsigned char BelongsToGhost(const std::vector<Index>& cells) const;

  const EdgeFinder& GetEdgeFinder() const;
  const ElementUses& GetEdgeUses() const;
  const ElementUses& GetVertexUses() const;
  const EdgeAngles& GetEdgeAngles() const;
  /// See CoincidentPoints.h; those that only added cells have coincide with none.
  const std::vector<vtkIdType>& GetCoincidentPoints() const;
  /// See MismatchedFaces.h.
  const std::vector<Index>& GetMismatchedFaces() const;
  /// The 2D cells, which are the faces of a mesh without 3D cells.
  const std::vector<vtkIdType>& GetPolygonCells() const;

private:
  vtkDataSet* Data;
  const MeshTopology& Topology;
  EvaluationOptions Options;
  double MergeTolerance;
  ElementSource Source;
  std::function<bool(double)> Progress;

  mutable std::array<double, 2> Range = { 0, 1 }; // of the present step
  mutable double Done = 0;
  mutable bool IsStopped = false;
  mutable std::optional<EdgeFinder> Edges;
  mutable std::optional<ElementUses> EdgeUses, VertexUses;
  mutable std::optional<EdgeAngles> Angles;
  mutable std::optional<std::vector<vtkIdType>> CoincidentPoints, PolygonCells;
  mutable std::optional<std::vector<Index>> MismatchedFaces;
};
}

#endif
