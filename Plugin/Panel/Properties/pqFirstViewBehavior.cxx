// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqFirstViewBehavior.h"

#include "ProxyValues.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqRenderView.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"

#include "vtkPVDataInformation.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"

#include <QTimer>

#include <algorithm>
#include <cstring>
#include <iterator>

namespace
{
//------------------------------------------------------------------------------
bool IsInspection(vtkSMProxy* representation)
{
  const char* type = vtkSMPropertyHelper(representation, "Representation", true).GetAsString();
  return type && std::strcmp(type, "Mesh Inspection") == 0;
}

//------------------------------------------------------------------------------
// Undo changes the type back, and another type may have this look, too.
void LookInspected(vtkSMProxy* representation)
{
  if (IsInspection(representation))
  {
    const pqScopedUndoExclude pause;
    camaron::SetLookOfInspection(representation);
  }
}

//------------------------------------------------------------------------------
// States have their own look.
bool IsLoading(vtkSMProxy* representation)
{
  return representation->GetSessionProxyManager()->GetInLoadXMLState();
}

//------------------------------------------------------------------------------
bool IsUntouched(vtkSMProxy* view)
{
  const char* const names[] = { "CameraPosition", "CameraFocalPoint", "CameraViewUp" };
  return std::all_of(std::begin(names), std::end(names),
    [view](const char* name) { return view->GetProperty(name)->IsValueDefault(); });
}

//------------------------------------------------------------------------------
bool IsSolid(const pqDataRepresentation* representation)
{
  const pqOutputPort* port = representation->getOutputPortFromInput();
  const double* bounds = port ? port->getDataInformation()->GetBounds() : nullptr;
  return bounds && bounds[0] < bounds[1] && bounds[2] < bounds[3] && bounds[4] < bounds[5];
}

//------------------------------------------------------------------------------
int CountData(const pqView* view)
{
  int count = 0;
  for (pqRepresentation* shown : view->getRepresentations())
  {
    count += qobject_cast<pqDataRepresentation*>(shown) ? 1 : 0;
  }
  return count;
}
}

//------------------------------------------------------------------------------
pqFirstViewBehavior::pqFirstViewBehavior(QObject* parent)
  : QObject(parent)
{
}

//------------------------------------------------------------------------------
void pqFirstViewBehavior::startup()
{
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::connect(model, &pqServerManagerModel::viewAdded, this, &pqFirstViewBehavior::follow);
  for (pqView* view : model->findItems<pqView*>())
  {
    this->follow(view);
  }
}

//------------------------------------------------------------------------------
void pqFirstViewBehavior::shutdown()
{
  QObject::disconnect(
    pqApplicationCore::instance()->getServerManagerModel(), nullptr, this, nullptr);
}

//------------------------------------------------------------------------------
// ParaView moves the camera to the data afterwards, and keeps its direction.
void pqFirstViewBehavior::follow(pqView* view)
{
  auto* drawing = qobject_cast<pqRenderView*>(view);
  if (!drawing)
  {
    return;
  }
  QObject::connect(drawing, &pqView::representationAdded, this,
    [drawing](pqRepresentation* added)
    {
      auto* data = qobject_cast<pqDataRepresentation*>(added);
      if (!data || !data->getProxy()->GetProperty("CutBy")) // of Mesh Inspection
      {
        return;
      }
      // Later, so that it is recorded by itself.
      QObject::connect(data, &pqDataRepresentation::representationTypeModified, data,
        [data]
        {
          if (!IsLoading(data->getProxy()))
          {
            QTimer::singleShot(0, data, [data] { LookInspected(data->getProxy()); });
          }
        });
      if (!IsInspection(data->getProxy()) || IsLoading(data->getProxy()))
      {
        return;
      }
      camaron::SetLookOfInspection(data->getProxy());
      if (CountData(drawing) == 1 && IsUntouched(drawing->getProxy()) && IsSolid(data))
      {
        drawing->getRenderViewProxy()->ApplyIsometricView();
      }
    });
}
