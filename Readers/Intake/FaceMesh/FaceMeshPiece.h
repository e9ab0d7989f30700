// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FaceMeshPiece
 * @brief The cells, faces and points of a FaceMesh that one rank needs.
 *
 * Items become cells of the grid: first all cells of the mesh, then the faces without a cell, in
 * the order of the file; without any faces, the points. A piece owns the items in its part of
 * space, see PieceOfSpace; the first point of a cell is that of its first face. It may have ghosts:
 * level by level the items that share a point with it. Its points are those of its items; the first
 * piece also has the points without a face.
 *
 * CellMeshPiece would visit each cell with the points of all its faces, which needs access to any
 * face: four bytes of each on every rank. Here, two bits of every face are enough.
 */
#ifndef camaron_FaceMeshPiece_h
#define camaron_FaceMeshPiece_h

#include "Intake/FaceMesh/FaceMesh.h"
#include "Intake/Pieces/PieceOfSpace.h"

#include <vector> // for items

namespace camaron
{
class FaceMeshPiece
{
public:
  /**
   * Finds the piece, and prepares @a mesh for access to it; the mesh must not move. For the whole
   * mesh, all lists must already be accessible.
   */
  bool Select(FaceMesh& mesh, const PieceRequest& request, const Progress& progress);

  /// Whether the piece is the whole mesh; ids are those of the file then.
  bool IsWhole() const { return this->Whole; }
  bool IsCloud() const { return this->Cloud; }

  ///@{
  /// Items in the order of the grid: in the order of the file, ghosts last.
  vtkIdType GetNumberOfItems() const
  {
    return this->Whole ? this->NumberOfOwnedItems : static_cast<vtkIdType>(this->Items.size());
  }
  vtkIdType GetNumberOfOwnedItems() const { return this->NumberOfOwnedItems; }
  vtkIdType GetItem(vtkIdType i) const
  {
    return this->Whole ? i : this->Items[static_cast<std::size_t>(i)];
  }
  /// The face of an item that is not a cell of the mesh.
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
  /// Points of the mesh in the piece, ascending; undefined if the piece is the whole mesh.
  const IdSet& GetPoints() const { return this->Points; }
  /// Whether a point belongs to another piece that has it, too.
  bool IsGhostPoint(vtkIdType id) const
  {
    return this->LowerPoints.Contains(id) || !this->OwnedPoints.Contains(id);
  }

  ///@{
  /// Faces, numbered consecutively within the piece.
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
  vtkIdType GetNumberOfFreeFaces() const
  {
    return this->AllFaces ? this->NumberOfMeshFaces
                          : static_cast<vtkIdType>(this->FreeFaces.size());
  }
  bool FindFreeFaces(FaceMesh& mesh, const Progress& progress);
  bool FindPlaces(const FaceMesh& mesh, const PieceRequest& request, const Progress& progress);
  void AddOwnedItems(const FaceMesh& mesh, const PieceRequest& request, const Progress& progress);
  void AddPoints(const FaceMesh& mesh, const IdSet& faces, IdSet& points, const Progress& progress);
  void AddGhosts(const FaceMesh& mesh, const Progress& progress);

  bool Whole = true;
  bool Cloud = false;
  bool AllFaces = true; ///< every face is an item
  std::vector<std::int32_t> FreeFaces;
  vtkIdType NumberOfCells = 0;
  vtkIdType NumberOfMeshPoints = 0;
  vtkIdType NumberOfMeshFaces = 0;
  vtkIdType NumberOfOwnedItems = 0;
  std::vector<vtkIdType> Items; ///< owned ones and ghosts, both ascending
  PieceOfSpace Space;
  IdSet FacesInside, FacesBefore; ///< whose first points are in the piece, or in one before it
  IdSet Cells, Faces, Points;
  IdSet OwnedPoints; ///< of owned items
  IdSet LowerPoints; ///< of ghosts that pieces before this one own
};
}

#endif
