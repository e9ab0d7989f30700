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
void ElementMarker::show(
  pqRenderView* view, vtkSMSourceProxy* elements, const QMap<QString, QVariant>& properties)
{
  const pqScopedUndoExclude pause;
  if (this->Representation && this->View == view && this->Elements == elements)
  {
    SetProperties(this->Representation, properties);
    view->render(); // later
    return;
  }
  this->hide();
  this->Representation.TakeReference(
    elements->GetSessionProxyManager()->NewProxy("representations", this->Name));
  if (!this->Representation)
  {
    return;
  }
  vtkSMPropertyHelper(this->Representation, "Input").Set(elements);
  SetProperties(this->Representation, properties);
  this->View = view;
  this->Elements = elements;
  vtkSMPropertyHelper(view->getProxy(), "HiddenRepresentations", true).Add(this->Representation);
  view->getProxy()->UpdateVTKObjects();
  view->getProxy()->MarkDirty(
    nullptr);     // ParaView does not notice that it has to update a hidden one
  view->render(); // later
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
