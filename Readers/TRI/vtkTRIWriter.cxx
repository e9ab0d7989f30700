// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTRIWriter.h"

#include "TRIWriting.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkTRIWriter);

//------------------------------------------------------------------------------
bool vtkTRIWriter::WriteMesh(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings,
  camaron::ScanError& error, const camaron::Progress& progress)
{
  const camaron::TRIOptions options = { static_cast<camaron::TRIDialect>(this->Dialect),
    this->GetOtherCells(), this->GetSurfaceFaces() };
  return camaron::WriteTRI(path, mesh, options, warnings, error, progress);
}

//------------------------------------------------------------------------------
void vtkTRIWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dialect: " << this->Dialect << "\n";
}
