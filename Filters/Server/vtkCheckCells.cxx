// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCheckCells.h"

#include "ControllerReducer.h"
#include "MeshInput.h"
#include "RequestFailure.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkCheckCells);

//------------------------------------------------------------------------------
int vtkCheckCells::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
int vtkCheckCells::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* const input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject::GetData(outputVector)->ShallowCopy(input);
  try
  {
    camaron::ControllerReducer reducer;
    camaron::GetMeshes(input, reducer);
  }
  catch (...)
  {
    return camaron::FailRequest(this, "", outputVector);
  }
  return 1;
}
