// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshOutputs.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTypes.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

namespace camaron
{
//------------------------------------------------------------------------------
void CopyDataSets(vtkDataObject* input, vtkDataObject* output, const ChangeDataSet& change)
{
  const auto copyDataSet = [&](vtkDataSet* data, unsigned int flatIndex)
  {
    auto copy = vtkSmartPointer<vtkDataSet>::Take(data->NewInstance());
    copy->ShallowCopy(data);
    change(copy, flatIndex);
    return copy;
  };
  if (auto* data = vtkDataSet::SafeDownCast(input))
  {
    output->ShallowCopy(copyDataSet(data, 0));
    return;
  }
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  auto* copy = vtkCompositeDataSet::SafeDownCast(output);
  copy->CopyStructure(composite);
  copy->GetFieldData()->ShallowCopy(composite->GetFieldData());
  vtkSmartPointer<vtkCompositeDataIterator> it;
  it.TakeReference(composite->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    vtkDataObject* leaf = it->GetCurrentDataObject();
    auto* data = vtkDataSet::SafeDownCast(leaf);
    copy->SetDataSet(it, data ? copyDataSet(data, it->GetCurrentFlatIndex()).Get() : leaf);
  }
}

//------------------------------------------------------------------------------
void CopyWithCellArrays(vtkDataObject* input, const NewCellArrays& arrays, vtkDataObject* output)
{
  CopyDataSets(input, output,
    [&](vtkDataSet* copy, unsigned int flatIndex)
    {
      const auto found = arrays.find(flatIndex);
      if (found != arrays.end())
      {
        for (vtkDoubleArray* array : found->second)
        {
          copy->GetCellData()->AddArray(array);
        }
      }
    });
}

//------------------------------------------------------------------------------
void MakeOutput(int type, int port, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(port);
  vtkDataObject* present = vtkDataObject::GetData(info);
  if (!present || present->GetDataObjectType() != type)
  {
    const auto created =
      vtkSmartPointer<vtkDataObject>::Take(vtkDataObjectTypes::NewDataObject(type));
    info->Set(vtkDataObject::DATA_OBJECT(), created);
  }
}

//------------------------------------------------------------------------------
void MakeTablesAndMesh(int numberOfTables, vtkDataObject* mesh, vtkInformationVector* outputVector)
{
  for (int port = 0; port <= numberOfTables; ++port)
  {
    const bool isMesh = port == numberOfTables && mesh;
    MakeOutput(isMesh ? mesh->GetDataObjectType() : VTK_TABLE, port, outputVector);
  }
}
}
