// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ElementMarker.h"

#include "ProxyValues.h"

#include "pqUndoStack.h"

#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"

namespace camaron
{
//------------------------------------------------------------------------------
ElementMarker::~ElementMarker()
{
  this->hide();
}

//------------------------------------------------------------------------------
void ElementMarker::show(pqRenderView* view, vtkSMSourceProxy* elements)
{
  const pqScopedUndoExclude pause;
  this->hide();
  this->Representation.TakeReference(
    elements->GetSessionProxyManager()->NewProxy("representations", "GeometryRepresentation"));
  if (!this->Representation)
  {
    return;
  }
  vtkSMPropertyHelper(this->Representation, "Input").Set(elements);
  // Yellow is not in the color maps of criteria, and no color of selections.
  const QVariantList yellow = { 1.0, 0.9, 0.1 };
  constexpr double width = 4;
  SetProperties(this->Representation,
    { { "Representation", QString("Wireframe") }, { "AmbientColor", yellow },
      { "DiffuseColor", yellow }, { "LineWidth", width }, { "Pickable", 0 } });
  this->View = view;
  vtkSMPropertyHelper(view->getProxy(), "HiddenRepresentations", true).Add(this->Representation);
  view->getProxy()->UpdateVTKObjects();
}

//------------------------------------------------------------------------------
void ElementMarker::hide()
{
  if (this->Representation && this->View)
  {
    const pqScopedUndoExclude pause;
    vtkSMPropertyHelper(this->View->getProxy(), "HiddenRepresentations", true)
      .Remove(this->Representation);
    this->View->getProxy()->UpdateVTKObjects();
    this->View->render(); // later
  }
  this->Representation = nullptr;
  this->View = nullptr;
}
}
