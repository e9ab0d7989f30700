// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::SharedElements
 * @brief Facets, edges, vertices or cells shared by pieces of a mesh, and values reduced over
 * these.
 *
 * Elements are the same if all their points are; see PieceBorders. They are compared by a 128-bit
 * hash; every rank compares a part. Duplicates of cells are ignored, except if the elements are
 * cells.
 */
#ifndef camaron_SharedElements_h
#define camaron_SharedElements_h

#include "Ranks/LinkedPieces.h"
#include "Ranks/Reducer.h"
#include "Selection/CellElements.h"

#include <cstdint> // for values
#include <vector>  // for the elements

namespace camaron
{
/// The elements of each piece.
std::vector<CellElements> MakeElements(const std::vector<LinkedPiece>& pieces, Adjacency adjacency);

class SharedElements
{
public:
  struct Element
  {
    std::int32_t Piece;
    vtkIdType Number; ///< index in CellElements of the piece, or of the cell
  };

  /// Collective. @a elements: for each piece.
  SharedElements(const std::vector<LinkedPiece>& pieces, const std::vector<CellElements>& elements,
    Reducer& reducer);

  /// Collective. The points of cells as elements.
  static SharedElements OfPoints(const std::vector<LinkedPiece>& pieces, Reducer& reducer);

  /// Collective. Cells with duplicates in other pieces, and these duplicates.
  static SharedElements OfCells(const std::vector<LinkedPiece>& pieces, Reducer& reducer);

  /// The shared elements in the pieces of this rank.
  const std::vector<Element>& Get() const { return this->Elements; }
  /// Collective. Replaces the value of each element of Get() by its minimum over all pieces.
  void Minimize(std::vector<std::int64_t>& values);

  /// Collective. Marks an element in all pieces if it is marked in one of them, and returns the
  /// newly marked elements. @a marks: for each piece and element; entries must convert to and from
  /// bool.
  template <typename Mark>
  std::vector<Element> Share(std::vector<std::vector<Mark>>& marks)
  {
    std::vector<std::int64_t> values;
    for (const Element& element : this->Elements)
    {
      values.push_back(marks[element.Piece][element.Number] ? 0 : 1);
    }
    this->Minimize(values);
    std::vector<Element> added;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const Element& element = this->Elements[i];
      if (values[i] == 0 && !marks[element.Piece][element.Number])
      {
        marks[element.Piece][element.Number] = true;
        added.push_back(element);
      }
    }
    return added;
  }

private:
  struct Candidate;
  static std::vector<Candidate> FindCandidates(const std::vector<LinkedPiece>& pieces,
    const std::vector<CellElements>& elements, camaron::Reducer& reducer);
  SharedElements(const std::vector<Candidate>& candidates, camaron::Reducer& reducer);

  camaron::Reducer& Reducer;
  std::vector<Element> Elements;
  std::vector<vtkIdType> Groups; // number of the group of each element, times the number of ranks,
                                 // plus the rank that compares it
  vtkIdType NumberOfGroups = 0;  // that this rank compares
};
}

#endif
