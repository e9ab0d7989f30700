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
void vtkInputFiles::SetTarget(const char* path)
{
  this->Target = path ? path : "";
}

//------------------------------------------------------------------------------
const char* vtkInputFiles::GetReplaced()
{
  auto* const all = vtkMultiProcessController::GetGlobalController();
  const bool isFirst = !all || all->GetLocalProcessId() == 0;
  this->Replaced = isFirst ? this->Files->FindReplaced(this->Target) : "";
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
  os << indent << "Target: " << this->Target << "\n";
}
