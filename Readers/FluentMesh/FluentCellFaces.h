// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentCellFaces
 * @brief The faces of one cell of a Fluent mesh, and the nodes of the cell derived from them.
 *
 * Contains scratch memory: use one per thread.
 */
#ifndef camaron_FluentCellFaces_h
#define camaron_FluentCellFaces_h

#include "FluentPiece.h"
#include "Intake/FaceMesh/CellShell.h"
#include "Intake/FaceMesh/PrimitiveMatcher.h"
#include "Mesh/FacetTable.h" // for Index

#include "vtkCellType.h" // for the types of cells

#include <algorithm> // for std::sort
#include <utility>   // for pairs
#include <vector>    // for scratch

class vtkUnstructuredGrid;

namespace camaron
{
/// Split faces and their parts, where neighbors have been refined.
struct FluentFaceTree
{
  /// Positions of a part and of the split face.
  struct Entry
  {
    vtkIdType Child, Parent;
  };
  std::vector<Entry> Entries;                           ///< sorted by part
  std::vector<std::pair<vtkIdType, vtkIdType>> Parents; ///< and their numbers of parts, sorted

  /// Sorts Entries.
  void Build();
  vtkIdType FindParent(vtkIdType child) const;
  vtkIdType GetNumberOfParts(vtkIdType parent) const;
};

/// Declared type of a cell; VTK_EMPTY_CELL if unknown.
struct FluentShape
{
  unsigned char Type = VTK_EMPTY_CELL;
  int Nodes = 0; ///< 0 if the type does not determine it
  int Faces = 0;
};

/// The shape of an element other than a polyhedron.
FluentShape GetFluentShape(FluentElement element);

/// The mesh from which cells are created.
struct FluentMesh
{
  const FluentFaces& Faces;
  const FluentCells& Cells;
  const FluentPiece& Piece;
  const FluentFaceTree& Tree;
  int Dimension;

  /// Index in the piece of the cell with an id of the file; -1 if it is not in the piece.
  vtkIdType FindCell(std::int32_t id) const
  {
    const vtkIdType leaf = this->Cells.FindLeaf(id);
    return leaf >= 0 ? this->Piece.FindLeaf(leaf) : -1;
  }
  FluentShape GetShape(vtkIdType cell) const;
  /// Passes on which faces cells share, so that MeshTopology need not match them again; @a lists
  /// contains the positions of the faces of every cell.
  void ProvideFaces(vtkUnstructuredGrid* grid, LargeVector<Index>&& lists) const;
};

class FluentCellFaces
{
public:
  explicit FluentCellFaces(const FluentMesh& mesh)
    : Mesh(mesh)
    , Matcher(PointSource())
    , Shell(PointSource())
  {
  }

  /// Loads the faces at these positions, which get sorted, for the cell with an id.
  void Load(std::int64_t cell, Index* faces, vtkIdType count)
  {
    // One thread finds them in ascending order and stores them from the end.
    std::reverse(faces, faces + count);
    if (!std::is_sorted(faces, faces + count))
    {
      std::sort(faces, faces + count);
    }
    this->Clear();
    for (vtkIdType i = 0; i < count; ++i)
    {
      this->Add(cell, faces[i]);
    }
  }

  ///@{
  /**
   * Finds the nodes of a cell of a type other than VTK_POLYHEDRON; false if the faces do not match.
   * If there are more faces than the type has, the parts of split faces are joined.
   */
  bool Match(unsigned char type);
  /// Node in VTK's order, as a point of the piece.
  vtkIdType GetNode(vtkIdType node) const
  {
    return this->GetPoint(
      this->Mesh.Dimension == 2 ? this->Ring[node] : this->Matcher.GetNodes()[node]);
  }
  /// Index of the face that is VTK's face @a face, for 3D cells.
  int GetFace(int face) const { return this->Matcher.GetFace(face); }
  /// Whether parts of faces were joined.
  bool HasJoined() const { return this->Joined; }
  ///@}

  ///@{
  /// Treats the faces as those of a polyhedron.
  void MakeShell();
  vtkIdType GetNumberOfShellPoints() const
  {
    return static_cast<vtkIdType>(this->Shell.GetPoints().size());
  }
  vtkIdType GetShellPoint(vtkIdType i) const
  {
    return this->GetPoint(this->Shell.GetPoints()[static_cast<std::size_t>(i)]);
  }
  std::int32_t GetNumberOfShellFaces() const { return this->Shell.GetNumberOfFaces(); }
  std::int32_t GetNumberOfShellCorners() const { return this->Shell.GetNumberOfCorners(); }
  /// Calls put(point) for the points of a face, seen from outside.
  template <typename Put>
  void ForEachShellPoint(std::int32_t face, Put&& put) const
  {
    this->Shell.ForEachPoint(face, [&](std::int32_t node) { put(this->GetPoint(node)); });
  }
  ///@}

private:
  vtkIdType GetPoint(std::int32_t node) const { return this->Mesh.Piece.GetPoint(node - 1); }
  void Clear()
  {
    this->Positions.clear();
    this->Lists.clear();
    this->Directions.clear();
    this->Joined = false;
  }
  void Add(std::int64_t cell, vtkIdType position)
  {
    const FluentFace face = this->Mesh.Faces[position];
    // The right-hand normal points into the first cell. For a face listed twice, the cell is on
    // both sides.
    const bool isSecond = !this->Positions.empty() && this->Positions.back() == position;
    const bool isFirstCell = face.GetCell(0) == cell && !isSecond;
    this->Positions.push_back(position);
    this->Lists.push_back(face.Nodes);
    this->Directions.push_back(isFirstCell ? FaceDirection::Inward : FaceDirection::Outward);
    this->Cell = cell;
  }
  bool JoinOnce(std::vector<vtkIdType>& faces) const;
  bool Join(std::size_t wanted);
  bool MatchVolume(unsigned char type);
  bool MakeRing();
  bool MakeShortRing();
  bool MakeLongRing();

  const FluentMesh& Mesh;
  std::int64_t Cell = 0;
  std::vector<vtkIdType> Positions;
  std::vector<IdList> Lists;
  std::vector<FaceDirection> Directions;
  bool Joined = false;
  PrimitiveMatcher Matcher;
  CellShell Shell;
  std::vector<std::int32_t> Ring; ///< nodes of a 2D cell
  struct Edge
  {
    std::int32_t From, To;
    bool Directed;
  };
  std::vector<Edge> Edges;
  std::vector<std::int32_t> Loops; ///< nodes with an edge to themselves
};
}

#endif
