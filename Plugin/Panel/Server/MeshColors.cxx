// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshColors.h"

#include "ProxyValues.h"
#include "pqInspectedMesh.h"
#include "pqMeshQuestions.h"

#include "pqDataRepresentation.h"
#include "pqRenderView.h"
#include "pqServer.h"
#include "pqUndoStack.h"

#include "vtkDataObject.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkSMColorMapEditorHelper.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMTransferFunctionProxy.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <utility>
#include <vector>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
DistributionRequest OneBin()
{
  DistributionRequest request;
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
  SetProperties(colors, input);
  UpdateInformation(colors);
  const bool hasBoth =
    input.value("HasUndefined").toInt() != 0 && input.value("HasNotJudged").toInt() != 0;
  constexpr int never = -1; // vtkSMTransferFunctionManager::NEVER
  return { { { "RGBPoints", GetProperty(colors, "Points") }, { "ColorSpace", QString("RGB") },
             { "NanColor", GetProperty(colors, "UndefinedColor") },
             { "BelowRangeColor", GetProperty(colors, "NotJudgedColor") },
             { "UseBelowRangeColor", hasBoth ? 1 : 0 }, { "AutomaticRescaleRangeMode", never },
             { "ScalarRangeInitialized", 1 }, { "Discretize", 0 } },
    GetProperty(colors, "UndefinedText").toString() };
}
}

//------------------------------------------------------------------------------
bool MeshColors::areOfInspection() const
{
  pqDataRepresentation* shown = this->Mesh->representation();
  return shown && GetProperty(shown->getProxy(), "Representation").toString() == InspectionName;
}

//------------------------------------------------------------------------------
void MeshColors::refit()
{
  if (this->areOwn())
  {
    const pqScopedUndoExclude pause;
    this->fit();
  }
}

//------------------------------------------------------------------------------
// Undo takes legends that were shown before out of the view: the colors have one if those that one
// saw last had one.
vtkSMProxy* MeshColors::updateLegend()
{
  pqDataRepresentation* shown = this->Mesh->representation();
  if (!shown)
  {
    return nullptr; // undo has removed the mesh, and another one will be found
  }
  const bool isUndone = std::exchange(this->IsUndone, false);
  if (!this->map())
  {
    return nullptr;
  }
  vtkSMProxy* view = this->Mesh->view()->getViewProxy();
  if (isUndone && this->HasLegend)
  {
    ShowLegend(shown->getProxy(), view);
    shown->renderViewEventually();
  }
  this->HasLegend = vtkSMColorMapEditorHelper::IsScalarBarVisible(shown->getProxy(), view);
  return this->legend();
}

//------------------------------------------------------------------------------
QString MeshColors::array() const
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
vtkSMProxy* MeshColors::map() const
{
  pqDataRepresentation* shown = this->Mesh->representation();
  return shown ? vtkSMColorMapEditorHelper::GetLookupTable(shown->getProxy()) : nullptr;
}

//------------------------------------------------------------------------------
bool MeshColors::areOf(const QString& array) const
{
  vtkSMProxy* colors = this->map();
  return colors && array == this->array() && this->Colored.contains(colors->GetGlobalID());
}

//------------------------------------------------------------------------------
bool MeshColors::areOwn() const
{
  vtkSMProxy* colors = this->map();
  return colors &&
    this->Colored.value(colors->GetGlobalID()).Points == GetProperty(colors, "RGBPoints");
}

//------------------------------------------------------------------------------
bool MeshColors::mayColor() const
{
  vtkSMProxy* colors = this->map();
  return colors && (!this->Colored.contains(colors->GetGlobalID()) || this->areOwn());
}

//------------------------------------------------------------------------------
MeshColors::OwnColors& MeshColors::judge(const Distribution& values, const Limits& limits)
{
  OwnColors& own = this->Colored[this->map()->GetGlobalID()];
  own.Acceptable = limits.value_or(qMakePair(values.Low, values.High));
  own.HasUndefined = values.Undefined > 0;
  own.HasNotJudged = !limits && this->areOfInspection() && values.hasNotJudged();
  return own;
}

//------------------------------------------------------------------------------
void MeshColors::judgeBy(const QString& array, const Limits& limits)
{
  if (array == this->array() && this->mayColor())
  {
    this->judge(this->Questions->distributions({ array }, OneBin()).value(0), limits);
    this->fit();
  }
}

//------------------------------------------------------------------------------
void MeshColors::markNotJudged(bool areMarked)
{
  if (this->areOfInspection())
  {
    SetTracedProperties(
      this->Mesh->representation()->getProxy(), { { "MarkCellsNotJudged", areMarked ? 1 : 0 } });
  }
}

//------------------------------------------------------------------------------
void MeshColors::fit()
{
  const QString array = this->array();
  const CriterionInfo* info = this->Questions->criterion(array);
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
  vtkSMProxy* colors = this->map();
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
  SetTracedProperties(colors, found.Map);
  own.Points = GetProperty(colors, "RGBPoints");
  own.UndefinedText = found.UndefinedText;
  this->markNotJudged(own.HasNotJudged);
  if (vtkSMProxy* legend = this->legend())
  {
    SetTracedProperties(legend, this->undefinedInLegend());
  }
  this->Mesh->representation()->renderViewEventually();
}

//------------------------------------------------------------------------------
vtkSMProxy* MeshColors::legend() const
{
  vtkSMProxy* colors = this->map();
  pqRenderView* view = this->Mesh->view();
  return colors && view
    ? vtkSMTransferFunctionProxy::FindScalarBarRepresentation(colors, view->getViewProxy())
    : nullptr;
}

//------------------------------------------------------------------------------
QMap<QString, QVariant> MeshColors::undefinedInLegend() const
{
  const OwnColors own = this->Colored.value(this->map()->GetGlobalID());
  return { { "DrawNanAnnotation", own.HasUndefined || own.HasNotJudged ? 1 : 0 },
    { "NanAnnotation", own.UndefinedText } };
}

//------------------------------------------------------------------------------
// Mesh Inspection has a color map of its own, so that other displays of the array keep theirs.
void MeshColors::colorBy(const QString& array, const Limits& limits)
{
  pqDataRepresentation* shown = this->Mesh->representation();
  const CriterionInfo* info = this->Questions->criterion(array);
  if (!shown || (!info && !this->Questions->otherArrays().contains(array)))
  {
    return;
  }
  const pqScopedUndoSet undo(tr("Color by '%1'").arg(array));
  vtkSMProxy* proxy = shown->getProxy();
  if (GetProperty(proxy, "Representation") == "Outline") // of grids, which shows no colors of cells
  {
    SetTracedProperties(proxy, { { "Representation", QString("Surface") } });
  }
  SetLookOfEdges(proxy);
  SetLightOfLegends(proxy);
  if (info && this->areOfInspection())
  {
    vtkSMColorMapEditorHelper::SetUseSeparateColorMap(proxy, true);
  }
  vtkSMColorMapEditorHelper::SetScalarColoring(
    proxy, array.toUtf8().constData(), vtkDataObject::CELL);
  vtkSMProxy* colors = this->map();
  const Distribution values = this->Questions->distributions({ array }, OneBin()).value(0);
  if (!info || !this->mayColor()) // colors of the user, or there are only those of ParaView
  {
    vtkSMColorMapEditorHelper::RescaleTransferFunctionToDataRange(proxy);
    this->markNotJudged(false);
  }
  else
  {
    this->judge(values, limits).Points = QVariant();
    this->fit();
  }
  if (pqRenderView* view = this->Mesh->view())
  {
    ShowLegend(proxy, view->getViewProxy());
    if (vtkSMProxy* legend = this->legend())
    {
      // The notation of numbers depends on the version of ParaView.
      const bool isNew = GetProperty(legend, "RangeLabelFormat").toString().contains('{');
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
      if (info && this->areOwn())
      {
        properties.insert(this->undefinedInLegend());
      }
      SetTracedProperties(legend, properties);
    }
  }
  shown->renderViewEventually();
}
}
