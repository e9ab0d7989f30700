// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The server's tables of criteria and presets, and what the client knows of the data.
#include "pqMeshQuestions.h"

#include "MarkedElements.h"
#include "pqInspectedMesh.h"

#include "pqActiveObjects.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqServer.h"

#include "vtkDataSetAttributes.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"

#include <cmath>

namespace
{
using camaron::PanelTable;

//------------------------------------------------------------------------------
// Of tables of cells or of elements.
camaron::CriterionInfo ReadCriterion(const PanelTable& table, int row)
{
  camaron::CriterionInfo info;
  info.Element = "Cell";
  info.Name = table.text(row, "Name");
  info.Label = table.text(row, "Label");
  info.Family = table.text(row, "Family");
  info.Unit = table.text(row, "Unit");
  info.AppliesTo = table.text(row, "AppliesTo");
  info.Description = table.text(row, "Description");
  info.Consequence = table.text(row, "Consequence");
  info.AcceptableFor = table.text(row, "AcceptableFor");
  info.Source = table.text(row, "AcceptableSource");
  info.Ideal = table.number(row, "Ideal");
  info.Low = table.number(row, "AcceptableLow");
  info.High = table.number(row, "AcceptableHigh");
  info.IsHint = table.integer(row, "AcceptableIsHint") != 0;
  info.IsCurved = table.integer(row, "IsCurved") != 0;
  const QString better = table.text(row, "Better");
  info.Better = better == "Bigger" ? 1 : better == "Smaller" ? -1 : 0;
  return info;
}

constexpr const char* SelectedName = "Selected"; // see vtkSelectElements

// Whether the values can be categories, as far as their range tells: texts, or whole numbers, and
// not as many as there are ids.
bool IsCategory(vtkPVArrayInformation& array, vtkTypeInt64 numberOfCells)
{
  if (array.GetDataType() == VTK_STRING)
  {
    return true;
  }
  constexpr double mostGroups = 1000; // of Quality Statistics
  const double* range = array.GetComponentRange(0);
  const bool isWhole = std::floor(range[0]) == range[0] && std::floor(range[1]) == range[1];
  const bool isInteger = array.GetDataType() != VTK_FLOAT && array.GetDataType() != VTK_DOUBLE;
  const double size = range[1] - range[0] + 1;
  return size <= mostGroups ? isWhole
                            : isInteger && size < 0.5 * static_cast<double>(numberOfCells);
}
}

//------------------------------------------------------------------------------
pqMeshQuestions::pqMeshQuestions(pqInspectedMesh* mesh, QObject* parent)
  : QObject(parent)
  , Mesh(mesh)
{
  const auto forgetSummary = [this] { this->Summary.reset(); };
  QObject::connect(mesh, &pqInspectedMesh::portChanged, this, forgetSummary);
  QObject::connect(mesh, &pqInspectedMesh::meshChanged, this, forgetSummary);
  QObject::connect(mesh, &pqInspectedMesh::forgotten, this,
    [this]
    {
      this->Registry.clear();
      this->Criteria.clear();
      this->Presets.clear();
    });
  QObject::connect(&pqActiveObjects::instance(), &pqActiveObjects::serverChanged, this,
    &pqMeshQuestions::registryChanged);
}

//------------------------------------------------------------------------------
const camaron::PanelTable& pqMeshQuestions::registry(int port) const
{
  static const PanelTable none;
  if (!this->Registry.contains(port))
  {
    const camaron::Helper table = this->Mesh->helpers().get("sources", "CriteriaTable");
    if (!table)
    {
      return none;
    }
    const PanelTable found = this->Mesh->helpers().fetch(table, port);
    if (found.isEmpty())
    {
      return none;
    }
    this->Registry[port] = found;
  }
  return this->Registry[port];
}

//------------------------------------------------------------------------------
const QVector<camaron::CriterionInfo>& pqMeshQuestions::criteria() const
{
  if (this->Criteria.isEmpty() && pqActiveObjects::instance().activeServer())
  {
    const PanelTable& cells = this->registry(0);
    for (int row = 0; row < cells.size(); ++row)
    {
      this->Criteria << ReadCriterion(cells, row);
    }
    const PanelTable& elements = this->registry(3);
    for (int row = 0; row < elements.size(); ++row)
    {
      camaron::CriterionInfo info = ReadCriterion(elements, row);
      info.Element = elements.text(row, "Element");
      info.AppliesTo = elements.text(row, "Cells");
      this->Criteria << info;
    }
  }
  return this->Criteria;
}

//------------------------------------------------------------------------------
const camaron::CriterionInfo* pqMeshQuestions::criterion(const QString& name) const
{
  const QString type = this->Mesh->elementType();
  const camaron::CriterionInfo* found = nullptr;
  for (const camaron::CriterionInfo& info : this->criteria())
  {
    if (info.Name == name && (!found || (info.Element == type && found->Element != type)))
    {
      found = &info;
    }
  }
  return found;
}

//------------------------------------------------------------------------------
const QVector<camaron::PresetInfo>& pqMeshQuestions::presets() const
{
  if (this->Presets.isEmpty() && pqActiveObjects::instance().activeServer())
  {
    const PanelTable& rules = this->registry(1);
    for (int row = 0; row < rules.size(); ++row)
    {
      const QString name = rules.text(row, "Preset");
      if (this->Presets.isEmpty() || this->Presets.back().Name != name)
      {
        this->Presets << camaron::PresetInfo{ name, rules.text(row, "Description"), {}, {}, {} };
      }
      this->Presets.back().Criteria << rules.text(row, "Criterion");
      this->Presets.back().Shapes << rules.text(row, "AcceptableFor");
      const QString line = rules.text(row, "Rule");
      if (!line.isEmpty())
      {
        const bool isHint = rules.integer(row, "AcceptableIsHint") != 0;
        this->Presets.back().Rules << (isHint ? line + " # hint" : line);
      }
    }
  }
  return this->Presets;
}

//------------------------------------------------------------------------------
camaron::MeshSummary pqMeshQuestions::summary() const
{
  if (this->Summary)
  {
    return *this->Summary;
  }
  camaron::MeshSummary summary;
  summary.Bounds = { 1, -1, 1, -1, 1, -1 };
  if (vtkPVDataInformation* information = this->Mesh->information())
  {
    summary.Name = (this->Mesh->meshPort() ? this->Mesh->meshPort() : this->Mesh->port())
                     ->getSource()
                     ->getSMName();
    summary.Step = this->Mesh->port()->getSource()->getSMName();
    summary.Step = summary.Step == summary.Name ? QString() : summary.Step;
    const bool hasGhosts = this->Mesh->cellArrays().contains("vtkGhostType");
    summary.Cells = hasGhosts ? camaron::CountElements(*this->Mesh, "All", "Cells")
                              : information->GetNumberOfCells();
    summary.Points = hasGhosts ? camaron::CountElements(*this->Mesh, "All", "Points")
                               : information->GetNumberOfPoints();
    summary.Memory = information->GetMemorySize();
    summary.Blocks = information->IsCompositeDataSet()
      ? static_cast<qint64>(information->GetNumberOfDataSets())
      : 0;
    information->GetBounds(summary.Bounds.data());
  }
  this->Summary = summary;
  return summary;
}

//------------------------------------------------------------------------------
QStringList pqMeshQuestions::evaluated() const
{
  const QStringList arrays = this->Mesh->cellArrays();
  QStringList names;
  for (const camaron::CriterionInfo& criterion : this->criteria())
  {
    if (arrays.contains(criterion.Name) && !names.contains(criterion.Name))
    {
      names << criterion.Name;
    }
  }
  return names;
}

//------------------------------------------------------------------------------
QString pqMeshQuestions::worstCriterion() const
{
  const QStringList names = this->evaluated();
  vtkPVDataInformation* information = this->Mesh->information();
  vtkPVArrayInformation* active = information
    ? information->GetCellDataInformation()->GetAttributeInformation(vtkDataSetAttributes::SCALARS)
    : nullptr;
  const QString name = active ? QString::fromUtf8(active->GetName()) : QString();
  return names.contains(name) ? name : names.value(0);
}

//------------------------------------------------------------------------------
QStringList pqMeshQuestions::otherArrays() const
{
  QStringList names = this->Mesh->cellArrays();
  names.removeIf(
    [this](const QString& name)
    {
      vtkPVArrayInformation* array = this->Mesh->array(name);
      return this->criterion(name) || name == SelectedName || name.startsWith("vtk") || !array ||
        array->GetDataType() == VTK_STRING; // which has groups, but no numbers
    });
  return names;
}

//------------------------------------------------------------------------------
QStringList pqMeshQuestions::groupArrays() const
{
  QStringList names;
  for (const QString& array : this->Mesh->cellArrays())
  {
    vtkPVArrayInformation* information = this->Mesh->array(array);
    if (information && IsCategory(*information, this->Mesh->information()->GetNumberOfCells()) &&
      !this->criterion(array) && !array.startsWith("vtk"))
    {
      names << array;
    }
  }
  return names;
}
