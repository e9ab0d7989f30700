// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InspectionModes.h"

#include <pqActiveObjects.h>
#include <pqServer.h>

#include <vtkNew.h>
#include <vtkPVXMLElement.h>
#include <vtkSMEnumerationDomain.h>
#include <vtkSMOrderedPropertyIterator.h>
#include <vtkSMProperty.h>
#include <vtkSMProxy.h>
#include <vtkSMSessionProxyManager.h>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
vtkSMProxy* FindDefinition()
{
  constexpr const char* group = "representations";
  constexpr const char* name = "MeshInspectionRepresentation";
  pqServer* server = pqActiveObjects::instance().activeServer();
  vtkSMSessionProxyManager* manager = server ? server->proxyManager() : nullptr;
  return manager && manager->HasDefinition(group, name) ? manager->GetPrototypeProxy(group, name)
                                                        : nullptr;
}
}

//------------------------------------------------------------------------------
QList<InspectionMode> FindInspectionModes()
{
  QList<InspectionMode> modes;
  vtkSMProxy* definition = FindDefinition();
  if (!definition)
  {
    return modes;
  }
  vtkNew<vtkSMOrderedPropertyIterator> it;
  it->SetProxy(definition);
  for (it->Begin(); !it->IsAtEnd(); it->Next())
  {
    vtkPVXMLElement* hints = it->GetProperty()->GetHints();
    vtkPVXMLElement* hint = hints ? hints->FindNestedElementByName("Switch") : nullptr;
    if (hint)
    {
      InspectionMode mode;
      mode.Name = hint->GetAttributeOrEmpty("name");
      mode.Property = it->GetKey();
      mode.Text = hint->GetAttributeOrEmpty("text");
      hint->GetScalarAttribute("value", &mode.On);
      hint->GetScalarAttribute("plain", &mode.Plain);
      mode.NeedsPoints = hint->GetAttribute("needs") != nullptr;
      modes << mode;
    }
  }
  return modes;
}

//------------------------------------------------------------------------------
QStringList FindInspectionChoices(const char* property)
{
  QStringList texts;
  vtkSMProxy* definition = FindDefinition();
  vtkSMProperty* found = definition ? definition->GetProperty(property) : nullptr;
  auto* domain = found ? found->FindDomain<vtkSMEnumerationDomain>() : nullptr;
  for (unsigned int i = 0; domain && i < domain->GetNumberOfEntries(); ++i)
  {
    texts << domain->GetEntryText(i);
  }
  return texts;
}
}
