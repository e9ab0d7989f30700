// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolygonOFFReader.h"

#include "PolygonOFFReading.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPolygonOFFReader);

//------------------------------------------------------------------------------
vtkPolygonOFFReader::vtkPolygonOFFReader()
  : vtkMeshFileReader(camaron::IsPolygonOFF, camaron::ReadPolygonOFF)
{
}
