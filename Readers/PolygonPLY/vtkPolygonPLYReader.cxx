// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolygonPLYReader.h"

#include "PolygonPLYReading.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPolygonPLYReader);

//------------------------------------------------------------------------------
int vtkPolygonPLYReader::CanReadFile(const char* fileName)
{
  return fileName && camaron::IsPLY(fileName) ? 1 : 0;
}

//------------------------------------------------------------------------------
bool vtkPolygonPLYReader::ReadMesh(const std::string& path, const camaron::PieceRequest& request,
  vtkUnstructuredGrid* output, camaron::Warnings& warnings, camaron::ScanError& error,
  const camaron::Progress& progress)
{
  return camaron::ReadPLY(path, request, output, warnings, error, progress);
}
