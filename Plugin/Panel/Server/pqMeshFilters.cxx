// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Filters that the panel creates in the pipeline.
#include "pqMeshFilters.h"

#include "ProxyValues.h"
#include "ThresholdSelection.h"
#include "pqInspectedMesh.h"
#include "pqMeshQuestions.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqObjectBuilder.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqProxyModifiedStateUndoElement.h"
#include "pqRenderView.h"
#include "pqServer.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"

#include "vtkNew.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMColorMapEditorHelper.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRepresentationProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTrace.h"
#include "vtkSMViewLayoutProxy.h"
#include "vtkSMViewProxy.h"

#include <QPointer>
#include <QScopedValueRollback>

namespace
{
constexpr const char* TickedPreset = "Ticked criteria"; // the choice of Preset for no preset

//------------------------------------------------------------------------------
pqPipelineSource* FindConsumer(pqOutputPort* port, const QString& name)
{
  for (pqPipelineSource* consumer : port->getConsumers())
  {
    if (camaron::IsFilter(consumer, name))
    {
      return consumer;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
// The value of a list of ticks: these names and no others.
QVariantList ToTicks(const QStringList& names)
{
  QVariantList ticks;
  for (const QString& name : names)
  {
    ticks << name << QString("1");
  }
  return ticks;
}

//------------------------------------------------------------------------------
// The view of a type that shows a table of Quality Statistics.
pqView* FindStatisticsView(const QString& type, pqServer* server)
{
  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  for (pqView* view : model->findItems<pqView*>(server))
  {
    for (pqRepresentation* shown : view->getRepresentations())
    {
      auto* data = qobject_cast<pqDataRepresentation*>(shown);
      const bool isOfStatistics = data && data->isVisible() &&
        camaron::IsFilter(data->getOutputPortFromInput()->getSource(), "QualityStatistics");
      if (view->getViewType() == type && isOfStatistics)
      {
        return view;
      }
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
// Tables, which are wide, below the other view, charts on its right.
pqView* CreateViewBeside(pqView* other, const QString& type, pqServer* server)
{
  pqView* view = pqApplicationCore::instance()->getObjectBuilder()->createView(type, server);
  vtkSMViewLayoutProxy* layout =
    other ? vtkSMViewLayoutProxy::FindLayout(other->getViewProxy()) : nullptr;
  int place = 0;
  if (layout)
  {
    constexpr double share = 0.6; // of the other view
    place = layout->GetViewLocation(other->getViewProxy());
    const char* split = type == "SpreadSheetView" ? "SplitVertical" : "SplitHorizontal";
    SM_SCOPED_TRACE(CallMethod).arg(layout).arg(split).arg(place).arg(share);
    place = type == "SpreadSheetView" ? layout->SplitVertical(place, share)
                                      : layout->SplitHorizontal(place, share);
  }
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  controller->AssignViewToLayout(view->getViewProxy(), layout, place + 1);
  return view;
}

//------------------------------------------------------------------------------
// As after Apply: undo brings back the state before it.
void MarkAsApplied(pqPipelineSource* source)
{
  if (source->modifiedState() == pqProxy::UNINITIALIZED)
  {
    vtkNew<pqProxyModifiedStateUndoElement> element;
    element->SetSession(source->getServer()->session());
    element->MadeUnmodified(source);
    ADD_UNDO_ELEM(element.Get());
  }
  source->setModifiedState(pqProxy::UNMODIFIED);
}
}

//------------------------------------------------------------------------------
pqMeshFilters::pqMeshFilters(pqInspectedMesh* mesh, pqMeshQuestions* questions, QObject* parent)
  : QObject(parent)
  , Mesh(mesh)
  , Questions(questions)
{
}

//------------------------------------------------------------------------------
double pqMeshFilters::estimatedSeconds(const QStringList& names) const
{
  const pqOutputPort* cells = names.isEmpty() ? nullptr : this->Mesh->cellsPort();
  return cells ? this->estimatedSeconds(
                   ToTicks(names), TickedPreset, cells->getSourceProxy(), cells->getPortNumber())
               : 0;
}

//------------------------------------------------------------------------------
double pqMeshFilters::estimatedSeconds(
  const QVariantList& ticks, const QString& preset, vtkSMSourceProxy* input, int port) const
{
  const camaron::Helper quality = this->Mesh->helpers().filter(
    "ElementQuality", input, "Estimate", { { "Criteria", ticks }, { "Preset", preset } }, port);
  if (!quality)
  {
    return 0;
  }
  vtkSMProperty* seconds = quality->GetProperty("EstimatedSeconds");
  camaron::UpdateInformation(quality, seconds);
  return vtkSMPropertyHelper(seconds).GetAsDouble();
}

//------------------------------------------------------------------------------
QVariantList pqMeshFilters::elementTicks(const QStringList& names, const QString& elementType) const
{
  QVariantList ticks; // of all arrays, as some are on by default
  for (const camaron::CriterionInfo& info : this->Questions->criteria())
  {
    if (info.Element == elementType)
    {
      ticks << info.Name << QString(names.contains(info.Name) ? "1" : "0");
    }
  }
  return ticks;
}

//------------------------------------------------------------------------------
void pqMeshFilters::evaluate(const QStringList& names, const QString& elementType)
{
  if (!this->Mesh->port() || names.isEmpty())
  {
    return;
  }
  const QScopedValueRollback<bool> evaluating(this->IsEvaluating, true);
  const bool isOfCells = elementType == "Cell";
  Q_EMIT this->evaluating(isOfCells ? this->estimatedSeconds(names) : 0);
  this->showElements(elementType);
  const QString filter = isOfCells ? "ElementQuality" : "MeshElements";
  const int output =
    isOfCells ? 0 : static_cast<int>(pqInspectedMesh::ElementTypes.indexOf(elementType));
  QMap<QString, QVariant> properties = { { isOfCells ? QString("Criteria") : elementType + "Arrays",
    isOfCells ? ToTicks(names) : this->elementTicks(names, elementType) } };
  if (isOfCells)
  {
    properties["Preset"] = QString(TickedPreset);
  }
  // Only steps of selection may be in between: another filter may have changed the cells.
  const pqOutputPort* evaluated =
    isOfCells ? this->Mesh->cellsPort() : this->Mesh->elementsPort(elementType);
  if (evaluated && camaron::IsFilter(evaluated->getSource(), filter))
  {
    this->changeFilter(evaluated->getSource(), properties);
  }
  else if (pqPipelineSource* consumer = FindConsumer(this->Mesh->port(), filter))
  {
    this->changeFilter(consumer, properties);
    this->inspect(consumer->getOutputPort(output));
  }
  else
  {
    this->addFilter(filter, properties, output);
  }
}

//------------------------------------------------------------------------------
void pqMeshFilters::evaluateAlso(const QString& name)
{
  if (this->Mesh->elementType() != "Cell")
  { // of faces and edges as polygons and lines
    if (!this->Mesh->cellArrays().contains(name))
    {
      this->addFilter("ElementQuality",
        { { "Criteria", ToTicks({ name }) }, { "Preset", QString(TickedPreset) } });
    }
    return;
  }
  QStringList names;
  for (const QString& evaluated : this->Questions->evaluated())
  {
    const camaron::CriterionInfo* info = this->Questions->criterion(evaluated);
    if (info && info->Element == "Cell")
    {
      names << evaluated;
    }
  }
  if (!names.contains(name))
  {
    this->evaluate(names << name);
  }
}

//------------------------------------------------------------------------------
void pqMeshFilters::showElements(const QString& elementType)
{
  if (elementType != this->Mesh->elementType())
  {
    this->inspect(this->Mesh->elementsPort(elementType));
  }
}

//------------------------------------------------------------------------------
void pqMeshFilters::changeFilter(
  pqPipelineSource* source, const QMap<QString, QVariant>& properties)
{
  const pqScopedUndoSet undo(tr("Change '%1'").arg(source->getSMName()));
  camaron::SetTracedProperties(source->getProxy(), properties);
  {
    const auto question = this->Mesh->helpers().ask();
    source->updatePipeline();
  }
  source->renderAllViews();
  this->Mesh->findLater();
}

//------------------------------------------------------------------------------
pqPipelineSource* pqMeshFilters::addFilter(
  const QString& name, const QMap<QString, QVariant>& properties, int shownPort)
{
  // What shows nothing is a table, which does not depend on steps of selection.
  const QPointer<pqOutputPort> input = shownPort < 0 ? this->Mesh->cellsPort() : this->Mesh->port();
  if (!input)
  {
    return nullptr;
  }
  const pqScopedUndoSet undo(tr("Create '%1'").arg(name));
  pqPipelineSource* filter = pqApplicationCore::instance()->getObjectBuilder()->createFilter(
    "filters", name, input->getSource(), input->getPortNumber());
  if (filter)
  {
    camaron::SetTracedProperties(filter->getProxy(), properties);
    {
      const auto question = this->Mesh->helpers().ask();
      filter->updatePipeline();
    }
    MarkAsApplied(filter);
    if (shownPort >= 0)
    {
      this->inspect(filter->getOutputPort(shownPort));
    }
    this->Mesh->findLater();
  }
  return filter;
}

//------------------------------------------------------------------------------
void pqMeshFilters::inspect(pqOutputPort* port)
{
  if (!port)
  {
    return;
  }
  const pqScopedUndoSet undo(tr("Show '%1'").arg(port->getPortName()));
  if (this->Mesh->port())
  {
    this->replaceInView(port, this->Mesh->port());
  }
  pqActiveObjects::instance().setActivePort(port);
  this->Mesh->setPort(port);
  this->Mesh->findLater();
}

//------------------------------------------------------------------------------
void pqMeshFilters::replaceInView(pqOutputPort* shown, pqOutputPort* before)
{
  pqRenderView* view = this->Mesh->view();
  if (!view)
  {
    return;
  }
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  vtkSMViewProxy* viewProxy = view->getViewProxy();
  vtkSMSourceProxy* old = before->getSourceProxy();
  const auto oldPort = static_cast<unsigned>(before->getPortNumber());
  vtkSMProxy* oldDisplay = viewProxy->FindRepresentation(old, oldPort);
  const bool hasLegend =
    oldDisplay && vtkSMColorMapEditorHelper::IsScalarBarVisible(oldDisplay, viewProxy);
  const bool isNew = shown->getRepresentation(view) == nullptr; // else it keeps its own look
  vtkSMProxy* display =
    controller->Show(shown->getSourceProxy(), shown->getPortNumber(), viewProxy);
  if (oldDisplay && display)
  {
    if (isNew)
    {
      camaron::CopyDisplay(oldDisplay, display);
    }
    controller->Hide(old, before->getPortNumber(), viewProxy);
    if (hasLegend && vtkSMColorMapEditorHelper::GetUsingScalarColoring(display))
    {
      camaron::ShowLegend(display, viewProxy);
    }
  }
  // Other outputs, such as the boundaries of a reader, would hide the mesh.
  for (pqOutputPort* other : before->getSource()->getOutputPorts())
  {
    pqDataRepresentation* drawn = other->getRepresentation(view);
    if (other != shown && other != before && drawn && drawn->isVisible())
    {
      controller->Hide(old, other->getPortNumber(), viewProxy);
    }
  }
  view->render();
}

//------------------------------------------------------------------------------
void pqMeshFilters::showStatistics(const QStringList& arrays, int table, const QString& viewType)
{
  const QPointer<pqOutputPort> mesh = this->Mesh->cellsPort(), active = this->Mesh->port();
  const QPointer<pqView> before = pqActiveObjects::instance().activeView();
  if (!mesh)
  {
    return;
  }
  const pqScopedUndoSet undo(tr("Show Table"));
  const auto question = this->Mesh->helpers().ask(); // the mesh stays
  const QMap<QString, QVariant> properties = { { "Arrays",
    QVariantList(arrays.begin(), arrays.end()) } };
  pqPipelineSource* statistics = nullptr;
  for (pqPipelineSource* consumer : mesh->getConsumers())
  { // one filter per list of arrays, so that views of others keep theirs
    const QVariant has = camaron::GetProperty(consumer->getProxy(), "Arrays");
    const bool isSame = has == properties["Arrays"] || QVariantList{ has } == properties["Arrays"];
    statistics = camaron::IsFilter(consumer, "QualityStatistics") && isSame ? consumer : statistics;
  }
  if (!statistics)
  {
    statistics = this->addFilter("QualityStatistics", properties, -1);
  }
  pqView* view = statistics ? FindStatisticsView(viewType, mesh->getServer()) : nullptr;
  if (statistics && !view)
  {
    view = CreateViewBeside(before, viewType, mesh->getServer());
  }
  if (view)
  {
    vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
    for (pqRepresentation* other : view->getRepresentations())
    {
      auto* data = qobject_cast<pqDataRepresentation*>(other);
      // A spreadsheet shows one table, and hides the one before by itself.
      if (data && data->isVisible() && viewType != "SpreadSheetView")
      {
        pqOutputPort* hidden = data->getOutputPortFromInput();
        controller->Hide(hidden->getSourceProxy(), hidden->getPortNumber(), view->getViewProxy());
      }
    }
    vtkSMProxy* shown = controller->Show(statistics->getSourceProxy(), table, view->getViewProxy());
    if (shown && shown->GetProperty("XArrayName"))
    { // the bars of the histogram
      const camaron::CriterionInfo* info = this->Questions->criterion(arrays.value(0));
      camaron::SetTracedProperties(view->getViewProxy(),
        { { "ChartTitle", this->Questions->summary().Name }, { "LeftAxisTitle", tr("Cells") },
          { "BottomAxisTitle", info ? info->title() : arrays.value(0) }, { "ShowLegend", 0 } });
      // All columns are listed: a state file that is loaded shows those that are not.
      statistics->getSourceProxy()->UpdatePipeline();
      const auto* found =
        statistics->getOutputPort(table)->getDataInformation()->GetRowDataInformation();
      QVariantList columns;
      for (int i = 0; i < found->GetNumberOfArrays(); ++i)
      {
        const QString name = found->GetArrayInformation(i)->GetName();
        if (found->GetArrayInformation(i)->GetDataType() != VTK_STRING)
        {
          columns << name << QString(name == "Count" ? "1" : "0");
        }
      }
      camaron::SetTracedProperties(shown,
        { { "UseIndexForXAxis", 0 }, { "XArrayName", QString("Center") },
          { "SeriesVisibility", columns } });
    }
    view->render();
  }
  pqActiveObjects::instance().setActiveView(before);
  pqActiveObjects::instance().setActivePort(active);
}
