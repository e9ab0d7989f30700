// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqInspectorState.h"

#include "pqInspectedMesh.h"

//------------------------------------------------------------------------------
pqInspectorState::pqInspectorState(pqInspectedMesh* mesh, QObject* parent)
  : QObject(parent)
  , Mesh(mesh)
{
  QObject::connect(mesh, &pqInspectedMesh::meshChanged, this, &pqInspectorState::followMesh);
}

//------------------------------------------------------------------------------
pqInspectorState::~pqInspectorState() = default;

//------------------------------------------------------------------------------
void pqInspectorState::followMesh()
{
  const QStringList names = this->Mesh->evaluated();
  if (!names.contains(this->Criterion))
  {
    const QString colored = this->Mesh->coloredBy();
    this->setCriterion(names.contains(colored) ? colored : names.value(0));
  }
}

//------------------------------------------------------------------------------
void pqInspectorState::setCriterion(const QString& name)
{
  if (name == this->Criterion)
  {
    return;
  }
  this->Criterion = name;
  this->KnowsLimits = false;
  this->HasUserLimits = false;
  Q_EMIT this->criterionChanged();
}

//------------------------------------------------------------------------------
void pqInspectorState::findLimits() const
{
  if (!this->KnowsLimits)
  { // the range of the criterion, unless it does not apply to these cells
    this->KnowsLimits = true;
    camaron::DistributionRequest request;
    request.Bins = 1;
    const camaron::Distribution shown = this->Criterion.isEmpty()
      ? camaron::Distribution()
      : this->Mesh->distributions({ this->Criterion }, request).value(0);
    this->Low = shown.Low;
    this->High = shown.High;
  }
}

//------------------------------------------------------------------------------
double pqInspectorState::low() const
{
  this->findLimits();
  return this->Low;
}

//------------------------------------------------------------------------------
double pqInspectorState::high() const
{
  this->findLimits();
  return this->High;
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
  if (low != this->low() || high != this->high())
  {
    this->Low = low;
    this->High = high;
    this->HasUserLimits = true;
    Q_EMIT this->limitsChanged();
  }
}
