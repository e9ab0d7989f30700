// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The active selection of the inspected mesh, and those before it.
#include "pqMeshSelection.h"

#include "MarkedElements.h"
#include "NumberText.h"
#include "ProxyValues.h"
#include "ThresholdSelection.h"
#include "pqInspectedMesh.h"
#include "pqMeshFilters.h"
#include "pqMeshQuestions.h"

#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqSelectionManager.h"
#include "pqUndoStack.h"

#include "vtkSMPropertyHelper.h"
#include "vtkSMSelectionHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTrace.h"

#include <QTimer>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace
{
constexpr int MostSelections = 20; // in the history

//------------------------------------------------------------------------------
// The properties of a step that are other ones now.
QMap<QString, QVariant> GetChanged(const camaron::SelectionStep& step)
{
  QMap<QString, QVariant> changed;
  for (auto item = step.Properties.cbegin(); item != step.Properties.cend(); ++item)
  {
    if (camaron::GetProperty(step.Filter->getProxy(), item.key()) != item.value())
    {
      changed[item.key()] = item.value();
    }
  }
  return changed;
}
}

//------------------------------------------------------------------------------
pqMeshSelection::pqMeshSelection(
  pqInspectedMesh* mesh, pqMeshQuestions* questions, pqMeshFilters* filters, QObject* parent)
  : QObject(parent)
  , Mesh(mesh)
  , Questions(questions)
  , Filters(filters)
{
  this->SelectionTimer.setSingleShot(true);
  this->SelectionTimer.setInterval(0);
  const auto tellLater = [this] { this->SelectionTimer.start(); };
  QObject::connect(&this->SelectionTimer, &QTimer::timeout, this,
    [this, tellLater]
    {
      if (this->Mesh->isComputing() || this->Mesh->willBeFound())
      {
        tellLater();
        return;
      }
      this->rememberSelection();
      Q_EMIT this->selectionChanged();
    });
  if (pqSelectionManager* manager = camaron::GetSelectionManager())
  {
    QObject::connect(manager, &pqSelectionManager::selectionChanged, this, tellLater);
  }
  QObject::connect(mesh, &pqInspectedMesh::portChanged, this, tellLater);
  QObject::connect(mesh, &pqInspectedMesh::meshChanged, this, &pqMeshSelection::restoreSelection);
  QObject::connect(mesh, &pqInspectedMesh::aboutToRemove, this,
    [this](pqPipelineSource* source)
    {
      this->Past.removeIf([source](const camaron::PastSelection& past)
        { return !past.Port || past.Port->getSource() == source; });
      if (this->Mesh->port() && this->Mesh->port()->getSource() == source)
      {
        this->IsStepRemoved = camaron::IsFilter(source, camaron::SelectName);
      }
    });
  QObject::connect(mesh, &pqInspectedMesh::forgotten, this,
    [this]
    {
      this->Past.clear();
      this->Brushed = {};
      this->SelectionBefore = {};
    });
}

//------------------------------------------------------------------------------
camaron::SelectionInfo pqMeshSelection::info() const
{
  camaron::SelectionInfo info;
  vtkSMSourceProxy* selected = this->Mesh->selection();
  if (!this->Mesh->port())
  {
    return info;
  }
  const camaron::MeshSummary summary = this->Questions->summary();
  info.Total = summary.Cells;
  if (!selected || vtkSMPropertyHelper(selected, "Input").GetNumberOfElements() == 0)
  {
    return info;
  }
  info.IsOfPoints = camaron::IsOfPoints(selected);
  // ParaView's own count would include ghosts.
  const QString elements = info.IsOfPoints ? "Points" : "Cells";
  info.Count = camaron::CountElements(*this->Mesh, "Current", elements);
  info.Total = info.IsOfPoints ? summary.Points : summary.Cells;
  return info;
}

//------------------------------------------------------------------------------
bool pqMeshSelection::selectValues(const QString& array,
  const QVector<QPair<double, double>>& ranges, int specials, camaron::Combination combination)
{
  pqSelectionManager* manager = camaron::GetSelectionManager();
  if (!this->Mesh->port() || !manager)
  {
    return false;
  }
  if (ranges.isEmpty() && specials == 0)
  {
    const bool clears = combination == camaron::Combination::Replace && this->Mesh->selection();
    if (clears)
    {
      this->clear();
    }
    return clears;
  }
  vtkSMSourceProxy* before = this->Mesh->selection();
  if (!before && // nothing to take away from
    (combination == camaron::Combination::Subtract ||
      combination == camaron::Combination::Intersect))
  {
    return false;
  }
  if (before && camaron::IsOfPoints(before)) // which cells do not combine with
  {
    combination = camaron::Combination::Replace;
  }
  // Thresholds neither select undefined values nor intersect.
  const bool isUndefined = (specials & camaron::HistogramBrush::Undefined) != 0;
  if (isUndefined || combination == camaron::Combination::Intersect)
  {
    this->selectValuesBySteps(array, ranges, specials, combination);
    return true;
  }
  const camaron::CriterionInfo* info = this->Questions->criterion(array);
  camaron::PastSelection brush;
  brush.Text = ranges.isEmpty()
    ? tr("%1 infinite").arg(info ? info->Label : array)
    : tr("%1 from %2 to %3")
        .arg(info ? info->Label : array, camaron::ShortNumber(ranges.front().first),
          camaron::ShortNumber(ranges.back().second));
  if (combination != camaron::Combination::Replace)
  {
    brush.Text =
      (combination == camaron::Combination::Add ? tr("Added: ") : tr("Subtracted: ")) + brush.Text;
  }
  camaron::BrushedValues values{ array, {}, combination };
  std::vector<double>& thresholds = values.Thresholds;
  for (const QPair<double, double>& range : ranges)
  {
    thresholds.insert(thresholds.end(), { range.first, range.second });
  }
  if (specials & camaron::HistogramBrush::Infinite)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    thresholds.insert(thresholds.end(), { -infinity, -infinity, infinity, infinity });
  }
  brush.Brushes = combination == camaron::Combination::Replace ? QVector<camaron::BrushedValues>()
                                                               : this->brushes();
  {
    const pqScopedUndoExclude pause;
    const auto selection =
      camaron::MakeThresholdSelection(this->Mesh->port()->getSource(), array, thresholds, false);
    if (before && combination == camaron::Combination::Add)
    {
      vtkSMSelectionHelper::AddSelection(before, selection);
    }
    else if (before && combination == camaron::Combination::Subtract)
    {
      vtkSMSelectionHelper::SubtractSelection(before, selection);
    }
    this->Mesh->port()->setSelectionInput(selection, 0);
    manager->select(this->Mesh->port());
  }

  camaron::TraceThresholds(
    this->Mesh->port(), values, false, "select the cells brushed in the histogram");
  if (combination == camaron::Combination::Replace || !brush.Brushes.isEmpty())
  {
    brush.Brushes << values;
  }
  this->Brushed = brush;
  return true;
}

//------------------------------------------------------------------------------
void pqMeshSelection::clear()
{
  if (pqSelectionManager* manager = camaron::GetSelectionManager())
  {
    const pqScopedUndoExclude pause;
    manager->clearSelection();
    if (this->Mesh->selection()) // that of a script, which the manager does not know
    {
      manager->clearSelection(this->Mesh->port());
    }
  }
}

//------------------------------------------------------------------------------
void pqMeshSelection::rememberSelection()
{
  vtkSMSourceProxy* selected = this->Mesh->selection();
  camaron::PastSelection now = std::exchange(this->Brushed, {});
  if (!this->Mesh->isFollowing() || !selected ||
    vtkSMPropertyHelper(selected, "Input").GetNumberOfElements() == 0)
  {
    return;
  }
  now.Port = this->Mesh->port();
  now.Selection = selected;
  for (pqPipelineSource* filter : this->stepFilters())
  {
    now.Steps << camaron::SelectionStep{ filter, camaron::GetProperties(filter->getProxy()) };
  }
  const bool isOfStep = !now.Steps.isEmpty() && now.Text.isEmpty() && camaron::IsResult(selected);
  const bool isOfView = !isOfStep && now.Text.isEmpty();
  const auto isKnown = [&](const camaron::PastSelection& past)
  {
    return past.Selection == selected ||
      (isOfStep && past.Port == now.Port && past.Steps == now.Steps);
  };
  if (std::any_of(this->Past.cbegin(), this->Past.cend(), isKnown))
  {
    return;
  }
  if (now.Text.isEmpty())
  {
    now.Text =
      isOfView ? tr("Selected in the view") : this->describeStep(this->Mesh->port()->getSource());
  }
  const camaron::SelectionInfo info = this->info();
  now.Text = tr("%1: %2 %3")
               .arg(now.Text, camaron::GroupedInteger(info.Count),
                 info.IsOfPoints ? (info.Count == 1 ? tr("point") : tr("points"))
                                 : this->Mesh->elements(info.Count));
  this->Past.prepend(now);
  this->Past = this->Past.mid(0, MostSelections);
  if (isOfView && !info.IsOfPoints && info.Count == 1)
  {
    Q_EMIT this->elementPicked();
  }
}

//------------------------------------------------------------------------------
QStringList pqMeshSelection::past() const
{
  QStringList texts;
  for (const camaron::PastSelection& past : this->Past)
  {
    texts << past.Text;
  }
  return texts;
}

//------------------------------------------------------------------------------
camaron::PastSelection pqMeshSelection::active() const
{
  vtkSMSourceProxy* selection = this->Mesh->selection();
  const auto past = std::find_if(this->Past.cbegin(), this->Past.cend(),
    [selection](const auto& candidate) { return candidate.Selection == selection; });
  return selection && past != this->Past.cend() ? *past : camaron::PastSelection();
}

//------------------------------------------------------------------------------
QVector<camaron::BrushedValues> pqMeshSelection::brushes() const
{
  vtkSMSourceProxy* selection = this->Mesh->selection();
  if (selection && camaron::IsResult(selection))
  {
    return { camaron::GetResultValues() };
  }
  return this->active().Brushes;
}

//------------------------------------------------------------------------------
void pqMeshSelection::reselect(int place)
{
  const camaron::PastSelection past = this->Past.value(place);
  if (!past.Port)
  {
    return;
  }
  for (const camaron::SelectionStep& step : past.Steps)
  {
    const auto changed = step.Filter ? GetChanged(step) : QMap<QString, QVariant>();
    if (!changed.isEmpty())
    {
      this->Filters->changeFilter(step.Filter, changed);
    }
  }
  if (past.Port != this->Mesh->port())
  {
    this->Filters->inspect(past.Port);
  }
  // After the results of steps that have changed, each of which becomes the active selection.
  QTimer::singleShot(0, this, [this, past] { this->activate(past); });
}

//------------------------------------------------------------------------------
void pqMeshSelection::activate(const camaron::PastSelection& past)
{
  pqSelectionManager* manager = camaron::GetSelectionManager();
  if (!manager || !past.Port || !past.Selection)
  {
    return;
  }
  {
    const pqScopedUndoExclude pause;
    past.Port->setSelectionInput(past.Selection, 0);
    manager->select(past.Port);
  }
  for (const camaron::BrushedValues& brush : past.Brushes)
  {
    camaron::TraceThresholds(
      past.Port, brush, false, "select once more the cells brushed in the histogram");
  }
  if (past.Brushes.isEmpty())
  {
    SM_SCOPED_TRACE(TraceText).arg(
      "# An earlier selection is active again, which traces cannot express.");
  }
}
