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
  QObject::connect(mesh, &pqInspectedMesh::displayChanged, this, &pqInspectorState::followColors);
}

//------------------------------------------------------------------------------
pqInspectorState::~pqInspectorState() = default;

//------------------------------------------------------------------------------
void pqInspectorState::followMesh()
{
  this->Acceptable.reset(); // may not apply to other cells
  if (this->Mesh->elementType() != this->ElementType)
  {
    this->ElementType = this->Mesh->elementType();
    this->UserLimits.reset();
  }
  const QStringList names = this->Mesh->evaluated();
  if (!names.contains(this->Criterion))
  {
    const QString colored = this->Mesh->coloredBy();
    this->setCriterion(names.contains(colored) ? colored : names.value(0));
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
  this->Criterion = name;
  this->Acceptable.reset();
  this->UserLimits.reset();
  Q_EMIT this->criterionChanged();
}

//------------------------------------------------------------------------------
QPair<double, double> pqInspectorState::limits() const
{
  if (this->UserLimits)
  {
    return *this->UserLimits;
  }
  if (!this->Acceptable)
  { // infinite if the range does not apply to these cells
    camaron::DistributionRequest request;
    request.Bins = 1;
    const camaron::Distribution shown = this->Criterion.isEmpty()
      ? camaron::Distribution()
      : this->Mesh->distributions({ this->Criterion }, request).value(0);
    this->Acceptable = QPair<double, double>(shown.Low, shown.High);
  }
  return *this->Acceptable;
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
