// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CheckTables.h"

#include "Base/Number.h"
#include "StatisticsTables.h"
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
// The columns of AddElement without an element.
void AddNoElement(TableRow& row)
{
  row.Add(std::int64_t(-1), std::string(), std::string(), std::string());
  row.Add(NaN, NaN, NaN, NaN, NaN);
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
    row.Add(rule.GetText(), GetName(result.Verdict), rule.Criterion,
      rule.FindCriterion()->UnitLabel(), rule.GetRangeText());
    row.Add(rule.Low, rule.High);
    row.Add(std::int64_t(rule.LowIncluded), std::int64_t(rule.HighIncluded));
    row.Add(rule.GetScopeText(), rule.Scope ? scope.GetName() : "", scope.Value, scope.Array);
    row.Add(results.NumberOfCells, result.Cells, result.Checked, result.Failing, result.Below,
      result.Above, result.Undefined, result.Infinite);
    row.Add(Percent(result.Failing, result.Checked), result.FailingSizePercent);
    row.Add(rule.Tolerance.GetText(), result.Tolerated, result.Min, result.Max);
    result.Worst ? AddElement(row, *result.Worst, results.IdSpaces[i], results.BlockNames)
                 : AddNoElement(row);
    row.Add(std::int64_t(rule.UndefinedFails), std::int64_t(rule.IsHint));
    row.Add(rule.Preset, rule.Source, std::int64_t(rule.Line), rule.GetLineText());
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
      row.Add(results.Rules[i].GetText(), static_cast<std::int64_t>(i), ++rank);
      AddElement(row, cell, results.IdSpaces[i], results.BlockNames);
      row.Add(GetName(cell.Why));
      row.AppendTo(table);
    }
  }
}
}
