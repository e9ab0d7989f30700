// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFluentMeshWriter.h"

#include "FluentMeshWriting.h"
#include "Intake/CellMesh/OutputWarnings.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkFluentMeshWriter);

//------------------------------------------------------------------------------
int vtkFluentMeshWriter::GetDigitsOfCoordinates() const
{
  return this->Encoding == BINARY_SINGLE ? camaron::DigitsOfFloat : camaron::AllDigits;
}

//------------------------------------------------------------------------------
bool vtkFluentMeshWriter::WriteMesh(const std::string& path, vtkDataSet* mesh,
  camaron::Warnings& warnings, camaron::ScanError& error, const camaron::Progress& progress)
{
  return camaron::WriteFluentMesh(path, mesh, static_cast<camaron::FluentEncoding>(this->Encoding),
    this->GetOtherCells(), warnings, error, progress);
}

//------------------------------------------------------------------------------
void vtkFluentMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Encoding: " << this->Encoding << "\n";
}
