// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LargeSelection.h"

#include "pqOutputPort.h"

#include "vtkClientServerStream.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSession.h"

namespace camaron
{
namespace
{
constexpr int InsideRange = 3; // of Emphasis
}

//------------------------------------------------------------------------------
void LargeSelection::draw(bool isLarge, int emphasis, const QPair<double, double>& range) const
{
  vtkSMProxy* proxy = this->Mesh->getProxy();
  using Stream = vtkClientServerStream;
  Stream stream;
  const int isVisible = vtkSMPropertyHelper(proxy, "SelectionVisibility").GetAsInt();
  stream << Stream::Invoke << VTKOBJECT(proxy) << "SetSelectionVisibility"
         << (isLarge ? 0 : isVisible) << Stream::End;
  vtkSMProxy* inspection = proxy->GetProperty("Emphasis")->GetParent(); // a part of it
  const auto call = [&](const char* method, auto... arguments)
  {
    stream << Stream::Invoke << VTKOBJECT(inspection) << method;
    (stream << ... << arguments) << Stream::End;
  };
  call("SetEmphasis", emphasis);
  call("SetAcceptableRange", range.first, range.second);
  constexpr double share = 0.6;
  const vtkSMPropertyHelper color(proxy, "SelectionColor");
  call("SetAccent", color.GetAsDouble(0), color.GetAsDouble(1), color.GetAsDouble(2),
    isLarge ? share : 0.0);
  proxy->GetSession()->ExecuteStream(proxy->GetLocation(), stream);
  this->Mesh->renderViewEventually();
}

//------------------------------------------------------------------------------
bool LargeSelection::isActive() const
{
  pqOutputPort* port = this->Mesh ? this->Mesh->getOutputPortFromInput() : nullptr;
  return port && port->getSelectionInput() == this->Selection;
}

//------------------------------------------------------------------------------
void LargeSelection::show(
  pqDataRepresentation* mesh, vtkSMSourceProxy* selection, const QPair<double, double>& range)
{
  if (mesh != this->Mesh)
  {
    this->hide();
    this->Mesh = mesh;
  }
  this->Selection = selection;
  this->draw(true, InsideRange, range);
}

//------------------------------------------------------------------------------
void LargeSelection::hide()
{
  if (this->Mesh)
  {
    vtkSMProxy* proxy = this->Mesh->getProxy();
    const vtkSMPropertyHelper range(proxy, "AcceptableRange");
    this->draw(false, vtkSMPropertyHelper(proxy, "Emphasis").GetAsInt(),
      { range.GetAsDouble(0), range.GetAsDouble(1) });
    proxy->MarkDirty(nullptr); // what ParaView draws of a selection is not up to date
    this->Mesh = nullptr;
    this->Selection = nullptr;
  }
}
}
