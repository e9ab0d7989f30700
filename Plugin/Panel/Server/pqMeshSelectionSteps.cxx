// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Steps of selection: Select Elements in the pipeline after the inspected mesh.
#include "pqMeshSelection.h"

#include "NumberText.h"
#include "ProxyValues.h"
#include "ThresholdSelection.h"
#include "pqInspectedMesh.h"
#include "pqMeshFilters.h"
#include "pqMeshQuestions.h"

#include "pqApplicationCore.h"
#include "pqObjectBuilder.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqUndoStack.h"

#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

#include <algorithm>
#include <limits>

namespace
{
// Of camaron::Combination, as Select Elements names them.
const QStringList Combinations = { "Replace", "Add", "Subtract", "Intersect" };

//------------------------------------------------------------------------------
// Whether what is selected before a step matters to it.
bool DependsOnSelection(const QString& strategy, const QString& combination)
{
  const QStringList dependent = { "Expand", "Shrink", "Connected", "Invert", "Inside" };
  return combination != "Replace" || dependent.contains(strategy);
}

//------------------------------------------------------------------------------
// Whether a selection is the one with which the first step began.
bool IsBefore(const camaron::PastSelection& selection, pqPipelineSource* first)
{
  return selection.Port && selection.Port == camaron::GetInput(first);
}

//------------------------------------------------------------------------------
QString SpellLayers(vtkSMProxy* step, bool isSurface)
{
  const int layers = camaron::GetProperty(step, "NumberOfLayers").toInt();
  const QString adjacency = camaron::GetProperty(step, "Adjacency").toString();
  const QString where = adjacency == "Vertex" ? pqMeshSelection::tr("at vertices")
    : adjacency == "Edge" || isSurface        ? pqMeshSelection::tr("across edges")
                                              : pqMeshSelection::tr("across faces");
  return layers == 1 ? pqMeshSelection::tr("by a layer %1").arg(where)
                     : pqMeshSelection::tr("by %1 layers %2").arg(layers).arg(where);
}

//------------------------------------------------------------------------------
// Such as "from 10 to 20".
QString DescribeRange(vtkSMProxy* step)
{
  const bool isInside = camaron::GetProperty(step, "Side") == "Inside";
  if (camaron::GetProperty(step, "Range") == "Acceptable")
  {
    return isInside ? pqMeshSelection::tr("in the acceptable range")
                    : pqMeshSelection::tr("outside the acceptable range");
  }
  const auto limit = [step](const char* name)
  { return camaron::ShortNumber(camaron::GetProperty(step, name).toDouble()); };
  const bool hasLow = !camaron::GetProperty(step, "LowerLimit").toString().isEmpty();
  const bool hasHigh = !camaron::GetProperty(step, "UpperLimit").toString().isEmpty();
  if (hasLow && hasHigh)
  {
    return (
      isInside ? pqMeshSelection::tr("from %1 to %2") : pqMeshSelection::tr("not from %1 to %2"))
      .arg(limit("LowerLimit"), limit("UpperLimit"));
  }
  if (hasLow)
  {
    return (isInside ? pqMeshSelection::tr("at least %1") : pqMeshSelection::tr("less than %1"))
      .arg(limit("LowerLimit"));
  }
  return (isInside ? pqMeshSelection::tr("at most %1") : pqMeshSelection::tr("more than %1"))
    .arg(limit("UpperLimit"));
}
}

//------------------------------------------------------------------------------
void pqMeshSelection::selectValuesBySteps(const QString& array,
  const QVector<QPair<double, double>>& ranges, int specials, camaron::Combination combination)
{
  const pqScopedUndoSet undo(tr("Select Values"));
  if (combination == camaron::Combination::Replace && this->Mesh->port() &&
    this->BrushedPort == this->Mesh->port())
  {
    this->undoTo(static_cast<int>(this->stepFilters().size()) - this->BrushSteps);
  }
  const auto before = this->stepFilters().size();
  for (const QPair<double, double>& range : ranges)
  {
    this->selectBy("By criterion",
      { { "Array", array }, { "Side", "Inside" }, { "Range", "Custom" },
        { "LowerLimit", camaron::ExactNumber(range.first) },
        { "UpperLimit", camaron::ExactNumber(range.second) } },
      combination);
    combination = camaron::Combination::Add;
  }
  if (specials & camaron::HistogramBrush::Undefined)
  {
    this->selectBy("Undefined", { { "Array", array } }, combination);
    combination = camaron::Combination::Add;
  }
  if (specials & camaron::HistogramBrush::Infinite)
  {
    this->selectBy("By criterion",
      { { "Array", array }, { "Side", "Outside" }, { "Range", "Custom" },
        { "LowerLimit", camaron::ExactNumber(-std::numeric_limits<double>::max()) },
        { "UpperLimit", camaron::ExactNumber(std::numeric_limits<double>::max()) } },
      combination);
  }
  this->BrushSteps = static_cast<int>(this->stepFilters().size() - before);
  this->BrushedPort = this->Mesh->port();
}

//------------------------------------------------------------------------------
void pqMeshSelection::selectBy(const QString& strategy, const QMap<QString, QVariant>& properties,
  camaron::Combination combination)
{
  if (!this->Mesh->port())
  {
    return;
  }
  QMap<QString, QVariant> all = properties;
  all["Strategy"] = strategy;
  all["Combination"] = Combinations[static_cast<int>(combination)];
  pqPipelineSource* last = this->Mesh->port()->getSource();
  // Another layer of the same neighbors changes the last step instead of adding one.
  if (camaron::IsFilter(last, camaron::SelectName))
  {
    vtkSMProxy* proxy = last->getProxy();
    const bool isSame = camaron::GetProperty(proxy, "Strategy") == strategy &&
      camaron::GetProperty(proxy, "Adjacency") == properties.value("Adjacency");
    if (isSame && properties.contains("NumberOfLayers"))
    {
      all["NumberOfLayers"] = camaron::GetProperty(proxy, "NumberOfLayers").toInt() +
        properties.value("NumberOfLayers").toInt();
      this->Filters->changeFilter(last, all);
      return;
    }
    // A step that ignores those before it replaces one of its kind.
    if (!DependsOnSelection(strategy, all["Combination"].toString()) &&
      camaron::GetProperty(proxy, "Combination") == "Replace" &&
      camaron::GetProperty(proxy, "Strategy") == strategy)
    {
      this->Filters->changeFilter(last, all);
      return;
    }
  }
  if (!camaron::IsFilter(last, camaron::SelectName))
  {
    this->SelectionBefore = {};
    for (const camaron::PastSelection& past : this->Past)
    { // perhaps of a brush, which traces can express
      if (past.Selection == this->Mesh->selection())
      {
        this->SelectionBefore = past;
      }
    }
    this->SelectionBefore.Port = this->Mesh->port();
    this->SelectionBefore.Selection = this->Mesh->selection();
  }
  this->Filters->addFilter(camaron::SelectName, all);
}

//------------------------------------------------------------------------------
void pqMeshSelection::restoreSelection()
{
  if (!this->IsStepRemoved || !this->Mesh->port())
  {
    return;
  }
  this->IsStepRemoved = false;
  if (camaron::IsFilter(this->Mesh->port()->getSource(), camaron::SelectName))
  {
    camaron::ActivateResult(this->Mesh->port()->getSource());
  }
  else if (this->Mesh->port() == this->SelectionBefore.Port)
  {
    this->activate(this->SelectionBefore);
  }
}

//------------------------------------------------------------------------------
void pqMeshSelection::selectOutside(const QString& criterion, const camaron::Limits& limits)
{
  QMap<QString, QVariant> properties = { { "Array", criterion }, { "Side", "Failing" } };
  camaron::AddLimits(properties, limits);
  this->selectBy("By criterion", properties);
}

//------------------------------------------------------------------------------
void pqMeshSelection::selectDefect(const QString& bit)
{
  const pqScopedUndoSet undo(tr("Select Defect"));
  this->Filters->evaluateAlso("CellStatus");
  this->selectBy("Status", { { "StatusBits", bit } });
}

//------------------------------------------------------------------------------
void pqMeshSelection::selectPlaces(const QStringList& ids, const QString& idSpace,
  const QString& array, const camaron::Limits& limits)
{
  QMap<QString, QVariant> properties = camaron::GrowToPlace(array, limits);
  properties["Ids"] = ids.join(',');
  properties["IdSpace"] = idSpace;
  this->selectBy("Connected to ids", properties);
}

//------------------------------------------------------------------------------
QString pqMeshSelection::describeStep(pqPipelineSource* filter) const
{
  vtkSMProxy* step = filter->getProxy();
  const auto property = [step](const char* name) { return camaron::GetProperty(step, name); };
  const QString strategy = property("Strategy").toString();
  const QString array = property("Array").toString();
  const camaron::CriterionInfo* info = this->Questions->criterion(array);
  const QString criterion = info ? info->Label : array;
  const QString rules = property("Rules").toString(), zone = property("SetName").toString();
  const QString file = property("SetFile").toString().section('/', -1);
  const auto ids = property("Ids").toString().split(',', Qt::SkipEmptyParts).size();
  const bool isOfBadPlaces = property("OnlyInRange").toBool();
  const QStringList bits = property("StatusBits").toString().split(',');
  const camaron::PanelTable& known = this->Questions->statusBits();
  QStringList defects;
  for (int row = 0; row < known.size(); ++row)
  {
    defects += bits.contains(known.text(row, "Name")) ? QStringList(known.text(row, "Description"))
                                                      : QStringList();
  }
  const QMap<QString, QString> texts = {
    { "By criterion", QString("%1 %2").arg(criterion, DescribeRange(step)) },
    { "Undefined", tr("%1 undefined").arg(criterion) },
    { "Worst N", tr("Worst %1 by %2").arg(property("NumberOfWorst").toInt()).arg(criterion) },
    { "Worst percentage",
      tr("Worst %1\u00a0% by %2").arg(property("WorstPercentage").toDouble()).arg(criterion) },
    { "Status", defects.isEmpty() ? tr("Any defect") : tr("Defect: %1").arg(defects.join(", ")) },
    { "Failed rules", tr("Fails %1").arg(rules) },
    { "By id", tr("Listed by id: %1").arg(ids) },
    { "Connected", isOfBadPlaces ? tr("Connected bad places") : tr("Everything connected") },
    { "Connected to ids",
      (isOfBadPlaces ? tr("Bad places: %1") : tr("Everything connected to ids: %1")).arg(ids) },
    { "Set", zone.isEmpty() ? tr("Set %1").arg(file) : tr("Zone %1").arg(zone) },
    { "Invert", tr("Inverted") },
  };
  QString text = texts.value(strategy, strategy);
  if (strategy == "Expand" || strategy == "Shrink")
  {
    text = (strategy == "Expand" ? tr("Grow %1") : tr("Shrink %1"))
             .arg(SpellLayers(step, this->Questions->isSurface()));
  }
  const QMap<QString, QString> beginnings = { { "Add", tr("Added: %1") },
    { "Subtract", tr("Subtracted: %1") }, { "Intersect", tr("Intersected: %1") } };
  return beginnings.value(property("Combination").toString(), "%1").arg(text);
}

//------------------------------------------------------------------------------
QList<pqPipelineSource*> pqMeshSelection::stepFilters() const
{
  QList<pqPipelineSource*> filters;
  pqPipelineSource* source = this->Mesh->port() ? this->Mesh->port()->getSource() : nullptr;
  while (camaron::IsFilter(source, camaron::SelectName))
  {
    filters.prepend(source);
    pqOutputPort* input = camaron::GetInput(source);
    source = input ? input->getSource() : nullptr;
  }
  return filters;
}

//------------------------------------------------------------------------------
QVector<QPair<QString, int>> pqMeshSelection::steps() const
{
  QVector<QPair<QString, int>> steps;
  const QList<pqPipelineSource*> filters = this->stepFilters();
  vtkSMProxy* first = filters.isEmpty() ? nullptr : filters.front()->getProxy();
  if (first && vtkSMPropertyHelper(first, "Selection").GetNumberOfElements() > 0 &&
    DependsOnSelection(camaron::GetProperty(first, "Strategy").toString(),
      camaron::GetProperty(first, "Combination").toString()))
  {
    const bool isKnown =
      IsBefore(this->SelectionBefore, filters.front()) && !this->SelectionBefore.Text.isEmpty();
    steps << qMakePair(isKnown ? this->SelectionBefore.Text : tr("Selected before"), 0);
  }
  int number = 0;
  for (pqPipelineSource* filter : filters)
  {
    steps << qMakePair(this->describeStep(filter), ++number);
  }
  const camaron::PastSelection active = this->active();
  if (active.Selection && !camaron::IsResult(active.Selection))
  {
    steps << qMakePair(active.Text, Present);
  }
  return steps;
}

//------------------------------------------------------------------------------
QString pqMeshSelection::undoTo(int count)
{
  const pqScopedUndoSet undo(tr("Remove Selection Steps"));
  const QList<pqPipelineSource*> steps = this->stepFilters();
  qsizetype left = steps.size();
  const auto isOfStep = [&](pqPipelineSource* consumer)
  { return left < steps.size() && consumer == steps[left]; };
  QString error;
  while (left > count && error.isEmpty())
  {
    pqPipelineSource* last = steps[left - 1];
    const QList<pqPipelineSource*> consumers = last->getAllConsumers();
    const auto other = std::find_if_not(consumers.begin(), consumers.end(), isOfStep);
    if (other == consumers.end() && camaron::GetInput(last))
    {
      --left;
      continue;
    }
    error = tr("%1 has to be deleted first, which uses this step.")
              .arg(other == consumers.end() ? last->getSMName() : (*other)->getSMName());
  }
  if (left == 0 && !steps.isEmpty() && !IsBefore(this->SelectionBefore, steps.front()))
  { // of a state, or of another mesh since then
    this->SelectionBefore = { {}, camaron::GetInput(steps.front()),
      vtkSMSourceProxy::SafeDownCast(
        vtkSMPropertyHelper(steps.front()->getProxy(), "Selection").GetAsProxy()),
      {}, {} };
  }
  if (left < steps.size())
  {
    this->Filters->inspect(
      camaron::GetInput(steps[left])); // once, since ParaView builds its panels anew
    for (auto step = steps.size(); step > left; --step)
    {
      pqApplicationCore::instance()->getObjectBuilder()->destroy(steps[step - 1]);
    }
    this->IsStepRemoved = true;
  }
  else if (left > 0)
  { // perhaps after a selection in the view
    vtkSMSourceProxy* selected = this->Mesh->selection();
    if (!selected || !camaron::IsResult(selected))
    {
      camaron::ActivateResult(steps.back());
    }
  }
  this->Mesh->findLater();
  this->SelectionTimer.start();
  return error;
}
