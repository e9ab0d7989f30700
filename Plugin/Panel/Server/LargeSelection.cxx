// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LargeSelection.h"

#include "pqOutputPort.h"

#include "vtkClientServerStream.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSession.h"

#include <utility>

namespace camaron
{
namespace
{
constexpr int Nothing = 0, InsideRange = 3; // of Emphasis
}

//------------------------------------------------------------------------------
void LargeSelection::draw(
  const QVector<BrushedValues>& brushes, int emphasis, const QPair<double, double>& range) const
{
  vtkSMProxy* proxy = this->Mesh->getProxy();
  using Stream = vtkClientServerStream;
  Stream stream;
  const auto call = [&](vtkSMProxy* part, const char* method, auto... arguments)
  {
    stream << Stream::Invoke << VTKOBJECT(part) << method;
    (stream << ... << arguments) << Stream::End;
  };
  call(proxy, "SetSelectionVisibility",
    this->Selection ? 0 : vtkSMPropertyHelper(proxy, "SelectionVisibility").GetAsInt());
  vtkSMProxy* inspection = proxy->GetProperty("Emphasis")->GetParent(); // a part of it
  call(inspection, "SetEmphasis", emphasis);
  call(inspection, "SetAcceptableRange", range.first, range.second);
  constexpr double share = 0.6;
  const vtkSMPropertyHelper color(proxy, "SelectionColor");
  call(inspection, "SetAccent", color.GetAsDouble(0), color.GetAsDouble(1), color.GetAsDouble(2),
    brushes.isEmpty() ? 0.0 : share);
  int number = 0;
  for (const BrushedValues& brush : brushes)
  {
    number += static_cast<int>(brush.Thresholds.size() / 2);
  }
  call(inspection, "SetNumberOfBrushes", number);
  number = 0;
  for (const BrushedValues& brush : brushes)
  {
    const QByteArray array = brush.Array.toUtf8();
    for (std::size_t i = 0; i + 1 < brush.Thresholds.size(); i += 2)
    {
      call(inspection, "SetBrush", number++, array.constData(), brush.Thresholds[i],
        brush.Thresholds[i + 1], brush.How != Combination::Subtract ? 1 : 0);
    }
  }
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
void LargeSelection::follow(pqDataRepresentation* mesh)
{
  if (mesh != this->Mesh)
  {
    this->hide();
    this->Mesh = mesh;
  }
}

//------------------------------------------------------------------------------
void LargeSelection::show(
  pqDataRepresentation* mesh, vtkSMSourceProxy* selection, const QVector<BrushedValues>& brushes)
{
  this->follow(mesh);
  this->Selection = selection;
  this->draw(brushes, Nothing, {});
}

//------------------------------------------------------------------------------
void LargeSelection::preview(pqDataRepresentation* mesh, const QPair<double, double>& range)
{
  this->follow(mesh);
  this->draw({}, InsideRange, range);
}

//------------------------------------------------------------------------------
void LargeSelection::hide()
{
  if (this->Mesh)
  {
    vtkSMProxy* proxy = this->Mesh->getProxy();
    if (std::exchange(this->Selection, nullptr))
    {
      proxy->MarkDirty(nullptr); // what ParaView draws of a selection is not up to date
    }
    const vtkSMPropertyHelper range(proxy, "AcceptableRange");
    this->draw({}, vtkSMPropertyHelper(proxy, "Emphasis").GetAsInt(),
      { range.GetAsDouble(0), range.GetAsDouble(1) });
    this->Mesh = nullptr;
  }
}
}
