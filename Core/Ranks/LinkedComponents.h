// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::LinkedComponents
 * @brief Joins connected components of single pieces to those of the whole mesh.
 *
 * A component is a set of cells of one piece. Components whose cells are connected over the
 * Options.Links of their pieces get the same label.
 */
#ifndef camaron_LinkedComponents_h
#define camaron_LinkedComponents_h

#include "Ranks/EqualKeys.h"
#include "Ranks/LinkedPieces.h"
#include "Ranks/Reducer.h"

#include <array>   // for pairs
#include <cstdint> // for labels
#include <vector>  // for components

namespace camaron
{
class LinkedComponents
{
public:
  /**
   * Collective.
   * @param ofCells for every piece and cell its component, numbered from 0 over all pieces of this
   * rank; negative for ignored cells. Cells at linked facets must have a component unless they are
   * duplicates
   */
  LinkedComponents(const std::vector<LinkedPiece>& pieces,
    const std::vector<std::vector<Index>>& ofCells, Index numberOfComponents, Reducer& reducer);

  /// Whether the number of a component of this rank is its label.
  bool IsFirst(std::size_t component) const
  {
    return this->Labels[component] == this->GetOwnFirst() + static_cast<std::int64_t>(component);
  }

  /**
   * Collective. Combines values of all components that are connected: takes one value for each
   * component of this rank and returns the combined one for each.
   * @param add adds a Value to another one, with the same result in any order
   */
  template <typename Value, typename Add>
  std::vector<Value> Combine(const std::vector<Value>& values, Add&& add) const
  {
    struct Part
    {
      std::int64_t Label;
      Value Of;
      std::int64_t GetKey() const { return this->Label; }
      std::uint64_t GetHash() const { return static_cast<std::uint64_t>(this->Label); }
    };
    std::vector<Part> parts;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      parts.push_back({ this->Labels[i], values[i] });
    }
    return AskAboutEqual(parts, this->Reducer,
      [&](const std::vector<Received<Part>>& group)
      {
        Value sum = group[0].Sent->Of;
        std::for_each(group.begin() + 1, group.end(),
          [&](const Received<Part>& part) { add(sum, part.Sent->Of); });
        return sum;
      });
  }

private:
  int GetProcess(std::int64_t component) const;
  std::int64_t GetOwnFirst() const { return this->First[this->Reducer.GetProcess()]; }
  void FindContacts(
    const std::vector<LinkedPiece>& pieces, const std::vector<std::vector<Index>>& ofCells);
  void Propagate();

  camaron::Reducer& Reducer;
  std::vector<std::int64_t> First;  // number of the first component of each rank, and the total
                                    // number
  std::vector<std::int64_t> Labels; // for each component of this rank, the smallest number of all
                                    // components connected to it
  std::vector<std::array<std::int64_t, 2>> Contacts; // numbers of own and other components
};
}

#endif
