// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCriteriaTable.h"

#include "AcceptableRanges.h"
#include "Cell/CellDefects.h"
#include "ControllerReducer.h"
#include "Elements/ElementCriteria.h"
#include "Rules/ParsedRules.h"
#include "TableRows.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <cstdint>
#include <exception>
#include <string>

vtkStandardNewMacro(vtkCriteriaTable);

namespace
{
//------------------------------------------------------------------------------
const char* GetDimension(enum camaron::Unit unit)
{
  return unit == camaron::Unit::Length ? "Length"
    : unit == camaron::Unit::Area      ? "Area"
    : unit == camaron::Unit::Volume    ? "Volume"
                                       : "";
}

//------------------------------------------------------------------------------
std::string GetShapes(unsigned appliesTo)
{
  if (appliesTo & camaron::AnyCell)
  {
    return "any cell";
  }
  const std::pair<unsigned, const char*> shapes[] = { { camaron::Polygons, "polygons" },
    { camaron::Polyhedra, "polyhedra" }, { camaron::Triangles, "triangles" },
    { camaron::Quadrilaterals, "quadrilaterals" }, { camaron::Tetrahedra, "tetrahedra" },
    { camaron::Pyramids, "pyramids" }, { camaron::Wedges, "wedges" },
    { camaron::Hexahedra, "hexahedra" } };
  std::vector<std::string> names;
  for (const auto& shape : shapes)
  {
    if (appliesTo & shape.first)
    {
      names.emplace_back(shape.second);
    }
  }
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    list += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + names[i];
  }
  return list;
}

//------------------------------------------------------------------------------
void AddColumnsOfCriteria(vtkTable* table)
{
  camaron::AddColumns<vtkStringArray>(
    table, { "Name", "Label", "Description", "Unit", "Dimension", "AppliesTo" });
  camaron::AddColumns<vtkDoubleArray>(table, { "RangeLow", "RangeHigh", "Ideal" });
  camaron::AddColumns<vtkStringArray>(table, { "Better" });
  camaron::AddColumns<vtkDoubleArray>(table, { "AcceptableLow", "AcceptableHigh" });
  camaron::AddColumns<vtkStringArray>(table, { "AcceptableSource" });
  camaron::AddColumns<vtkIntArray>(table, { "AcceptableIsHint" });
  camaron::AddColumns<vtkStringArray>(table, { "AcceptableFor" });
  camaron::AddColumns<vtkIntArray>(table, { "IsCurved" });
  camaron::AddColumns<vtkStringArray>(
    table, { "Family", "Formula", "Degenerate", "Agreement", "Curved", "Consequence" });
}

//------------------------------------------------------------------------------
void AddCriterion(camaron::TableRow& row, const camaron::Criterion& criterion)
{
  row.Add(criterion.Name, criterion.Label, criterion.Description, criterion.UnitLabel(),
    GetDimension(criterion.Unit), GetShapes(criterion.AppliesTo));
  row.Add(criterion.Range[0], criterion.Range[1], criterion.Ideal);
  row.Add(camaron::GetBetterName(criterion.Better));
  row.Add(criterion.Acceptable[0], criterion.Acceptable[1], criterion.AcceptableSource);
  row.Add(std::int64_t(criterion.AcceptableIsHint), GetShapes(criterion.AcceptableFor));
  row.Add(std::int64_t(criterion.IsCurved), criterion.Family);
  const camaron::CriterionNotes& notes = criterion.Notes;
  row.Add(notes.Formula, notes.Degenerate, notes.Agreement, notes.Curved, notes.Consequence);
}

//------------------------------------------------------------------------------
void ListCriteria(vtkTable* table)
{
  AddColumnsOfCriteria(table);
  for (const camaron::Criterion& criterion : camaron::GetCriteria())
  {
    camaron::TableRow row;
    AddCriterion(row, criterion);
    row.AppendTo(table);
  }
}

//------------------------------------------------------------------------------
void ListRanges(vtkTable* table, const std::vector<camaron::Preset::Rule>& rules)
{
  camaron::AddColumns<vtkStringArray>(table, { "Criterion" });
  camaron::AddColumns<vtkDoubleArray>(table, { "AcceptableLow", "AcceptableHigh" });
  for (const camaron::Preset::Rule& rule : rules)
  {
    camaron::TableRow row;
    row.Add(rule.Criterion, rule.Acceptable[0], rule.Acceptable[1]);
    row.AppendTo(table);
  }
}

//------------------------------------------------------------------------------
void ListRules(vtkTable* table)
{
  camaron::AddColumns<vtkStringArray>(table, { "Preset", "Description", "Criterion" });
  camaron::AddColumns<vtkDoubleArray>(table, { "AcceptableLow", "AcceptableHigh" });
  camaron::AddColumns<vtkIntArray>(table, { "AcceptableIsHint" });
  camaron::AddColumns<vtkStringArray>(table, { "AcceptableFor", "Rule" });
  for (const camaron::Preset& preset : camaron::GetPresets())
  {
    const std::vector<camaron::Rule> rules = camaron::GetRulesOfPreset(preset, {});
    auto next = rules.begin();
    for (const camaron::Preset::Rule& rule : preset.Rules)
    {
      const bool isChecked = next != rules.end() && next->Criterion == rule.Criterion;
      camaron::TableRow row;
      row.Add(preset.Name, preset.Description, rule.Criterion);
      row.Add(rule.Acceptable[0], rule.Acceptable[1], std::int64_t(rule.IsHint));
      row.Add(GetShapes(rule.AcceptableFor), isChecked ? (next++)->GetLineText() : std::string());
      row.AppendTo(table);
    }
  }
}

//------------------------------------------------------------------------------
void ListElementArrays(vtkTable* table)
{
  camaron::AddColumns<vtkStringArray>(table, { "Element", "Cells" });
  camaron::AddColumns<vtkIntArray>(table, { "IsDefault" });
  AddColumnsOfCriteria(table);
  for (const camaron::ElementTable& rows : camaron::GetElementTables())
  {
    for (std::size_t i = 0; i < rows.Arrays.size(); ++i)
    {
      const unsigned dimensions = rows.Arrays[i].Dimensions;
      camaron::TableRow row;
      row.Add(rows.Element,
        dimensions == camaron::OfPolygons      ? "2D"
          : dimensions == camaron::OfPolyhedra ? "3D"
                                               : "2D, 3D",
        std::int64_t(rows.Arrays[i].IsDefault));
      AddCriterion(row, rows.Criteria[i]);
      row.AppendTo(table);
    }
  }
}

//------------------------------------------------------------------------------
void ListDefects(vtkTable* table)
{
  camaron::AddColumns<vtkIntArray>(table, { "Bit" });
  camaron::AddColumns<vtkStringArray>(table, { "Name", "Description" });
  camaron::AddColumns<vtkIntArray>(table, { "Invalid" });
  for (const camaron::CellDefect& defect : camaron::CellDefects)
  {
    camaron::TableRow row;
    row.Add(
      std::int64_t(defect.Bit), defect.Name, defect.Description, std::int64_t(defect.IsInvalid));
    row.AppendTo(table);
  }
}
}

//------------------------------------------------------------------------------
vtkCriteriaTable::vtkCriteriaTable()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(5);
}

//------------------------------------------------------------------------------
// Else VTK would run the source on the first process only, where it would wait for the others to
// read the file.
int vtkCriteriaTable::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    outputVector->GetInformationObject(port)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkCriteriaTable::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  camaron::ControllerReducer reducer;
  ListCriteria(vtkTable::GetData(outputVector, 0));
  ListRules(vtkTable::GetData(outputVector, 1));
  int succeeds = 1;
  try
  {
    ListRanges(vtkTable::GetData(outputVector, 2),
      camaron::ReadRanges(this->Ranges, this->RangesFile, reducer));
    ListElementArrays(vtkTable::GetData(outputVector, 3));
    ListDefects(vtkTable::GetData(outputVector, 4));
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro("" << error.what() << '.');
    succeeds = 0;
  }
  for (int port = 0; port < this->GetNumberOfOutputPorts() && reducer.GetProcess() > 0; ++port)
  {
    vtkTable::GetData(outputVector, port)->SetNumberOfRows(0);
  }
  return succeeds;
}
