// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCriteriaTable.h"

#include "AcceptableRanges.h"
#include "Cell/CellDefects.h"
#include "ControllerReducer.h"
#include "Elements/ElementCriteria.h"
#include "Rules/ParsedRules.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <exception>
#include <string>

vtkStandardNewMacro(vtkCriteriaTable);

namespace
{
//------------------------------------------------------------------------------
template <typename Array>
Array* AddColumn(vtkTable* table, const char* name)
{
  vtkNew<Array> column;
  column->SetName(name);
  table->AddColumn(column);
  return column;
}

//------------------------------------------------------------------------------
const char* GetDimension(enum camaron::Unit unit)
{
  switch (unit)
  {
    case camaron::Unit::Length:
      return "Length";
    case camaron::Unit::Area:
      return "Area";
    case camaron::Unit::Volume:
      return "Volume";
    default:
      return "";
  }
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
const char* GetBetter(camaron::Better better)
{
  switch (better)
  {
    case camaron::Better::Smaller:
      return "Smaller";
    case camaron::Better::Bigger:
      return "Bigger";
    default:
      return "Neither";
  }
}

//------------------------------------------------------------------------------
void ListCriteria(vtkTable* table, const std::vector<camaron::Criterion>& criteria)
{
  auto* name = AddColumn<vtkStringArray>(table, "Name");
  auto* label = AddColumn<vtkStringArray>(table, "Label");
  auto* description = AddColumn<vtkStringArray>(table, "Description");
  auto* unit = AddColumn<vtkStringArray>(table, "Unit");
  auto* dimension = AddColumn<vtkStringArray>(table, "Dimension");
  auto* appliesTo = AddColumn<vtkStringArray>(table, "AppliesTo");
  auto* rangeLow = AddColumn<vtkDoubleArray>(table, "RangeLow");
  auto* rangeHigh = AddColumn<vtkDoubleArray>(table, "RangeHigh");
  auto* ideal = AddColumn<vtkDoubleArray>(table, "Ideal");
  auto* better = AddColumn<vtkStringArray>(table, "Better");
  auto* low = AddColumn<vtkDoubleArray>(table, "AcceptableLow");
  auto* high = AddColumn<vtkDoubleArray>(table, "AcceptableHigh");
  auto* source = AddColumn<vtkStringArray>(table, "AcceptableSource");
  auto* isHint = AddColumn<vtkIntArray>(table, "AcceptableIsHint");
  auto* acceptableFor = AddColumn<vtkStringArray>(table, "AcceptableFor");
  auto* isCurved = AddColumn<vtkIntArray>(table, "IsCurved");
  auto* family = AddColumn<vtkStringArray>(table, "Family");
  auto* formula = AddColumn<vtkStringArray>(table, "Formula");
  auto* degenerate = AddColumn<vtkStringArray>(table, "Degenerate");
  auto* agreement = AddColumn<vtkStringArray>(table, "Agreement");
  auto* curved = AddColumn<vtkStringArray>(table, "Curved");
  auto* consequence = AddColumn<vtkStringArray>(table, "Consequence");
  for (const camaron::Criterion& criterion : criteria)
  {
    name->InsertNextValue(criterion.Name);
    label->InsertNextValue(criterion.Label);
    description->InsertNextValue(criterion.Description);
    unit->InsertNextValue(criterion.UnitLabel());
    dimension->InsertNextValue(GetDimension(criterion.Unit));
    appliesTo->InsertNextValue(GetShapes(criterion.AppliesTo));
    rangeLow->InsertNextValue(criterion.Range[0]);
    rangeHigh->InsertNextValue(criterion.Range[1]);
    ideal->InsertNextValue(criterion.Ideal);
    better->InsertNextValue(GetBetter(criterion.Better));
    low->InsertNextValue(criterion.Acceptable[0]);
    high->InsertNextValue(criterion.Acceptable[1]);
    source->InsertNextValue(criterion.AcceptableSource);
    isHint->InsertNextValue(criterion.AcceptableIsHint ? 1 : 0);
    acceptableFor->InsertNextValue(GetShapes(criterion.AcceptableFor));
    isCurved->InsertNextValue(criterion.IsCurved ? 1 : 0);
    family->InsertNextValue(criterion.Family);
    formula->InsertNextValue(criterion.Notes.Formula);
    degenerate->InsertNextValue(criterion.Notes.Degenerate);
    agreement->InsertNextValue(criterion.Notes.Agreement);
    curved->InsertNextValue(criterion.Notes.Curved);
    consequence->InsertNextValue(criterion.Notes.Consequence);
  }
}

//------------------------------------------------------------------------------
void ListRanges(vtkTable* table, const std::vector<camaron::Preset::Rule>& rules)
{
  auto* criterion = AddColumn<vtkStringArray>(table, "Criterion");
  auto* low = AddColumn<vtkDoubleArray>(table, "AcceptableLow");
  auto* high = AddColumn<vtkDoubleArray>(table, "AcceptableHigh");
  for (const camaron::Preset::Rule& rule : rules)
  {
    criterion->InsertNextValue(rule.Criterion);
    low->InsertNextValue(rule.Acceptable[0]);
    high->InsertNextValue(rule.Acceptable[1]);
  }
}

//------------------------------------------------------------------------------
void ListRules(vtkTable* table, const std::vector<camaron::Preset>& presets)
{
  auto* name = AddColumn<vtkStringArray>(table, "Preset");
  auto* description = AddColumn<vtkStringArray>(table, "Description");
  auto* criterion = AddColumn<vtkStringArray>(table, "Criterion");
  auto* low = AddColumn<vtkDoubleArray>(table, "AcceptableLow");
  auto* high = AddColumn<vtkDoubleArray>(table, "AcceptableHigh");
  auto* isHint = AddColumn<vtkIntArray>(table, "AcceptableIsHint");
  auto* acceptableFor = AddColumn<vtkStringArray>(table, "AcceptableFor");
  auto* line = AddColumn<vtkStringArray>(table, "Rule");
  for (const camaron::Preset& preset : presets)
  {
    const std::vector<camaron::Rule> rules = camaron::GetRulesOfPreset(preset, {});
    auto next = rules.begin();
    for (const camaron::Preset::Rule& rule : preset.Rules)
    {
      name->InsertNextValue(preset.Name);
      description->InsertNextValue(preset.Description);
      criterion->InsertNextValue(rule.Criterion);
      low->InsertNextValue(rule.Acceptable[0]);
      high->InsertNextValue(rule.Acceptable[1]);
      isHint->InsertNextValue(rule.IsHint ? 1 : 0);
      acceptableFor->InsertNextValue(GetShapes(rule.AcceptableFor));
      const bool isChecked = next != rules.end() && next->Criterion == rule.Criterion;
      line->InsertNextValue(isChecked ? (next++)->GetLineText() : std::string());
    }
  }
}

//------------------------------------------------------------------------------
void ListElementArrays(vtkTable* table, bool isRoot)
{
  // Columns of a table must have the same number of rows when another one is added.
  auto* element = AddColumn<vtkStringArray>(table, "Element");
  auto* cells = AddColumn<vtkStringArray>(table, "Cells");
  auto* isDefault = AddColumn<vtkIntArray>(table, "IsDefault");
  std::vector<camaron::Criterion> criteria;
  for (const camaron::ElementTable& rows : camaron::GetElementTables())
  {
    criteria.insert(criteria.end(), rows.Criteria.begin(), rows.Criteria.end());
  }
  ListCriteria(table, isRoot ? criteria : std::vector<camaron::Criterion>());
  for (const camaron::ElementTable& rows : camaron::GetElementTables())
  {
    for (const camaron::ElementArray& row :
      isRoot ? rows.Arrays : std::vector<camaron::ElementArray>())
    {
      element->InsertNextValue(rows.Element);
      cells->InsertNextValue(row.Dimensions == camaron::OfPolygons ? "2D"
          : row.Dimensions == camaron::OfPolyhedra                 ? "3D"
                                                                   : "2D, 3D");
      isDefault->InsertNextValue(row.IsDefault ? 1 : 0);
    }
  }
}

//------------------------------------------------------------------------------
void ListDefects(vtkTable* table, bool isRoot)
{
  auto* bit = AddColumn<vtkIntArray>(table, "Bit");
  auto* name = AddColumn<vtkStringArray>(table, "Name");
  auto* description = AddColumn<vtkStringArray>(table, "Description");
  auto* invalid = AddColumn<vtkIntArray>(table, "Invalid");
  for (const camaron::CellDefect& defect : camaron::CellDefects)
  {
    if (isRoot)
    {
      bit->InsertNextValue(static_cast<int>(defect.Bit));
      name->InsertNextValue(defect.Name);
      description->InsertNextValue(defect.Description);
      invalid->InsertNextValue(defect.IsInvalid ? 1 : 0);
    }
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
  const bool isRoot = reducer.GetProcess() == 0;
  vtkTable* criteria = vtkTable::GetData(outputVector, 0);
  vtkTable* rules = vtkTable::GetData(outputVector, 1);
  ListCriteria(criteria, isRoot ? camaron::GetCriteria() : std::vector<camaron::Criterion>());
  ListRules(rules, isRoot ? camaron::GetPresets() : std::vector<camaron::Preset>());
  std::vector<camaron::Preset::Rule> ranges;
  try
  {
    ranges = camaron::ReadRanges(this->Ranges, this->RangesFile, reducer);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro("" << error.what() << '.');
    return 0;
  }
  ListRanges(
    vtkTable::GetData(outputVector, 2), isRoot ? ranges : std::vector<camaron::Preset::Rule>());
  ListElementArrays(vtkTable::GetData(outputVector, 3), isRoot);
  ListDefects(vtkTable::GetData(outputVector, 4), isRoot);
  return 1;
}
