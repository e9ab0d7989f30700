// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolyDataOutput.h"

#include "vtkCamaronCompat.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace camaron
{
//------------------------------------------------------------------------------
void MakePolyDataOutputs(vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    vtkSmartPointer<vtkDataObject> wanted;
    if (GetTree(input))
    {
      wanted.TakeReference(input->NewInstance());
    }
    else if (vtkCompositeDataSet::SafeDownCast(input))
    {
      wanted = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    }
    else
    {
      wanted = vtkSmartPointer<vtkPolyData>::New();
    }
    vtkInformation* info = outputVector->GetInformationObject(port);
    vtkDataObject* present = info->Get(vtkDataObject::DATA_OBJECT());
    if (!present || !present->IsA(wanted->GetClassName()))
    {
      info->Set(vtkDataObject::DATA_OBJECT(), wanted);
    }
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
