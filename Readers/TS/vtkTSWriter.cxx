// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTSWriter.h"

#include "TSWriting.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkTSWriter);

//------------------------------------------------------------------------------
bool vtkTSWriter::WriteMesh(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings,
  camaron::ScanError& error, const camaron::Progress& progress)
{
  const camaron::TSOptions options = { static_cast<camaron::TSDialect>(this->Dialect),
    this->GetOtherCells(), this->GetSurfaceFaces() };
  return camaron::WriteTS(path, mesh, options, warnings, error, progress);
}

//------------------------------------------------------------------------------
void vtkTSWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dialect: " << this->Dialect << "\n";
}
