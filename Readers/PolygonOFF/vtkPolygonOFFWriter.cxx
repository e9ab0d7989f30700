// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolygonOFFWriter.h"

#include "Intake/CellMesh/OutputWarnings.h"
#include "PolygonOFFWriting.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPolygonOFFWriter);

//------------------------------------------------------------------------------
int vtkPolygonOFFWriter::GetDigitsOfCoordinates() const
{
  return this->Encoding == BINARY ? camaron::DigitsOfFloat : this->Digits;
}

//------------------------------------------------------------------------------
bool vtkPolygonOFFWriter::WriteMesh(const std::string& path, vtkDataSet* mesh,
  camaron::Warnings& warnings, camaron::ScanError& error, const camaron::Progress& progress)
{
  const auto getName = [](const std::string& name)
  { return name == "None" ? std::string() : name; };
  camaron::OFFOptions options;
  options.Encoding = static_cast<camaron::OFFEncoding>(this->Encoding);
  options.Digits = this->Digits;
  options.WriteNormals = this->WriteNormals;
  options.WriteTexture = this->WriteTextureCoordinates;
  options.VertexColors = getName(this->VertexColors);
  options.FaceColors = getName(this->FaceColors);
  options.Others = this->GetOtherCells();
  options.Surface = this->GetSurfaceFaces();
  return camaron::WritePolygonOFF(path, mesh, options, warnings, error, progress);
}

//------------------------------------------------------------------------------
void vtkPolygonOFFWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Encoding: " << this->Encoding << "\n";
  os << indent << "Digits: " << this->Digits << "\n";
  os << indent << "WriteNormals: " << this->WriteNormals << "\n";
  os << indent << "WriteTextureCoordinates: " << this->WriteTextureCoordinates << "\n";
  os << indent << "VertexColors: " << this->VertexColors << "\n";
  os << indent << "FaceColors: " << this->FaceColors << "\n";
}
