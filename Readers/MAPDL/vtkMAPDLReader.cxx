// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMAPDLReader.h"

#include "MAPDLReading.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMAPDLReader);

//------------------------------------------------------------------------------
vtkMAPDLReader::vtkMAPDLReader()
  : vtkMeshFileReader(camaron::IsMAPDL)
{
}

//------------------------------------------------------------------------------
bool vtkMAPDLReader::ReadMesh(const std::string& path, const camaron::PieceRequest& request,
  vtkUnstructuredGrid* output, camaron::Warnings& warnings, camaron::ScanError& error,
  const camaron::Progress& progress)
{
  camaron::MAPDLOptions options;
  options.Linear = this->Linear;
  options.SurfaceEffects = this->SurfaceEffects;
  return camaron::ReadMAPDL(path, options, request, output, warnings, error, progress);
}

//------------------------------------------------------------------------------
void vtkMAPDLReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Linear: " << this->Linear << "\n";
  os << indent << "SurfaceEffects: " << this->SurfaceEffects << "\n";
}
