// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqInspectorState.h"

#include "MeshColors.h"
#include "NumberText.h"
#include "ProxyValues.h"
#include "pqInspectedMesh.h"
#include "pqMeshDisplay.h"
#include "pqMeshQuestions.h"
#include "pqMeshServices.h"

#include "pqServer.h"
#include "pqUndoStack.h"

#include <QPointer>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
const QPair<double, double> NoLimits = { -Infinity, Infinity };

//------------------------------------------------------------------------------
// A line of rules; empty without limits.
// Element: Cell, Face, Edge or Vertex.
QString SpellRule(
  const QString& criterion, const QPair<double, double>& limits, const QString& element)
{
  const auto [low, high] = limits;
  QStringList words(criterion);
  if (std::isfinite(low) && std::isfinite(high))
  {
    words << camaron::ExactNumber(low) << camaron::ExactNumber(high);
  }
  else if (camaron::IsPositive(low))
  {
    words << ">" << "0";
  }
  else if (std::isfinite(low))
  {
    words << ">=" << camaron::ExactNumber(low);
  }
  else if (std::isfinite(high))
  {
    words << "<=" << camaron::ExactNumber(high);
  }
  if (words.size() == 1)
  {
    return {};
  }
  static const QMap<QString, QString> scopes = { { "Face", "of faces" }, { "Edge", "of edges" },
    { "Vertex", "of vertices" } };
  if (scopes.contains(element))
  {
    words << scopes.value(element);
  }
  return words.join(' ');
}

//------------------------------------------------------------------------------
// A line of a file of ranges.
QString SpellRange(const QString& criterion, const QPair<double, double>& limits)
{
  const auto spell = [](double limit)
  { return std::isfinite(limit) ? camaron::ExactNumber(limit) : QString("*"); };
  return QStringList{ criterion, spell(limits.first), spell(limits.second) }.join(' ');
}

//------------------------------------------------------------------------------
bool IsCriterion(const pqMeshQuestions& questions, const QString& element, const QString& name)
{
  const auto& criteria = questions.criteria();
  return std::any_of(criteria.begin(), criteria.end(), [&](const camaron::CriterionInfo& info)
    { return info.Element == element && info.Name == name; });
}
}

//------------------------------------------------------------------------------
pqInspectorState::pqInspectorState(const pqMeshServices& services, QObject* parent)
  : QObject(parent)
  , Services(services)
  , Acceptable(NoLimits)
{
  QObject::connect(
    services.Mesh, &pqInspectedMesh::meshChanged, this, &pqInspectorState::followMesh);
  QObject::connect(
    services.Display, &pqMeshDisplay::displayChanged, this, &pqInspectorState::followColors);
}

//------------------------------------------------------------------------------
void pqInspectorState::followMesh()
{
  const bool isOther = this->Services.Mesh->elementType() != this->ElementType;
  if (isOther)
  {
    this->setCriterion(QString());
    this->ElementType = this->Services.Mesh->elementType();
  }
  const QStringList names = this->Services.Questions->evaluated();
  if (!names.contains(this->Criterion) &&
    !this->Services.Questions->otherArrays().contains(this->Criterion))
  {
    const QString colored = this->Services.Display->colors().array(),
                  last = this->CriterionOf[this->ElementType];
    this->setCriterion(names.contains(colored) ? colored
        : names.contains(last)                 ? last
                                               : this->Services.Questions->worstCriterion());
    if (isOther && !this->Criterion.isEmpty() && colored != this->Criterion)
    { // the view still has the colors of other elements
      this->Services.Display->colors().colorBy(this->Criterion, this->userLimits());
    }
  }
}

//------------------------------------------------------------------------------
void pqInspectorState::followColors()
{
  const QString colored = this->Services.Display->colors().array();
  if (colored != this->Colored)
  {
    this->Colored = colored;
    if (this->Services.Questions->evaluated().contains(colored))
    {
      this->setCriterion(colored);
    }
  }
}

//------------------------------------------------------------------------------
QString pqInspectorState::criterion() const
{
  return this->awaitsElements() ? QString() : this->Criterion;
}

//------------------------------------------------------------------------------
void pqInspectorState::setCriterion(const QString& name)
{
  if (name == this->Criterion)
  {
    return;
  }
  this->Criterion = name;
  if (!name.isEmpty())
  {
    this->CriterionOf[this->ElementType] = name;
  }
  this->Acceptable = NoLimits;
  Q_EMIT this->criterionChanged();
}

//------------------------------------------------------------------------------
void pqInspectorState::setElements(const QString& type)
{
  if (type != this->WantedElements)
  {
    this->WantedElements = type;
    Q_EMIT this->elementsChanged();
  }
}

//------------------------------------------------------------------------------
bool pqInspectorState::awaitsElements() const
{
  return !this->WantedElements.isEmpty() &&
    this->WantedElements != this->Services.Mesh->elementType();
}

//------------------------------------------------------------------------------
QPair<double, double> pqInspectorState::limits() const
{
  return this->criterion().isEmpty() ? NoLimits : this->userLimits().value_or(this->Acceptable);
}

//------------------------------------------------------------------------------
void pqInspectorState::setAcceptable(double low, double high)
{
  this->Acceptable = { low, high };
}

//------------------------------------------------------------------------------
void pqInspectorState::chooseCriterion(const QString& name)
{
  this->setCriterion(name);
  this->Services.Display->colors().colorBy(name, this->userLimits());
}

//------------------------------------------------------------------------------
void pqInspectorState::setLimits(double low, double high)
{
  const QPair<double, double> limits(low, high);
  if (limits != this->limits())
  {
    this->changeLimits(limits);
  }
}

//------------------------------------------------------------------------------
void pqInspectorState::changeLimits(const camaron::Limits& limits)
{
  const Key key = this->keyOf(this->Criterion);
  const camaron::Limits before = std::exchange(this->LimitsOf[key], limits);
  if (before == limits)
  {
    return;
  }
  {
    const pqScopedUndoSet undo(tr("Change Acceptable Range"));
    this->Services.Display->colors().judgeBy(this->Criterion, limits);
    const auto restore = [state = QPointer<pqInspectorState>(this), key](
                           const camaron::Limits& restored)
    {
      if (state)
      {
        state->restoreLimits(key, restored);
      }
    };
    camaron::AddToUndo(
      this->Services.Mesh->server()->session(), [=] { restore(before); }, [=] { restore(limits); });
  }
  Q_EMIT this->limitsChanged();
}

//------------------------------------------------------------------------------
void pqInspectorState::restoreLimits(const Key& key, const camaron::Limits& limits)
{
  this->LimitsOf[key] = limits;
  if (key == this->keyOf(this->Criterion))
  {
    Q_EMIT this->limitsChanged();
  }
}

//------------------------------------------------------------------------------
bool pqInspectorState::mayCompute() const
{
  return this->Services.Mesh->isSmall() ||
    this->Services.Mesh->cellsVersion() == this->AllowedVersion;
}

//------------------------------------------------------------------------------
void pqInspectorState::allowComputing()
{
  this->AllowedVersion = this->Services.Mesh->cellsVersion();
  Q_EMIT this->computingAllowed();
}

//------------------------------------------------------------------------------
QString pqInspectorState::rule() const
{
  return IsCriterion(*this->Services.Questions, this->ElementType, this->Criterion)
    ? SpellRule(this->Criterion, this->limits(), this->ElementType)
    : QString();
}

//------------------------------------------------------------------------------
QStringList pqInspectorState::userRanges(const QString& elements) const
{
  QStringList lines;
  for (auto item = this->LimitsOf.cbegin(); item != this->LimitsOf.cend(); ++item)
  {
    const auto& [element, name] = item.key();
    if (element == elements && item.value() &&
      IsCriterion(*this->Services.Questions, element, name))
    {
      lines << SpellRange(name, *item.value());
    }
  }
  return lines;
}

//------------------------------------------------------------------------------
camaron::ReportRequest pqInspectorState::reportRequest() const
{
  camaron::ReportRequest request;
  request.Rules = this->Checked;
  QStringList lines = this->Checked.Rules.split('\n', Qt::SkipEmptyParts), known;
  for (const QString& line : std::as_const(lines))
  {
    known << line.section('#', 0, 0).simplified(); // the same rule twice is an error
  }
  for (auto item = this->LimitsOf.cbegin(); item != this->LimitsOf.cend(); ++item)
  {
    const auto& [element, criterion] = item.key();
    if (!item.value() || !IsCriterion(*this->Services.Questions, element, criterion))
    {
      continue;
    }
    const QString line = SpellRule(criterion, *item.value(), element);
    if (!line.isEmpty() && !known.contains(line))
    {
      lines << line;
    }
  }
  request.Rules.Rules = lines.join('\n');
  request.Ranges = this->userRanges("Cell");
  return request;
}
