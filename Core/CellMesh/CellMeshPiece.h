// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellMeshPiece
 * @brief The cells and points of a CellMesh that one of several processes needs.
 *
 * A piece owns consecutive cells, as many as any other piece, and may have more as ghosts: level by
 * level those that share a point with it. Its points are those of its cells; the first piece also
 * has the points that no cell has. Cells and points are in the order of the file.
 *
 * Readers show all cells, once and once more for every level of ghosts, without keeping them. Then
 * they ask which rows of a table the piece has, and keep only these. PieceRows.h does so for rows
 * of text.
 */
#ifndef camaron_CellMeshPiece_h
#define camaron_CellMeshPiece_h

#include "Base/IdSet.h"
#include "CellMesh/CellMesh.h"
#include "Scan/PieceRequest.h"

#include <algorithm> // for std::any_of
#include <mutex>     // for what threads find

namespace camaron
{
class CellMeshPiece
{
public:
  ///@{
  /**
   * Finds the piece: after Start, unless it is whole then, all cells are shown, in any order and by
   * any thread, and again as long as Continue says so.
   * @param points of the mesh
   */
  void Start(vtkIdType numberOfPoints, vtkIdType numberOfCells, const PieceRequest& request);
  void Show(vtkIdType cell, const std::int32_t* points, vtkIdType size);
  bool Continue();
  ///@}

  /// Finds the piece of a mesh that is all there; false if stopped.
  bool Select(const CellMesh& mesh, const PieceRequest& request, const Progress& progress);

  /**
   * Warns of cells of the whole mesh that have a point twice, named as in "hexahedron",
   * "hexahedra". Only for the first piece; @a mesh is looked at if that is whole.
   */
  void WarnOfRepeatedPoints(const CellMesh& mesh, Warnings& warnings, const Progress& progress,
    const char* one = "cell", const char* many = "cells") const;

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
  bool AreNear(const std::int32_t* points, vtkIdType size) const
  {
    return std::any_of(
      points, points + size, [this](std::int32_t id) { return this->Near.Contains(id); });
  }
  void NoteFirstUse(vtkIdType cell, const std::int32_t* points, vtkIdType size);

  bool Whole = true;
  bool Ghosts = false;
  bool IsFirst = true;
  int Level = 0; ///< that is being found; 0 for the owned cells
  int NumberOfLevels = 0;
  vtkIdType NumberOfMeshPoints = 0;
  vtkIdType NumberOfMeshCells = 0;
  vtkIdType Begin = 0;
  vtkIdType End = 0;
  IdSet Cells, Points;
  IdSet OwnedPoints; ///< of owned cells
  IdSet LowerPoints; ///< of ghosts that come before the owned cells
  IdSet Near;        ///< points of the levels before
  IdSet Used;        ///< points of all cells; for the first piece only, as are those below
  Tally Repeating;   ///< cells with a point twice
  std::mutex Mutex;  ///< for these, of which there are few
};

/// Leaves the cells of the piece in a mesh, with indices of points of the piece.
void KeepPiece(CellMesh& mesh, const CellMeshPiece& piece);

/// One VTK_VERTEX per point of the mesh: those of a piece, which is found.
CellMesh MakeCloud(vtkIdType numberOfPoints, const PieceRequest& request, CellMeshPiece& piece);

//------------------------------------------------------------------------------
inline void CellMeshPiece::Show(vtkIdType cell, const std::int32_t* points, vtkIdType size)
{
  const bool isOwned = !this->IsGhostCell(cell);
  if (this->Level == 0 && this->IsFirst)
  {
    this->NoteFirstUse(cell, points, size);
  }
  if (this->Level == 0 ? !isOwned
                       : isOwned || this->Cells.Contains(cell) || !this->AreNear(points, size))
  {
    return;
  }
  this->Cells.Add(cell);
  IdSet& set = cell < this->Begin ? this->LowerPoints : this->Points;
  for (vtkIdType i = 0; i < size; ++i)
  {
    set.Add(points[i]);
  }
}
}

#endif
