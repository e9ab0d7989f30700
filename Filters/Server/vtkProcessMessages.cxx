// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkProcessMessages.h"

#include "ControllerReducer.h"

#include "vtkLogger.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <mutex>
#include <utility>
#include <vector>

//------------------------------------------------------------------------------
// Stores messages, and passes them on to a store that it replaces.
class vtkMessageStore : public vtkOutputWindow
{
public:
  static vtkMessageStore* New();
  vtkTypeMacro(vtkMessageStore, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayErrorText(const char* text) override
  {
    this->Add(this->Errors, text);
    if (auto* const outer = vtkMessageStore::SafeDownCast(this->Before))
    {
      outer->DisplayErrorText(text);
    }
  }
  void DisplayWarningText(const char* text) override
  {
    this->Add(this->Warnings, text);
    if (auto* const outer = vtkMessageStore::SafeDownCast(this->Before))
    {
      outer->DisplayWarningText(text);
    }
  }
  void DisplayGenericWarningText(const char* text) override { this->DisplayWarningText(text); }

  std::string TakeErrors() { return this->Take(this->Errors); }
  std::string TakeWarnings() { return this->Take(this->Warnings); }

  const vtkSmartPointer<vtkOutputWindow> Before = vtkOutputWindow::GetInstance();

private:
  void Add(std::string& texts, const char* text)
  {
    constexpr char separator = '\x1f';
    const std::lock_guard<std::mutex> lock(this->Mutex);
    texts += std::string(text) + separator;
  }
  std::string Take(std::string& texts)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return std::exchange(texts, std::string());
  }

  std::mutex Mutex;
  std::string Errors, Warnings;
};

vtkStandardNewMacro(vtkMessageStore);
vtkStandardNewMacro(vtkProcessMessages);

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
vtkProcessMessages::~vtkProcessMessages()
{
  if (this->Store)
  {
    if (vtkOutputWindow::GetInstance() == this->Store)
    {
      vtkOutputWindow::SetInstance(this->Store->Before);
    }
    vtkLogger::SetStderrVerbosity(static_cast<vtkLogger::Verbosity>(this->Verbosity));
  }
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
  if (!this->Store)
  {
    this->Store = vtkSmartPointer<vtkMessageStore>::New();
    vtkOutputWindow::SetInstance(this->Store);
    this->Verbosity = vtkLogger::GetCurrentVerbosityCutoff();
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }
}

//------------------------------------------------------------------------------
std::string vtkProcessMessages::Collect(const std::string& texts) const
{
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
  this->Errors = this->Collect(this->Store ? this->Store->TakeErrors() : "");
  this->Warnings = this->Collect(this->Store ? this->Store->TakeWarnings() : "");
}
