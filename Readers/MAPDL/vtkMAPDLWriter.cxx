// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMAPDLWriter.h"

#include "MAPDLWriting.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMAPDLWriter);

//------------------------------------------------------------------------------
bool vtkMAPDLWriter::WriteMesh(const std::string& path, vtkDataSet* mesh,
  camaron::Warnings& warnings, camaron::ScanError& error, const camaron::Progress& progress)
{
  camaron::MAPDLWriteOptions options;
  options.OriginalIds = this->OriginalIds;
  options.Digits = this->Digits;
  options.Others = this->GetOtherCells();
  return camaron::WriteMAPDL(path, mesh, options, warnings, error, progress);
}

//------------------------------------------------------------------------------
void vtkMAPDLWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OriginalIds: " << this->OriginalIds << "\n";
  os << indent << "Digits: " << this->Digits << "\n";
}
