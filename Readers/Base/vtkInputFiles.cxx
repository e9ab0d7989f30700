// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInputFiles.h"

#include "UpstreamFiles.h"

#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkInputFiles);

//------------------------------------------------------------------------------
vtkInputFiles::vtkInputFiles()
  : Files(std::make_unique<camaron::InputFiles>())
{
}

//------------------------------------------------------------------------------
vtkInputFiles::~vtkInputFiles() = default;

//------------------------------------------------------------------------------
void vtkInputFiles::AddFile(const char* path)
{
  this->Files->Add(path ? path : "");
}

//------------------------------------------------------------------------------
void vtkInputFiles::AddSource(vtkAlgorithm* source)
{
  this->Files->Add(camaron::FindUpstreamFiles(source));
}

//------------------------------------------------------------------------------
void vtkInputFiles::AddTarget(const char* path)
{
  this->Targets.emplace_back(path ? path : "");
}

//------------------------------------------------------------------------------
void vtkInputFiles::ClearTargets()
{
  this->Targets.clear();
}

//------------------------------------------------------------------------------
const char* vtkInputFiles::GetReplaced()
{
  auto* const all = vtkMultiProcessController::GetGlobalController();
  const bool isFirst = !all || all->GetLocalProcessId() == 0;
  this->Replaced.clear();
  if (isFirst)
  {
    for (const std::string& input : this->Files->FindReplaced(this->Targets))
    {
      this->Replaced += input + '\x1f';
    }
  }
  if (!this->Replaced.empty())
  {
    this->Replaced.pop_back();
  }
  return this->Replaced.c_str();
}

//------------------------------------------------------------------------------
void vtkInputFiles::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const std::string& path : this->Files->GetPaths())
  {
    os << indent << "File: " << path << "\n";
  }
  for (const std::string& path : this->Targets)
  {
    os << indent << "Target: " << path << "\n";
  }
}
