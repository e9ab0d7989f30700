// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkM3DReader.h"

#include "M3DReading.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkM3DReader);

//------------------------------------------------------------------------------
vtkM3DReader::vtkM3DReader()
  : vtkMeshFileReader(camaron::IsM3D)
{
}

//------------------------------------------------------------------------------
bool vtkM3DReader::ReadMesh(const std::string& path, const camaron::PieceRequest& request,
  vtkUnstructuredGrid* output, camaron::Warnings& warnings, camaron::ScanError& error,
  const camaron::Progress& progress)
{
  camaron::M3DOptions options;
  options.AddProjection = this->AddProjection;
  return camaron::ReadM3D(path, request, options, output, warnings, error, progress);
}

//------------------------------------------------------------------------------
void vtkM3DReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AddProjection: " << this->AddProjection << "\n";
}
