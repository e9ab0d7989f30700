// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ElementContext
 * @brief Input and shared tables of the arrays of faces, edges and vertices of a mesh.
 *
 * Tables are built on first use and shared by all arrays. Getters are not thread-safe: functions
 * of arrays get their tables first and then run in parallel.
 */
#ifndef camaron_ElementContext_h
#define camaron_ElementContext_h

#include "Base/Buffer.h"
#include "Base/Parallel.h"
#include "Cell/CellGeometry.h"
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

/// The dimensions that occur in a mesh.
unsigned FindCellDimensions(const MeshView& mesh);

/// Number of cells, faces and polygon cells at an edge or vertex.
struct ElementUses
{
  LargeVector<Index> Cells;         ///< 2D and 3D cells
  LargeVector<Index> Polygons;      ///< 2D cells
  LargeVector<Index> Faces;         ///< faces of 3D cells, counted once, and 2D cells
  LargeVector<Index> BoundaryFaces; ///< faces with one 3D cell
};

/// Dihedral angles of the 3D cells at every edge, in radians; NaN if there are none.
struct EdgeAngles
{
  LargeVector<double> Min, Max, Sum;
};

/// Describes a mesh that is a piece completed by cells of other pieces; see CompletePieces.
struct ElementSource
{
  vtkDataSet* Piece =
    nullptr; ///< provides the points of the elements and their data; the first points of the mesh
  unsigned Dimensions = 0; ///< CellDimensions of other pieces
  bool IsComplete = false; ///< whether all cells of all pieces at the points of this piece's cells
                           ///< are present
  ///@{
  /// Results for all pieces, if requested; see CoincidentPoints.h and MismatchedFaces.h.
  const std::vector<vtkIdType>* CoincidentPoints = nullptr;
  const std::vector<Index>* MismatchedFaces = nullptr;
  ///@}
};

class ElementContext
{
public:
  /**
   * @param mesh provides ghosts and global ids, which override those of the options
   * @param mergeTolerance distance up to which points coincide; 0 for 8 machine epsilons of their
   * coordinates
   */
  ElementContext(vtkDataSet* mesh, const MeshTopology& topology, EvaluationOptions options,
    double mergeTolerance = 0, const ElementSource& source = {});

  ///@{
  /**
   * Sets a callback that receives the completed fraction, 0 to 1, and returns false to stop.
   * GoesOn reports the completed fraction of the current Step and returns whether to continue;
   * once false it stays false, and results are invalid.
   */
  void SetProgress(std::function<bool(double)> progress) { this->Progress = std::move(progress); }
  bool GoesOn(double done = 0) const;
  ///@}

  /// While it exists, progress is reported as the part from @a begin to @a end of the enclosing
  /// step.
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

  /// Calls @a function(begin, end) for the cells of the mesh in parallel while GoesOn.
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
  /// The data set with the points of the elements and their data.
  vtkDataSet* GetPiece() const { return this->Source.Piece; }
  const MeshTopology& GetTopology() const { return this->Topology; }
  const MeshView& GetMesh() const { return this->Topology.GetMesh(); }
  const EvaluationOptions& GetOptions() const { return this->Options; }
  /// Whether the mesh has cells of this dimension, 2 or 3.
  bool HasCells(int dimension) const { return (this->Source.Dimensions >> dimension & 1) != 0; }
  unsigned GetDimensions() const { return this->Source.Dimensions; }
  /// Global id of a cell of the mesh; its index without global ids.
  vtkIdType GetGlobalCell(vtkIdType cell) const;
  /// Whether all neighbors of the elements kept are known, even beyond duplicates.
  bool IsComplete() const { return this->Source.IsComplete; }
  /// Whether a cell duplicates a cell that belongs to another piece.
  bool IsCopy(vtkIdType cell) const { return this->Options.IsCopy(cell); }
  /// DUPLICATECELL if the cell of the smallest global id is a ghost, else 0.
  unsigned char BelongsToGhost(const std::vector<Index>& cells) const;

  const EdgeFinder& GetEdgeFinder() const;
  const ElementUses& GetEdgeUses() const;
  const ElementUses& GetVertexUses() const;
  const EdgeAngles& GetEdgeAngles() const;
  /// See CoincidentPoints.h; points that only added cells have do not coincide with any.
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

  mutable std::array<double, 2> Range = { 0, 1 }; // of the current step
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
