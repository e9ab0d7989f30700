// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OnLoading.h"

#include "Base/FormerNames.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPVXMLElement.h"
#include "vtkProcessModule.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyLocator.h"
#include "vtkSMProxyManager.h"

#include <string>
#include <string_view>

namespace
{
//------------------------------------------------------------------------------
// A former name of another plugin's property is not ours: the proxy must have the new name instead.
void CheckProxy(vtkPVXMLElement* element, vtkSMProxyLocator* locator)
{
  int id = 0;
  vtkSMProxy* const proxy =
    element->GetScalarAttribute("id", &id) ? locator->LocateProxy(id) : nullptr;
  for (unsigned int i = 0; proxy && i < element->GetNumberOfNestedElements(); ++i)
  {
    const std::string_view name = element->GetNestedElement(i)->GetAttributeOrEmpty("name");
    for (const camaron::FormerName& entry : camaron::FormerNames)
    {
      const std::string former(entry.Former), present(entry.Name);
      if (name == former && !proxy->GetProperty(former.c_str()) &&
        proxy->GetProperty(present.c_str()))
      {
        vtkErrorWithObjectMacro(proxy, << proxy->GetXMLLabel() << " has no property " << former
                                       << camaron::DescribeFormerName(former)
                                       << ". The value of the state file is ignored.");
      }
    }
  }
}

//------------------------------------------------------------------------------
void CheckElements(vtkPVXMLElement* parent, vtkSMProxyLocator* locator)
{
  for (unsigned int i = 0; i < parent->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* const element = parent->GetNestedElement(i);
    if (element->GetName() == std::string_view("Proxy"))
    {
      CheckProxy(element, locator);
    }
    else
    {
      CheckElements(element, locator);
    }
  }
}

//------------------------------------------------------------------------------
void CheckState(vtkObject*, unsigned long, void*, void* data)
{
  const auto* information = static_cast<vtkSMProxyManager::LoadStateInformation*>(data);
  CheckElements(information->RootElement, information->ProxyLocator);
}
}

namespace camaron
{
//------------------------------------------------------------------------------
void CheckStates()
{
  if (!vtkProcessModule::GetProcessModule())
  {
    return;
  }
  // See FollowSessions about the type of observer.
  vtkNew<vtkCallbackCommand> callback;
  callback->SetCallback(CheckState);
  vtkSMProxyManager::GetProxyManager()->AddObserver(vtkCommand::LoadStateEvent, callback);
}
}
