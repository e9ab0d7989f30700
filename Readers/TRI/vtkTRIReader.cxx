// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTRIReader.h"

#include "TRIReading.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkTRIReader);

//------------------------------------------------------------------------------
int vtkTRIReader::CanReadFile(const char* fileName)
{
  return fileName && camaron::IsTRI(fileName) ? 1 : 0;
}

//------------------------------------------------------------------------------
bool vtkTRIReader::ReadMesh(const std::string& path, const camaron::PieceRequest& request,
  vtkUnstructuredGrid* output, camaron::Warnings& warnings, camaron::ScanError& error,
  const camaron::Progress& progress)
{
  return camaron::ReadTRI(path, request, output, warnings, error, progress);
}
