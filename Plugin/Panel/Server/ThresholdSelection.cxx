// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ThresholdSelection.h"

#include "ProxyValues.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqOutputPort.h"
#include "pqPipelineFilter.h"
#include "pqPipelineSource.h"
#include "pqSelectionManager.h"
#include "pqUndoStack.h"

#include "vtkDataObject.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSelectionHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTrace.h"
#include "vtkSelectionNode.h"

#include <QPointer>

#include <string>

namespace camaron
{
namespace
{
constexpr const char* SelectedArray = "Selected"; // see vtkSelectElements
}

//------------------------------------------------------------------------------
pqSelectionManager* GetSelectionManager()
{
  return qobject_cast<pqSelectionManager*>(
    pqApplicationCore::instance()->manager("SELECTION_MANAGER"));
}

//------------------------------------------------------------------------------
bool IsFilter(pqPipelineSource* source, const QString& name)
{
  return source && name == source->getProxy()->GetXMLName();
}

//------------------------------------------------------------------------------
pqOutputPort* GetInput(pqPipelineSource* source)
{
  auto* filter = qobject_cast<pqPipelineFilter*>(source);
  const QList<pqOutputPort*> inputs = filter ? filter->getInputs("Input") : QList<pqOutputPort*>();
  return inputs.isEmpty() ? nullptr : inputs.front();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSMSourceProxy> MakeThresholdSelection(pqPipelineSource* source,
  const QString& array, const std::vector<double>& thresholds, bool isOfPoints)
{
  const auto description = vtkSmartPointer<vtkSMSourceProxy>::Take(vtkSMSourceProxy::SafeDownCast(
    source->proxyManager()->NewProxy("sources", "ThresholdSelectionSource")));
  vtkSMPropertyHelper(description, "ArrayName").Set(array.toUtf8().constData());
  vtkSMPropertyHelper(description, "Thresholds")
    .Set(thresholds.data(), static_cast<unsigned>(thresholds.size()));
  vtkSMPropertyHelper(description, "FieldType")
    .Set(isOfPoints ? vtkSelectionNode::POINT : vtkSelectionNode::CELL);
  description->UpdateVTKObjects();
  return vtkSmartPointer<vtkSMSourceProxy>::Take(vtkSMSourceProxy::SafeDownCast(
    vtkSMSelectionHelper::NewAppendSelectionsFromSelectionSource(description)));
}

//------------------------------------------------------------------------------
bool IsResult(vtkSMSourceProxy* selection)
{
  vtkSMPropertyHelper input(selection, "Input");
  vtkSMProxy* only = input.GetNumberOfElements() == 1 ? input.GetAsProxy(0) : nullptr;
  return only && only->GetProperty("ArrayName") && only->GetProperty("Thresholds") &&
    vtkSMPropertyHelper(only, "ArrayName").GetAsString() == std::string(SelectedArray);
}

//------------------------------------------------------------------------------
BrushedValues GetResultValues()
{
  return { SelectedArray, { 1, 1 } };
}

//------------------------------------------------------------------------------
void TraceThresholds(
  pqOutputPort* port, const BrushedValues& brush, bool isOfPoints, const char* comment)
{
  // The expression that makes a trace item must have all arguments.
#define CAMARON_TRACE                                                                              \
  SM_SCOPED_TRACE(CallFunction)                                                                    \
    .arg("SelectThresholds")                                                                       \
    .arg("Thresholds", brush.Thresholds)                                                           \
    .arg("ArrayName", brush.Array.toUtf8().constData())                                            \
    .arg("FieldType", isOfPoints ? "POINT" : "CELL")                                               \
    .arg("Source", port->getSourceProxy())                                                         \
    .arg("comment", comment)
  if (brush.How != Combination::Replace)
  {
    CAMARON_TRACE.arg("Modifier", brush.How == Combination::Add ? "ADD" : "SUBTRACT");
  }
  else
  {
    CAMARON_TRACE;
  }
#undef CAMARON_TRACE
}

//------------------------------------------------------------------------------
void ActivateResult(pqPipelineSource* source)
{
  pqSelectionManager* manager = GetSelectionManager();
  if (!manager)
  {
    return;
  }
  const bool isOfPoints = GetProperty(source->getProxy(), "ElementType") == "Points";
  const BrushedValues values = GetResultValues();
  {
    const pqScopedUndoExclude pause;
    const auto selection =
      MakeThresholdSelection(source, values.Array, values.Thresholds, isOfPoints);
    // The first call clears selections of all other outputs. Both calls change the active source,
    // which a script may have set to something else.
    const QPointer<pqOutputPort> active = pqActiveObjects::instance().activePort();
    pqOutputPort* port = source->getOutputPort(0);
    manager->select(port);
    port->setSelectionInput(selection, 0);
    manager->select(port);
    if (active && active->getSource() != source)
    {
      pqActiveObjects::instance().setActivePort(active);
    }
  }

  TraceThresholds(source->getOutputPort(0), values, isOfPoints,
    "make what Select Elements selects the active selection");
}

//------------------------------------------------------------------------------
bool IsOfPoints(vtkSMSourceProxy* selection)
{
  vtkSMPropertyHelper input(selection, "Input");
  vtkSMProxy* first = input.GetNumberOfElements() > 0 ? input.GetAsProxy(0) : nullptr;
  if (!first)
  {
    return false;
  }
  return first->GetProperty("FieldType")
    ? vtkSMPropertyHelper(first, "FieldType").GetAsInt() == vtkSelectionNode::POINT
    : vtkSMPropertyHelper(first, "ElementType", true).GetAsInt() == vtkDataObject::POINT;
}
}
