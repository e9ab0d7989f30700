// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StatisticsTables.h
 * @brief Columns and rows of the tables of vtkQualityStatistics.
 */
#ifndef camaron_StatisticsTables_h
#define camaron_StatisticsTables_h

#include "Grouping.h"
#include "Statistics/Histogram.h"
#include "Statistics/Quantiles.h"
#include "Statistics/Summary.h"
#include "Statistics/Weights.h"
#include "Statistics/Worst.h"

#include <array>    // for coordinates
#include <optional> // for optional values
#include <string>   // for names
#include <vector>   // for lists

class vtkTable;

namespace camaron
{
class TableRow;

/// Values that all rows of an array and group share.
struct RowLabels
{
  std::string Criterion;
  std::string Unit;
  std::string Group;
  std::string IdSpace;
  std::optional<double> Time; ///< for tables with that column
};

/// Positions of the elements with the smallest and the largest value.
struct ExtremePlaces
{
  std::array<double, 3> Min, Max;
};

/// Options that determine the columns of all tables.
struct TableLayout
{
  bool HasTime = false;
  std::string WeightArray; ///< empty: no weights
};

///@{
/// Add the columns to an empty table. @a percents: adds a column P<percent> for each.
void AddStatisticsColumns(
  vtkTable* table, const TableLayout& layout, const std::vector<double>& percents);
void AddHistogramColumns(vtkTable* table, const TableLayout& layout);
void AddWorstColumns(vtkTable* table, const TableLayout& layout);
void AddCurveColumns(vtkTable* table, const TableLayout& layout);
///@}

void AddStatisticsRow(vtkTable* table, const RowLabels& labels, const Summary& summary,
  const ExtremePlaces& places, const std::vector<double>& quantiles,
  const std::optional<ValueRange>& acceptable, const std::optional<WeightedSummary>& weighted);
/// @a judged: of each bin, the elements that the acceptable range applies to.
void AddHistogramRows(vtkTable* table, const RowLabels& labels, const Bins& bins,
  const Histogram& histogram, const std::vector<std::int64_t>& judged);
/// Adds Id, IdSpace, Block, CellType, Value, X, Y, Z and Size of an element to a row. Points have
/// the cell type PointCellType.
void AddElement(TableRow& row, const WorstElement& element, const std::string& idSpace,
  const BlockNames& blockNames);
/// @a vertices: one text per element. @a hasRange: whether the array has an acceptable range.
void AddWorstRows(vtkTable* table, const RowLabels& labels, bool hasRange,
  const std::vector<WorstElement>& worst, const std::vector<std::string>& vertices,
  const BlockNames& blockNames);
/// @a weighted: statistics of the same elements, if the curve has weights.
void AddCurveRows(vtkTable* table, const RowLabels& labels, const CumulativeCurve& curve,
  const Summary& summary, const std::optional<WeightedSummary>& weighted);

/// The scale with the name "Linear" or "Logarithmic". Throws std::invalid_argument for any other
/// name.
BinScale ToBinScale(const std::string& name);
}

#endif
