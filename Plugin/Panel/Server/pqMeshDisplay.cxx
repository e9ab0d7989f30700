// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Display of the inspected mesh in the active view.
#include "pqMeshDisplay.h"

#include "ElementMarker.h"
#include "LargeSelection.h"
#include "MarkedElements.h"
#include "MeshCamera.h"
#include "MeshColors.h"
#include "ProxyValues.h"
#include "ThresholdSelection.h"
#include "pqInspectedMesh.h"
#include "pqMeshSelection.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqDataRepresentation.h"
#include "pqInteractivePropertyWidgetAbstract.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "pqUndoStack.h"

#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkEventQtSlotConnect.h"
#include "vtkNew.h"
#include "vtkPVArrayInformation.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMStringListDomain.h"
#include "vtkWeakPointer.h"

#include <QEvent>
#include <QPointer>
#include <QWidget>
#include <pqTimer.h>

#include <algorithm>

namespace
{
constexpr qint64 MostShining = 100000; // MostCells of the overlay

//------------------------------------------------------------------------------
// The shape of the cut; nullptr if the mesh is not shown.
vtkSMProxy* GetCut(pqDataRepresentation* shown)
{
  vtkSMProperty* shape = shown ? shown->getProxy()->GetProperty("CutShape") : nullptr;
  return shape ? vtkSMPropertyHelper(shape).GetAsProxy() : nullptr;
}
}

//------------------------------------------------------------------------------
class pqMeshDisplay::Internals
{
public:
  /// A proxy whose changes are changes of the display.
  struct Followed
  {
    vtkWeakPointer<vtkSMProxy> Proxy;
    vtkNew<vtkEventQtSlotConnect> Connector;
  };

  Internals(pqInspectedMesh* mesh, pqMeshQuestions* questions, pqMeshDisplay* display)
    : Colors(mesh, questions)
    , Camera(mesh, display)
  {
  }

  void Follow(Followed& followed, vtkSMProxy* proxy)
  {
    if (proxy != followed.Proxy)
    {
      followed.Proxy = proxy;
      followed.Connector->Disconnect();
      if (proxy)
      {
        followed.Connector->Connect(
          proxy, vtkCommand::PropertyModifiedEvent, &this->DisplayTimer, SLOT(start()));
      }
    }
  }

  pqTimer DisplayTimer;
  QPointer<pqDataRepresentation> Shown;
  Followed Display, Cut, Map, Legend;
  camaron::MeshColors Colors;
  camaron::MeshCamera Camera;
  camaron::ElementMarker Shining{ "ElementOverlay" }; // what is selected
  camaron::LargeSelection Emphasized;                 // if that is much
};

//------------------------------------------------------------------------------
pqMeshDisplay::pqMeshDisplay(
  pqInspectedMesh* mesh, pqMeshQuestions* questions, pqMeshSelection* selection, QObject* parent)
  : QObject(parent)
  , Mesh(mesh)
  , Selection(selection)
  , Internal(std::make_unique<Internals>(mesh, questions, this))
{
  this->Internal->DisplayTimer.setSingleShot(true);
  this->Internal->DisplayTimer.setInterval(0);
  QObject::connect(&this->Internal->DisplayTimer, &QTimer::timeout, this,
    [this]
    {
      // Its handles, the Properties panel and scripts move it, too.
      this->Internal->Follow(this->Internal->Cut, GetCut(this->Mesh->representation()));
      this->Internal->Follow(this->Internal->Map, this->Internal->Colors.map());
      this->Internal->Follow(this->Internal->Legend,
        this->Internal->Colors.updateLegend()); // the user hides and shows it
      this->showSelection();
      Q_EMIT this->displayChanged();
    });
  QObject::connect(
    selection, &pqMeshSelection::selectionChanged, this, &pqMeshDisplay::showSelection);

  auto& active = pqActiveObjects::instance();
  QObject::connect(&active, &pqActiveObjects::viewChanged, this, &pqMeshDisplay::followDisplay);
  QObject::connect(&active,
    QOverload<pqDataRepresentation*>::of(&pqActiveObjects::representationChanged), this,
    &pqMeshDisplay::followDisplay);
  QObject::connect(mesh, &pqInspectedMesh::meshChanged, this,
    [this]
    {
      this->Internal->Colors.refit(); // perhaps another time step
      this->followDisplay();
    });
  QObject::connect(
    mesh, &pqInspectedMesh::cellsPortChanged, this, [this] { this->Internal->Camera.unmark(); });
  QObject::connect(mesh, &pqInspectedMesh::followingChanged, this, &pqMeshDisplay::showSelection);
  QObject::connect(mesh, &pqInspectedMesh::aboutToRemove, this,
    [this](pqPipelineSource* source)
    {
      const auto isOf = [source](pqOutputPort* port)
      { return port && port->getSource() == source; };
      if (isOf(this->Mesh->cellsPort()))
      {
        this->Internal->Camera.unmark();
      }
      if (isOf(this->Mesh->port()))
      {
        this->Internal->Shining.hide();
        this->Internal->Emphasized.hide();
      }
    });
  QObject::connect(mesh, &pqInspectedMesh::forgotten, this,
    [this]
    {
      this->Internal->Colors.forget();
      this->Internal->Camera.forget();
      this->Internal->Shining.hide();
      this->Internal->Emphasized.hide();
    });
  if (pqUndoStack* undo = pqApplicationCore::instance()->getUndoStack())
  {
    for (const auto signal : { &pqUndoStack::undone, &pqUndoStack::redone })
    { // perhaps the color maps
      QObject::connect(undo, signal, this,
        [this]
        {
          this->Internal->Colors.forgetUndone();
          this->Internal->DisplayTimer.start();
        });
    }
  }
}

//------------------------------------------------------------------------------
pqMeshDisplay::~pqMeshDisplay() = default;

//------------------------------------------------------------------------------
camaron::MeshColors& pqMeshDisplay::colors()
{
  return this->Internal->Colors;
}

//------------------------------------------------------------------------------
camaron::MeshCamera& pqMeshDisplay::camera()
{
  return this->Internal->Camera;
}

//------------------------------------------------------------------------------
void pqMeshDisplay::followDisplay()
{
  pqDataRepresentation* shown = this->Mesh->representation();
  if (shown != this->Internal->Shown)
  {
    if (this->Internal->Shown)
    {
      QObject::disconnect(this->Internal->Shown, nullptr, this, nullptr);
    }
    this->Internal->Shown = shown;
    this->Internal->Follow(this->Internal->Display, shown ? shown->getProxy() : nullptr);
    if (shown)
    {
      QObject::connect(shown, &pqDataRepresentation::visibilityChanged, this,
        [this] { this->Internal->DisplayTimer.start(); });
    }
  }
  pqRenderView* view = this->Mesh->view();
  if (QWidget* place = view ? view->widget() : nullptr) // none while a session ends
  {
    place->installEventFilter(this);
  }
  this->Internal->DisplayTimer.start();
}

//------------------------------------------------------------------------------
bool pqMeshDisplay::eventFilter(QObject* watched, QEvent* event)
{
  if (event->type() == QEvent::Resize)
  {
    this->Internal->DisplayTimer.start();
  }
  return this->QObject::eventFilter(watched, event);
}

//------------------------------------------------------------------------------
bool pqMeshDisplay::isInspected() const
{
  return this->Internal->Colors.areOfInspection();
}

//------------------------------------------------------------------------------
bool pqMeshDisplay::canInspect() const
{
  pqDataRepresentation* shown = this->Mesh->representation();
  vtkSMProperty* types = shown ? shown->getProxy()->GetProperty("Representation") : nullptr;
  auto* known = types ? types->FindDomain<vtkSMStringListDomain>() : nullptr;
  unsigned int place = 0;
  return known && known->IsInDomain(camaron::InspectionName, place) != 0;
}

//------------------------------------------------------------------------------
QString pqMeshDisplay::cutShape() const
{
  vtkSMProxy* proxy = GetCut(this->Mesh->representation());
  return proxy ? QString(proxy->GetXMLName()) : QString();
}

//------------------------------------------------------------------------------
QVariant pqMeshDisplay::value(const QString& property) const
{
  pqDataRepresentation* shown = this->Mesh->representation();
  return shown ? camaron::GetProperty(shown->getProxy(), property) : QVariant();
}

//------------------------------------------------------------------------------
void pqMeshDisplay::set(const QMap<QString, QVariant>& properties)
{
  pqDataRepresentation* shown = this->Mesh->representation();
  if (!shown)
  {
    return;
  }
  QMap<QString, QVariant> all = properties;
  if (!this->isInspected() && !all.contains("Representation"))
  {
    if (!this->canInspect())
    {
      return;
    }
    all["Representation"] = QString(camaron::InspectionName);
  }
  const pqScopedUndoSet undo(tr("Change Display"));
  camaron::SetTracedProperties(shown->getProxy(), all);
  shown->renderViewEventually();
  this->Internal->DisplayTimer.start();
}

//------------------------------------------------------------------------------
void pqMeshDisplay::preview(const QMap<QString, QVariant>& properties)
{
  pqDataRepresentation* shown = this->Mesh->representation();
  if (!shown || !this->isInspected())
  {
    return;
  }
  const pqScopedUndoExclude pause;
  camaron::SetProperties(shown->getProxy(), properties);
  shown->renderViewEventually();
}

//------------------------------------------------------------------------------
void pqMeshDisplay::previewBrush(double low, double high)
{
  pqDataRepresentation* shown = this->Mesh->representation();
  if (shown && this->isInspected())
  {
    this->Internal->Emphasized.preview(shown, { low, high });
  }
}

//------------------------------------------------------------------------------
void pqMeshDisplay::setCut(const QString& shape, const QMap<QString, QVariant>& values)
{
  pqDataRepresentation* shown = this->Mesh->representation();
  if (!shown)
  {
    return;
  }
  const pqScopedUndoSet undo(tr("Change Cut"));
  camaron::SetCut(shown->getProxy(), shape, values);
  shown->renderViewEventually();
}

//------------------------------------------------------------------------------
QMap<QString, QVariant> pqMeshDisplay::cut(const QStringList& names) const
{
  QMap<QString, QVariant> values;
  vtkSMProxy* cut = GetCut(this->Mesh->representation());
  for (const QString& name : names)
  {
    const QVariant value = camaron::GetProperty(cut, name);
    if (value.isValid())
    {
      values[name] = value;
    }
  }
  return values;
}

//------------------------------------------------------------------------------
void pqMeshDisplay::previewCut(const QMap<QString, QVariant>& values)
{
  if (vtkSMProxy* cut = GetCut(this->Mesh->representation()))
  {
    const pqScopedUndoExclude pause;
    camaron::SetProperties(cut, values);
    this->Mesh->representation()->renderViewEventually();
  }
}

//------------------------------------------------------------------------------
bool pqMeshDisplay::hasCutHandles() const
{
  const auto widgets =
    pqCoreUtilities::mainWidget()->findChildren<pqInteractivePropertyWidgetAbstract*>();
  vtkSMProxy* cut = GetCut(this->Mesh->representation());
  return std::any_of(
    widgets.begin(), widgets.end(), [cut](const auto* widget) { return widget->proxy() == cut; });
}

//------------------------------------------------------------------------------
QPair<double, double> pqMeshDisplay::isosurfaceRange() const
{
  vtkPVArrayInformation* values = this->Mesh->array(this->isosurfaceArray(), vtkDataObject::POINT);
  return values ? qMakePair(values->GetComponentRange(0)[0], values->GetComponentRange(0)[1])
                : qMakePair(0.0, 1.0);
}

//------------------------------------------------------------------------------
QString pqMeshDisplay::isosurfaceArray() const
{
  pqDataRepresentation* shown = this->Mesh->representation();
  vtkSMProperty* property = shown ? shown->getProxy()->GetProperty("IsosurfaceArray") : nullptr;
  const QString array = property
    ? QString::fromUtf8(vtkSMPropertyHelper(property).GetInputArrayNameToProcess())
    : QString();
  return this->Mesh->array(array, vtkDataObject::POINT) ? array : QString();
}

//------------------------------------------------------------------------------
void pqMeshDisplay::showSelection()
{
  vtkSMSourceProxy* selection = this->Mesh->selection();
  pqDataRepresentation* shown = this->Mesh->representation();
  const bool isDrawn = selection && shown && shown->isVisible() &&
    !camaron::IsOfPoints(selection) &&
    this->value("CellsToDraw").toInt() == 0; // else selected or other cells are drawn alone
  const auto brushes = isDrawn && this->isInspected() && this->value("DrawWith").toInt() == 0
    ? this->Selection->brushes()
    : QVector<camaron::BrushedValues>();
  const qint64 number =
    brushes.isEmpty() ? 0 : camaron::CountElements(*this->Mesh, "Current", "Cells");
  if (number > camaron::LargeSelection::Least)
  {
    this->Internal->Emphasized.show(shown, selection, brushes);
  }
  else if (this->Internal->Emphasized.isOf(shown) ||
    !this->Internal->Emphasized.isActive()) // else of another mesh
  {
    this->Internal->Emphasized.hide();
  }
  if (!isDrawn || !this->Mesh->isFollowing() || number > MostShining)
  {
    this->Internal->Shining.hide();
    return;
  }
  const auto port = static_cast<unsigned>(this->Mesh->port()->getPortNumber());
  this->Internal->Shining.show(this->Mesh->view(),
    this->Mesh->port()->getSourceProxy()->GetSelectionOutput(port),
    { { "Color", this->value("SelectionColor") } });
}
