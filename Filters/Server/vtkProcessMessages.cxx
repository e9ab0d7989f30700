// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkProcessMessages.h"

#include "ControllerReducer.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkLogger.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <utility>
#include <vector>

vtkStandardNewMacro(vtkProcessMessages);

namespace
{
constexpr char Separator = '\x1f';

}

//------------------------------------------------------------------------------
// The client already has what the first process of a server reports.
vtkProcessMessages::vtkProcessMessages()
{
  if (camaron::ControllerReducer().GetProcess() > 0)
  {
    this->Start();
  }
}

//------------------------------------------------------------------------------
std::string vtkProcessMessages::Arrivals::Take()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return std::exchange(this->Texts, std::string());
}

//------------------------------------------------------------------------------
void vtkProcessMessages::Observe()
{
  this->IsAlone = true;
  this->Start();
}

//------------------------------------------------------------------------------
void vtkProcessMessages::Start()
{
  if (this->Window)
  {
    return;
  }
  this->Window = vtkOutputWindow::GetInstance();
  this->Observe(vtkCommand::ErrorEvent, this->ErrorObserver, this->NewErrors);
  this->Observe(vtkCommand::WarningEvent, this->WarningObserver, this->NewWarnings);
  this->Mode = this->Window->GetDisplayMode();
  this->Window->SetDisplayModeToNever();
  this->Verbosity = vtkLogger::GetCurrentVerbosityCutoff();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

//------------------------------------------------------------------------------
vtkProcessMessages::~vtkProcessMessages()
{
  if (this->Window)
  {
    this->Window->RemoveObserver(this->ErrorObserver);
    this->Window->RemoveObserver(this->WarningObserver);
    this->Window->SetDisplayMode(this->Mode);
    vtkLogger::SetStderrVerbosity(static_cast<vtkLogger::Verbosity>(this->Verbosity));
  }
}

//------------------------------------------------------------------------------
void vtkProcessMessages::Observe(
  unsigned long event, vtkCallbackCommand* observer, Arrivals& messages)
{
  observer->SetCallback(
    [](vtkObject*, unsigned long, void* arrivals, void* text)
    {
      auto* const to = static_cast<Arrivals*>(arrivals);
      const std::lock_guard<std::mutex> lock(to->Mutex);
      to->Texts += std::string(static_cast<const char*>(text)) + Separator;
    });
  observer->SetClientData(&messages);
  this->Window->AddObserver(event, observer);
}

//------------------------------------------------------------------------------
std::string vtkProcessMessages::Collect(Arrivals& messages) const
{
  const std::string texts = messages.Take();
  if (this->IsAlone)
  {
    return texts;
  }
  camaron::ControllerReducer reducer;
  const bool isFirst = reducer.GetProcess() == 0;
  const std::vector<char> own(texts.begin(), texts.end());
  std::vector<std::size_t> sizes;
  const std::vector<char> all = reducer.Gather(own, sizes);
  return isFirst ? std::string(all.begin(), all.end()) : "";
}

//------------------------------------------------------------------------------
void vtkProcessMessages::Gather()
{
  this->Errors = this->Collect(this->NewErrors);
  this->Warnings = this->Collect(this->NewWarnings);
}

//------------------------------------------------------------------------------
void vtkProcessMessages::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Errors: " << this->Errors << "\n";
  os << indent << "Warnings: " << this->Warnings << "\n";
}
