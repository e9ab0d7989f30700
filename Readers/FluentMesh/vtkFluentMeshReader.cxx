// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFluentMeshReader.h"

#include "FluentMeshReading.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkFluentMeshReader);

//------------------------------------------------------------------------------
vtkFluentMeshReader::vtkFluentMeshReader()
  : vtkFluentReader(camaron::IsFluentMesh, camaron::ReadFluentMesh)
{
}
