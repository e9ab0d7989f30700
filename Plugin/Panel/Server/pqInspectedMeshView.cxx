// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Display of the inspected mesh in the active view, and its camera.
#include "pqInspectedMesh.h"

#include "ProxyValues.h"

#include "pqActiveObjects.h"
#include "pqCoreConfiguration.h"
#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqRenderView.h"
#include "pqUndoStack.h"

#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkMath.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkSMColorMapEditorHelper.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMRepresentationProxy.h"
#include "vtkSMStringListDomain.h"
#include "vtkSMTrace.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkSMTransferFunctionProxy.h"

#include <QVariantAnimation>

#include <algorithm>
#include <cmath>

namespace
{
constexpr const char* InspectionName = "Mesh Inspection";
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
void SetCamera(vtkSMProxy* view, const QVector<double>& camera)
{
  const auto properties = ToProperties(camera);
  for (auto item = properties.cbegin(); item != properties.cend(); ++item)
  {
    camaron::SetProperty(view, item.key(), item.value());
  }
  view->UpdateVTKObjects();
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
      SetCamera(proxy, camera);
      proxy->InteractiveRender();
    });
  QObject::connect(flight, &QVariantAnimation::finished, view,
    [=]
    {
      camaron::SetTracedProperties(proxy, ToProperties(end));
      view->setCenterOfRotation(end[3], end[4], end[5]);
      view->render();
    });
  flight->start(QAbstractAnimation::DeleteWhenStopped);
}
}

//------------------------------------------------------------------------------
pqRenderView* pqInspectedMesh::view() const
{
  return qobject_cast<pqRenderView*>(pqActiveObjects::instance().activeView());
}

//------------------------------------------------------------------------------
pqDataRepresentation* pqInspectedMesh::representation() const
{
  pqRenderView* view = this->view();
  return this->Port && view ? this->Port->getRepresentation(view) : nullptr;
}

//------------------------------------------------------------------------------
void pqInspectedMesh::followDisplay()
{
  pqDataRepresentation* shown = this->representation();
  if (shown != this->Followed)
  {
    if (this->Followed)
    {
      QObject::disconnect(this->Followed, nullptr, this, nullptr);
    }
    this->Followed = shown;
    this->DisplayConnector->Disconnect();
    if (shown)
    {
      QObject::connect(shown, &pqDataRepresentation::visibilityChanged, this,
        [this] { this->DisplayTimer.start(); });
      this->DisplayConnector->Connect(
        shown->getProxy(), vtkCommand::PropertyModifiedEvent, &this->DisplayTimer, SLOT(start()));
    }
  }
  this->DisplayTimer.start();
}

//------------------------------------------------------------------------------
bool pqInspectedMesh::isInspected() const
{
  return this->display("Representation").toString() == InspectionName;
}

//------------------------------------------------------------------------------
bool pqInspectedMesh::canInspect() const
{
  pqDataRepresentation* shown = this->representation();
  vtkSMProperty* types = shown ? shown->getProxy()->GetProperty("Representation") : nullptr;
  auto* known = types ? types->FindDomain<vtkSMStringListDomain>() : nullptr;
  unsigned int place = 0;
  return known && known->IsInDomain(InspectionName, place) != 0;
}

//------------------------------------------------------------------------------
QString pqInspectedMesh::cutShape() const
{
  pqDataRepresentation* shown = this->representation();
  vtkSMProperty* shape = shown ? shown->getProxy()->GetProperty("CutShape") : nullptr;
  vtkSMProxy* proxy = shape ? vtkSMPropertyHelper(shape).GetAsProxy() : nullptr;
  return proxy ? QString(proxy->GetXMLName()) : QString();
}

//------------------------------------------------------------------------------
QVariant pqInspectedMesh::display(const QString& property) const
{
  pqDataRepresentation* shown = this->representation();
  return shown ? camaron::GetProperty(shown->getProxy(), property) : QVariant();
}

//------------------------------------------------------------------------------
void pqInspectedMesh::setDisplay(const QMap<QString, QVariant>& properties)
{
  pqDataRepresentation* shown = this->representation();
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
    all["Representation"] = QString(InspectionName);
  }
  BEGIN_UNDO_SET(tr("Change Display"));
  camaron::SetTracedProperties(shown->getProxy(), all);
  END_UNDO_SET();
  shown->renderViewEventually();
  this->DisplayTimer.start();
}

//------------------------------------------------------------------------------
void pqInspectedMesh::previewDisplay(const QMap<QString, QVariant>& properties)
{
  pqDataRepresentation* shown = this->representation();
  if (!shown || !this->isInspected())
  {
    return;
  }
  BEGIN_UNDO_EXCLUDE();
  for (auto item = properties.cbegin(); item != properties.cend(); ++item)
  {
    camaron::SetProperty(shown->getProxy(), item.key(), item.value());
  }
  shown->getProxy()->UpdateVTKObjects();
  END_UNDO_EXCLUDE();
  shown->renderViewEventually();
}

//------------------------------------------------------------------------------
void pqInspectedMesh::setCut(const QString& shape, const QMap<QString, QVariant>& values)
{
  pqDataRepresentation* shown = this->representation();
  if (!shown)
  {
    return;
  }
  BEGIN_UNDO_SET(tr("Change Cut"));
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", shown->getProxy());
    if (vtkSMProxy* cut = camaron::ChooseProxy(shown->getProxy(), "CutShape", shape))
    {
      shown->getProxy()->UpdateVTKObjects();
      camaron::SetTracedProperties(cut, values);
    }
  }
  END_UNDO_SET();
  shown->renderViewEventually();
}

//------------------------------------------------------------------------------
QPair<double, double> pqInspectedMesh::isosurfaceRange() const
{
  pqDataRepresentation* shown = this->representation();
  QPair<double, double> range = { 0, 1 };
  if (!shown)
  {
    return range;
  }
  const QString array = this->isosurfaceArray();
  vtkPVArrayInformation* values =
    this->information()->GetArrayInformation(array.toUtf8().constData(), vtkDataObject::POINT);
  if (values)
  {
    range = { values->GetComponentRange(0)[0], values->GetComponentRange(0)[1] };
  }
  return range;
}

//------------------------------------------------------------------------------
QString pqInspectedMesh::isosurfaceArray() const
{
  pqDataRepresentation* shown = this->representation();
  vtkSMProperty* property = shown ? shown->getProxy()->GetProperty("IsosurfaceArray") : nullptr;
  return property ? QString::fromUtf8(vtkSMPropertyHelper(property).GetInputArrayNameToProcess())
                  : QString();
}

//------------------------------------------------------------------------------
QString pqInspectedMesh::coloredBy() const
{
  pqDataRepresentation* shown = this->representation();
  if (!shown || !vtkSMColorMapEditorHelper::GetUsingScalarColoring(shown->getProxy()))
  {
    return QString();
  }
  vtkSMPropertyHelper colors(shown->getProxy(), "ColorArrayName");
  return colors.GetInputArrayAssociation() == vtkDataObject::CELL
    ? QString::fromUtf8(colors.GetInputArrayNameToProcess())
    : QString();
}

//------------------------------------------------------------------------------
void pqInspectedMesh::colorBy(const QString& criterion)
{
  pqDataRepresentation* shown = this->representation();
  const camaron::CriterionInfo* info = this->criterion(criterion);
  if (!shown || !info)
  {
    return;
  }
  BEGIN_UNDO_SET(tr("Color by '%1'").arg(criterion));
  vtkSMProxy* proxy = shown->getProxy();
  vtkSMColorMapEditorHelper::SetScalarColoring(
    proxy, criterion.toUtf8().constData(), vtkDataObject::CELL);
  vtkSMProxy* colors = vtkSMColorMapEditorHelper::GetLookupTable(proxy);
  if (colors && !this->Colored.contains(criterion))
  {
    this->Colored.insert(criterion);
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", colors);
    // Red is the bad end: of the smallest values if larger ones are better.
    vtkSMTransferFunctionProxy::ApplyPreset(colors, "Cool to Warm", true);
    if (info->Better > 0 || (info->Better == 0 && std::isfinite(info->Low)))
    {
      vtkSMTransferFunctionProxy::InvertTransferFunction(colors);
    }
  }
  vtkSMColorMapEditorHelper::RescaleTransferFunctionToDataRange(proxy);
  if (pqRenderView* view = this->view())
  {
    vtkSMColorMapEditorHelper::SetScalarBarVisibility(proxy, view->getViewProxy(), true);
    vtkNew<vtkSMTransferFunctionManager> legends;
    legends->UpdateScalarBars(
      view->getViewProxy(), vtkSMTransferFunctionManager::HIDE_UNUSED_SCALAR_BARS);
    vtkSMProxy* legend = colors
      ? vtkSMTransferFunctionProxy::FindScalarBarRepresentation(colors, view->getViewProxy())
      : nullptr;
    if (legend)
    {
      camaron::SetTracedProperties(
        legend, { { "Title", info->Label }, { "ComponentTitle", info->Unit } });
    }
  }
  END_UNDO_SET();
  shown->renderViewEventually();
}

//------------------------------------------------------------------------------
void pqInspectedMesh::flyTo(const camaron::Location& location, bool open)
{
  pqRenderView* view = this->view();
  if (!view || !this->Port)
  {
    return;
  }
  vtkSMProxy* proxy = view->getViewProxy();
  QVector<double> camera = GetCamera(proxy);
  if (this->CameraBefore.isEmpty())
  {
    this->CameraBefore = camera;
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
  Fly(view, camera);
  Q_EMIT this->displayChanged();
}

//------------------------------------------------------------------------------
void pqInspectedMesh::flyBack()
{
  pqRenderView* view = this->view();
  if (view && this->canFlyBack())
  {
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
  return !this->CameraBefore.isEmpty();
}
