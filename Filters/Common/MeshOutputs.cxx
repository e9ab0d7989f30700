// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshOutputs.h"

#include "Base/Buffer.h"
#include "Base/Parallel.h"
#include "Criteria/Criterion.h"
#include "Curved/CellMap.h"
#include "Mesh/CellShape.h"
#include "Mesh/MeshView.h"
#include "vtkCamaronCompat.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTypes.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <string>

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
int GetNumberOfPieces(vtkInformationVector* outputs)
{
  return outputs->GetInformationObject(0)->Get(
    vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES());
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

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnsignedCharArray> MakeUndefinedMask(vtkDoubleArray* values, vtkDataSet* mesh)
{
  // Other data sets have no higher-order cells.
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(mesh);
  const MeshView view(grid);
  const Criterion* const criterion = FindCriterion(values->GetName());
  const bool isCurved = criterion && criterion->IsCurved;
  const auto mask = MakeLargeArray<vtkUnsignedCharArray>(values->GetNumberOfValues());
  mask->SetName((std::string(values->GetName()) + "_Undefined").c_str());
  const double* from = values->GetPointer(0);
  unsigned char* to = mask->GetPointer(0);
  ParallelForEach(values->GetNumberOfValues(), LightGrain,
    [&](vtkIdType cell)
    {
      NullReason reason = GetNullReason(from[cell]);
      if (reason == NullReason::Value && grid &&
        GetCellShape(view.GetCellType(cell)).IsHigherOrder &&
        !(isCurved && CellMap::IsMapped(view, cell)))
      {
        reason = NullReason::HigherOrder;
      }
      to[cell] = static_cast<unsigned char>(reason);
    });
  return mask;
}
}
