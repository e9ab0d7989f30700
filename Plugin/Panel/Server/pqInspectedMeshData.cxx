// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What the client knows of the data: counts, bounds, names of arrays.
#include "pqInspectedMesh.h"

#include "ProxyValues.h"

#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqServer.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMSessionProxyManager.h"

#include <cmath>

namespace
{
constexpr const char* SettingsName = "MeshInspectorSettings";
constexpr const char* SelectedName = "Selected"; // see vtkSelectElements

// Whether the values can be categories, as far as their range tells: whole numbers, and not as many
// as there are ids.
bool IsCategory(vtkPVArrayInformation& array, vtkTypeInt64 numberOfCells)
{
  if (array.GetDataType() == VTK_STRING)
  {
    return false;
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
vtkPVDataInformation* pqInspectedMesh::information() const
{
  return this->Port ? this->Port->getDataInformation() : nullptr;
}

//------------------------------------------------------------------------------
camaron::MeshSummary pqInspectedMesh::summary() const
{
  if (this->Summary)
  {
    return *this->Summary;
  }
  camaron::MeshSummary summary;
  summary.Bounds = { 1, -1, 1, -1, 1, -1 };
  if (vtkPVDataInformation* information = this->information())
  {
    summary.Name = (this->MeshPort ? this->MeshPort : this->Port)->getSource()->getSMName();
    summary.Step = this->Port->getSource()->getSMName();
    summary.Step = summary.Step == summary.Name ? QString() : summary.Step;
    const bool hasGhosts = this->cellArrays().contains("vtkGhostType");
    summary.Cells = hasGhosts ? this->count("All", "Cells") : information->GetNumberOfCells();
    summary.Points = hasGhosts ? this->count("All", "Points") : information->GetNumberOfPoints();
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
QStringList pqInspectedMesh::cellArrays() const
{
  QStringList names;
  if (vtkPVDataInformation* information = this->information())
  {
    auto* arrays = information->GetCellDataInformation();
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      vtkPVArrayInformation* array = arrays->GetArrayInformation(i);
      if (array->GetName() && array->GetNumberOfComponents() == 1)
      {
        names << QString::fromUtf8(array->GetName());
      }
    }
  }
  return names;
}

//------------------------------------------------------------------------------
QString pqInspectedMesh::idSpace() const
{
  vtkPVDataInformation* information = this->information();
  const bool hasIds = information &&
    information->GetCellDataInformation()->GetAttributeInformation(vtkDataSetAttributes::GLOBALIDS);
  return hasIds ? "Global id" : "Index";
}

//------------------------------------------------------------------------------
QStringList pqInspectedMesh::evaluated() const
{
  const QStringList arrays = this->cellArrays();
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
QString pqInspectedMesh::worstCriterion() const
{
  const QStringList names = this->evaluated();
  vtkPVDataInformation* information = this->information();
  vtkPVArrayInformation* active = information
    ? information->GetCellDataInformation()->GetAttributeInformation(vtkDataSetAttributes::SCALARS)
    : nullptr;
  const QString name = active ? QString::fromUtf8(active->GetName()) : QString();
  return names.contains(name) ? name : names.value(0);
}

//------------------------------------------------------------------------------
QStringList pqInspectedMesh::otherArrays() const
{
  QStringList names = this->cellArrays();
  names.removeIf(
    [this](const QString& name)
    {
      auto* array =
        this->information()->GetArrayInformation(name.toUtf8().constData(), vtkDataObject::CELL);
      return this->criterion(name) || name == SelectedName || name.startsWith("vtk") || !array ||
        array->GetDataType() == VTK_STRING; // which has groups, but no numbers
    });
  return names;
}

//------------------------------------------------------------------------------
QStringList pqInspectedMesh::groupArrays() const
{
  QStringList names;
  for (const QString& array : this->cellArrays())
  {
    vtkPVArrayInformation* information = this->Port->getDataInformation()->GetArrayInformation(
      array.toUtf8().constData(), vtkDataObject::CELL);
    if (information && IsCategory(*information, this->information()->GetNumberOfCells()) &&
      !this->criterion(array) && !array.startsWith("vtk"))
    {
      names << array;
    }
  }
  return names;
}

//------------------------------------------------------------------------------
bool pqInspectedMesh::isSmall() const
{
  vtkPVDataInformation* information = this->information();
  return information && information->GetNumberOfCells() <= this->automaticLimit();
}

//------------------------------------------------------------------------------
vtkSMProxy* pqInspectedMesh::settings() const
{
  pqServer* server = this->server();
  return server ? server->proxyManager()->GetProxy("settings", SettingsName) : nullptr;
}

//------------------------------------------------------------------------------
qint64 pqInspectedMesh::automaticLimit() const
{
  return camaron::GetProperty(this->settings(), "AutomaticLimit").toLongLong();
}
