// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CheckTables.h
 * @brief Columns and rows of the tables of vtkCheckQuality.
 */
#ifndef camaron_CheckTables_h
#define camaron_CheckTables_h

#include "Grouping.h"
#include "Rules/RuleResults.h"

#include <cstdint> // for counts
#include <string>  // for names
#include <vector>  // for lists

class vtkTable;

namespace camaron
{
/// The results of all rules.
struct CheckResults
{
  std::vector<Rule> Rules;
  std::vector<RuleResult> Results; ///< one per rule
  std::int64_t NumberOfCells = 0;
  std::vector<std::string> IdSpaces; ///< one per rule
  camaron::BlockNames BlockNames;
};

///@{
/// Add the columns to an empty table.
void AddRuleColumns(vtkTable* table);
void AddFailingColumns(vtkTable* table);
///@}

///@{
/// Add the rows; those of the rules also add the field data.
void AddRuleRows(vtkTable* table, const CheckResults& results);
void AddFailingRows(vtkTable* table, const CheckResults& results);
///@}
}

#endif
