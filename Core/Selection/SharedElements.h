// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::SharedElements
 * @brief The facets, edges, vertices or cells that pieces of a mesh have in common, and values that
 * they agree on.
 *
 * Elements are the same when all of their points are; see PieceBorders. They are compared by a hash
 * of 128 bits, every process its share. But for cells themselves, cells that are copies of others
 * take no part.
 */
#ifndef camaron_SharedElements_h
#define camaron_SharedElements_h

#include "Ranks/LinkedPieces.h"
#include "Ranks/Reducer.h"
#include "Selection/CellElements.h"

#include <cstdint> // for values
#include <tuple>   // for comparisons
#include <vector>  // for the elements

namespace camaron
{
class SharedElements
{
public:
  struct Element
  {
    std::int32_t Piece;
    vtkIdType Number; ///< in CellElements of the piece, or of the cell
  };

  /// Collective. @a elements: of each piece.
  SharedElements(const std::vector<LinkedPiece>& pieces, const std::vector<CellElements>& elements,
    Reducer& reducer);

  /// Collective. The points of the cells.
  static SharedElements OfPoints(const std::vector<LinkedPiece>& pieces, Reducer& reducer);

  /// Collective. The cells of which others have copies, and the copies.
  static SharedElements OfCells(const std::vector<LinkedPiece>& pieces, Reducer& reducer);

  /// Those of this process' pieces.
  const std::vector<Element>& Get() const { return this->Elements; }
  /// Collective. Replaces the value of each of Get() by the smallest one that any piece has for it.
  void Minimize(std::vector<std::int64_t>& values);

  /// Collective. Marks in all pieces what is marked in one of them, and returns what was not marked
  /// before. @a marks: of each piece and element, converted to bool and assigned from it.
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
  explicit SharedElements(camaron::Reducer& reducer)
    : Reducer(reducer)
  {
  }
  struct Candidate
  {
    std::uint64_t Hash[2];
    std::int32_t Block, Piece;
    vtkIdType Number;
    auto GetKey() const { return std::tie(this->Hash[0], this->Hash[1], this->Block); }
  };
  void FindCandidates(const std::vector<LinkedPiece>& pieces,
    const std::vector<CellElements>& elements, std::vector<Candidate>& candidates);
  void FindGroups(const std::vector<Candidate>& candidates);

  camaron::Reducer& Reducer;
  std::vector<Element> Elements;              // by the process that compares them
  std::vector<std::size_t> SentTo;            // of the elements to every process
  std::vector<std::vector<vtkIdType>> Groups; // of what this process compares, by sender
  vtkIdType NumberOfGroups = 0;
};
}

#endif
