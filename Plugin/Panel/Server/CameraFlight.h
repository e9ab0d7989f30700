// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CameraFlight
 * @brief Moves the camera of a view to a location, so that one sees where it goes.
 */
#ifndef camaron_CameraFlight_h
#define camaron_CameraFlight_h

#include "InspectedMeshTypes.h"

#include <QPointer>          // for the flight
#include <QVariantAnimation> // for the flight

#include <functional> // for what follows

class pqInspectedMesh;
class pqRenderView;
class vtkSMProxy;

namespace camaron
{
/// Position, focal point, view up, parallel scale.
QVector<double> GetCamera(vtkSMProxy* view);

/// The camera of a view moved to a location, on the side where it is: `toCamera`. The location
/// takes up this share of the height of the view, or of its width if that is less.
QVector<double> Aim(vtkSMProxy* view, const Location& location, double share, double toCamera[3]);

/// Six half-spaces around an element: a point and the outward normal of each. The first one faces
/// the camera, so that nothing hides the element.
QVariantList MakeBox(
  const Location& location, const double toCamera[3], const QVector<double>& camera);

class CameraFlight
{
public:
  explicit CameraFlight(pqInspectedMesh* mesh)
    : Mesh(mesh)
  {
  }

  /// Moves the camera of a view; then something may happen. It waits while the mesh is computed.
  void start(
    pqRenderView* view, const QVector<double>& camera, const std::function<void()>& arrive = {});
  void stop()
  {
    if (this->Animation)
    {
      this->Animation->stop();
    }
  }

  bool isUnderWay() const
  {
    return this->Animation && this->Animation->state() == QAbstractAnimation::Running;
  }

private:
  void end(pqRenderView* view, const QVector<double>& camera, const std::function<void()>& arrive);

  pqInspectedMesh* Mesh;
  QPointer<QVariantAnimation> Animation;
};
}

#endif
