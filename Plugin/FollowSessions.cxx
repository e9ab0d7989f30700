// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OnLoading.h"

#include "MeshInspectionInGeometryRepresentationXML.h"
#include "MeshInspectionInUnstructuredGridRepresentationXML.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPVLogger.h"
#include "vtkPVXMLElement.h"
#include "vtkProcessModule.h"
#include "vtkSMPluginManager.h"
#include "vtkSMProxyDefinitionManager.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSessionIterator.h"
#include "vtkSmartPointer.h"

#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace
{
struct Extension
{
  const char* Representation;
  const char* XML;
};

// Not among the plugin's own XML files: a client without the plugin would receive these from its
// server, and ParaView aborts when it cannot create a part of a representation.
const Extension Extensions[] = {
  { "GeometryRepresentation", MeshInspectionInGeometryRepresentationXML },
  { "UnstructuredGridRepresentation", MeshInspectionInUnstructuredGridRepresentationXML },
};

//------------------------------------------------------------------------------
bool IsExtended(vtkPVXMLElement* representation)
{
  for (unsigned int i = 0; i < representation->GetNumberOfNestedElements(); ++i)
  {
    if (representation->GetNestedElement(i)->GetAttributeOrEmpty("subproxy") ==
      std::string_view("MeshInspectionRepresentation"))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// On the client and on the server, which keeps it for its other clients.
void ExtendRepresentations(vtkSMSession* session)
{
  vtkSMProxyDefinitionManager* definitions =
    session->GetSessionProxyManager()->GetProxyDefinitionManager();
  for (const auto& [representation, xml] : Extensions)
  {
    vtkPVXMLElement* found =
      definitions->GetProxyDefinition("representations", representation, false);
    if (found && !IsExtended(found))
    {
      definitions->LoadConfigurationXMLFromString(xml);
    }
  }
}

//------------------------------------------------------------------------------
void FollowSession(vtkSMSession* session)
{
  if (!(session->GetProcessRoles() & vtkPVSession::CLIENT))
  {
    return;
  }
  if (!(session->GetProcessRoles() & vtkPVSession::SERVERS))
  {
    // Definitions come from the server; ParaView 6.1 does not pass on the versions of its plugins.
    vtkPVXMLElement* plugin =
      session->GetSessionProxyManager()->GetProxyDefinitionManager()->GetProxyDefinition(
        "misc", "CamaronPlugin", false);
    if (!plugin)
    {
      return;
    }
    const std::string version = plugin->GetAttributeOrEmpty("version");
    static std::set<std::pair<vtkIdType, std::string>> warned;
    const vtkIdType id = vtkProcessModule::GetProcessModule()->GetSessionID(session);
    if (version != CAMARON_VERSION && warned.emplace(id, version).second)
    {
      vtkWarningWithObjectMacro(session,
        "The plugin Camaron is " << CAMARON_VERSION << " here but " << version
                                 << " on the server. Install the same version on both sides.");
    }
  }
  ExtendRepresentations(session);
}

//------------------------------------------------------------------------------
void FollowAll(vtkObject*, unsigned long, void*, void*)
{
  const auto sessions = vtkSmartPointer<vtkSessionIterator>::Take(
    vtkProcessModule::GetProcessModule()->NewSessionIterator());
  for (sessions->InitTraversal(); !sessions->IsDoneWithTraversal(); sessions->GoToNextItem())
  {
    if (auto* session = vtkSMSession::SafeDownCast(sessions->GetCurrentSession()))
    {
      FollowSession(session);
    }
  }
}
}

namespace camaron
{
//------------------------------------------------------------------------------
void FollowSessions()
{
  vtkVLogF(PARAVIEW_LOG_PLUGIN_VERBOSITY(), "%s", CAMARON_PROVENANCE);
  if (!vtkProcessModule::GetProcessModule())
  {
    return;
  }
  // Not a member or a lambda as observer: its code would be unloaded before ParaView deletes it.
  vtkNew<vtkCallbackCommand> callback;
  callback->SetCallback(FollowAll);
  vtkProcessModule::GetProcessModule()->AddObserver(vtkCommand::ConnectionCreatedEvent, callback);
  vtkSMProxyManager::GetProxyManager()->GetPluginManager()->AddObserver(
    vtkSMPluginManager::PluginLoadedEvent, callback);
  FollowAll(nullptr, vtkCommand::NoEvent, nullptr, nullptr);
}
}
