// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FaceMeshPiece
 * @brief The cells, faces and points of a FaceMesh that one of several processes needs.
 *
 * Items are what becomes a cell of the grid: first all cells of the mesh, then the faces that no
 * cell has, in the order of the file; where there are no faces at all, the points. A piece owns
 * consecutive items, as many as any other piece, and may have more as ghosts: level by level those
 * that share a point with it. Its points are those of its items; the first piece also has the
 * points that no face has.
 */
#ifndef camaron_FaceMeshPiece_h
#define camaron_FaceMeshPiece_h

#include "FaceMesh/FaceMesh.h"

#include <vector> // for ghosts

namespace camaron
{
class FaceMeshPiece
{
public:
  /**
   * Finds the piece and prepares @a mesh for access to it, which must stay where it is. For the
   * whole mesh all lists must be accessible already.
   */
  bool Select(FaceMesh& mesh, const PieceRequest& request, const Progress& progress);

  /// True if the piece is all of the mesh: ids are those of the file then.
  bool IsWhole() const { return this->Whole; }
  bool IsCloud() const { return this->Cloud; }

  ///@{
  /// Items in the order of the grid, ghosts last.
  vtkIdType GetNumberOfItems() const
  {
    return this->End - this->Begin + static_cast<vtkIdType>(this->Ghosts.size());
  }
  vtkIdType GetNumberOfOwnedItems() const { return this->End - this->Begin; }
  vtkIdType GetItem(vtkIdType i) const
  {
    return i < this->End - this->Begin ? this->Begin + i
                                       : this->Ghosts[i - this->End + this->Begin];
  }
  /// Face of an item that is no cell of the mesh.
  vtkIdType GetFace(vtkIdType item) const
  {
    const vtkIdType i = item - this->NumberOfCells;
    return this->AllFaces ? i : this->FreeFaces[i];
  }
  ///@}

  vtkIdType GetNumberOfPoints() const
  {
    return this->Whole ? this->NumberOfMeshPoints : this->Points.GetNumberOfMembers();
  }
  /// Id in the piece of a point of the mesh.
  vtkIdType GetPoint(vtkIdType id) const { return this->Whole ? id : this->Points.GetNumber(id); }
  /// Points of the mesh in the piece, ascending; only if it is not whole.
  const IdSet& GetPoints() const { return this->Points; }
  /// Ghost points belong to another piece that has them too.
  bool IsGhostPoint(vtkIdType id) const
  {
    return this->LowerPoints.Contains(id) || !this->OwnedPoints.Contains(id);
  }

  ///@{
  /// Faces numbered densely for the piece.
  vtkIdType GetNumberOfFaces() const
  {
    return this->Whole ? this->NumberOfMeshFaces : this->Faces.GetNumberOfMembers();
  }
  vtkIdType GetFaceNumber(vtkIdType id) const
  {
    return this->Whole ? id : this->Faces.GetNumber(id);
  }
  ///@}

private:
  bool FindFreeFaces(FaceMesh& mesh, const Progress& progress);
  void AddPoints(const FaceMesh& mesh, const IdSet& faces, IdSet& points, const Progress& progress);
  void AddGhosts(const FaceMesh& mesh, const Progress& progress);

  bool Whole = true;
  bool Cloud = false;
  bool AllFaces = true; ///< every face is an item
  std::vector<std::int32_t> FreeFaces;
  vtkIdType NumberOfCells = 0;
  vtkIdType NumberOfMeshPoints = 0;
  vtkIdType NumberOfMeshFaces = 0;
  vtkIdType Begin = 0;
  vtkIdType End = 0;
  std::vector<vtkIdType> Ghosts; ///< ascending
  IdSet Cells, Faces, Points;
  IdSet OwnedPoints; ///< of owned items
  IdSet LowerPoints; ///< of ghosts that come before the owned items
};
}

#endif
