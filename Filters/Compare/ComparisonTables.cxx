// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ComparisonTables.h"

#include "AcceptableRanges.h"
#include "Base/Number.h"
#include "TableRows.h"

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Adds a column for A, one for B and one for B - A.
template <typename Array>
void AddTriples(vtkTable* table, std::initializer_list<std::string> names)
{
  for (const std::string& name : names)
  {
    AddColumns<Array>(table, { name + "A", name + "B", name + "Difference" });
  }
}

//------------------------------------------------------------------------------
template <typename Number>
void AddTriple(TableRow& row, Number a, Number b)
{
  row.Add(a, b, b - a);
}

//------------------------------------------------------------------------------
TableRow MakeRow(const ArrayComparison& comparison)
{
  return { comparison.Time, comparison.Name, comparison.Unit, comparison.Group };
}

//------------------------------------------------------------------------------
double GetOutOfRangePercent(const ArrayComparison& comparison, int mesh)
{
  const Summary& summary = comparison.Summaries[mesh];
  return comparison.Acceptable
    ? Percent(summary.BelowCount + summary.AboveCount, summary.JudgedCount)
    : NaN;
}

//------------------------------------------------------------------------------
// Fraction of the elements that have a value.
double GetFraction(const Histogram& histogram, std::int64_t count)
{
  const std::int64_t total = histogram.GetTotal() - histogram.UndefinedCount;
  return total > 0 ? static_cast<double>(count) / static_cast<double>(total) : NaN;
}
}

//------------------------------------------------------------------------------
const std::vector<double>& GetComparedPercents()
{
  static const std::vector<double> percents = { 1, 5, 50, 95, 99 };
  return percents;
}

//------------------------------------------------------------------------------
void AddComparisonColumns(vtkTable* table, bool hasTime)
{
  AddLabelColumns(table, hasTime);
  AddColumns<vtkStringArray>(table, { "Better" });
  AddTriples<IntegerColumn>(table, { "Count", "UndefinedCount", "InfiniteCount" });
  AddTriples<vtkDoubleArray>(table, { "Min", "Max", "Mean", "StdDev", "Sum" });
  for (const double percent : GetComparedPercents())
  {
    AddTriples<vtkDoubleArray>(table, { "P" + std::to_string(static_cast<int>(percent)) });
  }
  AddColumns<vtkDoubleArray>(table, { "AcceptableLow", "AcceptableHigh" });
  AddTriples<IntegerColumn>(table, { "JudgedCount", "OutOfRangeCount" });
  AddTriples<vtkDoubleArray>(table, { "OutOfRangePercent" });
  AddColumns<vtkDoubleArray>(table, { "Distance", "DistanceValue" });
  AddColumns<IntegerColumn>(
    table, { "SameCells", "ComparedCount", "ImprovedCount", "WorsenedCount", "UnchangedCount" });
}

//------------------------------------------------------------------------------
void AddComparisonRow(vtkTable* table, const ArrayComparison& comparison)
{
  const Summary &a = comparison.Summaries[0], &b = comparison.Summaries[1];
  TableRow row = MakeRow(comparison);
  row.Add(GetBetterName(comparison.Better));
  AddTriple(row, a.Count, b.Count);
  AddTriple(row, a.UndefinedCount, b.UndefinedCount);
  AddTriple(row, a.InfiniteCount, b.InfiniteCount);
  AddTriple(row, a.Min, b.Min);
  AddTriple(row, a.Max, b.Max);
  AddTriple(row, a.Mean, b.Mean);
  AddTriple(row, a.StandardDeviation, b.StandardDeviation);
  AddTriple(row, a.Sum, b.Sum);
  for (std::size_t q = 0; q < GetComparedPercents().size(); ++q)
  {
    AddTriple(row, comparison.Quantiles[0][q], comparison.Quantiles[1][q]);
  }
  row.Add(comparison.Acceptable ? comparison.Acceptable->Low : NaN,
    comparison.Acceptable ? comparison.Acceptable->High : NaN);
  AddTriple(row, a.JudgedCount, b.JudgedCount);
  AddTriple(row, a.BelowCount + a.AboveCount, b.BelowCount + b.AboveCount);
  AddTriple(row, GetOutOfRangePercent(comparison, 0), GetOutOfRangePercent(comparison, 1));
  row.Add(comparison.Distance.Distance, comparison.Distance.Value);
  const ValueChanges changes = comparison.Changes.value_or(ValueChanges());
  row.Add(std::int64_t(comparison.Changes.has_value()), changes.Compared, changes.Improved,
    changes.Worsened, changes.Unchanged);
  row.AppendTo(table);
}

//------------------------------------------------------------------------------
void AddCommonHistogramColumns(vtkTable* table, bool hasTime)
{
  AddLabelColumns(table, hasTime);
  AddColumns<IntegerColumn>(table, { "Bin" });
  AddColumns<vtkDoubleArray>(table, { "LowerEdge", "UpperEdge", "Center" });
  AddColumns<IntegerColumn>(table, { "CountA", "CountB" });
  AddColumns<vtkDoubleArray>(table, { "FractionA", "FractionB", "FractionDifference" });
  AddColumns<IntegerColumn>(table, { "UnderflowA", "UnderflowB" });
}

//------------------------------------------------------------------------------
void AddCommonHistogramRows(vtkTable* table, const ArrayComparison& comparison)
{
  const Histogram &a = comparison.Histograms[0], &b = comparison.Histograms[1];
  for (std::size_t bin = 0; bin < comparison.Bins.GetSize(); ++bin)
  {
    TableRow row = MakeRow(comparison);
    row.Add(static_cast<std::int64_t>(bin), comparison.Bins.GetEdges()[bin],
      comparison.Bins.GetEdges()[bin + 1], comparison.Bins.GetCenter(bin), a.Counts[bin],
      b.Counts[bin]);
    AddTriple(row, GetFraction(a, a.Counts[bin]), GetFraction(b, b.Counts[bin]));
    row.Add(a.Underflow, b.Underflow);
    row.AppendTo(table);
  }
}
}
