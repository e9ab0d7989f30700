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

namespace
{
constexpr const char* SettingsName = "MeshInspectorSettings";
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
    summary.Name = this->Port->getSource()->getSMName();
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
QStringList pqInspectedMesh::groupArrays() const
{
  QStringList names;
  for (const QString& array : this->cellArrays())
  {
    vtkPVArrayInformation* information = this->Port->getDataInformation()->GetArrayInformation(
      array.toUtf8().constData(), vtkDataObject::CELL);
    const bool isText = information && information->GetDataType() == VTK_STRING;
    if (!isText && !this->criterion(array) && !array.startsWith("vtk"))
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
