// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkM3DWriter.h"

#include "M3DWriting.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkM3DWriter);

//------------------------------------------------------------------------------
bool vtkM3DWriter::WriteMesh(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings,
  camaron::ScanError& error, const camaron::Progress& progress)
{
  camaron::M3DWriteOptions options;
  options.Dialect = this->Dialect == AUTOMATIC
    ? camaron::GetM3DDialect(path)
    : static_cast<camaron::M3DDialect>(this->Dialect - M3D);
  options.Digits = this->Digits;
  options.Others = this->GetOtherCells();
  return camaron::WriteM3D(path, mesh, options, warnings, error, progress);
}

//------------------------------------------------------------------------------
void vtkM3DWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dialect: " << this->Dialect << "\n";
  os << indent << "Digits: " << this->Digits << "\n";
}
