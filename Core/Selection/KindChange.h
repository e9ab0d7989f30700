// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::KindChange
 * @brief Converts selections between cells and the faces, edges or points that bound them.
 *
 * An element belongs to a cell if it is a face, an edge or a point of the cell, which means that
 * the cell has its points. Elements are points of the mesh, or cells of other data sets with the
 * same points, such as the faces of Mesh Elements. An element at a border between pieces has the
 * cells of all of them; duplicates of cells (DUPLICATECELL) are ignored. All methods are
 * collective, and results do not depend on how the mesh is split.
 */
#ifndef camaron_KindChange_h
#define camaron_KindChange_h

#include "Selection/CellElements.h"
#include "Selection/Growth.h"
#include "Selection/SharedElements.h"

#include <atomic> // for marks of several threads

namespace camaron
{
struct SetHash;

/// How many of the related elements must be selected.
enum class Quantifier
{
  Any,
  All
};

/// The elements that bound cells.
struct BoundingElements
{
  int Dimension = 0; ///< 0 to 2
  /// The pieces with cells of that dimension, parallel to the pieces of the cells; nullptr for the
  /// points of these.
  const std::vector<LinkedPiece>* Pieces = nullptr;
};

class KindChange
{
public:
  /// Keeps references to all arguments. Only cells of @a pieces with a higher dimension than the
  /// elements are considered.
  KindChange(
    const std::vector<LinkedPiece>& pieces, const BoundingElements& bounding, Reducer& reducer);

  /// Marks cells with any or all of their elements marked; cells without elements are not marked.
  /// @param marks of the elements
  CellMarks MarkCells(const CellMarks& marks, Quantifier quantifier);
  /// Marks elements with any or all of their cells marked; elements without cells are not marked.
  /// @param marks of the cells
  CellMarks MarkBounding(const CellMarks& marks, Quantifier quantifier);

private:
  using Flags = std::vector<std::vector<std::atomic<unsigned char>>>; // for each piece and element
                                                                      // of CellElements

  bool TakesPart(std::size_t piece, vtkIdType cell) const;
  std::vector<SetHash> HashElements(std::size_t piece) const;
  void FindBounding(std::size_t piece);
  Flags MakeFlags() const;
  template <typename Visit>
  void ForEachBounding(std::size_t piece, vtkIdType element, Visit&& visit) const;

  const std::vector<LinkedPiece>& Pieces;
  const BoundingElements Bounding;
  const std::vector<CellElements> Elements;
  SharedElements Shared;
  // Except for points: for each element of CellElements the first bounding element, and for each of
  // these the next one, or -1.
  std::vector<std::vector<vtkIdType>> First, Next;
};
}

#endif
