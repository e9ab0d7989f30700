// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Past selections of the session.
#include "pqMeshSelection.h"

#include "NumberText.h"
#include "ProxyValues.h"
#include "ThresholdSelection.h"
#include "pqInspectedMesh.h"
#include "pqMeshFilters.h"

#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqSelectionManager.h"
#include "pqUndoStack.h"

#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTrace.h"

#include <QTimer>

#include <algorithm>
#include <utility>

namespace
{
constexpr int MostSelections = 20;

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
void pqMeshSelection::rememberSelection()
{
  vtkSMSourceProxy* selected =
    this->Mesh->port() ? this->Mesh->port()->getSelectionInput() : nullptr;
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
    now.Text = isOfView ? tr("Selected in the view")
                        : this->describeStep(this->Mesh->port()->getSourceProxy());
  }
  const camaron::SelectionInfo info = this->info();
  now.Text = tr("%1: %2 %3")
               .arg(now.Text, camaron::GroupedInteger(info.Count),
                 info.IsOfPoints     ? (info.Count == 1 ? tr("point") : tr("points"))
                   : info.Count == 1 ? this->Mesh->element()
                                     : this->Mesh->elements());
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
  vtkSMSourceProxy* selection =
    this->Mesh->port() ? this->Mesh->port()->getSelectionInput() : nullptr;
  const auto past = std::find_if(this->Past.cbegin(), this->Past.cend(),
    [selection](const auto& candidate) { return candidate.Selection == selection; });
  return selection && past != this->Past.cend() ? *past : camaron::PastSelection();
}

//------------------------------------------------------------------------------
QString pqMeshSelection::last() const
{
  const camaron::PastSelection active = this->active();
  return active.Selection && !camaron::IsResult(active.Selection) ? active.Text : QString();
}

//------------------------------------------------------------------------------
QVector<camaron::BrushedValues> pqMeshSelection::brushes() const
{
  vtkSMSourceProxy* selection =
    this->Mesh->port() ? this->Mesh->port()->getSelectionInput() : nullptr;
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
