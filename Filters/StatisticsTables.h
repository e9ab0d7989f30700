// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StatisticsTables.h
 * @brief Columns and rows of the tables that vtkQualityStatistics makes.
 */
#ifndef camaron_StatisticsTables_h
#define camaron_StatisticsTables_h

#include "Statistics/Histogram.h"
#include "Statistics/Summary.h"
#include "Statistics/Weights.h"
#include "Statistics/Worst.h"

#include <optional> // for what may be unknown
#include <string>   // for names
#include <vector>   // for lists

class vtkTable;

namespace camaron
{
/// What the rows of an array and group have in common.
struct RowLabels
{
  std::string Criterion;
  std::string Unit;
  std::string Group;
  std::string IdSpace;
};

///@{
/// Give an empty table its columns. @a percents: a column P<percent> for each; @a weightArray may be empty.
void AddStatisticsColumns(
  vtkTable* table, const std::vector<double>& percents, const std::string& weightArray);
void AddHistogramColumns(vtkTable* table);
void AddWorstColumns(vtkTable* table);
///@}

void AddStatisticsRow(vtkTable* table, const RowLabels& labels, const Summary& summary,
  const std::vector<double>& quantiles, const std::optional<ValueRange>& acceptable,
  const std::optional<WeightedSummary>& weighted);
void AddHistogramRows(
  vtkTable* table, const RowLabels& labels, const Bins& bins, const Histogram& histogram);
/// @a blockNames: by the block number of the elements.
void AddWorstRows(vtkTable* table, const RowLabels& labels, const std::vector<WorstElement>& worst,
  const std::vector<std::pair<int, std::string>>& blockNames);
}

#endif
