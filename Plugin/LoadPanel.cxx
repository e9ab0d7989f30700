// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OnLoading.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPVPlugin.h"
#include "vtkPVPluginLoader.h"
#include "vtkPVPluginTracker.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#if !defined(_WIN32)
#include <dlfcn.h>
#endif

namespace
{
//------------------------------------------------------------------------------
// Whether the program has an application of Qt and ParaView's widgets. The plugin links neither. It
// may be loaded before there is a pqApplicationCore: ParaView loads PV_PLUGIN_PATH first.
bool HasWindow()
{
#if defined(_WIN32)
  return false;
#else
  const void* const application = dlsym(RTLD_DEFAULT, "_ZN16QCoreApplication4selfE");
  return application && *static_cast<void* const*>(application) &&
    dlsym(RTLD_DEFAULT, "_ZN17pqApplicationCore8instanceEv");
#endif
}

//------------------------------------------------------------------------------
void FollowPlugin(vtkObject*, unsigned long, void*, void* data)
{
  auto* const plugin = static_cast<vtkPVPlugin*>(data);
  if (plugin->GetPluginName() != std::string_view("Camaron") || !plugin->GetFileName() ||
    !HasWindow())
  {
    return;
  }
  const std::filesystem::path file = plugin->GetFileName();
  const std::filesystem::path panel =
    file.parent_path() / "Panel" / ("CamaronPanel" + file.extension().string());
  std::error_code missing;
  vtkNew<vtkPVPluginLoader> loader;
  if (!std::filesystem::is_regular_file(panel, missing) || !loader->LoadPlugin(panel.c_str()) ||
    !loader->GetPluginVersion()) // not if it was loaded before
  {
    return;
  }
  const std::string version = plugin->GetPluginVersionString();
  if (version != loader->GetPluginVersion())
  {
    vtkGenericWarningMacro("The plugin Camaron is " << version << " but " << panel.string()
                                                    << " is " << loader->GetPluginVersion()
                                                    << ". Build or install both again.");
  }
}
}

namespace camaron
{
//------------------------------------------------------------------------------
void LoadPanel()
{
  // When all others have registered the plugin. See FollowSessions about the type of observer.
  vtkNew<vtkCallbackCommand> callback;
  callback->SetCallback(FollowPlugin);
  vtkPVPluginTracker::GetInstance()->AddObserver(vtkCommand::RegisterEvent, callback, -1);
}
}
