// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::LinkedComponents
 * @brief What hangs together in the pieces of a mesh, joined over all pieces.
 *
 * A component is a set of cells of one piece. Those whose cells lead to each other by Options.Links
 * of their pieces get the same label.
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
   * @param ofCells of every piece and cell its component, numbered from 0 over all pieces of this
   * process; negative for cells that take no part. Cells at linked facets take part unless they are
   * copies
   */
  LinkedComponents(const std::vector<LinkedPiece>& pieces,
    const std::vector<std::vector<Index>>& ofCells, Index numberOfComponents, Reducer& reducer);

  /// Of each component of this process the smallest number of all that hang together with it.
  const std::vector<std::int64_t>& GetLabels() const { return this->Labels; }
  /// The process that has the component which gives the label.
  int GetProcess(std::int64_t label) const;

private:
  struct Contact
  {
    std::int64_t Own, Other; // numbers of components
    int Process;
  };
  std::int64_t GetOwnFirst() const { return this->First[this->Reducer.GetProcess()]; }
  void FindContacts(
    const std::vector<LinkedPiece>& pieces, const std::vector<std::vector<Index>>& ofCells);
  void Propagate();

  camaron::Reducer& Reducer;
  std::vector<std::int64_t> First; // number of the first component of each process, and of all
  std::vector<std::int64_t> Labels;
  std::vector<Contact> Contacts;
};
}

#endif
