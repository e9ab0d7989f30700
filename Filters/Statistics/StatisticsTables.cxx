// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StatisticsTables.h"

#include "Base/Number.h"
#include "ElementPlaces.h"
#include "Grouping.h"
#include "PropertyValues.h"
#include "TableRows.h"

#include <cstdio>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
TableRow MakeRow(const RowLabels& labels)
{
  return { labels.Time, labels.Criterion, labels.Unit, labels.Group };
}
}

//------------------------------------------------------------------------------
void AddStatisticsColumns(
  vtkTable* table, const TableLayout& layout, const std::vector<double>& percents)
{
  AddLabelColumns(table, layout.HasTime);
  AddColumns<IntegerColumn>(
    table, { "Count", "UndefinedCount", "InfiniteCount", "ApplicableCount" });
  AddColumns<vtkDoubleArray>(table, { "Min" });
  AddColumns<IntegerColumn>(table, { "ArgMin" });
  AddColumns<vtkDoubleArray>(table, { "ArgMinX", "ArgMinY", "ArgMinZ", "Max" });
  AddColumns<IntegerColumn>(table, { "ArgMax" });
  AddColumns<vtkDoubleArray>(table, { "ArgMaxX", "ArgMaxY", "ArgMaxZ" });
  AddColumns<vtkStringArray>(table, { "IdSpace" });
  AddColumns<vtkDoubleArray>(table,
    { "Mean", "StdDev", "Variance", "Skewness", "Kurtosis", "RootMeanSquare", "GeometricMean",
      "Sum" });
  for (const double percent : percents)
  {
    char name[32];
    std::snprintf(name, sizeof(name), "P%.10g", percent);
    AddColumns<vtkDoubleArray>(table, { name });
  }
  AddColumns<vtkDoubleArray>(table, { "AcceptableLow", "AcceptableHigh" });
  AddColumns<IntegerColumn>(
    table, { "JudgedCount", "JudgedUndefinedCount", "BelowCount", "AboveCount" });
  AddColumns<vtkDoubleArray>(table, { "OutOfRangePercent" });
  if (!layout.WeightArray.empty())
  {
    const std::string badFraction = "Bad" + layout.WeightArray + "Fraction";
    AddColumns<vtkDoubleArray>(table, { "Weight", "WeightedMean", badFraction.c_str() });
  }
}

//------------------------------------------------------------------------------
void AddStatisticsRow(vtkTable* table, const RowLabels& labels, const Summary& summary,
  const ExtremePlaces& places, const std::vector<double>& quantiles,
  const std::optional<ValueRange>& acceptable, const std::optional<WeightedSummary>& weighted)
{
  TableRow row = MakeRow(labels);
  row.Add(
    summary.Count, summary.UndefinedCount, summary.InfiniteCount, summary.GetApplicableCount());
  row.Add(summary.Min, std::int64_t(summary.ArgMin), places.Min);
  row.Add(summary.Max, std::int64_t(summary.ArgMax), places.Max, labels.IdSpace);
  row.Add(summary.Mean, summary.StandardDeviation, summary.Variance, summary.Skewness,
    summary.Kurtosis, summary.RootMeanSquare, summary.GeometricMean, summary.Sum);
  for (const double quantile : quantiles)
  {
    row.Add(quantile);
  }
  row.Add(acceptable ? acceptable->Low : NaN, acceptable ? acceptable->High : NaN);
  row.Add(
    summary.JudgedCount, summary.JudgedUndefinedCount, summary.BelowCount, summary.AboveCount);
  row.Add(acceptable ? Percent(summary.BelowCount + summary.AboveCount, summary.JudgedCount) : NaN);
  if (weighted)
  {
    row.Add(weighted->Weight, weighted->Mean, acceptable ? weighted->BadFraction : NaN);
  }
  row.AppendTo(table);
}

//------------------------------------------------------------------------------
void AddHistogramColumns(vtkTable* table, const TableLayout& layout)
{
  AddLabelColumns(table, layout.HasTime);
  AddColumns<IntegerColumn>(table, { "Bin" });
  AddColumns<vtkDoubleArray>(table, { "LowerEdge", "UpperEdge", "Center" });
  AddColumns<IntegerColumn>(table, { "Count" });
  AddColumns<vtkDoubleArray>(table, { "Percent", "CumulativePercent" });
  AddColumns<IntegerColumn>(
    table, { "Underflow", "Overflow", "UndefinedCount", "InfiniteCount", "JudgedCount" });
}

//------------------------------------------------------------------------------
void AddHistogramRows(vtkTable* table, const RowLabels& labels, const Bins& bins,
  const Histogram& histogram, const std::vector<std::int64_t>& judged)
{
  const std::int64_t total = histogram.GetTotal();
  std::int64_t upTo = histogram.Underflow;
  const auto add = [&](std::int64_t bin, double low, double high, double center, std::int64_t count,
                     std::int64_t judgedCount)
  {
    upTo += count;
    TableRow row = MakeRow(labels);
    row.Add(bin, low, high, center, count, Percent(count, total), Percent(upTo, total));
    row.Add(
      histogram.Underflow, histogram.Overflow, histogram.UndefinedCount, histogram.InfiniteCount);
    row.Add(judgedCount);
    row.AppendTo(table);
  };
  if (bins.GetSize() == 0)
  {
    add(-1, NaN, NaN, NaN, 0, 0); // there may be values, but none of them is in a bin
  }
  for (std::size_t bin = 0; bin < bins.GetSize(); ++bin)
  {
    add(static_cast<std::int64_t>(bin), bins.GetEdges()[bin], bins.GetEdges()[bin + 1],
      bins.GetCenter(bin), histogram.Counts[bin], judged[bin]);
  }
}

//------------------------------------------------------------------------------
void AddWorstColumns(vtkTable* table, const TableLayout& layout)
{
  AddLabelColumns(table, layout.HasTime);
  AddColumns<IntegerColumn>(table, { "Rank", "Id" });
  AddColumns<vtkStringArray>(table, { "IdSpace", "Block", "CellType" });
  AddColumns<vtkDoubleArray>(table, { "Value", "X", "Y", "Z", "Size" });
  AddColumns<vtkStringArray>(table, { "Vertices" });
  AddColumns<IntegerColumn>(table, { "Judged" });
}

//------------------------------------------------------------------------------
void AddElement(TableRow& row, const WorstElement& element, const std::string& idSpace,
  const BlockNames& blockNames)
{
  row.Add(std::int64_t(element.Id), idSpace, FindBlockName(blockNames, element.BlockNumber),
    element.CellType == PointCellType ? std::string("Point") : GetCellTypeLabel(element.CellType));
  row.Add(element.Value, element.Place[0], element.Place[1], element.Place[2], element.Size);
}

//------------------------------------------------------------------------------
void AddWorstRows(vtkTable* table, const RowLabels& labels, bool hasRange,
  const std::vector<WorstElement>& worst, const std::vector<std::string>& vertices,
  const BlockNames& blockNames)
{
  for (std::size_t i = 0; i < worst.size(); ++i)
  {
    const WorstElement& element = worst[i];
    TableRow row = MakeRow(labels);
    row.Add(static_cast<std::int64_t>(i + 1));
    AddElement(row, element, labels.IdSpace, blockNames);
    row.Add(vertices[i], std::int64_t(hasRange && element.IsJudged));
    row.AppendTo(table);
  }
}

//------------------------------------------------------------------------------
void AddCurveColumns(vtkTable* table, const TableLayout& layout)
{
  AddLabelColumns(table, layout.HasTime);
  AddColumns<vtkDoubleArray>(table, { "Value" });
  AddColumns<IntegerColumn>(table, { "Count" });
  AddColumns<vtkDoubleArray>(table, { "Percent" });
  if (!layout.WeightArray.empty())
  {
    AddColumns<vtkDoubleArray>(table, { "Weight", "WeightPercent" });
  }
}

//------------------------------------------------------------------------------
void AddCurveRows(vtkTable* table, const RowLabels& labels, const CumulativeCurve& curve,
  const Summary& summary, const std::optional<WeightedSummary>& weighted)
{
  for (std::size_t point = 0; point < curve.Values.size(); ++point)
  {
    TableRow row = MakeRow(labels);
    row.Add(curve.Values[point], curve.CountsUpTo[point],
      Percent(curve.CountsUpTo[point], summary.Count - summary.UndefinedCount));
    if (weighted)
    {
      row.Add(curve.WeightsUpTo[point],
        weighted->Weight > 0 ? 100 * (curve.WeightsUpTo[point] / weighted->Weight) : NaN);
    }
    row.AppendTo(table);
  }
}

//------------------------------------------------------------------------------
BinScale ToBinScale(const std::string& name)
{
  return ParseChoice<BinScale>("Histogram Scale", name,
    { { "Linear", BinScale::Linear }, { "Logarithmic", BinScale::Logarithmic } });
}
}
