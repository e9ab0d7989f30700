// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The active selection of the inspected mesh.
#include "pqInspectedMesh.h"

#include "ProxyValues.h"
#include "ThresholdSelection.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqObjectBuilder.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqSelectionManager.h"
#include "pqUndoStack.h"

#include "vtkDataObject.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSelectionHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTrace.h"
#include "vtkSelectionNode.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace
{
constexpr const char* SelectName = "SelectElements";

//------------------------------------------------------------------------------
pqSelectionManager* GetSelectionManager()
{
  return qobject_cast<pqSelectionManager*>(
    pqApplicationCore::instance()->manager("SELECTION_MANAGER"));
}

//------------------------------------------------------------------------------
QString SpellStep(vtkSMProxy* step)
{
  const QString strategy = camaron::GetProperty(step, "Strategy").toString();
  const QString combination = camaron::GetProperty(step, "Combination").toString();
  QString text = strategy == "Null" ? "Undefined" : strategy;
  if (strategy == "By criterion" || strategy == "Worst N" || strategy == "Null")
  {
    text += ' ' + camaron::GetProperty(step, "Array").toString();
  }
  else if (strategy == "Worst share")
  {
    text += QString(" %1 % %2")
              .arg(camaron::GetProperty(step, "WorstShare").toDouble())
              .arg(camaron::GetProperty(step, "Array").toString());
  }
  else if (strategy == "Status")
  {
    text += ' ' + camaron::GetProperty(step, "StatusBits").toStringList().join(' ');
  }
  else if (strategy == "Expand" || strategy == "Shrink")
  {
    text += QString(" × %1 (%2)")
              .arg(camaron::GetProperty(step, "NumberOfRings").toInt())
              .arg(camaron::GetProperty(step, "Adjacency").toString());
  }
  return combination == "Replace" ? text : combination + ": " + text;
}

//------------------------------------------------------------------------------
// Modifier of paraview.selection; nullptr for one that does not exist there.
const char* GetModifier(camaron::Combination combination)
{
  switch (combination)
  {
    case camaron::Combination::Add:
      return "ADD";
    case camaron::Combination::Subtract:
      return "SUBTRACT";
    default:
      return nullptr;
  }
}

//------------------------------------------------------------------------------
QString GetCombinationName(camaron::Combination combination)
{
  switch (combination)
  {
    case camaron::Combination::Add:
      return "Add";
    case camaron::Combination::Subtract:
      return "Subtract";
    case camaron::Combination::Intersect:
      return "Intersect";
    default:
      return "Replace";
  }
}
}

//------------------------------------------------------------------------------
vtkSMSourceProxy* pqInspectedMesh::marked(const QString& strategy, const QString& elements) const
{
  vtkSMSourceProxy* select = this->filterHelper(SelectName, "Marked");
  if (select)
  {
    camaron::SetProperty(select, "Strategy", strategy);
    camaron::SetProperty(select, "ElementType", elements);
    vtkSMPropertyHelper input(select, "Selection");
    vtkSMSourceProxy* selection = this->Port->getSelectionInput();
    if (input.GetAsProxy() != selection) // else the filter would mark them once more
    {
      input.RemoveAllValues();
      if (selection)
      {
        input.Set(selection, 0);
      }
    }
    select->UpdateVTKObjects();
  }
  return select;
}

//------------------------------------------------------------------------------
qint64 pqInspectedMesh::count(const QString& strategy, const QString& elements) const
{
  const camaron::UndoPause pause;
  vtkSMSourceProxy* select = this->marked(strategy, elements);
  if (!select)
  {
    return 0;
  }
  select->UpdatePipeline(this->time());
  vtkSMProperty* number = select->GetProperty("NumberOfSelectedElements");
  select->UpdatePropertyInformation(number);
  return vtkSMPropertyHelper(number).GetAsIdType();
}

//------------------------------------------------------------------------------
camaron::SelectionInfo pqInspectedMesh::selection() const
{
  camaron::SelectionInfo info;
  vtkSMSourceProxy* selected = this->Port ? this->Port->getSelectionInput() : nullptr;
  if (!this->Port)
  {
    return info;
  }
  const camaron::MeshSummary summary = this->summary();
  info.Total = summary.Cells;
  if (!selected || vtkSMPropertyHelper(selected, "Input").GetNumberOfElements() == 0)
  {
    return info;
  }
  vtkSMProxy* first = vtkSMPropertyHelper(selected, "Input").GetAsProxy(0);
  info.IsOfPoints = first->GetProperty("FieldType")
    ? vtkSMPropertyHelper(first, "FieldType").GetAsInt() == vtkSelectionNode::POINT
    : vtkSMPropertyHelper(first, "ElementType", true).GetAsInt() == vtkDataObject::POINT;
  // ParaView's own count would include ghosts.
  const QString elements = info.IsOfPoints ? "Points" : "Cells";
  info.Count = this->count("Current", elements);
  info.Total = info.IsOfPoints ? summary.Points : summary.Cells;
  return info;
}

//------------------------------------------------------------------------------
void pqInspectedMesh::selectValues(const QString& array,
  const QVector<QPair<double, double>>& ranges, int specials, camaron::Combination combination)
{
  pqSelectionManager* manager = GetSelectionManager();
  if (!this->Port || !manager)
  {
    return;
  }
  if (ranges.isEmpty() && specials == 0)
  {
    if (combination == camaron::Combination::Replace)
    {
      this->clearSelection();
    }
    return;
  }
  // Thresholds neither select undefined values nor intersect.
  const bool isUndefined = (specials & camaron::HistogramBrush::Undefined) != 0;
  if (isUndefined || combination == camaron::Combination::Intersect)
  {
    this->selectValuesBySteps(array, ranges, specials, combination);
    return;
  }
  std::vector<double> thresholds;
  for (const QPair<double, double>& range : ranges)
  {
    thresholds.insert(thresholds.end(), { range.first, range.second });
  }
  if (specials & camaron::HistogramBrush::Infinite)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    thresholds.insert(thresholds.end(), { -infinity, -infinity, infinity, infinity });
  }
  {
    const camaron::UndoPause pause;
    const auto selection =
      camaron::MakeThresholdSelection(this->Port->getSource(), array, thresholds, false);
    vtkSMSourceProxy* before = this->Port->getSelectionInput();
    if (before && combination == camaron::Combination::Add)
    {
      vtkSMSelectionHelper::AddSelection(before, selection);
    }
    else if (before && combination == camaron::Combination::Subtract)
    {
      vtkSMSelectionHelper::SubtractSelection(before, selection);
    }
    this->Port->setSelectionInput(selection, 0);
    manager->select(this->Port);
  }

  // The expression that makes a trace item must have all arguments.
#define CAMARON_TRACE                                                                              \
  SM_SCOPED_TRACE(CallFunction)                                                                    \
    .arg("SelectThresholds")                                                                       \
    .arg("Thresholds", thresholds)                                                                 \
    .arg("ArrayName", array.toUtf8().constData())                                                  \
    .arg("FieldType", "CELL")                                                                      \
    .arg("Source", this->Port->getSourceProxy())                                                   \
    .arg("comment", "select the cells brushed in the histogram")
  if (const char* modifier = GetModifier(combination))
  {
    CAMARON_TRACE.arg("Modifier", modifier);
  }
  else
  {
    CAMARON_TRACE;
  }
#undef CAMARON_TRACE
}

//------------------------------------------------------------------------------
void pqInspectedMesh::selectValuesBySteps(const QString& array,
  const QVector<QPair<double, double>>& ranges, int specials, camaron::Combination combination)
{
  if (combination == camaron::Combination::Replace && this->Port && this->BrushedPort == this->Port)
  {
    this->undoSelectionTo(static_cast<int>(this->selectionSteps().size()) - this->BrushSteps);
  }
  const auto before = this->selectionSteps().size();
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
    this->selectBy("Null", { { "Array", array } }, combination);
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
  this->BrushSteps = static_cast<int>(this->selectionSteps().size() - before);
  this->BrushedPort = this->Port;
}

//------------------------------------------------------------------------------
void pqInspectedMesh::selectBy(const QString& strategy, const QMap<QString, QVariant>& properties,
  camaron::Combination combination)
{
  if (!this->Port)
  {
    return;
  }
  QMap<QString, QVariant> all = properties;
  all["Strategy"] = strategy;
  all["Combination"] = GetCombinationName(combination);
  pqPipelineSource* last = this->Port->getSource();
  // Another layer of the same neighbors changes the last step instead of adding one.
  if (camaron::IsFilter(last, SelectName))
  {
    vtkSMProxy* proxy = last->getProxy();
    const bool isSame = camaron::GetProperty(proxy, "Strategy") == strategy &&
      camaron::GetProperty(proxy, "Adjacency") == properties.value("Adjacency");
    if (isSame && properties.contains("NumberOfRings"))
    {
      all["NumberOfRings"] = camaron::GetProperty(proxy, "NumberOfRings").toInt() +
        properties.value("NumberOfRings").toInt();
      this->changeFilter(last, all);
      return;
    }
    // A step that ignores those before it replaces one of its kind.
    const QStringList dependent = { "Expand", "Shrink", "Connected", "Invert", "Inside" };
    if (combination == camaron::Combination::Replace && !dependent.contains(strategy) &&
      camaron::GetProperty(proxy, "Combination") == "Replace" &&
      camaron::GetProperty(proxy, "Strategy") == strategy)
    {
      this->changeFilter(last, all);
      return;
    }
  }
  if (!camaron::IsFilter(last, SelectName))
  {
    this->SelectionBefore = this->Port->getSelectionInput();
    this->SelectionBeforePort = this->Port;
  }
  this->addFilter(SelectName, all);
}

//------------------------------------------------------------------------------
void pqInspectedMesh::restoreSelection()
{
  pqSelectionManager* manager = GetSelectionManager();
  if (!this->IsStepRemoved || !this->Port || !manager)
  {
    return;
  }
  this->IsStepRemoved = false;
  if (camaron::IsFilter(this->Port->getSource(), SelectName))
  {
    camaron::ActivateResult(this->Port->getSource());
  }
  else if (this->Port == this->SelectionBeforePort && this->SelectionBefore)
  {
    const camaron::UndoPause pause;
    this->Port->setSelectionInput(this->SelectionBefore, 0);
    manager->select(this->Port);
  }
}

//------------------------------------------------------------------------------
void pqInspectedMesh::selectOutside(const QString& array, const camaron::Limits& limits)
{
  QMap<QString, QVariant> properties = { { "Array", array }, { "Side", "Outside" } };
  camaron::AddLimits(properties, limits);
  this->selectBy("By criterion", properties);
}

//------------------------------------------------------------------------------
qint64 pqInspectedMesh::selectFailing(const camaron::CheckRequest& request, int rule, qint64 count)
{
  constexpr qint64 most = 100000; // ids in a property
  const camaron::CheckResult result = this->check(request, static_cast<int>(std::min(count, most)));
  QStringList ids;
  QString idSpace = "Index";
  for (int row = 0; row < result.Worst.size(); ++row)
  {
    if (result.Worst.integer(row, "RuleIndex") == rule)
    {
      ids << result.Worst.text(row, "Id");
      idSpace = result.Worst.text(row, "IdSpace");
    }
  }
  if (ids.isEmpty())
  {
    this->clearSelection();
    return 0;
  }
  this->selectBy("By id", { { "Ids", ids.join(',') }, { "IdSpace", idSpace } });
  return ids.size();
}

//------------------------------------------------------------------------------
QStringList pqInspectedMesh::selectionSteps() const
{
  QStringList steps;
  pqPipelineSource* source = this->Port ? this->Port->getSource() : nullptr;
  while (camaron::IsFilter(source, SelectName))
  {
    steps.prepend(SpellStep(source->getProxy()));
    pqOutputPort* input = camaron::GetInput(source);
    source = input ? input->getSource() : nullptr;
  }
  return steps;
}

//------------------------------------------------------------------------------
void pqInspectedMesh::undoSelectionTo(int count)
{
  BEGIN_UNDO_SET(tr("Remove Selection Steps"));
  for (auto left = this->selectionSteps().size(); left > count; --left)
  {
    pqPipelineSource* last = this->Port->getSource();
    const QPointer<pqOutputPort> input = camaron::GetInput(last);
    if (!input || last->getNumberOfConsumers() > 0)
    {
      break;
    }
    this->inspect(input);
    pqApplicationCore::instance()->getObjectBuilder()->destroy(last);
    this->IsStepRemoved = true;
  }
  END_UNDO_SET();
  this->MeshTimer.start();
  this->SelectionTimer.start();
}

//------------------------------------------------------------------------------
void pqInspectedMesh::clearSelection()
{
  if (pqSelectionManager* manager = GetSelectionManager())
  {
    const camaron::UndoPause pause;
    manager->clearSelection();
  }
}
