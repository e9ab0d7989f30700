// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqLegendLightBehavior.h"

#include "ProxyValues.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"

#include "vtkSMColorMapEditorHelper.h"
#include "vtkSMProxy.h"

#include <QTimer>

#include <memory>

namespace
{
//------------------------------------------------------------------------------
// What is known of a representation.
struct Coloring
{
  bool IsKnown = false; ///< else it was just made, or loaded from a state
  bool IsEven = false;  ///< the light may be, when it was looked at last
  bool WasEven = false; ///< the light was even, and was taken back
};

//------------------------------------------------------------------------------
void Update(vtkSMProxy* display, Coloring& coloring)
{
  const bool isEven = vtkSMColorMapEditorHelper::GetUsingScalarColoring(display) ||
    camaron::GetProperty(display, "Representation") == "Mesh Inspection";
  const bool changes = coloring.IsKnown && isEven != coloring.IsEven;
  coloring.IsKnown = true;
  coloring.IsEven = isEven;
  if (!changes)
  {
    return;
  }
  // Undo changes the coloring, and the light follows that.
  const pqScopedUndoExclude pause;
  if (isEven && coloring.WasEven)
  {
    camaron::SetLightOfLegends(display);
  }
  else if (!isEven)
  {
    coloring.WasEven = camaron::ResetLightOfLegends(display) || coloring.WasEven;
  }
}
}

//------------------------------------------------------------------------------
pqLegendLightBehavior::pqLegendLightBehavior(QObject* parent)
  : QObject(parent)
{
}

//------------------------------------------------------------------------------
void pqLegendLightBehavior::startup()
{
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::connect(
    model, &pqServerManagerModel::representationAdded, this, &pqLegendLightBehavior::follow);
  for (pqRepresentation* representation : model->findItems<pqRepresentation*>())
  {
    this->follow(representation);
  }
}

//------------------------------------------------------------------------------
void pqLegendLightBehavior::shutdown()
{
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::disconnect(model, nullptr, this, nullptr);
  for (pqRepresentation* representation : model->findItems<pqRepresentation*>())
  {
    QObject::disconnect(representation, nullptr, this, nullptr);
  }
}

//------------------------------------------------------------------------------
void pqLegendLightBehavior::follow(pqRepresentation* representation)
{
  auto* data = qobject_cast<pqDataRepresentation*>(representation);
  if (!data || !data->getProxy()->GetProperty("CutBy")) // of Mesh Inspection
  {
    return;
  }
  // Later, so that it is recorded by itself, and after all of a state or an undo step is there.
  const auto look = [data, coloring = std::make_shared<Coloring>()]
  { QTimer::singleShot(0, data, [data, coloring] { Update(data->getProxy(), *coloring); }); };
  QObject::connect(data, &pqDataRepresentation::colorArrayNameModified, this, look);
  QObject::connect(data, &pqDataRepresentation::representationTypeModified, this, look);
  look();
}
