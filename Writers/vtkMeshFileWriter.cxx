// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshFileWriter.h"

#include "Scan/MappedFile.h"
#include "Scan/Progress.h"
#include "Scan/ScanError.h"

#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"

//------------------------------------------------------------------------------
vtkMeshFileWriter::~vtkMeshFileWriter()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
int vtkMeshFileWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
void vtkMeshFileWriter::WriteData()
{
  auto* mesh = vtkDataSet::SafeDownCast(this->GetInput());
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("The name of the file to write is not set.");
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    return;
  }
  const camaron::Progress progress(
    [this](double fraction)
    {
      this->UpdateProgress(fraction);
      return !this->CheckAbort();
    });
  camaron::Warnings warnings;
  camaron::ScanError error;
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->WriteMesh(this->FileName, mesh, warnings, error, progress) && !error)
  {
    this->SetErrorCode(vtkErrorCode::UserError); // stopped
  }
  if (error)
  {
    vtkErrorMacro(<< error.Message);
    this->SetErrorCode(camaron::GetVTKErrorCode(error.Kind));
    return;
  }
  const std::string name = camaron::GetFileName(this->FileName);
  for (const std::string& sentence : warnings.GetSentences())
  {
    vtkWarningMacro(<< name << ": " << sentence);
  }
}

//------------------------------------------------------------------------------
void vtkMeshFileWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
