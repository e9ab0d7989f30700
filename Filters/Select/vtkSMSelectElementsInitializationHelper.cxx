// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMSelectElementsInitializationHelper.h"

#include "vtkObjectFactory.h"
#include "vtkPVVersionQuick.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMTrace.h"

#include <string>

namespace
{
//------------------------------------------------------------------------------
// Uses the name that ParaView's panel would give the proxy on Apply.
void RegisterSelection(vtkSMProxy* proxy, const char* kind)
{
  constexpr const char* group = "selection_sources";
  vtkSMSessionProxyManager* manager = proxy->GetSessionProxyManager();
  if (!manager->GetProxyName(group, proxy))
  {
    const std::string name = std::string(kind) + "." + proxy->GetGlobalIDAsString();
    manager->RegisterProxy(group, name.c_str(), proxy);
#if PARAVIEW_VERSION_NUMBER_QUICK <                                                                \
  PARAVIEW_VERSION_CHECK(6, 1, 0) // whose trace handles this in states only
    SM_SCOPED_TRACE(RegisterSelectionProxy).arg("proxy", proxy);
#endif
  }
}
}

vtkStandardNewMacro(vtkSMSelectElementsInitializationHelper);

//------------------------------------------------------------------------------
void vtkSMSelectElementsInitializationHelper::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement* element, vtkMTimeType initializedAt)
{
  // The superclass requires an input, and would replace a selection set by a script.
  vtkSMPropertyHelper selection(proxy, "Selection");
  if (!vtkSMPropertyHelper(proxy, "Input").GetAsProxy() || selection.GetAsProxy())
  {
    return;
  }
  this->Superclass::PostInitializeProxy(proxy, element, initializedAt);
  if (selection.GetAsProxy())
  {
    vtkSMPropertyHelper parts(selection.GetAsProxy(), "Input");
    for (unsigned int i = 0; i < parts.GetNumberOfElements(); ++i)
    {
      RegisterSelection(parts.GetAsProxy(i), "selection_sources");
    }
    RegisterSelection(selection.GetAsProxy(), "selection_filter");
#if PARAVIEW_VERSION_NUMBER_QUICK >= PARAVIEW_VERSION_CHECK(6, 1, 0)
    // A replayed trace copies the active selection again: the constructor needs no argument, and
    // ParaView would skip the creation because it cannot trace this one.
    if (vtkSMTrace::GetActiveTracer())
    {
      proxy->GetProperty("Selection")->SetPanelVisibility("never");
    }
#endif
  }
}
