// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshSurface.h"

#include "Mesh/BoundarySurface.h"
#include "MeshInput.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <exception>

vtkStandardNewMacro(vtkMeshSurface);

//------------------------------------------------------------------------------
int vtkMeshSurface::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkMeshSurface::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  try
  {
    camaron::MakeBoundarySurface(camaron::AsMesh(vtkDataSet::GetData(inputVector[0])), output);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro("The surface of the mesh cannot be taken: " << error.what() << '.');
    output->Initialize();
    return 0;
  }
  return 1;
}
