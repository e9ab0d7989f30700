// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::KindChange
 * @brief From selected cells to the faces, edges or points that bound them, and back.
 *
 * Elements belong to a cell if they are a face, an edge or a point of it: if their points are. They
 * may be the points of the mesh, or cells of other data sets with the same points, such as the
 * faces of Mesh Elements. A face, an edge or a point between pieces has the cells of all of them;
 * copies of cells (DUPLICATECELL) take no part. All methods are collective; what they find does not
 * depend on how the mesh is split.
 */
#ifndef camaron_KindChange_h
#define camaron_KindChange_h

#include "Selection/CellElements.h"
#include "Selection/Growth.h"
#include "Selection/SharedElements.h"

#include <atomic> // for marks of several threads

namespace camaron
{
struct PointsHash;

/// How many of the elements of the other kind must be selected.
enum class Quantifier
{
  Any,
  All
};

/// What bounds cells.
struct BoundingElements
{
  int Dimension = 0; ///< 0 to 2
  /// Whose cells of that dimension they are, parallel to the pieces of the cells; none for the
  /// points of these.
  const std::vector<LinkedPiece>* Pieces = nullptr;
};

class KindChange
{
public:
  /// Borrows everything. Cells of @a pieces take part if their dimension is above that of the
  /// elements.
  KindChange(
    const std::vector<LinkedPiece>& pieces, const BoundingElements& bounding, Reducer& reducer);

  /// Of the cells those with any or with all of their elements marked; none without elements. @a
  /// marks: of the elements.
  CellMarks MarkCells(const CellMarks& marks, Quantifier quantifier);
  /// Of the elements those with any or with all of their cells marked; none without cells. @a
  /// marks: of the cells.
  CellMarks MarkBounding(const CellMarks& marks, Quantifier quantifier);

private:
  using Flags = std::vector<std::vector<std::atomic<unsigned char>>>; // of each piece and element
                                                                      // of CellElements

  bool TakesPart(std::size_t piece, vtkIdType cell) const;
  std::vector<PointsHash> HashElements(std::size_t piece) const;
  void FindBounding(std::size_t piece);
  Flags MakeFlags() const;
  template <typename Visit>
  void ForEachBounding(std::size_t piece, vtkIdType element, Visit&& visit) const;

  const std::vector<LinkedPiece>& Pieces;
  const BoundingElements Bounding;
  const std::vector<CellElements> Elements;
  SharedElements Shared;
  // Unless they are points: of each element the first one that bounds there, of each of those the
  // next one, or -1.
  std::vector<std::vector<vtkIdType>> First, Next;
};
}

#endif
