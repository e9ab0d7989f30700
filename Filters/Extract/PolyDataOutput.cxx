// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolyDataOutput.h"

#include "MeshOutputs.h"
#include "vtkCamaronCompat.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace camaron
{
//------------------------------------------------------------------------------
void MakePolyDataOutputs(vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  const int type = GetTree(input)              ? input->GetDataObjectType()
    : vtkCompositeDataSet::SafeDownCast(input) ? VTK_MULTIBLOCK_DATA_SET
                                               : VTK_POLY_DATA;
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    MakeOutput(type, port, outputVector);
  }
}

//------------------------------------------------------------------------------
std::vector<vtkPolyData*> MakePolyDataLeaves(vtkDataObject* input, vtkDataObject* output)
{
  if (auto* single = vtkPolyData::SafeDownCast(output))
  {
    return { single };
  }
  auto* from = vtkCompositeDataSet::SafeDownCast(input);
  auto* to = vtkCompositeDataSet::SafeDownCast(output);
  to->CopyStructure(from);
  to->GetFieldData()->ShallowCopy(from->GetFieldData());
  std::vector<vtkPolyData*> leaves;
  vtkSmartPointer<vtkCompositeDataIterator> it;
  it.TakeReference(from->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    if (vtkDataSet::SafeDownCast(it->GetCurrentDataObject()))
    {
      vtkNew<vtkPolyData> leaf;
      to->SetDataSet(it, leaf);
      leaves.push_back(leaf);
    }
  }
  return leaves;
}
}
