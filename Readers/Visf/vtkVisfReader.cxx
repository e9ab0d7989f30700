// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVisfReader.h"

#include "VisfReading.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVisfReader);

//------------------------------------------------------------------------------
int vtkVisfReader::CanReadFile(const char* fileName)
{
  return fileName && camaron::IsVisf(fileName) ? 1 : 0;
}

//------------------------------------------------------------------------------
bool vtkVisfReader::ReadMesh(const std::string& path, const camaron::PieceRequest& request,
  vtkUnstructuredGrid* output, camaron::Warnings& warnings, camaron::ScanError& error,
  const camaron::Progress& progress)
{
  return camaron::ReadVisf(path, request, output, warnings, error, progress);
}
