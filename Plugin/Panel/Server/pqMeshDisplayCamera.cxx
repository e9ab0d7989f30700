// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Flights of the camera of the active view to elements.
#include "pqMeshDisplay.h"

#include "ProxyValues.h"
#include "pqInspectedMesh.h"
#include "pqMeshQuestions.h"

#include "pqCoreConfiguration.h"
#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqRenderView.h"
#include "pqUndoStack.h"

#include "vtkMath.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"

#include <QEasingCurve>
#include <QSet>
#include <QTimer>
#include <QVariantAnimation>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

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
// Position, focal point and view up.
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
QMap<QString, QVariant> ToProperties(const QVector<double>& camera)
{
  const auto three = [&](int first)
  { return QVariantList{ camera[first], camera[first + 1], camera[first + 2] }; };
  return { { "CameraPosition", three(0) }, { "CameraFocalPoint", three(3) },
    { "CameraViewUp", three(6) }, { "CameraParallelScale", camera[9] } };
}

//------------------------------------------------------------------------------
// The camera of a view moved to a location, on the side where it is: `toCamera`. The location takes
// up this share of the height of the view, or of its width if that is less.
QVector<double> Aim(
  vtkSMProxy* view, const camaron::Location& location, double share, double toCamera[3])
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
  const camaron::Location& location, const double toCamera[3], const QVector<double>& camera)
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
void pqMeshDisplay::flyTo(const camaron::Location& location, bool open)
{
  pqRenderView* view = this->Mesh->view();
  if (!view || !this->Mesh->port() ||
    !std::all_of(std::begin(location.Center), std::end(location.Center),
      [](double coordinate) { return std::isfinite(coordinate); }))
  {
    return;
  }
  if (!open || !this->canFlyBack())
  {
    this->closeDisplay();
  }
  this->rememberCamera(view);
  double direction[3];
  const QVector<double> camera = Aim(view->getProxy(), location, ShareOfElement, direction);
  const QVariantList box =
    open && location.Size > 0 ? MakeBox(location, direction, camera) : QVariantList();
  this->Marker.hide();
  this->fly(view, camera,
    [this, view, location, box, cells = QPointer<pqOutputPort>(this->Mesh->cellsPort())]
    {
      if (!box.isEmpty() && this->canFlyBack()) // only now: the camera moves at once and often
      {
        const pqScopedUndoSet undo(tr("Open Mesh"));
        this->rememberDisplay();
        this->set({ { "CutBy", 1 }, { "CutKeeps", 1 }, { "CellsToDraw", 0 }, { "GlassShell", 1 },
          { "DrawEdges", 1 } });
        this->setCut("HalfSpaces", { { "Planes", box } });
      }
      const camaron::Helper target = cells && cells == this->Mesh->cellsPort()
        ? this->Questions->extracted(location, "Target")
        : nullptr;
      if (target && this->Mesh->helpers().update(target)) // views do not update it at first
      {
        const QVariant color = camaron::GetLook(target, "MarkColor");
        this->Marker.show(view, target,
          { { "Representation", QString("Wireframe") }, { "AmbientColor", color },
            { "DiffuseColor", color }, { "LineWidth", 4.0 }, { "Pickable", 0 } });
      }
    });
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
  if (this->Flight)
  {
    this->Flight->stop();
  }
  this->closeDisplay();
  this->Marker.hide();
  this->rememberCamera(view);
  this->rememberDisplay();
  this->set({ { "CutBy", 0 }, { "CellsToDraw", 1 }, { "GlassShell", 1 }, { "DrawEdges", 1 } });
  if (location)
  {
    double direction[3];
    this->fly(view, Aim(view->getProxy(), *location, ShareOfSelection, direction));
  }
  Q_EMIT this->displayChanged();
}

//------------------------------------------------------------------------------
void pqMeshDisplay::rememberCamera(pqRenderView* view)
{
  if (!this->canFlyBack())
  {
    this->BeforeFlight = camaron::DisplayState();
    this->BeforeFlight->View = view;
    this->BeforeFlight->Camera = GetCamera(view->getProxy());
    this->BeforeFlight->Cells = this->Mesh->cellsPort();
  }
}

//------------------------------------------------------------------------------
void pqMeshDisplay::rememberDisplay()
{
  camaron::DisplayState& before = *this->BeforeFlight;
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
  if (!this->BeforeFlight || this->BeforeFlight->Properties.isEmpty())
  {
    return;
  }
  const pqScopedUndoSet undo(tr("Change Display"));
  QSet<pqDataRepresentation*> opened = { this->BeforeFlight->Drawn };
  if (this->canFlyBack())
  { // after a step of selection, its display is open, too
    opened << this->Mesh->representation();
  }
  for (pqDataRepresentation* drawn : std::as_const(opened))
  {
    if (drawn)
    {
      camaron::SetCut(drawn->getProxy(), this->BeforeFlight->CutShape, {});
      camaron::SetTracedProperties(drawn->getProxy(), this->BeforeFlight->Properties);
      drawn->renderViewEventually();
    }
  }
  this->BeforeFlight->Drawn = nullptr;
  this->BeforeFlight->Properties.clear();
}

//------------------------------------------------------------------------------
void pqMeshDisplay::flyBack()
{
  if (!this->canFlyBack())
  {
    return;
  }
  this->Marker.hide();
  this->closeDisplay();
  this->fly(this->BeforeFlight->View, this->BeforeFlight->Camera);
  this->BeforeFlight.reset();
  Q_EMIT this->displayChanged();
}

//------------------------------------------------------------------------------
bool pqMeshDisplay::canFlyBack() const
{
  return this->BeforeFlight && this->Mesh->cellsPort() &&
    this->Mesh->cellsPort() == this->BeforeFlight->Cells && this->BeforeFlight->View &&
    this->BeforeFlight->View == this->Mesh->view();
}

//------------------------------------------------------------------------------
// During a moment, not at once: the user sees where the camera goes, also where pictures take long.
void pqMeshDisplay::fly(
  pqRenderView* view, const QVector<double>& end, const std::function<void()>& arrive)
{
  if (this->Flight)
  {
    this->Flight->stop();
  }
  vtkSMRenderViewProxy* proxy = view->getRenderViewProxy();
  const QVector<double> start = GetCamera(proxy);
  auto* flight = new QVariantAnimation(view);
  this->Flight = flight;
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
        this->endFlight(view, end, arrive);
        return;
      }
      const double way = QEasingCurve(QEasingCurve::InOutQuad).valueForProgress(share);
      QVector<double> camera = start;
      for (int i = 0; i < camera.size(); ++i)
      {
        camera[i] += (end[i] - start[i]) * way;
      }
      const pqScopedUndoExclude pause;
      camaron::SetProperties(proxy, ToProperties(camera));
      proxy->InteractiveRender();
    });
  QObject::connect(
    flight, &QVariantAnimation::finished, view, [=] { this->endFlight(view, end, arrive); });
  flight->start(QAbstractAnimation::DeleteWhenStopped);
}

//------------------------------------------------------------------------------
void pqMeshDisplay::endFlight(
  pqRenderView* view, const QVector<double>& end, const std::function<void()>& arrive)
{
  if (this->Mesh->isComputing())
  {
    QTimer::singleShot(0, view, [=] { this->endFlight(view, end, arrive); });
    return;
  }
  if (arrive)
  {
    arrive();
  }
  const pqScopedUndoExclude pause;
  camaron::SetTracedProperties(view->getProxy(), ToProperties(end));
  view->setCenterOfRotation(end[3], end[4], end[5]);
  view->render();
}
