// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqMeshServices.h"

#include "pqInspectedMesh.h"
#include "pqMeshDisplay.h"
#include "pqMeshFilters.h"
#include "pqMeshQuestions.h"
#include "pqMeshSelection.h"

#include "pqApplicationCore.h"

#include <QPointer>

//------------------------------------------------------------------------------
pqMeshServices* pqMeshServices::instance()
{
  static QPointer<pqMeshServices> services;
  if (!services)
  {
    services = new pqMeshServices(pqApplicationCore::instance());
  }
  return services;
}

//------------------------------------------------------------------------------
// In this order, each also hears of changes before those that depend on it.
pqMeshServices::pqMeshServices(QObject* parent)
  : QObject(parent)
  , Mesh(new pqInspectedMesh(this))
  , Questions(new pqMeshQuestions(this->Mesh, this))
  , Filters(new pqMeshFilters(this->Mesh, this->Questions, this))
  , Selection(new pqMeshSelection(this->Mesh, this->Questions, this->Filters, this))
  , Display(new pqMeshDisplay(this->Mesh, this->Questions, this->Selection, this))
{
}

//------------------------------------------------------------------------------
pqMeshServices::~pqMeshServices()
{
  delete this->Display;
  delete this->Selection;
  delete this->Filters;
  delete this->Questions;
  delete this->Mesh;
}
