// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqInspectedMesh.h"

#include "NumberText.h"
#include "ProxyValues.h"
#include "ThresholdSelection.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqSelectionManager.h"
#include "pqServer.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"

#include "vtkCommand.h"
#include "vtkPVDataInformation.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"

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
}

//------------------------------------------------------------------------------
pqInspectedMesh* pqInspectedMesh::instance()
{
  static QPointer<pqInspectedMesh> mesh;
  if (!mesh)
  {
    mesh = new pqInspectedMesh(pqApplicationCore::instance());
  }
  return mesh;
}

//------------------------------------------------------------------------------
pqInspectedMesh::pqInspectedMesh(QObject* parent)
  : QObject(parent)
{
  for (pqTimer* timer : { &this->MeshTimer, &this->DisplayTimer, &this->SelectionTimer })
  {
    timer->setSingleShot(true);
    timer->setInterval(0);
  }
  QObject::connect(&this->MeshTimer, &QTimer::timeout, this, &pqInspectedMesh::findMesh);
  QObject::connect(&this->DisplayTimer, &QTimer::timeout, this,
    [this]
    {
      this->showSelectionThrough();
      Q_EMIT this->displayChanged();
    });
  QObject::connect(&this->SelectionTimer, &QTimer::timeout, this,
    [this]
    {
      if (this->isComputing() || this->MeshTimer.isActive())
      {
        this->SelectionTimer.start();
        return;
      }
      this->rememberSelection();
      this->showSelectionThrough();
      Q_EMIT this->selectionChanged();
    });

  this->Helpers.onRefused([this] { this->MeshTimer.start(); });

  auto& active = pqActiveObjects::instance();
  const auto findLater = [this] { this->MeshTimer.start(); };
  QObject::connect(&active, &pqActiveObjects::portChanged, this, findLater);
  QObject::connect(&active, &pqActiveObjects::dataUpdated, this, findLater);
  QObject::connect(&active, &pqActiveObjects::viewChanged, this, &pqInspectedMesh::followDisplay);
  QObject::connect(&active, &pqActiveObjects::serverChanged, this,
    [this]
    {
      this->forget();
      Q_EMIT this->registryChanged();
    });
  QObject::connect(&active,
    QOverload<pqDataRepresentation*>::of(&pqActiveObjects::representationChanged), this,
    &pqInspectedMesh::followDisplay);

  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::connect(model, &pqServerManagerModel::modifiedStateChanged, this, findLater);
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
      pqPipelineSource* cells = this->CellsPort ? this->CellsPort->getSource() : nullptr;
      if (source == cells)
      {
        this->Marker.hide();
      }
      this->Helpers.forget(source, cells);
      this->Past.removeIf([source](const camaron::PastSelection& past)
        { return !past.Port || past.Port->getSource() == source; });
      if (this->Port && this->Port->getSource() == source)
      {
        this->IsStepRemoved = camaron::IsFilter(source, camaron::SelectName);
        this->Shining.hide();
        this->setPort(nullptr);
        this->MeshTimer.start();
      }
    });
  if (pqUndoStack* undo = pqApplicationCore::instance()->getUndoStack())
  {
    for (const auto signal : { &pqUndoStack::undone, &pqUndoStack::redone })
    { // perhaps the color maps
      QObject::connect(undo, signal, this, [this] { this->Colored.clear(); });
    }
  }
  if (pqSelectionManager* manager = camaron::GetSelectionManager())
  {
    QObject::connect(manager, &pqSelectionManager::selectionChanged, this,
      [this] { this->SelectionTimer.start(); });
  }
  this->MeshTimer.start();
}

//------------------------------------------------------------------------------
pqInspectedMesh::~pqInspectedMesh() = default;

//------------------------------------------------------------------------------
void pqInspectedMesh::setFollowing(bool follows)
{
  this->IsFollowing = follows;
  if (follows)
  {
    this->MeshTimer.start();
  }
  else
  {
    this->Shining.hide();
  }
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
    this->MeshTimer.start();
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
    this->ReasonForNone = information->GetNumberOfPoints() == 0 ? tr("%1 is empty.").arg(name)
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
  if (vtkSMProxy* settings = this->settings())
  {
    this->SettingsConnector->Connect(
      settings, vtkCommand::PropertyModifiedEvent, &this->MeshTimer, SLOT(start()));
  }
  this->Summary.reset();
  this->restoreSelection();
  this->followDisplay();
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
    this->Marker.hide(); // it is of other cells
  }
  pqOutputPort* mesh = cells;
  while (mesh &&
    (camaron::IsFilter(mesh->getSource(), "ElementQuality") ||
      camaron::IsFilter(mesh->getSource(), "MeshElements")))
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
    this->Summary.reset();
    this->SelectionTimer.start();
    if (port) // else perhaps a step of selection was removed
    {
      this->followCells();
    }
  }
}

//------------------------------------------------------------------------------
void pqInspectedMesh::forget()
{
  this->Helpers.clear();
  this->Registry.clear();
  this->Criteria.clear();
  this->Presets.clear();
  this->setPort(nullptr);
  this->Colored.clear();
  this->BeforeFlight.reset();
  this->Past.clear();
  this->Brushed = {};
  this->SelectionBefore = {};
  this->Marker.hide();
  this->Shining.hide();
  this->MeshTimer.start();
}

//------------------------------------------------------------------------------
pqOutputPort* pqInspectedMesh::port() const
{
  return this->Port;
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
