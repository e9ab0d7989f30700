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
#include "vtkSMColorMapEditorHelper.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMTransferFunctionProxy.h"
#include "vtkSmartPointer.h"

#include <QWidget>

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
constexpr const char* LegendName = "ScalarBarWidgetRepresentation";
constexpr int AnyLocation = 0, LowerRightCorner = 2; // of a legend
constexpr int WidthOfLegend = 130;     // in pixels, with seven digits and a title beside it
constexpr double Bottom = 0.02;        // its distance from the end of the view, as ParaView's
constexpr double OpacityBehind = 0.75; // so that it can be read on a mesh that fills the view

//------------------------------------------------------------------------------
// What vtkQualityColors finds for a range of values.
struct QualityColors
{
  QMap<QString, QVariant> Map;    // properties of the color map
  QMap<QString, QVariant> Legend; // properties of its legend
};

// The format of a number such as ".3g" in the notation of this version of ParaView.
QString GetNotation(vtkSMProxy* legend, const QString& number)
{
  const bool isNew = GetProperty(legend, "RangeLabelFormat").toString().contains('{');
  return isNew ? "{:" + number + "}" : "%" + number;
}

QualityColors FindColors(vtkSMSessionProxyManager* server, const QMap<QString, QVariant>& input)
{
  const auto colors = vtkSmartPointer<vtkSMProxy>::Take(server->NewProxy("misc", "QualityColors"));
  if (!colors)
  {
    return {};
  }
  SetProperties(colors, input);
  UpdateInformation(colors);
  const bool hasUndefined = input.value("HasUndefined").toInt() != 0;
  const bool hasNotJudged = input.value("HasNotJudged").toInt() != 0;
  const QString digits = QString(".%1g").arg(GetProperty(colors, "LabelDigits").toInt());
  constexpr int never = -1; // vtkSMTransferFunctionManager::NEVER
  return { { { "RGBPoints", GetProperty(colors, "Points") }, { "ColorSpace", QString("RGB") },
             { "NanColor", GetProperty(colors, "UndefinedColor") },
             { "BelowRangeColor", GetProperty(colors, "NotJudgedColor") },
             { "UseBelowRangeColor", hasUndefined && hasNotJudged ? 1 : 0 },
             { "AutomaticRescaleRangeMode", never }, { "ScalarRangeInitialized", 1 },
             { "Discretize", 0 } },
    { { "UseCustomLabels", 1 }, { "AddRangeLabels", 0 }, { "AutomaticLabelFormat", 0 },
      { "CustomLabels", GetProperty(colors, "Labels") },
      { "LabelFormat",
        GetNotation(server->GetPrototypeProxy("representations", LegendName), digits) },
      { "DrawNanAnnotation", hasUndefined || hasNotJudged ? 1 : 0 },
      { "NanAnnotation", GetProperty(colors, "UndefinedText") } } };
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
  vtkSMProxy* legend = this->legend();
  const pqScopedUndoExclude pause;
  this->placeLegend();
  const auto own = this->Colored.find(this->map()->GetGlobalID());
  if (legend && own != this->Colored.end() && !own->Legend.isEmpty() && !this->areOwn())
  { // the user has changed the colors, to which the labels belong
    own->Legend.clear();
    SetTracedProperties(
      legend, { { "UseCustomLabels", 0 }, { "AddRangeLabels", 1 }, { "AutomaticLabelFormat", 1 } });
  }
  return legend;
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
  vtkPVArrayInformation* values = this->Mesh->array(array);
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
  if (found.Map.value("RGBPoints") == own.Points && found.Legend == own.Legend)
  {
    return;
  }
  SetTracedProperties(colors, found.Map);
  own.Points = GetProperty(colors, "RGBPoints");
  own.Legend = found.Legend;
  this->markNotJudged(own.HasNotJudged);
  if (vtkSMProxy* legend = this->legend())
  {
    SetTracedProperties(legend, own.Legend);
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
// The background of the view, translucent.
QVariant FindColorBehind(vtkSMProxy* view)
{
  vtkSMProxy* palette = view->GetSessionProxyManager()->GetProxy("settings", "ColorPalette");
  const bool isOfPalette =
    palette && GetProperty(view, "UseColorPaletteForBackground").toInt() != 0;
  QVariantList color = isOfPalette ? GetProperty(palette, "BackgroundColor").toList()
                                   : GetProperty(view, "Background").toList();
  color.append(OpacityBehind);
  return color;
}

//------------------------------------------------------------------------------
// At the place where ParaView puts it, but it would move the bar with the length of the numbers: at
// a fixed distance from the right end of the view. What the user changes stays.
void MeshColors::placeLegend()
{
  vtkSMProxy* legend = this->legend();
  const QWidget* view = legend ? this->Mesh->view()->widget() : nullptr;
  if (!view || view->width() <= WidthOfLegend)
  {
    return;
  }
  PlacedLegend& known = this->Legends[legend->GetGlobalID()];
  const QVariant place = QVariantList{ 1.0 - double(WidthOfLegend) / view->width(), Bottom };
  const int location = GetProperty(legend, "WindowLocation").toInt();
  const bool isOurs = location == AnyLocation && GetProperty(legend, "Position") == known.Place;
  if (location == LowerRightCorner || (isOurs && known.Place != place))
  {
    known.Place = place;
    SetTracedProperties(legend, { { "WindowLocation", AnyLocation }, { "Position", place } });
  }
  const QVariant behind = FindColorBehind(this->Mesh->view()->getViewProxy());
  const bool isOurColor = legend->GetProperty("BackgroundColor")->IsValueDefault() ||
    GetProperty(legend, "BackgroundColor") == known.ColorBehind;
  if (isOurColor && known.ColorBehind != behind)
  {
    known.ColorBehind = behind;
    SetTracedProperties(legend, { { "DrawBackground", 1 }, { "BackgroundColor", behind } });
  }
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
      const std::vector<double>& edges = values.Histogram.Edges;
      constexpr double fourDigits = 1000;
      const bool isOfLargeIntegers = !edges.empty() && edges.back() >= fourDigits &&
        std::floor(edges.front()) == edges.front() && std::floor(edges.back()) == edges.back();
      QMap<QString, QVariant> properties = { { "Title", info ? info->title() : array },
        { "ComponentTitle", QString() },
        { "RangeLabelFormat", GetNotation(legend, isOfLargeIntegers ? ".0f" : ".3g") },
        { "DrawNanAnnotation", values.Undefined > 0 ? 1 : 0 },
        { "NanAnnotation", tr("undefined") } };
      if (info && this->areOwn())
      {
        properties.insert(this->Colored[this->map()->GetGlobalID()].Legend);
      }
      SetTracedProperties(legend, properties);
      this->placeLegend();
    }
  }
  shown->renderViewEventually();
}
}
