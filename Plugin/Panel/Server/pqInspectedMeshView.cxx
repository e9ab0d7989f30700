// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Display of the inspected mesh in the active view.
#include "pqInspectedMesh.h"

#include "ProxyValues.h"
#include "ServerConnection.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqDataRepresentation.h"
#include "pqInteractivePropertyWidgetAbstract.h"
#include "pqOutputPort.h"
#include "pqRenderView.h"
#include "pqServer.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"

#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkSMColorMapEditorHelper.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMRepresentationProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMStringListDomain.h"
#include "vtkSMTrace.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkSMTransferFunctionProxy.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr const char* InspectionName = "Mesh Inspection";

//------------------------------------------------------------------------------
// Widgets that have handles in views for a proxy.
QList<pqInteractivePropertyWidgetAbstract*> FindHandles(vtkSMProxy* proxy)
{
  QList<pqInteractivePropertyWidgetAbstract*> found =
    pqCoreUtilities::mainWidget()->findChildren<pqInteractivePropertyWidgetAbstract*>();
  found.removeIf([proxy](const auto* widget) { return !proxy || widget->proxy() != proxy; });
  return found;
}

//------------------------------------------------------------------------------
camaron::DistributionRequest OneBin()
{
  camaron::DistributionRequest request;
  request.Bins = 1;
  return request;
}

//------------------------------------------------------------------------------
// The properties of a color map for values from low to high, with limits or without.
QMap<QString, QVariant> FindColors(vtkSMSessionProxyManager* server,
  const camaron::CriterionInfo& info, const camaron::Distribution& values)
{
  const auto colors = vtkSmartPointer<vtkSMProxy>::Take(server->NewProxy("misc", "QualityColors"));
  if (!colors || values.Histogram.Edges.empty())
  {
    return {};
  }
  camaron::SetProperties(colors,
    { { "Range", QVariantList{ values.Histogram.Edges.front(), values.Histogram.Edges.back() } },
      { "Acceptable", QVariantList{ values.Low, values.High } }, { "Better", info.Better } });
  camaron::UpdateInformation(colors);
  constexpr int never = -1; // vtkSMTransferFunctionManager::NEVER
  return { { "RGBPoints", camaron::GetProperty(colors, "Points") },
    { "ColorSpace", QString("RGB") },
    { "NanColor", camaron::GetProperty(colors, "UndefinedColor") },
    { "AutomaticRescaleRangeMode", never }, { "ScalarRangeInitialized", 1 }, { "Discretize", 0 } };
}
}

//------------------------------------------------------------------------------
pqRenderView* pqInspectedMesh::view() const
{
  auto* active = qobject_cast<pqRenderView*>(pqActiveObjects::instance().activeView());
  const auto shows = [this](pqRenderView* view)
  {
    pqDataRepresentation* shown = this->Port ? this->Port->getRepresentation(view) : nullptr;
    return shown && shown->isVisible();
  };
  if (!active || !shows(active))
  {
    auto* model = pqApplicationCore::instance()->getServerManagerModel();
    for (pqRenderView* other :
      model->findItems<pqRenderView*>(pqActiveObjects::instance().activeServer()))
    {
      if (shows(other))
      {
        return other;
      }
    }
  }
  return active;
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
vtkSMProxy* pqInspectedMesh::cutProxy() const
{
  pqDataRepresentation* shown = this->representation();
  vtkSMProperty* shape = shown ? shown->getProxy()->GetProperty("CutShape") : nullptr;
  return shape ? vtkSMPropertyHelper(shape).GetAsProxy() : nullptr;
}

//------------------------------------------------------------------------------
QString pqInspectedMesh::cutShape() const
{
  vtkSMProxy* proxy = this->cutProxy();
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
  const pqScopedUndoSet undo(tr("Change Display"));
  camaron::SetTracedProperties(shown->getProxy(), all);
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
  const pqScopedUndoExclude pause;
  camaron::SetProperties(shown->getProxy(), properties);
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
  const pqScopedUndoSet undo(tr("Change Cut"));
  camaron::SetCut(shown->getProxy(), shape, values);
  shown->renderViewEventually();
}

//------------------------------------------------------------------------------
QMap<QString, QVariant> pqInspectedMesh::cut(const QStringList& names) const
{
  QMap<QString, QVariant> values;
  vtkSMProxy* cut = this->cutProxy();
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
void pqInspectedMesh::previewCut(const QMap<QString, QVariant>& values)
{
  if (vtkSMProxy* cut = this->cutProxy())
  {
    const pqScopedUndoExclude pause;
    camaron::SetProperties(cut, values);
    this->representation()->renderViewEventually();
  }
}

//------------------------------------------------------------------------------
std::optional<bool> pqInspectedMesh::cutHandles()
{
  std::optional<bool> areShown;
  for (auto* handles : FindHandles(this->cutProxy()))
  {
    QObject::connect(handles, &pqInteractivePropertyWidgetAbstract::widgetVisibilityToggled, this,
      &pqInspectedMesh::displayChanged, Qt::UniqueConnection);
    areShown = areShown.value_or(false) || handles->isWidgetVisible();
  }
  return areShown;
}

//------------------------------------------------------------------------------
void pqInspectedMesh::showCutHandles(bool areShown)
{
  for (auto* handles : FindHandles(this->cutProxy()))
  {
    handles->setWidgetVisible(areShown);
  }
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
  const char* array =
    property ? vtkSMPropertyHelper(property).GetInputArrayNameToProcess() : nullptr;
  const bool exists =
    array && this->information()->GetArrayInformation(array, vtkDataObject::POINT);
  return exists ? QString::fromUtf8(array) : QString();
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
void pqInspectedMesh::colorBy(const QString& array)
{
  pqDataRepresentation* shown = this->representation();
  const camaron::CriterionInfo* info = this->criterion(array);
  if (!shown || (!info && !this->otherArrays().contains(array)))
  {
    return;
  }
  const pqScopedUndoSet undo(tr("Color by '%1'").arg(array));
  vtkSMProxy* proxy = shown->getProxy();
  if (this->display("Representation") == "Outline") // of grids, which shows no colors of cells
  {
    camaron::SetTracedProperties(proxy, { { "Representation", QString("Surface") } });
  }
  // The look of the report. With ParaView's light, faces that are turned away match no color of the
  // legend.
  camaron::SetLookOfEdges(proxy);
  camaron::SetUnchangedProperties(proxy, { { "Ambient", 0.35 }, { "Diffuse", 0.7 } });
  vtkSMColorMapEditorHelper::SetScalarColoring(
    proxy, array.toUtf8().constData(), vtkDataObject::CELL);
  vtkSMProxy* colors = vtkSMColorMapEditorHelper::GetLookupTable(proxy);
  const camaron::Distribution values = this->distributions({ array }, OneBin()).value(0);
  const bool isOwn = info && colors &&
    this->Colored.value(array, camaron::GetProperty(colors, "RGBPoints")) ==
      camaron::GetProperty(colors, "RGBPoints");
  if (!isOwn) // the user has chosen other colors, or there are only those of ParaView
  {
    vtkSMColorMapEditorHelper::RescaleTransferFunctionToDataRange(proxy);
  }
  else
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", colors);
    camaron::SetProperties(colors, FindColors(this->server()->proxyManager(), *info, values));
    this->Colored[array] = camaron::GetProperty(colors, "RGBPoints");
  }
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
      // The notation of numbers depends on the version of ParaView.
      const bool isNew = camaron::GetProperty(legend, "RangeLabelFormat").toString().contains('{');
      const QString format(isNew ? "{:.3g}" : "%.3g");
      camaron::SetTracedProperties(legend,
        { { "Title", info ? info->title() : array }, { "ComponentTitle", QString() },
          { "RangeLabelFormat", format }, { "DrawNanAnnotation", values.Undefined > 0 ? 1 : 0 },
          { "NanAnnotation", tr("undefined") } });
    }
  }
  shown->renderViewEventually();
}
