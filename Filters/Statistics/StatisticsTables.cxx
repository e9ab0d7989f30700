// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StatisticsTables.h"

#include "ElementPlaces.h"
#include "Grouping.h"
#include "TableRows.h"

#include "vtkDoubleArray.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// All digits of an integer if the array has integers; else an empty text.
std::string ToTextIf(bool ofIntegers, const ExactValue& value)
{
  return ofIntegers && IsInteger64(value) ? ToText(value) : std::string();
}

//------------------------------------------------------------------------------
// A row that starts with the labels.
class Row : public TableRow
{
public:
  explicit Row(const RowLabels& labels)
  {
    if (labels.Time)
    {
      this->Add(*labels.Time);
    }
    this->Add(labels.Criterion);
    this->Add(labels.Unit);
    this->Add(labels.Group);
  }
};

//------------------------------------------------------------------------------
void AddLabelColumns(vtkTable* table, const TableLayout& layout)
{
  if (layout.HasTime)
  {
    AddColumns<vtkDoubleArray>(table, { "Time" });
  }
  AddColumns<vtkStringArray>(table, { "Criterion", "Unit", "Group" });
}
}

//------------------------------------------------------------------------------
void AddStatisticsColumns(
  vtkTable* table, const TableLayout& layout, const std::vector<double>& percents)
{
  AddLabelColumns(table, layout);
  AddColumns<IntegerColumn>(table, { "Count", "NullCount", "InfCount", "ApplicableCount" });
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
  AddColumns<IntegerColumn>(table, { "JudgedCount", "BelowCount", "AboveCount" });
  AddColumns<vtkDoubleArray>(table, { "OutOfRangePercent" });
  AddColumns<vtkStringArray>(table, { "MinInteger", "MaxInteger" });
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
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  Row row(labels);
  row.Add(summary.Count);
  row.Add(summary.NullCount);
  row.Add(summary.InfCount);
  row.Add(summary.GetApplicableCount());
  row.Add(summary.Min);
  row.Add(std::int64_t(summary.ArgMin));
  row.Add(places.Min);
  row.Add(summary.Max);
  row.Add(std::int64_t(summary.ArgMax));
  row.Add(places.Max);
  row.Add(labels.IdSpace);
  row.Add(summary.Mean);
  row.Add(summary.StandardDeviation);
  row.Add(summary.Variance);
  row.Add(summary.Skewness);
  row.Add(summary.Kurtosis);
  row.Add(summary.RootMeanSquare);
  row.Add(summary.GeometricMean);
  row.Add(summary.Sum);
  for (const double quantile : quantiles)
  {
    row.Add(quantile);
  }
  row.Add(acceptable ? acceptable->Low : unknown);
  row.Add(acceptable ? acceptable->High : unknown);
  row.Add(summary.JudgedCount);
  row.Add(summary.BelowCount);
  row.Add(summary.AboveCount);
  row.Add(
    acceptable ? Percent(summary.BelowCount + summary.AboveCount, summary.JudgedCount) : unknown);
  row.Add(ToTextIf(labels.OfIntegers, { summary.Min, summary.MinRest }));
  row.Add(ToTextIf(labels.OfIntegers, { summary.Max, summary.MaxRest }));
  if (weighted)
  {
    row.Add(weighted->Weight);
    row.Add(weighted->Mean);
    row.Add(acceptable ? weighted->BadFraction : unknown);
  }
  row.AppendTo(table);
}

//------------------------------------------------------------------------------
void AddHistogramColumns(vtkTable* table, const TableLayout& layout)
{
  AddLabelColumns(table, layout);
  AddColumns<IntegerColumn>(table, { "Bin" });
  AddColumns<vtkDoubleArray>(table, { "LowerEdge", "UpperEdge", "Center" });
  AddColumns<IntegerColumn>(table, { "Count" });
  AddColumns<vtkDoubleArray>(table, { "Percent", "CumulativePercent" });
  AddColumns<IntegerColumn>(table, { "Underflow", "Overflow", "NullCount", "InfCount" });
}

//------------------------------------------------------------------------------
void AddHistogramRows(
  vtkTable* table, const RowLabels& labels, const Bins& bins, const Histogram& histogram)
{
  const std::int64_t total = histogram.GetTotal();
  std::int64_t upTo = histogram.Underflow;
  if (bins.GetSize() == 0)
  {
    // There may be values even though none of them falls into a bin.
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    Row row(labels);
    row.Add(std::int64_t(-1));
    for (int edge = 0; edge < 3; ++edge)
    {
      row.Add(unknown);
    }
    row.Add(std::int64_t(0));
    row.Add(Percent(0, total));
    row.Add(Percent(upTo, total));
    row.Add(histogram.Underflow);
    row.Add(histogram.Overflow);
    row.Add(histogram.NullCount);
    row.Add(histogram.InfCount);
    row.AppendTo(table);
  }
  for (std::size_t bin = 0; bin < bins.GetSize(); ++bin)
  {
    upTo += histogram.Counts[bin];
    Row row(labels);
    row.Add(static_cast<std::int64_t>(bin));
    row.Add(bins.GetEdges()[bin]);
    row.Add(bins.GetEdges()[bin + 1]);
    row.Add(bins.GetCenter(bin));
    row.Add(histogram.Counts[bin]);
    row.Add(Percent(histogram.Counts[bin], total));
    row.Add(Percent(upTo, total));
    row.Add(histogram.Underflow);
    row.Add(histogram.Overflow);
    row.Add(histogram.NullCount);
    row.Add(histogram.InfCount);
    row.AppendTo(table);
  }
}

//------------------------------------------------------------------------------
void AddWorstColumns(vtkTable* table, const TableLayout& layout)
{
  AddLabelColumns(table, layout);
  AddColumns<IntegerColumn>(table, { "Rank", "Id" });
  AddColumns<vtkStringArray>(table, { "IdSpace", "Block", "CellType" });
  AddColumns<vtkDoubleArray>(table, { "Value", "X", "Y", "Z", "Size" });
  AddColumns<vtkStringArray>(table, { "Vertices", "ValueInteger" });
}

//------------------------------------------------------------------------------
void AddWorstRows(vtkTable* table, const RowLabels& labels, const std::vector<WorstElement>& worst,
  const std::vector<std::string>& vertices,
  const std::vector<std::pair<int, std::string>>& blockNames)
{
  for (std::size_t i = 0; i < worst.size(); ++i)
  {
    const WorstElement& element = worst[i];
    const auto block = std::find_if(blockNames.begin(), blockNames.end(),
      [&](const auto& entry) { return entry.first == element.BlockNumber; });
    Row row(labels);
    row.Add(static_cast<std::int64_t>(i + 1));
    row.Add(std::int64_t(element.Id));
    row.Add(labels.IdSpace);
    row.Add(block == blockNames.end() ? std::string() : block->second);
    row.Add(element.CellType == PointCellType ? std::string("Point")
                                              : GetCellTypeLabel(element.CellType));
    row.Add(element.Value);
    row.Add(element.Place[0]);
    row.Add(element.Place[1]);
    row.Add(element.Place[2]);
    row.Add(element.Size);
    row.Add(vertices[i]);
    row.Add(ToTextIf(labels.OfIntegers, { element.Value, element.Rest }));
    row.AppendTo(table);
  }
}

//------------------------------------------------------------------------------
void AddCurveColumns(vtkTable* table, const TableLayout& layout)
{
  AddLabelColumns(table, layout);
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
    Row row(labels);
    row.Add(curve.Values[point]);
    row.Add(curve.CountsUpTo[point]);
    row.Add(Percent(curve.CountsUpTo[point], summary.Count - summary.NullCount));
    if (weighted)
    {
      row.Add(curve.WeightsUpTo[point]);
      row.Add(weighted->Weight > 0 ? 100 * (curve.WeightsUpTo[point] / weighted->Weight)
                                   : std::numeric_limits<double>::quiet_NaN());
    }
    row.AppendTo(table);
  }
}

//------------------------------------------------------------------------------
BinScale ToBinScale(const std::string& name)
{
  if (name != "Linear" && name != "Logarithmic")
  {
    throw std::invalid_argument(
      "Histogram Scale must be Linear or Logarithmic, not '" + name + "'");
  }
  return name == "Linear" ? BinScale::Linear : BinScale::Logarithmic;
}
}
