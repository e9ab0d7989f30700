// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ComparisonTables.h
 * @brief Columns and rows of the tables of vtkCompareQuality.
 */
#ifndef camaron_ComparisonTables_h
#define camaron_ComparisonTables_h

#include "Criteria/Criterion.h"
#include "Statistics/Histogram.h"
#include "Statistics/Summary.h"
#include "Statistics/ValueChanges.h"

#include <array>    // for both meshes
#include <optional> // for optional results
#include <string>   // for names
#include <vector>   // for quantiles

class vtkTable;

namespace camaron
{
/// The results for one array and one group of cells of meshes A and B.
struct ArrayComparison
{
  std::string Name;
  std::string Unit;
  std::string Group;
  std::optional<double> Time; ///< for tables with that column
  camaron::Better Better = Better::Neither;
  std::optional<ValueRange> Acceptable;
  std::array<Summary, 2> Summaries;
  std::array<std::vector<double>, 2> Quantiles; ///< at GetComparedPercents()
  DistributionDistance Distance;
  std::optional<ValueChanges> Changes; ///< only if both meshes have the same cells
  camaron::Bins Bins;
  std::array<Histogram, 2> Histograms;
};

/// Percentages of the quantiles that are compared.
const std::vector<double>& GetComparedPercents();

void AddComparisonColumns(vtkTable* table, bool hasTime);
void AddCommonHistogramColumns(vtkTable* table, bool hasTime);
void AddComparisonRow(vtkTable* table, const ArrayComparison& comparison);
void AddCommonHistogramRows(vtkTable* table, const ArrayComparison& comparison);
}

#endif
