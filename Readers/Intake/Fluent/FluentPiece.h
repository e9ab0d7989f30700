// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentPiece
 * @brief The cells and points of a Fluent mesh that one of several processes needs.
 *
 * A piece owns the cells in its part of space, see PieceOfSpace; the first point of a cell is here
 * that with the smallest id. It may have ghost cells, level by level those that share a point with
 * it. Its points are those of its cells; the first piece also has points without cells. Cells and
 * points are in the order of the file.
 */
#ifndef camaron_FluentPiece_h
#define camaron_FluentPiece_h

#include "Intake/Fluent/FluentCells.h"
#include "Intake/Fluent/FluentFaces.h"
#include "Intake/Ids/IdSet.h"
#include "Intake/Pieces/PieceOfSpace.h"

#include <functional> // for finding the points
#include <vector>     // for members

namespace camaron
{
class FluentPiece
{
public:
  using FindSpace = std::function<bool(PieceOfSpace& space)>;

  /// Determines the piece; false if aborted, or if faces cannot be visited.
  /// @param findSpace passes all points to a PieceOfSpace; not called for the whole mesh
  bool Select(const FluentFaces& faces, const FluentCells& cells, vtkIdType numberOfPoints,
    const PieceRequest& request, const FindSpace& findSpace, const Progress& progress);

  bool IsWhole() const { return this->Whole; }
  bool HasGhosts() const { return this->Ghosts; }
  vtkIdType GetNumberOfMeshPoints() const { return this->NumberOfMeshPoints; }
  vtkIdType GetNumberOfPoints() const
  {
    return this->Whole ? this->NumberOfMeshPoints : this->Points.GetNumberOfMembers();
  }
  vtkIdType GetNumberOfCells() const
  {
    return this->Whole ? this->NumberOfLeaves : this->Leaves.GetNumberOfMembers();
  }

  ///@{
  /// Index in the piece of a point (from 0) or leaf of the mesh, -1 if it is not in the piece.
  vtkIdType FindPoint(vtkIdType point) const { return this->Find(this->Points, point); }
  vtkIdType FindLeaf(vtkIdType leaf) const { return this->Find(this->Leaves, leaf); }
  ///@}
  /// Index in the piece of a point that is in it.
  vtkIdType GetPoint(vtkIdType point) const
  {
    return this->Whole ? point : this->Points.GetNumber(point);
  }
  /// The leaf of a cell of the piece.
  vtkIdType GetLeaf(vtkIdType cell) const
  {
    return this->Whole ? cell : this->Members[static_cast<std::size_t>(cell)];
  }
  ///@{
  /// Members of the piece; only if it is not whole.
  const IdSet& GetPoints() const { return this->Points; }
  const IdSet& GetLeaves() const { return this->Leaves; }
  ///@}
  ///@{
  /// Ghosts are owned by another piece.
  bool IsGhostPoint(vtkIdType point) const
  {
    return this->LowerPoints.Contains(point) || !this->OwnedPoints.Contains(point);
  }
  bool IsGhostLeaf(vtkIdType leaf) const { return !this->Whole && !this->Owned.Contains(leaf); }
  ///@}

private:
  vtkIdType Find(const IdSet& members, vtkIdType id) const
  {
    return this->Whole ? id : members.Contains(id) ? members.GetNumber(id) : -1;
  }
  bool FindOwned(const FluentFaces& faces, const FluentCells& cells, const PieceRequest& request,
    const FindSpace& findSpace, const Progress& progress);
  bool AddGhosts(const FluentFaces& faces, const FluentCells& cells, const Progress& progress);

  bool Whole = true;
  bool Ghosts = false;
  vtkIdType NumberOfMeshPoints = 0;
  vtkIdType NumberOfLeaves = 0;
  IdSet Leaves, Points;
  IdSet Owned, Before; ///< leaves of the piece without ghosts, and of pieces before it
  std::vector<std::int32_t> Members; ///< of Leaves
  IdSet OwnedPoints;                 ///< of owned cells
  IdSet LowerPoints;                 ///< of ghosts that pieces before this one own
};
}

#endif
