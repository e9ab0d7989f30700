// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVisfWriter.h"

#include "Intake/CellMesh/OutputWarnings.h"
#include "VisfWriting.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVisfWriter);

//------------------------------------------------------------------------------
int vtkVisfWriter::GetDigitsOfCoordinates() const
{
  return camaron::DigitsOfFloat;
}

//------------------------------------------------------------------------------
bool vtkVisfWriter::WriteMesh(const std::string& path, vtkDataSet* mesh,
  camaron::Warnings& warnings, camaron::ScanError& error, const camaron::Progress& progress)
{
  return camaron::WriteVisf(path, mesh, static_cast<camaron::VisfEncoding>(this->Encoding),
    this->WriteNeighbors, warnings, error, progress);
}

//------------------------------------------------------------------------------
void vtkVisfWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Encoding: " << this->Encoding << "\n";
  os << indent << "WriteNeighbors: " << this->WriteNeighbors << "\n";
}
