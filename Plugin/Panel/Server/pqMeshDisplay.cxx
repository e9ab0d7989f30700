// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Display of the inspected mesh in the active view.
#include "pqMeshDisplay.h"

#include "ProxyValues.h"
#include "ServerConnection.h"
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
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkSMColorMapEditorHelper.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMRepresentationProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMStringListDomain.h"
#include "vtkSMTrace.h"
#include "vtkSMTransferFunctionProxy.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace
{
constexpr const char* InspectionName = "Mesh Inspection";
constexpr qint64 MostShining = 100000; // MostCells of the overlay

//------------------------------------------------------------------------------
camaron::DistributionRequest OneBin()
{
  camaron::DistributionRequest request;
  request.Bins = 1;
  return request;
}

//------------------------------------------------------------------------------
// What vtkQualityColors finds for a range of values.
struct QualityColors
{
  QMap<QString, QVariant> Map; // properties of the color map
  QString UndefinedText;       // of the legend
};

QualityColors FindColors(vtkSMSessionProxyManager* server, const QMap<QString, QVariant>& input)
{
  const auto colors = vtkSmartPointer<vtkSMProxy>::Take(server->NewProxy("misc", "QualityColors"));
  if (!colors)
  {
    return {};
  }
  camaron::SetProperties(colors, input);
  camaron::UpdateInformation(colors);
  const bool hasBoth =
    input.value("HasUndefined").toInt() != 0 && input.value("HasNotJudged").toInt() != 0;
  constexpr int never = -1; // vtkSMTransferFunctionManager::NEVER
  return { { { "RGBPoints", camaron::GetProperty(colors, "Points") },
             { "ColorSpace", QString("RGB") },
             { "NanColor", camaron::GetProperty(colors, "UndefinedColor") },
             { "BelowRangeColor", camaron::GetProperty(colors, "NotJudgedColor") },
             { "UseBelowRangeColor", hasBoth ? 1 : 0 }, { "AutomaticRescaleRangeMode", never },
             { "ScalarRangeInitialized", 1 }, { "Discretize", 0 } },
    camaron::GetProperty(colors, "UndefinedText").toString() };
}
}

//------------------------------------------------------------------------------
pqMeshDisplay::pqMeshDisplay(
  pqInspectedMesh* mesh, pqMeshQuestions* questions, pqMeshSelection* selection, QObject* parent)
  : QObject(parent)
  , Mesh(mesh)
  , Questions(questions)
  , Selection(selection)
{
  this->DisplayTimer.setSingleShot(true);
  this->DisplayTimer.setInterval(0);
  QObject::connect(&this->DisplayTimer, &QTimer::timeout, this,
    [this]
    {
      // Its handles, the Properties panel and scripts move it, too.
      this->follow(this->Cut, this->cutProxy());
      this->followLegend();
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
      if (this->hasOwnColors())
      { // perhaps of another time step
        const pqScopedUndoExclude pause;
        this->fitColors();
      }
      this->followDisplay();
    });
  QObject::connect(mesh, &pqInspectedMesh::cellsPortChanged, this, [this] { this->Marker.hide(); });
  QObject::connect(mesh, &pqInspectedMesh::followingChanged, this, &pqMeshDisplay::showSelection);
  QObject::connect(mesh, &pqInspectedMesh::aboutToRemove, this,
    [this](pqPipelineSource* source)
    {
      const auto isOf = [source](pqOutputPort* port)
      { return port && port->getSource() == source; };
      if (isOf(this->Mesh->cellsPort()))
      {
        this->Marker.hide();
      }
      if (isOf(this->Mesh->port()))
      {
        this->Shining.hide();
        this->Emphasized.hide();
      }
    });
  QObject::connect(mesh, &pqInspectedMesh::forgotten, this,
    [this]
    {
      this->Colored.clear();
      this->BeforeFlight.reset();
      this->Marker.hide();
      this->Shining.hide();
      this->Emphasized.hide();
    });
  if (pqUndoStack* undo = pqApplicationCore::instance()->getUndoStack())
  {
    for (const auto signal : { &pqUndoStack::undone, &pqUndoStack::redone })
    { // perhaps the color maps
      QObject::connect(undo, signal, this,
        [this]
        {
          this->Colored.clear();
          this->IsUndone = true;
          this->DisplayTimer.start();
        });
    }
  }
}

//------------------------------------------------------------------------------
pqMeshDisplay::~pqMeshDisplay() = default;

//------------------------------------------------------------------------------
void pqMeshDisplay::followDisplay()
{
  pqDataRepresentation* shown = this->Mesh->representation();
  if (shown != this->Followed)
  {
    if (this->Followed)
    {
      QObject::disconnect(this->Followed, nullptr, this, nullptr);
    }
    this->Followed = shown;
    this->follow(this->Display, shown ? shown->getProxy() : nullptr);
    if (shown)
    {
      QObject::connect(shown, &pqDataRepresentation::visibilityChanged, this,
        [this] { this->DisplayTimer.start(); });
    }
  }
  this->DisplayTimer.start();
}

//------------------------------------------------------------------------------
void pqMeshDisplay::follow(FollowedProxy& followed, vtkSMProxy* proxy)
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

//------------------------------------------------------------------------------
// Undo takes legends that were shown before out of the view: the colors have one if those that one
// saw last had one.
void pqMeshDisplay::followLegend()
{
  pqDataRepresentation* shown = this->Mesh->representation();
  if (!shown)
  {
    return; // undo has removed the mesh, and another one will be found
  }
  vtkSMProxy* view = this->Mesh->view()->getViewProxy();
  const bool isUndone = std::exchange(this->IsUndone, false);
  vtkSMProxy* colors = this->colors();
  if (colors && isUndone && this->HasLegend)
  {
    camaron::ShowLegend(shown->getProxy(), view);
    shown->renderViewEventually();
  }
  vtkSMProxy* legend =
    colors ? vtkSMTransferFunctionProxy::FindScalarBarRepresentation(colors, view) : nullptr;
  if (colors)
  {
    this->HasLegend = vtkSMColorMapEditorHelper::IsScalarBarVisible(shown->getProxy(), view);
  }
  this->follow(this->Legend, legend); // the user hides and shows it
}

//------------------------------------------------------------------------------
bool pqMeshDisplay::isInspected() const
{
  return this->value("Representation").toString() == InspectionName;
}

//------------------------------------------------------------------------------
bool pqMeshDisplay::canInspect() const
{
  pqDataRepresentation* shown = this->Mesh->representation();
  vtkSMProperty* types = shown ? shown->getProxy()->GetProperty("Representation") : nullptr;
  auto* known = types ? types->FindDomain<vtkSMStringListDomain>() : nullptr;
  unsigned int place = 0;
  return known && known->IsInDomain(InspectionName, place) != 0;
}

//------------------------------------------------------------------------------
vtkSMProxy* pqMeshDisplay::cutProxy() const
{
  pqDataRepresentation* shown = this->Mesh->representation();
  vtkSMProperty* shape = shown ? shown->getProxy()->GetProperty("CutShape") : nullptr;
  return shape ? vtkSMPropertyHelper(shape).GetAsProxy() : nullptr;
}

//------------------------------------------------------------------------------
QString pqMeshDisplay::cutShape() const
{
  vtkSMProxy* proxy = this->cutProxy();
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
    all["Representation"] = QString(InspectionName);
  }
  const pqScopedUndoSet undo(tr("Change Display"));
  camaron::SetTracedProperties(shown->getProxy(), all);
  shown->renderViewEventually();
  this->DisplayTimer.start();
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
    this->Emphasized.preview(shown, { low, high });
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
void pqMeshDisplay::previewCut(const QMap<QString, QVariant>& values)
{
  if (vtkSMProxy* cut = this->cutProxy())
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
  vtkSMProxy* cut = this->cutProxy();
  return std::any_of(
    widgets.begin(), widgets.end(), [cut](const auto* widget) { return widget->proxy() == cut; });
}

//------------------------------------------------------------------------------
QPair<double, double> pqMeshDisplay::isosurfaceRange() const
{
  pqDataRepresentation* shown = this->Mesh->representation();
  QPair<double, double> range = { 0, 1 };
  if (!shown)
  {
    return range;
  }
  const QString array = this->isosurfaceArray();
  vtkPVArrayInformation* values = this->Mesh->information()->GetArrayInformation(
    array.toUtf8().constData(), vtkDataObject::POINT);
  if (values)
  {
    range = { values->GetComponentRange(0)[0], values->GetComponentRange(0)[1] };
  }
  return range;
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
QString pqMeshDisplay::coloredBy() const
{
  pqDataRepresentation* shown = this->Mesh->representation();
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
vtkSMProxy* pqMeshDisplay::colors() const
{
  pqDataRepresentation* shown = this->Mesh->representation();
  return shown ? vtkSMColorMapEditorHelper::GetLookupTable(shown->getProxy()) : nullptr;
}

//------------------------------------------------------------------------------
bool pqMeshDisplay::hasColoredBy(const QString& array) const
{
  vtkSMProxy* colors = this->colors();
  return colors && array == this->coloredBy() && this->Colored.contains(colors->GetGlobalID());
}

//------------------------------------------------------------------------------
bool pqMeshDisplay::hasOwnColors() const
{
  vtkSMProxy* colors = this->colors();
  return colors &&
    this->Colored.value(colors->GetGlobalID()).Points == camaron::GetProperty(colors, "RGBPoints");
}

//------------------------------------------------------------------------------
bool pqMeshDisplay::mayColor() const
{
  vtkSMProxy* colors = this->colors();
  return colors && (!this->Colored.contains(colors->GetGlobalID()) || this->hasOwnColors());
}

//------------------------------------------------------------------------------
pqMeshDisplay::OwnColors& pqMeshDisplay::judge(
  const camaron::Distribution& values, const camaron::Limits& limits)
{
  OwnColors& own = this->Colored[this->colors()->GetGlobalID()];
  own.Acceptable = limits.value_or(qMakePair(values.Low, values.High));
  own.HasUndefined = values.Undefined > 0;
  own.HasNotJudged = !limits && this->isInspected() && values.hasNotJudged();
  return own;
}

//------------------------------------------------------------------------------
void pqMeshDisplay::judgeBy(const QString& array, const camaron::Limits& limits)
{
  if (array == this->coloredBy() && this->mayColor())
  {
    this->judge(this->Questions->distributions({ array }, OneBin()).value(0), limits);
    this->fitColors();
  }
}

//------------------------------------------------------------------------------
void pqMeshDisplay::markNotJudged(bool areMarked)
{
  if (this->isInspected())
  {
    camaron::SetTracedProperties(
      this->Mesh->representation()->getProxy(), { { "MarkCellsNotJudged", areMarked ? 1 : 0 } });
  }
}

//------------------------------------------------------------------------------
void pqMeshDisplay::fitColors()
{
  const QString array = this->coloredBy();
  const camaron::CriterionInfo* info = this->Questions->criterion(array);
  vtkPVDataInformation* information = this->Mesh->information();
  vtkPVArrayInformation* values = information
    ? information->GetArrayInformation(array.toUtf8().constData(), vtkDataObject::CELL)
    : nullptr;
  if (!info || !values)
  {
    return;
  }
  const double* finite = values->GetComponentFiniteRange(0);
  const QPair<double, double> range =
    finite[0] <= finite[1] ? qMakePair(finite[0], finite[1]) : qMakePair(0.0, 1.0);
  vtkSMProxy* colors = this->colors();
  OwnColors& own = this->Colored[colors->GetGlobalID()];
  const QualityColors found = FindColors(this->Mesh->server()->proxyManager(),
    { { "Range", QVariantList{ range.first, range.second } },
      { "Acceptable", QVariantList{ own.Acceptable.first, own.Acceptable.second } },
      { "Better", info->Better }, { "HasUndefined", own.HasUndefined ? 1 : 0 },
      { "HasNotJudged", own.HasNotJudged ? 1 : 0 } });
  if (found.Map.value("RGBPoints") == own.Points && found.UndefinedText == own.UndefinedText)
  {
    return;
  }
  camaron::SetTracedProperties(colors, found.Map);
  own.Points = camaron::GetProperty(colors, "RGBPoints");
  own.UndefinedText = found.UndefinedText;
  this->markNotJudged(own.HasNotJudged);
  if (vtkSMProxy* legend = this->legend())
  {
    camaron::SetTracedProperties(legend, this->undefinedInLegend());
  }
  this->Mesh->representation()->renderViewEventually();
}

//------------------------------------------------------------------------------
vtkSMProxy* pqMeshDisplay::legend() const
{
  vtkSMProxy* colors = this->colors();
  pqRenderView* view = this->Mesh->view();
  return colors && view
    ? vtkSMTransferFunctionProxy::FindScalarBarRepresentation(colors, view->getViewProxy())
    : nullptr;
}

//------------------------------------------------------------------------------
QMap<QString, QVariant> pqMeshDisplay::undefinedInLegend() const
{
  const OwnColors own = this->Colored.value(this->colors()->GetGlobalID());
  return { { "DrawNanAnnotation", own.HasUndefined || own.HasNotJudged ? 1 : 0 },
    { "NanAnnotation", own.UndefinedText } };
}

//------------------------------------------------------------------------------
// Mesh Inspection has a color map of its own, so that other displays of the array keep theirs.
void pqMeshDisplay::colorBy(const QString& array, const camaron::Limits& limits)
{
  pqDataRepresentation* shown = this->Mesh->representation();
  const camaron::CriterionInfo* info = this->Questions->criterion(array);
  if (!shown || (!info && !this->Questions->otherArrays().contains(array)))
  {
    return;
  }
  const pqScopedUndoSet undo(tr("Color by '%1'").arg(array));
  vtkSMProxy* proxy = shown->getProxy();
  if (this->value("Representation") == "Outline") // of grids, which shows no colors of cells
  {
    camaron::SetTracedProperties(proxy, { { "Representation", QString("Surface") } });
  }
  camaron::SetLookOfEdges(proxy);
  camaron::SetLightOfLegends(proxy);
  if (info && this->isInspected())
  {
    vtkSMColorMapEditorHelper::SetUseSeparateColorMap(proxy, true);
  }
  vtkSMColorMapEditorHelper::SetScalarColoring(
    proxy, array.toUtf8().constData(), vtkDataObject::CELL);
  vtkSMProxy* colors = this->colors();
  const camaron::Distribution values = this->Questions->distributions({ array }, OneBin()).value(0);
  if (!info || !this->mayColor()) // colors of the user, or there are only those of ParaView
  {
    vtkSMColorMapEditorHelper::RescaleTransferFunctionToDataRange(proxy);
    this->markNotJudged(false);
  }
  else
  {
    this->judge(values, limits).Points = QVariant();
    this->fitColors();
  }
  if (pqRenderView* view = this->Mesh->view())
  {
    camaron::ShowLegend(proxy, view->getViewProxy());
    if (vtkSMProxy* legend = this->legend())
    {
      // The notation of numbers depends on the version of ParaView.
      const bool isNew = camaron::GetProperty(legend, "RangeLabelFormat").toString().contains('{');
      const std::vector<double>& edges = values.Histogram.Edges;
      constexpr double fourDigits = 1000;
      const bool isOfLargeIntegers = !edges.empty() && edges.back() >= fourDigits &&
        std::floor(edges.front()) == edges.front() && std::floor(edges.back()) == edges.back();
      const QString number = isOfLargeIntegers ? ".0f" : ".3g";
      const QString format = isNew ? "{:" + number + "}" : "%" + number;
      QMap<QString, QVariant> properties = { { "Title", info ? info->title() : array },
        { "ComponentTitle", QString() }, { "RangeLabelFormat", format },
        { "DrawNanAnnotation", values.Undefined > 0 ? 1 : 0 },
        { "NanAnnotation", tr("undefined") } };
      if (info && this->hasOwnColors())
      {
        properties.insert(this->undefinedInLegend());
      }
      camaron::SetTracedProperties(legend, properties);
    }
  }
  shown->renderViewEventually();
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
    this->Emphasized.show(shown, selection, brushes);
  }
  else if (this->Emphasized.isOf(shown) || !this->Emphasized.isActive()) // else of another mesh
  {
    this->Emphasized.hide();
  }
  if (!isDrawn || !this->Mesh->isFollowing() || number > MostShining)
  {
    this->Shining.hide();
    return;
  }
  const auto port = static_cast<unsigned>(this->Mesh->port()->getPortNumber());
  this->Shining.show(this->Mesh->view(),
    this->Mesh->port()->getSourceProxy()->GetSelectionOutput(port),
    { { "Color", this->value("SelectionColor") } });
}
