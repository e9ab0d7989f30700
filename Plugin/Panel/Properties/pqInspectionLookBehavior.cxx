// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqInspectionLookBehavior.h"

#include "MeshColors.h"
#include "ProxyValues.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqRenderView.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"

#include "vtkPVDataInformation.h"
#include "vtkSMColorMapEditorHelper.h"
#include "vtkSMProperty.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"

#include <QTimer>

#include <algorithm>
#include <iterator>
#include <memory>

namespace
{
//------------------------------------------------------------------------------
// What is known of the light of a representation.
struct Coloring
{
  bool IsKnown = false; ///< else it was just made, or loaded from a state
  bool IsEven = false;  ///< the light may be, when it was looked at last
  bool WasEven = false; ///< the light was even, and was taken back
};

//------------------------------------------------------------------------------
bool IsInspection(vtkSMProxy* display)
{
  return camaron::GetProperty(display, "Representation") == camaron::InspectionName;
}

//------------------------------------------------------------------------------
// Undo changes the coloring, and the light follows that.
void UpdateLight(vtkSMProxy* display, Coloring& coloring)
{
  const bool isEven =
    vtkSMColorMapEditorHelper::GetUsingScalarColoring(display) || IsInspection(display);
  const bool changes = coloring.IsKnown && isEven != coloring.IsEven;
  coloring.IsKnown = true;
  coloring.IsEven = isEven;
  const pqScopedUndoExclude pause;
  if (changes && isEven && coloring.WasEven)
  {
    camaron::SetLightOfLegends(display);
  }
  else if (changes && !isEven)
  {
    coloring.WasEven = camaron::ResetLightOfLegends(display) || coloring.WasEven;
  }
}

//------------------------------------------------------------------------------
// Undo changes the type back, and another type may have this look, too.
void LookInspected(vtkSMProxy* display)
{
  if (IsInspection(display))
  {
    const pqScopedUndoExclude pause;
    camaron::SetLookOfInspection(display);
  }
}

//------------------------------------------------------------------------------
// States have their own look.
bool IsLoading(vtkSMProxy* display)
{
  return display->GetSessionProxyManager()->GetInLoadXMLState();
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
// A representation that may be of Mesh Inspection; else nullptr.
pqDataRepresentation* GetInspectable(pqRepresentation* representation)
{
  auto* data = qobject_cast<pqDataRepresentation*>(representation);
  return data && data->getProxy()->GetProperty("CutBy") ? data : nullptr;
}
}

//------------------------------------------------------------------------------
void pqInspectionLookBehavior::startup()
{
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::connect(
    model, &pqServerManagerModel::viewAdded, this, &pqInspectionLookBehavior::followView);
  QObject::connect(
    model, &pqServerManagerModel::representationAdded, this, &pqInspectionLookBehavior::follow);
  for (pqView* view : model->findItems<pqView*>())
  {
    this->followView(view);
  }
  for (pqRepresentation* representation : model->findItems<pqRepresentation*>())
  {
    this->follow(representation);
  }
}

//------------------------------------------------------------------------------
void pqInspectionLookBehavior::shutdown()
{
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::disconnect(model, nullptr, this, nullptr);
  for (pqRepresentation* representation : model->findItems<pqRepresentation*>())
  {
    QObject::disconnect(representation, nullptr, this, nullptr);
  }
}

//------------------------------------------------------------------------------
// ParaView moves the camera to the data afterwards, and keeps its direction.
void pqInspectionLookBehavior::followView(pqView* view)
{
  auto* drawing = qobject_cast<pqRenderView*>(view);
  if (!drawing)
  {
    return;
  }
  QObject::connect(drawing, &pqView::representationAdded, this,
    [drawing](pqRepresentation* added)
    {
      pqDataRepresentation* data = GetInspectable(added);
      if (!data || !IsInspection(data->getProxy()) || IsLoading(data->getProxy()))
      {
        return;
      }
      camaron::SetLookOfInspection(data->getProxy());
      const QList<pqRepresentation*> shown = drawing->getRepresentations();
      const auto isData = [](pqRepresentation* candidate)
      { return qobject_cast<pqDataRepresentation*>(candidate) != nullptr; };
      if (std::count_if(shown.begin(), shown.end(), isData) == 1 &&
        IsUntouched(drawing->getProxy()) && IsSolid(data))
      {
        drawing->getRenderViewProxy()->ApplyIsometricView();
      }
    });
}

//------------------------------------------------------------------------------
// Later, so that it is recorded by itself, and after all of a state or an undo step is there.
void pqInspectionLookBehavior::follow(pqRepresentation* representation)
{
  pqDataRepresentation* data = GetInspectable(representation);
  if (!data)
  {
    return;
  }
  const auto updateLight = [data, coloring = std::make_shared<Coloring>()]
  { QTimer::singleShot(0, data, [=] { UpdateLight(data->getProxy(), *coloring); }); };
  QObject::connect(data, &pqDataRepresentation::colorArrayNameModified, this, updateLight);
  QObject::connect(data, &pqDataRepresentation::representationTypeModified, this,
    [data, updateLight]
    {
      updateLight();
      if (!IsLoading(data->getProxy()))
      {
        QTimer::singleShot(0, data, [data] { LookInspected(data->getProxy()); });
      }
    });
  updateLight();
}
