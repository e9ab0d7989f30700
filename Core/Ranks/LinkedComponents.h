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

#include "Ranks/LinkedPieces.h"
#include "Ranks/Reducer.h"

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

  /// For each component of this rank, the smallest number of all components connected to it.
  const std::vector<std::int64_t>& GetLabels() const { return this->Labels; }
  /// The rank of the component that has this number.
  int GetProcess(std::int64_t label) const;

private:
  struct Contact
  {
    std::int64_t Own, Other; // component numbers
    int Process;
  };
  std::int64_t GetOwnFirst() const { return this->First[this->Reducer.GetProcess()]; }
  void FindContacts(
    const std::vector<LinkedPiece>& pieces, const std::vector<std::vector<Index>>& ofCells);
  void Propagate();

  camaron::Reducer& Reducer;
  std::vector<std::int64_t> First; // number of the first component of each rank, and the total
                                   // number
  std::vector<std::int64_t> Labels;
  std::vector<Contact> Contacts;
};
}

#endif
