// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CheckedCells.h
 * @brief The cells in the scope of a rule.
 */
#ifndef camaron_CheckedCells_h
#define camaron_CheckedCells_h

#include "ElementBlocks.h"
#include "Grouping.h"
#include "Rules/Rule.h"

#include <optional> // for scopes
#include <string>   // for names
#include <vector>   // for masks

class vtkElementQuality;

namespace camaron
{
/// The cell array whose values define the cells of a scope, which may be a criterion; empty for a
/// block.
std::string GetArrayOfScope(const Scope& scope);

/// Chooses the criteria that rules need, of the filter that evaluates them.
void ChooseCriteria(const std::vector<Rule>& rules, vtkElementQuality& evaluator);

/**
 * Collective. Throws std::runtime_error on all processes if a rule refers to a block or a
 * one-component cell array that the mesh does not have. Criteria count as arrays.
 *
 * @param leaves the data sets of the input, whose arrays the message lists
 * @param blockNames see GetBlockNames
 */
void CheckScopes(const std::vector<Rule>& rules, const std::vector<DataSetLeaf>& leaves,
  const BlockNames& blockNames, Reducer& reducer);

/// The cells in a scope. Needs a byte per cell unless they are all cells.
class CheckedCells
{
public:
  /// Collective. @a scope: none means all cells; so do the other elements, whose blocks are
  /// @a blocks then. Throws as BlockValues does.
  CheckedCells(const std::optional<Scope>& scope, const ElementBlocks& blocks, Reducer& reducer);

  /// The part of @a values in the scope; valid as long as this object and the values.
  Population Restrict(const BlockValues& values) const;

private:
  std::vector<bool> IsInside;                    // by block: whether some of its cells are
  std::vector<std::vector<unsigned char>> Skips; // by block: empty if all of its cells are
};
}

#endif
