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
  // The range of the criterion, unless it does not apply to these cells.
  camaron::DistributionRequest request;
  request.Bins = 1;
  const camaron::Distribution shown = name.isEmpty()
    ? camaron::Distribution()
    : this->Mesh->distributions({ name }, request).value(0);
  this->Low = shown.Low;
  this->High = shown.High;
  this->HasDefaultLimits = true;
  Q_EMIT this->criterionChanged();
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
  if (low != this->Low || high != this->High)
  {
    this->Low = low;
    this->High = high;
    this->HasDefaultLimits = false;
    Q_EMIT this->limitsChanged();
  }
}
