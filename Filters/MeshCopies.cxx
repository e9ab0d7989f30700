// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshCopies.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkTable.h"

namespace camaron
{
namespace
{
using ArrayList = NewCellArrays::mapped_type;

//------------------------------------------------------------------------------
ArrayList Find(const NewCellArrays& arrays, unsigned int flatIndex)
{
  const auto found = arrays.find(flatIndex);
  return found == arrays.end() ? ArrayList() : found->second;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> CopyWith(
  vtkDataObject* leaf, const ArrayList& arrays)
{
  auto* data = vtkDataSet::SafeDownCast(leaf);
  if (!data)
  {
    return leaf;
  }
  auto copy = vtkSmartPointer<vtkDataSet>::Take(data->NewInstance());
  copy->ShallowCopy(data);
  for (vtkDoubleArray* array : arrays)
  {
    copy->GetCellData()->AddArray(array);
  }
  return copy;
}
}

//------------------------------------------------------------------------------
void CopyWithCellArrays(vtkDataObject* input, const NewCellArrays& arrays, vtkDataObject* output)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    output->ShallowCopy(CopyWith(input, Find(arrays, 0)));
    return;
  }
  auto* copy = vtkCompositeDataSet::SafeDownCast(output);
  copy->CopyStructure(composite);
  copy->GetFieldData()->ShallowCopy(composite->GetFieldData());
  vtkSmartPointer<vtkCompositeDataIterator> it;
  it.TakeReference(composite->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    copy->SetDataSet(it, CopyWith(it->GetCurrentDataObject(), Find(arrays, it->GetCurrentFlatIndex())));
  }
}

//------------------------------------------------------------------------------
void MakeTablesAndMesh(int numberOfTables, vtkDataObject* mesh, vtkInformationVector* outputVector)
{
  for (int port = 0; port <= numberOfTables; ++port)
  {
    vtkInformation* info = outputVector->GetInformationObject(port);
    vtkDataObject* output = vtkDataObject::GetData(info);
    const bool isMesh = port == numberOfTables && mesh;
    if (!output || !output->IsA(isMesh ? mesh->GetClassName() : "vtkTable"))
    {
      const auto created =
        vtkSmartPointer<vtkDataObject>::Take(isMesh ? mesh->NewInstance() : vtkTable::New());
      info->Set(vtkDataObject::DATA_OBJECT(), created);
    }
  }
}
}
