// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTSReader.h"

#include "TSReading.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkTSReader);

//------------------------------------------------------------------------------
int vtkTSReader::CanReadFile(const char* fileName)
{
  return fileName && camaron::IsTS(fileName) ? 1 : 0;
}

//------------------------------------------------------------------------------
bool vtkTSReader::ReadMesh(const std::string& path, const camaron::PieceRequest& request,
  vtkUnstructuredGrid* output, camaron::Warnings& warnings, camaron::ScanError& error,
  const camaron::Progress& progress)
{
  return camaron::ReadTS(path, request, output, warnings, error, progress);
}
