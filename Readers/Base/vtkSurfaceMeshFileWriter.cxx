// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceMeshFileWriter.h"

#include "Intake/CellMesh/CellConversion.h"

//------------------------------------------------------------------------------
camaron::SurfaceFaces vtkSurfaceMeshFileWriter::GetSurfaceFaces() const
{
  return this->FacesOfVolumes == EVERY ? camaron::SurfaceFaces::Every
                                       : camaron::SurfaceFaces::Boundary;
}

//------------------------------------------------------------------------------
void vtkSurfaceMeshFileWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FacesOfVolumes: " << this->FacesOfVolumes << "\n";
}
