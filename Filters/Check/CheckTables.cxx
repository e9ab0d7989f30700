// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CheckTables.h"

#include "Grouping.h"
#include "TableRows.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkStringArray.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Of a cell: Id, IdSpace, Block and CellType; then Value, X, Y, Z and Size.
void AddCell(TableRow& row, const WorstElement& cell, const CheckResults& results, std::size_t rule)
{
  const auto block = std::find_if(results.BlockNames.begin(), results.BlockNames.end(),
    [&](const auto& entry) { return entry.first == cell.BlockNumber; });
  row.Add(std::int64_t(cell.Id));
  row.Add(results.IdSpaces[rule]);
  row.Add(block == results.BlockNames.end() ? std::string() : block->second);
  row.Add(GetCellTypeLabel(cell.CellType));
  row.Add(cell.Value);
  for (const double coordinate : cell.Place)
  {
    row.Add(coordinate);
  }
  row.Add(cell.Size);
}

//------------------------------------------------------------------------------
void AddNoCell(TableRow& row)
{
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  row.Add(std::int64_t(-1));
  for (int text = 0; text < 3; ++text)
  {
    row.Add(std::string());
  }
  for (int number = 0; number < 5; ++number)
  {
    row.Add(unknown);
  }
}

//------------------------------------------------------------------------------
void AddText(vtkFieldData* data, const char* name, const std::vector<std::string>& texts)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& text : texts)
  {
    array->InsertNextValue(text);
  }
  data->AddArray(array);
}

//------------------------------------------------------------------------------
void AddCount(vtkFieldData* data, const char* name, std::int64_t count)
{
  vtkNew<IntegerColumn> array;
  array->SetName(name);
  array->InsertNextValue(count);
  data->AddArray(array);
}

//------------------------------------------------------------------------------
void AddFieldData(vtkFieldData* data, const CheckResults& results)
{
  const auto count = [&](Verdict verdict)
  {
    return std::count_if(results.Results.begin(), results.Results.end(),
      [&](const RuleResult& result) { return result.Verdict == verdict; });
  };
  AddText(data, "Verdict", { GetName(GetWorstVerdict(results.Results)) });
  AddText(data, "Notes", GetNotes(results.Rules, results.Results));
  AddCount(data, "Cells", results.NumberOfCells);
  AddCount(data, "Rules", static_cast<std::int64_t>(results.Rules.size()));
  AddCount(data, "Failed", count(Verdict::Fail));
  AddCount(data, "Warned", count(Verdict::Warn));
  AddCount(data, "Empty", count(Verdict::Empty));
}
}

//------------------------------------------------------------------------------
void AddRuleColumns(vtkTable* table)
{
  AddColumns<vtkStringArray>(table, { "Rule", "Verdict", "Criterion", "Unit", "Range" });
  AddColumns<vtkDoubleArray>(table, { "Low", "High" });
  AddColumns<IntegerColumn>(table, { "LowIncluded", "HighIncluded" });
  AddColumns<vtkStringArray>(table, { "Scope", "ScopeBy", "ScopeValue", "ScopeArray" });
  AddColumns<IntegerColumn>(
    table, { "Total", "Cells", "Checked", "Failing", "Below", "Above", "Undefined", "Infinite" });
  AddColumns<vtkDoubleArray>(table, { "FailingPercent", "FailingVolumePercent" });
  AddColumns<vtkStringArray>(table, { "Tolerance" });
  AddColumns<IntegerColumn>(table, { "Tolerated" });
  AddColumns<vtkDoubleArray>(table, { "Min", "Max" });
  AddColumns<IntegerColumn>(table, { "WorstId" });
  AddColumns<vtkStringArray>(table, { "IdSpace", "WorstBlock", "WorstCellType" });
  AddColumns<vtkDoubleArray>(table, { "WorstValue", "X", "Y", "Z", "Size" });
  AddColumns<IntegerColumn>(table, { "UndefinedFails", "Hint" });
  AddColumns<vtkStringArray>(table, { "Preset", "Source" });
  AddColumns<IntegerColumn>(table, { "Line" });
  AddColumns<vtkStringArray>(table, { "Text" });
}

//------------------------------------------------------------------------------
void AddRuleRows(vtkTable* table, const CheckResults& results)
{
  for (std::size_t i = 0; i < results.Rules.size(); ++i)
  {
    const Rule& rule = results.Rules[i];
    const RuleResult& result = results.Results[i];
    const Scope scope = rule.Scope.value_or(Scope());
    TableRow row;
    row.Add(rule.GetText());
    row.Add(std::string(GetName(result.Verdict)));
    row.Add(rule.Criterion);
    row.Add(rule.FindCriterion()->UnitLabel());
    row.Add(rule.GetRangeText());
    row.Add(rule.Low);
    row.Add(rule.High);
    row.Add(std::int64_t(rule.LowIncluded));
    row.Add(std::int64_t(rule.HighIncluded));
    row.Add(rule.GetScopeText());
    row.Add(std::string(rule.Scope ? scope.GetName() : ""));
    row.Add(scope.Value);
    row.Add(scope.Array);
    for (const std::int64_t count : { results.NumberOfCells, result.Cells, result.Checked,
           result.Failing, result.Below, result.Above, result.Undefined, result.Infinite })
    {
      row.Add(count);
    }
    row.Add(Percent(result.Failing, result.Checked));
    row.Add(result.FailingSizePercent);
    row.Add(rule.Tolerance.GetText());
    row.Add(result.Tolerated);
    row.Add(result.Min);
    row.Add(result.Max);
    result.Worst ? AddCell(row, *result.Worst, results, i) : AddNoCell(row);
    row.Add(std::int64_t(rule.UndefinedFails));
    row.Add(std::int64_t(rule.IsHint));
    row.Add(rule.Preset);
    row.Add(rule.Source);
    row.Add(std::int64_t(rule.Line));
    row.Add(rule.GetLineText());
    row.AppendTo(table);
  }
  AddFieldData(table->GetFieldData(), results);
}

//------------------------------------------------------------------------------
void AddFailingColumns(vtkTable* table)
{
  AddColumns<vtkStringArray>(table, { "Rule" });
  AddColumns<IntegerColumn>(table, { "RuleIndex", "Rank", "Id" });
  AddColumns<vtkStringArray>(table, { "IdSpace", "Block", "CellType" });
  AddColumns<vtkDoubleArray>(table, { "Value", "X", "Y", "Z", "Size" });
  AddColumns<vtkStringArray>(table, { "Why" });
}

//------------------------------------------------------------------------------
void AddFailingRows(vtkTable* table, const CheckResults& results)
{
  for (std::size_t i = 0; i < results.Rules.size(); ++i)
  {
    std::int64_t rank = 0;
    for (const FailingCell& cell : results.Results[i].List)
    {
      TableRow row;
      row.Add(results.Rules[i].GetText());
      row.Add(static_cast<std::int64_t>(i));
      row.Add(++rank);
      AddCell(row, cell, results, i);
      row.Add(std::string(GetName(cell.Why)));
      row.AppendTo(table);
    }
  }
}
}
