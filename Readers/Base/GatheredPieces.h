// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::GatheredPieces
 * @brief Which cells and points of pieces are kept when these become one mesh, and their order.
 *
 * See MergeParts for the rules. Points and cells are numbered consecutively over all pieces.
 */
#ifndef camaron_GatheredPieces_h
#define camaron_GatheredPieces_h

#include "GatheredMesh.h"
#include "Mesh/MeshView.h"

#include "vtkDataSet.h"           // for members
#include "vtkDataSetAttributes.h" // for kinds of ghosts
#include "vtkUnsignedCharArray.h" // for ghosts

#include <algorithm> // for the search of pieces
#include <array>     // for positions
#include <cstddef>   // for std::size_t
#include <vector>    // for pieces

namespace camaron
{
class GatheredPieces
{
public:
  struct Piece
  {
    vtkDataSet* Mesh;
    int Block;
    MeshView View;
    vtkUnsignedCharArray* Ghosts;
    vtkIdType FirstPoint; ///< among the points of all pieces
    vtkIdType FirstCell;  ///< among the cells of all pieces
    bool IsLeftOut(vtkIdType cell) const
    {
      constexpr int kinds = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
      return this->Ghosts && (this->Ghosts->GetValue(cell) & kinds) != 0;
    }
  };

  explicit GatheredPieces(const std::vector<MeshPart>& parts);

  const std::vector<Piece>& GetPieces() const { return this->Pieces; }
  /// False if cells or points are left out, merged or sorted.
  bool IsUnchanged() const;
  /// Points that were merged with another at the same position.
  vtkIdType GetNumberOfTwins() const { return this->NumberOfTwins; }
  /// Positions where one piece has several points and others have points, too.
  vtkIdType GetNumberOfUnclearPlaces() const { return this->NumberOfUnclearPlaces; }

  vtkIdType GetNumberOfNewPoints() const { return static_cast<vtkIdType>(this->OldPoints.size()); }
  /// The first of the points that were merged into a new one.
  vtkIdType GetOldPoint(vtkIdType newPoint) const { return this->OldPoints[newPoint]; }
  /// -1 if the point is dropped.
  vtkIdType GetNewPoint(const Piece& piece, vtkIdType point) const
  {
    return this->NewPoints[piece.FirstPoint + point];
  }
  vtkIdType GetNumberOfNewCells() const { return static_cast<vtkIdType>(this->OldCells.size()); }
  vtkIdType GetOldCell(vtkIdType newCell) const { return this->OldCells[newCell]; }

  /// Calls @a visit(piece, cell) for the cells that are kept, in their new order.
  template <typename Visit>
  void ForEachCell(Visit&& visit) const
  {
    for (const vtkIdType cell : this->OldCells)
    {
      const Piece& piece = this->FindPiece(cell, &Piece::FirstCell);
      visit(piece, cell - piece.FirstCell);
    }
  }
  /// The piece of a point (&Piece::FirstPoint) or cell (&Piece::FirstCell).
  const Piece& FindPiece(vtkIdType id, vtkIdType Piece::* first) const
  {
    return *(std::upper_bound(this->Pieces.begin(), this->Pieces.end(), id,
               [first](vtkIdType i, const Piece& piece) { return i < piece.*first; }) -
      1);
  }
  /// Its index among the pieces.
  std::size_t GetIndex(const Piece& piece) const
  {
    return static_cast<std::size_t>(&piece - this->Pieces.data());
  }
  std::array<double, 3> GetPlace(vtkIdType point) const
  {
    const Piece& piece = this->FindPiece(point, &Piece::FirstPoint);
    std::array<double, 3> x;
    piece.View.GetPoint(point - piece.FirstPoint, x.data());
    return x;
  }

private:
  using Iterator = std::vector<Piece>::const_iterator;

  void OrderCells();
  void DropPoints();
  void NumberPoints();
  void NumberPointsById(Iterator begin, Iterator end);
  void NumberPointsByPlace(Iterator begin, Iterator end);
  std::vector<vtkIdType> FindBorderPoints(Iterator begin, Iterator end) const;
  void MergeTwins(const vtkIdType* begin, const vtkIdType* end);
  bool HaveSamePlace(vtkIdType a, vtkIdType b) const;

  std::vector<Piece> Pieces;
  vtkIdType NumberOfPoints = 0;
  vtkIdType NumberOfCells = 0;
  vtkIdType NumberOfTwins = 0;
  vtkIdType NumberOfUnclearPlaces = 0;
  std::vector<vtkIdType> OldCells;  // per new cell
  std::vector<vtkIdType> NewPoints; // per point of all pieces; -1 if it is dropped
  std::vector<vtkIdType> OldPoints; // per new point the first of those merged into it
};
}

#endif
