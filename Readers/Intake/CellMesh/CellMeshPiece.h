// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellMeshPiece
 * @brief The cells and points of a mesh that one rank needs.
 *
 * A piece owns the cells in its part of space, see PieceOfSpace, and may have ghost cells: level by
 * level those that share a point with it. Its points are those of its cells; the first piece also
 * has the unused points. Cells and points are in the order of the file.
 *
 * Readers pass all cells to it, twice and once more for every level of ghosts, without storing
 * them. Then they query which rows of a table belong to the piece, and store only these.
 * PieceRows.h does this for rows of text.
 *
 * If a file names the cells on both sides of faces, readers pass all faces instead, twice and twice
 * more for every level. The first point of a cell is then that with the smallest id, which does not
 * depend on the order of visits, and points that no face of a cell has are unused.
 */
#ifndef camaron_CellMeshPiece_h
#define camaron_CellMeshPiece_h

#include "Intake/CellMesh/CellMesh.h"
#include "Intake/Ids/IdSet.h"
#include "Intake/Pieces/PieceOfSpace.h"

#include <algorithm> // for std::any_of
#include <atomic>    // for what threads find
#include <mutex>     // for what threads find
#include <utility>   // for std::move
#include <vector>    // for the points of cells

namespace camaron
{
class CellMeshPiece
{
public:
  /// Sets the function that passes all points. Without it, cells are divided by the ids of points.
  void SetPoints(PieceOfSpace::ForEachPoint forEach) { this->ForEachPoint = std::move(forEach); }

  /// Leaves out points that no cell has: for meshes of which only some cells are passed. Then not
  /// even a single piece is the whole mesh.
  void LeaveOutUnusedPoints() { this->KeepsUnused = false; }

  ///@{
  /**
   * Finds the piece: after Start, unless the piece is the whole mesh, pass all cells, in any order
   * and from any thread, and again while NextPass returns true. IsFound is false in the end if the
   * points could not be passed.
   * @param points of the mesh
   */
  void Start(vtkIdType numberOfPoints, vtkIdType numberOfCells, const PieceRequest& request);
  void Visit(vtkIdType cell, const std::int32_t* points, vtkIdType size);
  /// For faces, at least one point each; @a cells are the two on its sides, -1 for none.
  void VisitFace(
    vtkIdType face, const vtkIdType* cells, const std::int32_t* points, vtkIdType size);
  bool NextPass();
  bool IsFound() const { return !this->HasFailed; }
  ///@}

  /// All of that: @a pass() passes all cells, and returns false on errors. Does not call it if the
  /// piece is the whole mesh.
  template <typename Pass>
  bool Find(
    vtkIdType numberOfPoints, vtkIdType numberOfCells, const PieceRequest& request, Pass&& pass)
  {
    this->Start(numberOfPoints, numberOfCells, request);
    return this->FindBy(pass);
  }
  /// The same for a mesh given by its faces.
  template <typename Pass>
  bool FindByFaces(vtkIdType numberOfPoints, vtkIdType numberOfCells, vtkIdType numberOfFaces,
    const PieceRequest& request, Pass&& pass)
  {
    this->Start(numberOfPoints, numberOfCells, request);
    this->StartFaces(numberOfFaces, request);
    return this->FindBy(pass);
  }

  /// Finds the piece of a mesh that is completely in memory; false if stopped.
  bool Select(const CellMesh& mesh, const PieceRequest& request, const Progress& progress);

  /**
   * Warns about cells of the whole mesh with a repeated point; @a one and @a many name them, e.g.
   * "hexahedron", "hexahedra". Only for the first piece; counts them in @a mesh if the piece is
   * the whole mesh.
   */
  void WarnOfRepeatedPoints(const CellMesh& mesh, Warnings& warnings, const Progress& progress,
    const char* one = "cell", const char* many = "cells") const;

  /// Whether the piece is the whole mesh; indices are those of the file then.
  bool IsWhole() const { return this->Whole; }
  bool HasGhosts() const { return this->Ghosts; }

  ///@{
  vtkIdType GetNumberOfMeshPoints() const { return this->NumberOfMeshPoints; }
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
  /// Index in the piece of a point or cell of the mesh, or -1.
  vtkIdType FindPoint(vtkIdType point) const { return this->GetIndex(this->Points, point); }
  vtkIdType FindCell(vtkIdType cell) const { return this->GetIndex(this->Cells, cell); }
  ///@}

  ///@{
  /// Points and cells of the mesh in the piece; undefined if the piece is the whole mesh.
  const IdSet& GetPoints() const { return this->Points; }
  const IdSet& GetCells() const { return this->Cells; }
  ///@}

  ///@{
  /// Ghosts belong to another piece.
  bool IsGhostPoint(vtkIdType point) const
  {
    return this->LowerPoints.Contains(point) || !this->OwnedPoints.Contains(point);
  }
  bool IsGhostCell(vtkIdType cell) const { return !this->Whole && !this->Owned.Contains(cell); }
  ///@}

private:
  template <typename Pass>
  bool FindBy(Pass&& pass)
  {
    bool good = true;
    for (bool goesOn = !this->Whole; goesOn; goesOn = good && this->NextPass())
    {
      good = pass();
    }
    return good && this->IsFound();
  }
  void StartFaces(vtkIdType numberOfFaces, const PieceRequest& request);
  void FindOwned();
  vtkIdType GetIndex(const IdSet& members, vtkIdType id) const
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
  bool KeepsUnused = true;
  bool HasFailed = false;
  int Level = 0; ///< level being found; 0 for the owned cells, -1 for the part of space
  int NumberOfLevels = 0;
  vtkIdType NumberOfMeshPoints = 0;
  vtkIdType NumberOfMeshCells = 0;
  PieceOfSpace::ForEachPoint ForEachPoint;
  PieceOfSpace Space;
  IdSet Cells, Points;
  IdSet Owned;       ///< cells without ghosts
  IdSet OwnedPoints; ///< of owned cells
  IdSet LowerPoints; ///< of ghosts that pieces before this one own
  IdSet Near;        ///< points of the previous levels
  ///@{
  /// Of meshes given by faces.
  bool HasFaces = false;
  bool IsAdding = false;                                  ///< the points of New, which are known
  std::vector<std::atomic<std::uint32_t>> SmallestPoints; ///< of cells
  IdSet Before;                                           ///< cells of pieces before this one
  IdSet New;                                              ///< cells of the level being found
  ///@}
  IdSet Used;       ///< points of all cells; for the first piece only, like the following members
  Tally Repeating;  ///< cells with a repeated point
  std::mutex Mutex; ///< for Repeating, which is rarely changed
};

/// Only keeps the cells of the piece in a mesh, with point indices of the piece.
void KeepPiece(CellMesh& mesh, const CellMeshPiece& piece);

/// One VTK_VERTEX per point of the piece, which is found first; false if it is not.
bool MakeCloud(
  vtkIdType numberOfPoints, const PieceRequest& request, CellMeshPiece& piece, CellMesh& cloud);

//------------------------------------------------------------------------------
inline void CellMeshPiece::Visit(vtkIdType cell, const std::int32_t* points, vtkIdType size)
{
  const vtkIdType first = size > 0 ? points[0] : -1;
  if (this->Level < 0)
  {
    this->Space.Add(cell, first);
    return;
  }
  if (this->Level == 0 && this->IsFirst)
  {
    this->NoteFirstUse(cell, points, size);
  }
  if (this->Level == 0 ? !this->Space.Has(first)
                       : this->Cells.Contains(cell) || !this->AreNear(points, size))
  {
    return;
  }
  this->Cells.Add(cell);
  if (this->Level == 0)
  {
    this->Owned.Add(cell);
  }
  IdSet& set = this->Space.IsBefore(first) ? this->LowerPoints : this->Points;
  for (vtkIdType i = 0; i < size; ++i)
  {
    set.Add(points[i]);
  }
}
}

#endif
