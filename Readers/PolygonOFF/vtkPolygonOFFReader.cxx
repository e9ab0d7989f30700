// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolygonOFFReader.h"

#include "PolygonOFFReading.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPolygonOFFReader);

//------------------------------------------------------------------------------
int vtkPolygonOFFReader::CanReadFile(const char* fileName)
{
  return fileName && camaron::IsPolygonOFF(fileName) ? 1 : 0;
}

//------------------------------------------------------------------------------
bool vtkPolygonOFFReader::ReadMesh(const std::string& path, const camaron::PieceRequest& request,
  vtkUnstructuredGrid* output, camaron::Warnings& warnings, camaron::ScanError& error,
  const camaron::Progress& progress)
{
  return camaron::ReadPolygonOFF(path, request, output, warnings, error, progress);
}
