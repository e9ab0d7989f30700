// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshCamera.h"

#include "MarkedElements.h"
#include "ProxyValues.h"
#include "pqInspectedMesh.h"
#include "pqMeshDisplay.h"

#include "pqCoreConfiguration.h"
#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqRenderView.h"
#include "pqServer.h"
#include "pqUndoStack.h"

#include "vtkMath.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSourceProxy.h"

#include <QEasingCurve>
#include <QSet>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <utility>

namespace camaron
{
namespace
{
// A flight shows at least this time and these pictures, but ends in time.
constexpr int FlightMilliseconds = 300, LeastPictures = 12, LongestFlightMilliseconds = 2000;
// How much of the view an element takes up, and everything that is selected.
constexpr double ShareOfElement = 0.375, ShareOfSelection = 0.8;
// An opened mesh keeps the cells with their centroid this far around the element, and none in
// front.
constexpr double RadiusOfSizes = 1.2, FrontOfSizes = 0.02;

//------------------------------------------------------------------------------
QMap<QString, QVariant> ToProperties(const QVector<double>& camera)
{
  const auto three = [&](int first)
  { return QVariantList{ camera[first], camera[first + 1], camera[first + 2] }; };
  return { { "CameraPosition", three(0) }, { "CameraFocalPoint", three(3) },
    { "CameraViewUp", three(6) }, { "CameraParallelScale", camera[9] } };
}

//------------------------------------------------------------------------------
// Position, focal point, view up, parallel scale.
QVector<double> GetCamera(vtkSMProxy* view)
{
  QVector<double> camera;
  for (const char* name : { "CameraPosition", "CameraFocalPoint", "CameraViewUp" })
  {
    for (unsigned i = 0; i < 3; ++i)
    {
      camera << vtkSMPropertyHelper(view, name).GetAsDouble(i);
    }
  }
  return camera << vtkSMPropertyHelper(view, "CameraParallelScale").GetAsDouble();
}

//------------------------------------------------------------------------------
// The camera of a view moved to a location, on the side where it is: `toCamera`. The location takes
// up this share of the height of the view, or of its width if that is less.
QVector<double> Aim(vtkSMProxy* view, const Location& location, double share, double toCamera[3])
{
  QVector<double> camera = GetCamera(view);
  for (int i = 0; i < 3; ++i)
  {
    toCamera[i] = camera[i] - camera[3 + i];
  }
  const double length = vtkMath::Normalize(toCamera);
  const vtkSMPropertyHelper size(view, "ViewSize");
  const double aspect = size.GetAsDouble(0) / std::max(1.0, size.GetAsDouble(1));
  const double height = location.Size / share / (aspect > 0 ? std::min(1.0, aspect) : 1.0);
  const double angle = vtkSMPropertyHelper(view, "CameraViewAngle").GetAsDouble();
  const double distance =
    location.Size > 0 ? height / 2 / std::tan(vtkMath::RadiansFromDegrees(angle) / 2) : length;
  for (int i = 0; i < 3; ++i)
  {
    camera[3 + i] = location.Center[i];
    camera[i] = location.Center[i] + distance * toCamera[i];
  }
  camera[9] = location.Size > 0 ? height / 2 : camera[9];
  return camera;
}

//------------------------------------------------------------------------------
// Six half-spaces around an element: a point and the outward normal of each. The first one faces
// the camera, so that nothing hides the element.
QVariantList MakeBox(
  const Location& location, const double toCamera[3], const QVector<double>& camera)
{
  double up[3] = { camera[6], camera[7], camera[8] }, right[3];
  vtkMath::Cross(up, toCamera, right);
  vtkMath::Normalize(right);
  vtkMath::Cross(toCamera, right, up);
  QVariantList planes;
  const auto add = [&](const double normal[3], double sign, double sizes)
  {
    for (int i = 0; i < 3; ++i)
    {
      planes << location.Center[i] + sign * sizes * location.Size * normal[i];
    }
    for (int i = 0; i < 3; ++i)
    {
      planes << sign * normal[i];
    }
  };
  add(toCamera, 1, FrontOfSizes);
  add(toCamera, -1, RadiusOfSizes);
  for (const double sign : { -1.0, 1.0 })
  {
    add(up, sign, RadiusOfSizes);
    add(right, sign, RadiusOfSizes);
  }
  return planes;
}
}

//------------------------------------------------------------------------------
void MeshCamera::stop()
{
  if (this->Animation)
  {
    this->Animation->stop();
  }
}

//------------------------------------------------------------------------------
void MeshCamera::unmark()
{
  this->Marker.hide();
  this->Marked.reset();
}

//------------------------------------------------------------------------------
void MeshCamera::flyTo(const Location& location, bool open)
{
  pqRenderView* view = this->Mesh->view();
  if (!view || !this->Mesh->port() || !location.isFinite())
  {
    return;
  }
  const Place from = this->here(view);
  this->From = from;
  if (!open || !this->canFlyBack())
  {
    this->closeDisplay();
  }
  this->rememberCamera(view);
  double direction[3];
  const QVector<double> camera = Aim(view->getProxy(), location, ShareOfElement, direction);
  const QVariantList box =
    open && location.Size > 0 ? MakeBox(location, direction, camera) : QVariantList();
  this->unmark();
  this->start(view, camera,
    [this, view, location, camera, box, from,
      cells = QPointer<pqOutputPort>(this->Mesh->cellsPort())]
    {
      const bool isOfCells = cells && cells == this->Mesh->cellsPort();
      const pqScopedUndoSet undo(tr("Fly to Element"));
      if (!box.isEmpty() && this->canFlyBack()) // only now: the camera moves at once and often
      {
        this->rememberDisplay();
        this->Display->set({ { "CutBy", 1 }, { "CutKeeps", 1 }, { "CellsToDraw", 0 },
          { "GlassShell", 1 }, { "DrawEdges", 1 } });
        this->Display->setCut("HalfSpaces", { { "Planes", box } });
      }
      if (isOfCells)
      {
        this->mark(view, location);
        this->recordWay(from, camera);
      }
    });
  Q_EMIT this->Display->displayChanged();
}

//------------------------------------------------------------------------------
void MeshCamera::mark(pqRenderView* view, const Location& location)
{
  const Helper target = ExtractElements(*this->Mesh, location, "Target");
  if (this->Mesh->helpers().update(target)) // views do not update it at first
  {
    const QVariant color = GetLook(target, "MarkColor");
    this->Marker.show(view, target,
      { { "Representation", QString("Wireframe") }, { "AmbientColor", color },
        { "DiffuseColor", color }, { "LineWidth", 4.0 }, { "Pickable", 0 } });
    this->Marked = location;
  }
}

//------------------------------------------------------------------------------
MeshCamera::Place MeshCamera::here(pqRenderView* view) const
{
  return this->Animation && this->Animation->state() == QAbstractAnimation::Running
    ? this->From
    : Place{ view, GetCamera(view->getProxy()), this->Mesh->cellsPort(), this->Marked,
        this->Before };
}

//------------------------------------------------------------------------------
void MeshCamera::recordWay(const Place& from, const QVector<double>& camera)
{
  const Place to = { from.View, camera, this->Mesh->cellsPort(), this->Marked, this->Before };
  const auto way = [display = QPointer<pqMeshDisplay>(this->Display)](const Place& place)
  {
    if (display)
    {
      display->camera().goTo(place);
    }
  };
  AddToUndo(this->Mesh->server()->session(), [=] { way(from); }, [=] { way(to); });
}

//------------------------------------------------------------------------------
void MeshCamera::goTo(const Place& place)
{
  this->unmark();
  this->Before = place.Before;
  this->From = place;
  if (place.View)
  {
    this->start(place.View, place.Camera,
      [this, place]
      {
        if (place.Marked && place.Cells && place.Cells == this->Mesh->cellsPort())
        {
          this->mark(place.View, *place.Marked);
        }
      });
  }
  Q_EMIT this->Display->displayChanged();
}

//------------------------------------------------------------------------------
void MeshCamera::showSelected(const std::optional<Location>& location)
{
  pqRenderView* view = this->Mesh->view();
  if (!view || !this->Mesh->port())
  {
    return;
  }
  const pqScopedUndoSet undo(tr("Show Selected"));
  const Place from = this->here(view);
  this->stop();
  this->closeDisplay();
  this->unmark();
  this->rememberCamera(view);
  this->rememberDisplay();
  this->Display->set(
    { { "CutBy", 0 }, { "CellsToDraw", 1 }, { "GlassShell", 1 }, { "DrawEdges", 1 } });
  QVector<double> camera = GetCamera(view->getProxy());
  if (location)
  {
    double direction[3];
    camera = Aim(view->getProxy(), *location, ShareOfSelection, direction);
    this->From = from;
    this->start(view, camera);
  }
  this->recordWay(from, camera);
  Q_EMIT this->Display->displayChanged();
}

//------------------------------------------------------------------------------
void MeshCamera::rememberCamera(pqRenderView* view)
{
  if (!this->canFlyBack())
  {
    this->Before.emplace();
    this->Before->View = view;
    this->Before->Camera = GetCamera(view->getProxy());
    this->Before->Cells = this->Mesh->cellsPort();
  }
}

//------------------------------------------------------------------------------
void MeshCamera::rememberDisplay()
{
  BeforeFlight& before = *this->Before;
  if (!before.Properties.isEmpty())
  {
    return; // it is open already, also that of a step of selection, which looks the same
  }
  before.Drawn = this->Mesh->representation();
  before.CutShape = this->Display->cutShape();
  for (const char* name :
    { "Representation", "CutBy", "CutKeeps", "CellsToDraw", "GlassShell", "DrawEdges" })
  {
    before.Properties[name] = this->Display->value(name);
  }
}

//------------------------------------------------------------------------------
void MeshCamera::closeDisplay()
{
  if (!this->Before || this->Before->Properties.isEmpty())
  {
    return;
  }
  const pqScopedUndoSet undo(tr("Change Display"));
  QSet<pqDataRepresentation*> opened = { this->Before->Drawn };
  if (this->canFlyBack())
  { // after a step of selection, its display is open, too
    opened << this->Mesh->representation();
  }
  for (pqDataRepresentation* drawn : std::as_const(opened))
  {
    if (drawn)
    {
      SetCut(drawn->getProxy(), this->Before->CutShape, {});
      SetTracedProperties(drawn->getProxy(), this->Before->Properties);
      drawn->renderViewEventually();
    }
  }
  this->Before->Drawn = nullptr;
  this->Before->Properties.clear();
}

//------------------------------------------------------------------------------
void MeshCamera::flyBack()
{
  if (!this->canFlyBack())
  {
    return;
  }
  const pqScopedUndoSet undo(tr("Fly Back"));
  const Place from = this->here(this->Before->View);
  this->unmark();
  this->closeDisplay();
  const QVector<double> camera = this->Before->Camera;
  this->From = from;
  this->start(from.View, camera);
  this->Before.reset();
  this->recordWay(from, camera);
  Q_EMIT this->Display->displayChanged();
}

//------------------------------------------------------------------------------
bool MeshCamera::canFlyBack() const
{
  return this->Before && this->Mesh->cellsPort() &&
    this->Mesh->cellsPort() == this->Before->Cells && this->Before->View &&
    this->Before->View == this->Mesh->view();
}

//------------------------------------------------------------------------------
// During a moment, not at once: the user sees where the camera goes, also where pictures take long.
void MeshCamera::start(
  pqRenderView* view, const QVector<double>& camera, const std::function<void()>& arrive)
{
  this->stop();
  vtkSMRenderViewProxy* proxy = view->getRenderViewProxy();
  const QVector<double> start = GetCamera(proxy);
  auto* flight = new QVariantAnimation(view);
  this->Animation = flight;
  // A test would otherwise look at the view in the middle of the flight.
  flight->setDuration(
    pqCoreConfiguration::instance()->testScriptCount() > 0 ? 0 : LongestFlightMilliseconds);
  flight->setStartValue(0.0);
  flight->setEndValue(double(LongestFlightMilliseconds) / FlightMilliseconds);
  QObject::connect(flight, &QVariantAnimation::valueChanged, view,
    [=, pictures = 0](const QVariant& value) mutable
    {
      if (this->Mesh->isComputing() || flight->currentTime() == 0 || // nothing has moved
        flight->currentTime() == flight->duration())                 // it finishes itself
      {
        return;
      }
      const double share = std::min(value.toDouble(), double(++pictures) / LeastPictures);
      if (share >= 1)
      {
        flight->stop();
        this->end(view, camera, arrive);
        return;
      }
      const double way = QEasingCurve(QEasingCurve::InOutQuad).valueForProgress(share);
      QVector<double> now = start;
      for (int i = 0; i < now.size(); ++i)
      {
        now[i] += (camera[i] - start[i]) * way;
      }
      const pqScopedUndoExclude pause;
      SetProperties(proxy, ToProperties(now));
      proxy->InteractiveRender();
    });
  QObject::connect(
    flight, &QVariantAnimation::finished, view, [=] { this->end(view, camera, arrive); });
  flight->start(QAbstractAnimation::DeleteWhenStopped);
}

//------------------------------------------------------------------------------
void MeshCamera::end(
  pqRenderView* view, const QVector<double>& camera, const std::function<void()>& arrive)
{
  if (this->Mesh->isComputing())
  {
    QTimer::singleShot(0, view, [=] { this->end(view, camera, arrive); });
    return;
  }
  if (arrive)
  {
    arrive();
  }
  const pqScopedUndoExclude pause;
  SetTracedProperties(view->getProxy(), ToProperties(camera));
  view->setCenterOfRotation(camera[3], camera[4], camera[5]);
  view->render();
}
}
