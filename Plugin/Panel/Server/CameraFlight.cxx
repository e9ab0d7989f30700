// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CameraFlight.h"

#include "ProxyValues.h"
#include "pqInspectedMesh.h"

#include "pqCoreConfiguration.h"
#include "pqRenderView.h"
#include "pqUndoStack.h"

#include "vtkMath.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"

#include <QEasingCurve>
#include <QTimer>

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
// A flight shows at least this time and these pictures, but ends in time.
constexpr int FlightMilliseconds = 300, LeastPictures = 12, LongestFlightMilliseconds = 2000;
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
}

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
// During a moment, not at once: the user sees where the camera goes, also where pictures take long.
void CameraFlight::start(
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
void CameraFlight::end(
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
