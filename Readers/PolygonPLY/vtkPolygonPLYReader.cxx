// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolygonPLYReader.h"

#include "PolygonPLYReading.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPolygonPLYReader);

//------------------------------------------------------------------------------
vtkPolygonPLYReader::vtkPolygonPLYReader()
  : vtkMeshFileReader(camaron::IsPLY, camaron::ReadPLY)
{
}
