// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqInspectedMesh.h"

#include "InspectedMeshTypes.h"
#include "NumberText.h"
#include "ThresholdSelection.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqServer.h"
#include "pqServerManagerModel.h"

#include "vtkCommand.h"
#include "vtkPVDataInformation.h"
#include "vtkSMSessionProxyManager.h"

namespace
{
//------------------------------------------------------------------------------
// Information about the output of a port, without an update, which only Apply may cause; nullptr
// for a source that awaits it.
vtkPVDataInformation* GetApplied(pqOutputPort* port)
{
  pqPipelineSource* source = port ? port->getSource() : nullptr;
  return source && source->modifiedState() != pqProxy::UNINITIALIZED ? port->getDataInformation()
                                                                     : nullptr;
}

//------------------------------------------------------------------------------
// Whether criteria can be evaluated on the data.
bool IsMesh(vtkPVDataInformation* information)
{
  return information->GetNumberOfCells() > 0 &&
    (information->DataSetTypeIsA("vtkDataSet") || information->IsCompositeDataSet());
}

//------------------------------------------------------------------------------
// What may read the file of an empty source: ParaView opens any .msh with its reader of Fluent
// cases, which finds nothing in a mesh of Gmsh and does not say so, and Exodus with IOSS, which
// refuses polyhedra.
QString SpellOtherReader(pqPipelineSource* source)
{
  return camaron::IsFilter(source, "FLUENTReader")
    ? pqInspectedMesh::tr(" If the file is a Gmsh mesh, load ParaView's plugin GmshIO with "
                          "Tools > Manage Plugins, and open it with the Gmsh Reader.")
    : camaron::IsFilter(source, "IOSSReader")
    ? pqInspectedMesh::tr(" If the file has polyhedra, load ParaView's plugin LegacyExodusReader "
                          "with Tools > Manage Plugins, and open it with the Legacy Exodus II "
                          "Reader.")
    : QString();
}
}

//------------------------------------------------------------------------------
pqInspectedMesh::pqInspectedMesh(QObject* parent)
  : QObject(parent)
  , MeshOutput(nullptr)
{
  this->MeshTimer.setSingleShot(true);
  this->MeshTimer.setInterval(0);
  QObject::connect(&this->MeshTimer, &QTimer::timeout, this, &pqInspectedMesh::findMesh);
  this->Helpers.onRefused([this] { this->findLater(); });

  auto& active = pqActiveObjects::instance();
  QObject::connect(&active, &pqActiveObjects::portChanged, this, &pqInspectedMesh::findLater);
  QObject::connect(&active, &pqActiveObjects::dataUpdated, this, &pqInspectedMesh::findLater);
  QObject::connect(&active, &pqActiveObjects::serverChanged, this, &pqInspectedMesh::forget);

  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::connect(
    model, &pqServerManagerModel::modifiedStateChanged, this, &pqInspectedMesh::findLater);
  QObject::connect(model, &pqServerManagerModel::dataUpdated, this,
    [this](pqPipelineSource* source)
    {
      this->CellsVersion += this->CellsPort && this->CellsPort->getSource() == source ? 1 : 0;
      this->MeshVersion += this->MeshPort && this->MeshPort->getSource() == source ? 1 : 0;
    });
  QObject::connect(
    model, &pqServerManagerModel::aboutToRemoveServer, this, &pqInspectedMesh::forget);
  QObject::connect(model, &pqServerManagerModel::preSourceRemoved, this,
    [this](pqPipelineSource* source)
    {
      Q_EMIT this->aboutToRemove(source);
      this->Helpers.forget(source, this->CellsPort ? this->CellsPort->getSource() : nullptr);
      if (this->Port && this->Port->getSource() == source)
      {
        this->setPort(nullptr);
        this->findLater();
      }
    });
  this->findLater();
}

//------------------------------------------------------------------------------
void pqInspectedMesh::setFollowing(bool follows)
{
  this->IsFollowing = follows;
  if (follows)
  {
    this->findLater();
  }
  Q_EMIT this->followingChanged();
}

//------------------------------------------------------------------------------
void pqInspectedMesh::findMesh()
{
  if (!this->IsFollowing)
  {
    return;
  }
  if (this->isComputing())
  {
    this->findLater();
    return;
  }
  pqOutputPort* active = pqActiveObjects::instance().activePort();
  vtkPVDataInformation* information = GetApplied(active);
  if (active && !active->getSource()->proxyManager()->HasDefinition("sources", "CriteriaTable"))
  {
    this->setPort(nullptr);
    this->ReasonForNone =
      tr("The server has no plugin Camaron. Start pvserver with PV_PLUGIN_PATH set, or load the "
         "plugin with Tools > Manage Plugins.");
  }
  else if (information)
  {
    this->setPort(IsMesh(information) ? active : nullptr);
    const QString name = active->getSource()->getSMName();
    this->ReasonForNone = information->GetNumberOfPoints() == 0
      ? tr("%1 is empty.").arg(name) + SpellOtherReader(active->getSource())
      : information->DataSetTypeIsA("vtkDataSet")
      ? tr("%1 has no cells, only %2 points.")
          .arg(name, camaron::GroupedInteger(information->GetNumberOfPoints()))
      : tr("%1 is not a mesh.").arg(name);
  }
  else if (!active)
  {
    this->setPort(nullptr);
    this->ReasonForNone.clear();
  } // a source that awaits Apply leaves the mesh as it is
  this->followCells();
  this->SettingsConnector->Disconnect();
  if (vtkSMProxy* settings = MeshOutput::settings())
  {
    this->SettingsConnector->Connect(
      settings, vtkCommand::PropertyModifiedEvent, &this->MeshTimer, SLOT(start()));
  }
  Q_EMIT this->meshChanged();
}

//------------------------------------------------------------------------------
void pqInspectedMesh::followCells()
{
  pqOutputPort* cells = this->Port;
  while (cells && camaron::IsFilter(cells->getSource(), camaron::SelectName))
  {
    cells = camaron::GetInput(cells->getSource());
  }
  if (cells != this->CellsPort)
  {
    this->CellsPort = cells;
    ++this->CellsVersion;
    Q_EMIT this->cellsPortChanged();
  }
  pqOutputPort* mesh = cells;
  while (mesh &&
    (camaron::IsFilter(mesh->getSource(), "ElementQuality") ||
      camaron::IsFilter(mesh->getSource(), "MeshElements") ||
      camaron::IsFilter(mesh->getSource(), camaron::SelectName))) // of cells, before their faces
  {
    mesh = camaron::GetInput(mesh->getSource());
  }
  if (mesh != this->MeshPort || this->elementType() != this->MeshElements)
  {
    this->MeshPort = mesh;
    this->MeshElements = this->elementType();
    ++this->MeshVersion;
  }
}

//------------------------------------------------------------------------------
void pqInspectedMesh::setPort(pqOutputPort* port)
{
  if (port != this->Port)
  {
    this->Port = port;
    if (port) // else perhaps a step of selection was removed
    {
      this->followCells();
    }
    Q_EMIT this->portChanged();
  }
}

//------------------------------------------------------------------------------
void pqInspectedMesh::forget()
{
  this->Helpers.clear();
  this->setPort(nullptr);
  Q_EMIT this->forgotten();
  this->findLater();
}

//------------------------------------------------------------------------------
QString pqInspectedMesh::reasonForNone() const
{
  return this->ReasonForNone.isEmpty()
    ? tr("Open a mesh and click Apply; its quality appears here.")
    : this->ReasonForNone;
}

//------------------------------------------------------------------------------
pqServer* pqInspectedMesh::server() const
{
  return pqActiveObjects::instance().activeServer();
}
