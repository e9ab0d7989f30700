// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Display of the inspected mesh in the active view.
#include "pqMeshDisplay.h"

#include "CameraFlight.h"
#include "ElementMarker.h"
#include "LargeSelection.h"
#include "MeshColors.h"
#include "ProxyValues.h"
#include "ThresholdSelection.h"
#include "pqInspectedMesh.h"
#include "pqMeshQuestions.h"
#include "pqMeshSelection.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqDataRepresentation.h"
#include "pqInteractivePropertyWidgetAbstract.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "pqServer.h"
#include "pqUndoStack.h"

#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkEventQtSlotConnect.h"
#include "vtkNew.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMRepresentationProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMStringListDomain.h"
#include "vtkWeakPointer.h"

#include <QEvent>
#include <QPointer>
#include <QSet>
#include <QWidget>
#include <pqTimer.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace
{
// How much of the view an element takes up, and everything that is selected.
constexpr double ShareOfElement = 0.375, ShareOfSelection = 0.8;
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
// What a flight to an element changes, to restore it.
struct pqMeshDisplay::BeforeFlight
{
  QPointer<pqRenderView> View;
  QVector<double> Camera;
  QPointer<pqOutputPort> Cells;
  QPointer<pqDataRepresentation> Drawn; // whose display was changed
  QMap<QString, QVariant> Properties;   // of it; empty if it was not changed
  QString CutShape;
};

//------------------------------------------------------------------------------
// Where undo and redo go.
struct pqMeshDisplay::Place
{
  QPointer<pqRenderView> View;
  QVector<double> Camera;
  QPointer<pqOutputPort> Cells;
  std::optional<camaron::Location> Marked;
  std::optional<BeforeFlight> Before;
};

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

  Internals(pqInspectedMesh* mesh, pqMeshQuestions* questions)
    : Colors(mesh, questions)
    , Flight(mesh)
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

  void Unmark()
  {
    this->Marker.hide();
    this->Marked.reset();
  }

  pqTimer DisplayTimer;
  QPointer<pqDataRepresentation> Shown;
  Followed Display, Cut, Map, Legend;
  camaron::MeshColors Colors;
  camaron::ElementMarker Marker{ "GeometryRepresentation" };
  camaron::ElementMarker Shining{ "ElementOverlay" }; // what is selected
  camaron::LargeSelection Emphasized;                 // if that is much
  std::optional<camaron::Location> Marked;
  camaron::CameraFlight Flight;
  Place From; // of the flight that is under way
  std::optional<pqMeshDisplay::BeforeFlight> Before;
};

//------------------------------------------------------------------------------
pqMeshDisplay::pqMeshDisplay(
  pqInspectedMesh* mesh, pqMeshQuestions* questions, pqMeshSelection* selection, QObject* parent)
  : QObject(parent)
  , Mesh(mesh)
  , Questions(questions)
  , Selection(selection)
  , Internal(std::make_unique<Internals>(mesh, questions))
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
    mesh, &pqInspectedMesh::cellsPortChanged, this, [this] { this->Internal->Unmark(); });
  QObject::connect(mesh, &pqInspectedMesh::followingChanged, this, &pqMeshDisplay::showSelection);
  QObject::connect(mesh, &pqInspectedMesh::aboutToRemove, this,
    [this](pqPipelineSource* source)
    {
      const auto isOf = [source](pqOutputPort* port)
      { return port && port->getSource() == source; };
      if (isOf(this->Mesh->cellsPort()))
      {
        this->Internal->Unmark();
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
      this->Internal->Before.reset();
      this->Internal->Unmark();
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
  const QByteArray array = this->isosurfaceArray().toUtf8();
  vtkPVArrayInformation* values = array.isEmpty()
    ? nullptr
    : this->Mesh->information()->GetArrayInformation(array, vtkDataObject::POINT);
  return values ? qMakePair(values->GetComponentRange(0)[0], values->GetComponentRange(0)[1])
                : qMakePair(0.0, 1.0);
}

//------------------------------------------------------------------------------
QString pqMeshDisplay::isosurfaceArray() const
{
  pqDataRepresentation* shown = this->Mesh->representation();
  vtkSMProperty* property = shown ? shown->getProxy()->GetProperty("IsosurfaceArray") : nullptr;
  const char* array =
    property ? vtkSMPropertyHelper(property).GetInputArrayNameToProcess() : nullptr;
  const bool exists =
    array && this->Mesh->information()->GetArrayInformation(array, vtkDataObject::POINT);
  return exists ? QString::fromUtf8(array) : QString();
}

//------------------------------------------------------------------------------
void pqMeshDisplay::showSelection()
{
  vtkSMSourceProxy* selection =
    this->Mesh->port() ? this->Mesh->port()->getSelectionInput() : nullptr;
  pqDataRepresentation* shown = this->Mesh->representation();
  const bool isDrawn = selection && shown && shown->isVisible() &&
    !camaron::IsOfPoints(selection) &&
    this->value("CellsToDraw").toInt() == 0; // else selected or other cells are drawn alone
  const auto brushes = isDrawn && this->isInspected() && this->value("DrawWith").toInt() == 0
    ? this->Selection->brushes()
    : QVector<camaron::BrushedValues>();
  const qint64 number = brushes.isEmpty() ? 0 : this->Questions->count("Current", "Cells");
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

//------------------------------------------------------------------------------
void pqMeshDisplay::flyTo(const camaron::Location& location, bool open)
{
  pqRenderView* view = this->Mesh->view();
  if (!view || !this->Mesh->port() ||
    !std::all_of(std::begin(location.Center), std::end(location.Center),
      [](double coordinate) { return std::isfinite(coordinate); }))
  {
    return;
  }
  const Place from = this->here(view);
  this->Internal->From = from;
  if (!open || !this->canFlyBack())
  {
    this->closeDisplay();
  }
  this->rememberCamera(view);
  double direction[3];
  const QVector<double> camera =
    camaron::Aim(view->getProxy(), location, ShareOfElement, direction);
  const QVariantList box =
    open && location.Size > 0 ? camaron::MakeBox(location, direction, camera) : QVariantList();
  this->Internal->Unmark();
  this->Internal->Flight.start(view, camera,
    [this, view, location, camera, box, from,
      cells = QPointer<pqOutputPort>(this->Mesh->cellsPort())]
    {
      const bool isOfCells = cells && cells == this->Mesh->cellsPort();
      const pqScopedUndoSet undo(tr("Fly to Element"));
      if (!box.isEmpty() && this->canFlyBack()) // only now: the camera moves at once and often
      {
        this->rememberDisplay();
        this->set({ { "CutBy", 1 }, { "CutKeeps", 1 }, { "CellsToDraw", 0 }, { "GlassShell", 1 },
          { "DrawEdges", 1 } });
        this->setCut("HalfSpaces", { { "Planes", box } });
      }
      if (isOfCells)
      {
        this->mark(view, location);
        this->recordWay(from, camera);
      }
    });
  Q_EMIT this->displayChanged();
}

//------------------------------------------------------------------------------
void pqMeshDisplay::mark(pqRenderView* view, const camaron::Location& location)
{
  const camaron::Helper target = this->Questions->extracted(location, "Target");
  if (target && this->Mesh->helpers().update(target)) // views do not update it at first
  {
    const QVariant color = camaron::GetLook(target, "MarkColor");
    this->Internal->Marker.show(view, target,
      { { "Representation", QString("Wireframe") }, { "AmbientColor", color },
        { "DiffuseColor", color }, { "LineWidth", 4.0 }, { "Pickable", 0 } });
    this->Internal->Marked = location;
  }
}

//------------------------------------------------------------------------------
pqMeshDisplay::Place pqMeshDisplay::here(pqRenderView* view) const
{
  return this->Internal->Flight.isUnderWay()
    ? this->Internal->From
    : Place{ view, camaron::GetCamera(view->getProxy()), this->Mesh->cellsPort(),
        this->Internal->Marked, this->Internal->Before };
}

//------------------------------------------------------------------------------
void pqMeshDisplay::recordWay(const Place& from, const QVector<double>& camera)
{
  const Place to = { from.View, camera, this->Mesh->cellsPort(), this->Internal->Marked,
    this->Internal->Before };
  const auto way = [display = QPointer<pqMeshDisplay>(this)](const Place& place)
  {
    if (display)
    {
      display->goTo(place);
    }
  };
  camaron::AddToUndo(this->Mesh->server()->session(), [=] { way(from); }, [=] { way(to); });
}

//------------------------------------------------------------------------------
void pqMeshDisplay::goTo(const Place& place)
{
  this->Internal->Unmark();
  this->Internal->Before = place.Before;
  this->Internal->From = place;
  if (place.View)
  {
    this->Internal->Flight.start(place.View, place.Camera,
      [this, place]
      {
        if (place.Marked && place.Cells && place.Cells == this->Mesh->cellsPort())
        {
          this->mark(place.View, *place.Marked);
        }
      });
  }
  Q_EMIT this->displayChanged();
}

//------------------------------------------------------------------------------
void pqMeshDisplay::showSelected(const std::optional<camaron::Location>& location)
{
  pqRenderView* view = this->Mesh->view();
  if (!view || !this->Mesh->port())
  {
    return;
  }
  const pqScopedUndoSet undo(tr("Show Selected"));
  const Place from = this->here(view);
  this->Internal->Flight.stop();
  this->closeDisplay();
  this->Internal->Unmark();
  this->rememberCamera(view);
  this->rememberDisplay();
  this->set({ { "CutBy", 0 }, { "CellsToDraw", 1 }, { "GlassShell", 1 }, { "DrawEdges", 1 } });
  QVector<double> camera = camaron::GetCamera(view->getProxy());
  if (location)
  {
    double direction[3];
    camera = camaron::Aim(view->getProxy(), *location, ShareOfSelection, direction);
    this->Internal->From = from;
    this->Internal->Flight.start(view, camera);
  }
  this->recordWay(from, camera);
  Q_EMIT this->displayChanged();
}

//------------------------------------------------------------------------------
void pqMeshDisplay::rememberCamera(pqRenderView* view)
{
  if (!this->canFlyBack())
  {
    this->Internal->Before.emplace();
    this->Internal->Before->View = view;
    this->Internal->Before->Camera = camaron::GetCamera(view->getProxy());
    this->Internal->Before->Cells = this->Mesh->cellsPort();
  }
}

//------------------------------------------------------------------------------
void pqMeshDisplay::rememberDisplay()
{
  BeforeFlight& before = *this->Internal->Before;
  if (!before.Properties.isEmpty())
  {
    return; // it is open already, also that of a step of selection, which looks the same
  }
  before.Drawn = this->Mesh->representation();
  before.CutShape = this->cutShape();
  for (const char* name :
    { "Representation", "CutBy", "CutKeeps", "CellsToDraw", "GlassShell", "DrawEdges" })
  {
    before.Properties[name] = this->value(name);
  }
}

//------------------------------------------------------------------------------
void pqMeshDisplay::closeDisplay()
{
  if (!this->Internal->Before || this->Internal->Before->Properties.isEmpty())
  {
    return;
  }
  const pqScopedUndoSet undo(tr("Change Display"));
  QSet<pqDataRepresentation*> opened = { this->Internal->Before->Drawn };
  if (this->canFlyBack())
  { // after a step of selection, its display is open, too
    opened << this->Mesh->representation();
  }
  for (pqDataRepresentation* drawn : std::as_const(opened))
  {
    if (drawn)
    {
      camaron::SetCut(drawn->getProxy(), this->Internal->Before->CutShape, {});
      camaron::SetTracedProperties(drawn->getProxy(), this->Internal->Before->Properties);
      drawn->renderViewEventually();
    }
  }
  this->Internal->Before->Drawn = nullptr;
  this->Internal->Before->Properties.clear();
}

//------------------------------------------------------------------------------
void pqMeshDisplay::flyBack()
{
  if (!this->canFlyBack())
  {
    return;
  }
  const pqScopedUndoSet undo(tr("Fly Back"));
  const Place from = this->here(this->Internal->Before->View);
  this->Internal->Unmark();
  this->closeDisplay();
  const QVector<double> camera = this->Internal->Before->Camera;
  this->Internal->From = from;
  this->Internal->Flight.start(from.View, camera);
  this->Internal->Before.reset();
  this->recordWay(from, camera);
  Q_EMIT this->displayChanged();
}

//------------------------------------------------------------------------------
bool pqMeshDisplay::canFlyBack() const
{
  return this->Internal->Before && this->Mesh->cellsPort() &&
    this->Mesh->cellsPort() == this->Internal->Before->Cells && this->Internal->Before->View &&
    this->Internal->Before->View == this->Mesh->view();
}
