// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolygonPLYWriter.h"

#include "Intake/CellMesh/OutputWarnings.h"
#include "PolygonPLYWriting.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPolygonPLYWriter);

//------------------------------------------------------------------------------
int vtkPolygonPLYWriter::GetDigitsOfCoordinates() const
{
  return this->Coordinates == FLOAT ? camaron::DigitsOfFloat : camaron::AllDigits;
}

//------------------------------------------------------------------------------
bool vtkPolygonPLYWriter::WriteMesh(const std::string& path, vtkDataSet* mesh,
  camaron::Warnings& warnings, camaron::ScanError& error, const camaron::Progress& progress)
{
  camaron::PLYWriteOptions options;
  options.Encoding = static_cast<camaron::PLYEncoding>(this->Encoding);
  options.FloatCoordinates = this->Coordinates == FLOAT;
  options.Cells = this->WriteCells;
  options.Others = this->GetOtherCells();
  options.Surface = this->GetSurfaceFaces();
  return camaron::WritePLY(path, mesh, options, warnings, error, progress);
}

//------------------------------------------------------------------------------
void vtkPolygonPLYWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Encoding: " << this->Encoding << "\n";
  os << indent << "Coordinates: " << this->Coordinates << "\n";
  os << indent << "WriteCells: " << this->WriteCells << "\n";
}
