// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetGenReader.h"

#include "TetGenReading.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkTetGenReader);

//------------------------------------------------------------------------------
int vtkTetGenReader::CanReadFile(const char* fileName)
{
  return fileName && camaron::IsTetGen(fileName) ? 1 : 0;
}

//------------------------------------------------------------------------------
bool vtkTetGenReader::ReadMesh(const std::string& path, const camaron::PieceRequest& request,
  vtkUnstructuredGrid* output, camaron::Warnings& warnings, camaron::ScanError& error,
  const camaron::Progress& progress)
{
  return camaron::ReadTetGen(path, request, output, warnings, error, progress);
}
