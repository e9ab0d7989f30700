// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFluentMeshReader.h"

#include "FluentMeshReading.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkFluentMeshReader);

//------------------------------------------------------------------------------
vtkFluentMeshReader::vtkFluentMeshReader()
  : vtkFluentReader(camaron::IsFluentMesh)
{
}

//------------------------------------------------------------------------------
bool vtkFluentMeshReader::ReadZones(const std::string& path, const camaron::PieceRequest& request,
  vtkUnstructuredGrid* grid, vtkMultiBlockDataSet* boundaries, camaron::Warnings& warnings,
  camaron::ScanError& error, const camaron::Progress& progress)
{
  return camaron::ReadFluentMesh(path, request, grid, boundaries, warnings, error, progress);
}
