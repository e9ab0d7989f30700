// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqInspectorState.h"

#include "pqInspectedMesh.h"

#include <limits>

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
const QPair<double, double> NoLimits = { -Infinity, Infinity };
}

//------------------------------------------------------------------------------
pqInspectorState::pqInspectorState(pqInspectedMesh* mesh, QObject* parent)
  : QObject(parent)
  , Mesh(mesh)
  , Acceptable(NoLimits)
{
  QObject::connect(mesh, &pqInspectedMesh::meshChanged, this, &pqInspectorState::followMesh);
  QObject::connect(mesh, &pqInspectedMesh::displayChanged, this, &pqInspectorState::followColors);
}

//------------------------------------------------------------------------------
pqInspectorState::~pqInspectorState() = default;

//------------------------------------------------------------------------------
void pqInspectorState::followMesh()
{
  const bool isOther = this->Mesh->elementType() != this->ElementType;
  if (isOther)
  {
    this->setCriterion(QString());
    this->ElementType = this->Mesh->elementType();
  }
  const QStringList names = this->Mesh->evaluated();
  if (!names.contains(this->Criterion))
  {
    const QString colored = this->Mesh->coloredBy(), last = this->CriterionOf[this->ElementType];
    this->setCriterion(names.contains(colored) ? colored
        : names.contains(last)                 ? last
                                               : this->Mesh->worstCriterion());
    if (isOther && !this->Criterion.isEmpty() && colored != this->Criterion)
    { // the view still has the colors of other elements
      this->Mesh->colorBy(this->Criterion);
    }
  }
}

//------------------------------------------------------------------------------
void pqInspectorState::followColors()
{
  const QString colored = this->Mesh->coloredBy();
  if (colored != this->Colored)
  {
    this->Colored = colored;
    if (this->Mesh->evaluated().contains(colored))
    {
      this->setCriterion(colored);
    }
  }
}

//------------------------------------------------------------------------------
void pqInspectorState::setCriterion(const QString& name)
{
  if (name == this->Criterion)
  {
    return;
  }
  const auto key = [this](const QString& criterion) { return this->ElementType + '/' + criterion; };
  this->LimitsOf[key(this->Criterion)] = this->UserLimits;
  this->Criterion = name;
  if (!name.isEmpty())
  {
    this->CriterionOf[this->ElementType] = name;
  }
  this->Acceptable = NoLimits;
  this->UserLimits = this->LimitsOf[key(name)];
  Q_EMIT this->criterionChanged();
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
  this->Mesh->colorBy(name);
}

//------------------------------------------------------------------------------
void pqInspectorState::setLimits(double low, double high)
{
  const QPair<double, double> limits(low, high);
  if (limits != this->limits())
  {
    this->UserLimits = limits;
    Q_EMIT this->limitsChanged();
  }
}

//------------------------------------------------------------------------------
void pqInspectorState::resetLimits()
{
  if (this->UserLimits)
  {
    this->UserLimits.reset();
    Q_EMIT this->limitsChanged();
  }
}

//------------------------------------------------------------------------------
bool pqInspectorState::mayCompute() const
{
  return this->Mesh->isSmall() || this->Mesh->cellsVersion() == this->AllowedVersion;
}

//------------------------------------------------------------------------------
void pqInspectorState::allowComputing()
{
  this->AllowedVersion = this->Mesh->cellsVersion();
  Q_EMIT this->computingAllowed();
}
