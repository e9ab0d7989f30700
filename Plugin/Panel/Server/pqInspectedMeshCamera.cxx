// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Flights of the camera of the active view to elements.
#include "pqInspectedMesh.h"

#include "ProxyValues.h"

#include "pqCoreConfiguration.h"
#include "pqOutputPort.h"
#include "pqRenderView.h"

#include "vtkMath.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSourceProxy.h"

#include <QVariantAnimation>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{
constexpr int FlightMilliseconds = 300;
// The element takes up about a fifth of the height of the view.
constexpr double DistanceOfSizes = 5;
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

//------------------------------------------------------------------------------
// Moves the camera during a moment, not at once: the user sees where it goes.
void Fly(pqRenderView* view, const QVector<double>& end)
{
  vtkSMRenderViewProxy* proxy = view->getRenderViewProxy();
  const QVector<double> start = GetCamera(proxy);
  auto* flight = new QVariantAnimation(view);
  // A test would otherwise look at the view in the middle of the flight.
  flight->setDuration(
    pqCoreConfiguration::instance()->testScriptCount() > 0 ? 0 : FlightMilliseconds);
  flight->setStartValue(0.0);
  flight->setEndValue(1.0);
  flight->setEasingCurve(QEasingCurve::InOutQuad);
  QObject::connect(flight, &QVariantAnimation::valueChanged, view,
    [=](const QVariant& value)
    {
      QVector<double> camera = start;
      for (int i = 0; i < camera.size(); ++i)
      {
        camera[i] += (end[i] - start[i]) * value.toDouble();
      }
      const camaron::UndoPause pause; // views have a stack of cameras
      camaron::SetProperties(proxy, ToProperties(camera));
      proxy->InteractiveRender();
    });
  QObject::connect(flight, &QVariantAnimation::finished, view,
    [=]
    {
      const camaron::UndoPause pause;
      camaron::SetTracedProperties(proxy, ToProperties(end));
      view->setCenterOfRotation(end[3], end[4], end[5]);
      view->render();
    });
  flight->start(QAbstractAnimation::DeleteWhenStopped);
}
}

//------------------------------------------------------------------------------
vtkSMSourceProxy* pqInspectedMesh::extracted(const camaron::Location& location) const
{
  const camaron::UndoPause pause;
  vtkSMSourceProxy* selected = this->cellsHelper("SelectElements", "Target");
  vtkSMSourceProxy* extraction = this->cellsHelper("ExtractSelection", "Target");
  if (!selected || !extraction)
  {
    return nullptr;
  }
  camaron::SetProperties(
    selected, { { "Strategy", "By id" }, { "Ids", location.Id }, { "IdSpace", location.IdSpace } });
  if (!location.GroupArray.isEmpty())
  {
    selected = this->filterHelper("SelectElements", "TargetGroup", selected);
    QMap<QString, QVariant> properties =
      camaron::GrowToPlace(location.GroupArray, location.GroupLimits);
    properties["Strategy"] = QString("Connected");
    camaron::SetProperties(selected, properties);
  }
  vtkSMPropertyHelper(extraction, "Selection").Set(selected, 1);
  extraction->UpdateVTKObjects();
  return extraction;
}

//------------------------------------------------------------------------------
void pqInspectedMesh::flyTo(const camaron::Location& location, bool open)
{
  pqRenderView* view = this->view();
  if (!view || !this->Port ||
    !std::all_of(std::begin(location.Center), std::end(location.Center),
      [](double coordinate) { return std::isfinite(coordinate); }))
  {
    return;
  }
  vtkSMProxy* proxy = view->getViewProxy();
  QVector<double> camera = GetCamera(proxy);
  if (!this->canFlyBack())
  {
    this->CameraBefore = camera;
    this->ViewBefore = view;
    this->CellsPortBefore = this->CellsPort;
    this->CutShapeBefore = this->cutShape();
    for (const char* name : { "Representation", "CutBy", "CutKeeps", "GlassShell", "DrawEdges" })
    {
      this->DisplayBefore[name] = this->display(name);
    }
  }
  double direction[3], length = 0;
  for (int i = 0; i < 3; ++i)
  {
    direction[i] = camera[i] - camera[3 + i];
  }
  length = vtkMath::Normalize(direction);
  const double distance = location.Size > 0 ? DistanceOfSizes * location.Size : length;
  for (int i = 0; i < 3; ++i)
  {
    camera[3 + i] = location.Center[i];
    camera[i] = location.Center[i] + distance * direction[i];
  }
  camera[9] = location.Size > 0 ? location.Size * DistanceOfSizes / 4 : camera[9];
  if (open && location.Size > 0)
  {
    this->setDisplay(
      { { "CutBy", 1 }, { "CutKeeps", 1 }, { "GlassShell", 1 }, { "DrawEdges", 1 } });
    this->setCut("HalfSpaces", { { "Planes", MakeBox(location, direction, camera) } });
  }
  if (vtkSMSourceProxy* target = this->extracted(location))
  {
    this->Marker.show(view, target);
  }
  Fly(view, camera);
  Q_EMIT this->displayChanged();
}

//------------------------------------------------------------------------------
void pqInspectedMesh::flyBack()
{
  pqRenderView* view = this->view();
  if (view && this->canFlyBack())
  {
    this->Marker.hide();
    this->setCut(this->CutShapeBefore, {});
    this->setDisplay(this->DisplayBefore);
    Fly(view, this->CameraBefore);
    this->CameraBefore.clear();
    this->DisplayBefore.clear();
    Q_EMIT this->displayChanged();
  }
}

//------------------------------------------------------------------------------
bool pqInspectedMesh::canFlyBack() const
{
  return !this->CameraBefore.isEmpty() && this->CellsPort &&
    this->CellsPort == this->CellsPortBefore && this->ViewBefore &&
    this->ViewBefore == this->view();
}
