// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellPiece
 * @brief The cells and points of a CellMesh that one of several processes needs.
 *
 * A piece owns consecutive cells, as many as any other piece, and may have more as ghosts: level by level
 * those that share a point with it. Its points are those of its cells; the first piece also has the
 * points that no cell has. Cells and points are in the order of the file.
 *
 * Readers ask which rows of a table the piece has, and keep only these.
 */
#ifndef camaron_CellPiece_h
#define camaron_CellPiece_h

#include "CellMesh/CellMesh.h"
#include "Scan/PieceRequest.h"
#include "Scan/IdSet.h"

namespace camaron
{
class CellPiece
{
public:
  /// Finds the piece; false if stopped.
  bool Select(const CellMesh& mesh, const PieceRequest& request, const Progress& progress);

  /// True if the piece is all of the mesh: indices are those of the file then.
  bool IsWhole() const { return this->Whole; }
  bool HasGhosts() const { return this->Ghosts; }

  ///@{
  vtkIdType GetNumberOfPoints() const
  {
    return this->Whole ? this->NumberOfMeshPoints : this->Points.GetNumberOfMembers();
  }
  vtkIdType GetNumberOfCells() const
  {
    return this->Whole ? this->NumberOfMeshCells : this->Cells.GetNumberOfMembers();
  }
  ///@}

  ///@{
  /// Index in the piece of a point or cell of the mesh, -1 if it is not in it.
  vtkIdType FindPoint(vtkIdType point) const { return this->Find(this->Points, point); }
  vtkIdType FindCell(vtkIdType cell) const { return this->Find(this->Cells, cell); }
  ///@}

  ///@{
  /// Points and cells of the mesh in the piece; only if it is not whole.
  const IdSet& GetPoints() const { return this->Points; }
  const IdSet& GetCells() const { return this->Cells; }
  ///@}

  ///@{
  /// Ghosts belong to another piece.
  bool IsGhostPoint(vtkIdType point) const
  {
    return this->LowerPoints.Contains(point) || !this->OwnedPoints.Contains(point);
  }
  bool IsGhostCell(vtkIdType cell) const { return cell < this->Begin || cell >= this->End; }
  ///@}

private:
  vtkIdType Find(const IdSet& members, vtkIdType id) const
  {
    return this->Whole ? id : members.Contains(id) ? members.GetNumber(id) : -1;
  }
  void AddGhosts(const CellMesh& mesh, const Progress& progress);

  bool Whole = true;
  bool Ghosts = false;
  vtkIdType NumberOfMeshPoints = 0;
  vtkIdType NumberOfMeshCells = 0;
  vtkIdType Begin = 0;
  vtkIdType End = 0;
  IdSet Cells, Points;
  IdSet OwnedPoints; ///< of owned cells
  IdSet LowerPoints; ///< of ghosts that come before the owned cells
};
}

#endif
