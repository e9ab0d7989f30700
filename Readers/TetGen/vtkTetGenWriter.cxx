// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetGenWriter.h"

#include "TetGenWriting.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkTetGenWriter);

//------------------------------------------------------------------------------
bool vtkTetGenWriter::WriteMesh(const std::string& path, vtkDataSet* mesh,
  camaron::Warnings& warnings, camaron::ScanError& error, const camaron::Progress& progress)
{
  const camaron::TetGenOptions options = { this->FirstId, this->GetOtherCells(), this->WriteArrays,
    this->WriteBoundaryFaces };
  return camaron::WriteTetGen(path, mesh, options, warnings, error, progress);
}

//------------------------------------------------------------------------------
void vtkTetGenWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FirstId: " << this->FirstId << "\n";
  os << indent << "WriteArrays: " << this->WriteArrays << "\n";
  os << indent << "WriteBoundaryFaces: " << this->WriteBoundaryFaces << "\n";
}
