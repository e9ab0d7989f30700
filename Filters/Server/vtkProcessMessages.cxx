// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkProcessMessages.h"

#include "ControllerReducer.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkLogger.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <vector>

vtkStandardNewMacro(vtkProcessMessages);

namespace
{
constexpr char Separator = '\x1f';

//------------------------------------------------------------------------------
void Note(vtkObject*, unsigned long, void* messages, void* text)
{
  *static_cast<std::string*>(messages) += std::string(static_cast<const char*>(text)) + Separator;
}
}

//------------------------------------------------------------------------------
// The client already shows what the first process reports.
vtkProcessMessages::vtkProcessMessages()
{
  if (camaron::ControllerReducer().GetProcess() == 0)
  {
    return;
  }
  this->Window = vtkOutputWindow::GetInstance();
  this->Observe(vtkCommand::ErrorEvent, this->ErrorObserver, this->Errors);
  this->Observe(vtkCommand::WarningEvent, this->WarningObserver, this->Warnings);
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
  unsigned long event, vtkCallbackCommand* observer, std::string& messages)
{
  observer->SetCallback(Note);
  observer->SetClientData(&messages);
  this->Window->AddObserver(event, observer);
}

//------------------------------------------------------------------------------
void vtkProcessMessages::Collect(std::string& messages)
{
  camaron::ControllerReducer reducer;
  const bool isFirst = reducer.GetProcess() == 0;
  const std::vector<char> own(messages.begin(), isFirst ? messages.begin() : messages.end());
  std::vector<std::size_t> sizes;
  const std::vector<char> all = reducer.Gather(own, sizes);
  messages = isFirst ? std::string(all.begin(), all.end()) : "";
}

//------------------------------------------------------------------------------
void vtkProcessMessages::Gather()
{
  Collect(this->Errors);
  Collect(this->Warnings);
}

//------------------------------------------------------------------------------
void vtkProcessMessages::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Errors: " << this->Errors << "\n";
  os << indent << "Warnings: " << this->Warnings << "\n";
}
