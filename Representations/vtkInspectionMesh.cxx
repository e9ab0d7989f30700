// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInspectionMesh.h"

#include "InspectionArrays.h"

#include "ControllerReducer.h"
#include "Drawing/OuterFacets.h"
#include "ElementBlocks.h"
#include "Mesh/FacetLinks.h"
#include "MeshInput.h"
#include "MeshPieces.h"

#include "vtkAppendFilter.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkConstantArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProcessModule.h"
#include "vtkTypeUInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedIntArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <exception>
#include <numeric>

using namespace camaron;

vtkStandardNewMacro(vtkInspectionMesh);

namespace
{
//------------------------------------------------------------------------------
bool HasOnlyPolygons(vtkPolyData* surface)
{
  return surface->GetNumberOfVerts() == 0 && surface->GetNumberOfLines() == 0 &&
    surface->GetNumberOfStrips() == 0;
}

//------------------------------------------------------------------------------
// A grid with the cells of `data`, which shares what it can.
vtkSmartPointer<vtkUnstructuredGrid> AsGrid(vtkDataSet* data)
{
  const vtkSmartPointer<vtkDataSet> mesh = AsMesh(data);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  auto* surface = vtkPolyData::SafeDownCast(mesh);
  if (surface && HasOnlyPolygons(surface))
  {
    vtkNew<vtkUnsignedCharArray> types;
    types->SetNumberOfValues(surface->GetNumberOfPolys());
    types->FillValue(VTK_POLYGON);
    grid->SetPoints(surface->GetPoints());
    grid->SetCells(types, surface->GetPolys());
    grid->GetPointData()->ShallowCopy(surface->GetPointData());
    grid->GetCellData()->ShallowCopy(surface->GetCellData());
  }
  else if (surface)
  {
    vtkNew<vtkAppendFilter> append;
    append->AddInputData(surface);
    append->Update();
    grid->ShallowCopy(append->GetOutput());
  }
  else
  {
    grid->ShallowCopy(mesh);
  }
  return grid;
}

//------------------------------------------------------------------------------
void AddIds(vtkDataSetAttributes* attributes, vtkIdType size, const char* name)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(name);
  ids->SetNumberOfValues(size);
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + size, vtkIdType(0));
  attributes->AddArray(ids);
}

//------------------------------------------------------------------------------
void AddConstant(vtkCellData* data, vtkIdType size, const char* name, unsigned int value)
{
  vtkNew<vtkConstantArray<unsigned int>> values;
  values->SetName(name);
  values->ConstructBackend(value);
  values->SetNumberOfTuples(size);
  data->AddArray(values);
}

//------------------------------------------------------------------------------
// Where the elements come from, for the selection of what is seen.
void AddOrigins(vtkUnstructuredGrid* grid, bool hasBlocks, unsigned int block)
{
  AddIds(grid->GetCellData(), grid->GetNumberOfCells(), CellIdsName);
  AddIds(grid->GetPointData(), grid->GetNumberOfPoints(), PointIdsName);
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const int process = controller ? controller->GetLocalProcessId() : 0;
  AddConstant(grid->GetCellData(), grid->GetNumberOfCells(), ProcessIdsName,
    static_cast<unsigned int>(process));
  if (hasBlocks)
  {
    AddConstant(grid->GetCellData(), grid->GetNumberOfCells(), BlockIdsName, block);
  }
}

//------------------------------------------------------------------------------
// Pieces meet on their way, or the data leave the process that has them.
bool IsDistributed()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return vtkProcessModule::GetProcessType() != vtkProcessModule::PROCESS_CLIENT ||
    (controller && controller->GetNumberOfProcesses() > 1);
}
}

//------------------------------------------------------------------------------
int vtkInspectionMesh::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkInspectionMesh::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0], 0);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  const bool hasBlocks = vtkCompositeDataSet::SafeDownCast(input) != nullptr;
  const std::vector<DataSetLeaf> leaves = GetLeaves(input);
  const std::vector<vtkSmartPointer<vtkDataArray>> outerFacets = this->FindOuterFacets(leaves);
  vtkNew<vtkAppendFilter> append;
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    const auto grid = AsGrid(leaves[i].Data);
    if (hasBlocks || IsDistributed())
    {
      AddOrigins(grid, hasBlocks, leaves[i].FlatIndex);
    }
    if (!outerFacets.empty())
    {
      grid->GetCellData()->AddArray(outerFacets[i]);
    }
    if (!hasBlocks)
    {
      output->ShallowCopy(grid);
    }
    else if (grid->GetNumberOfCells() > 0)
    {
      append->AddInputData(grid);
    }
  }
  if (append->GetNumberOfInputConnections(0) > 0)
  {
    append->Update();
    output->ShallowCopy(append->GetOutput());
  }
  return 1;
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkDataArray>> vtkInspectionMesh::FindOuterFacets(
  const std::vector<DataSetLeaf>& leaves)
{
  std::vector<vtkSmartPointer<vtkDataArray>> found;
  ControllerReducer reducer;
  if (reducer.GetNumberOfProcesses() == 1)
  {
    return found;
  }
  try
  {
    MeshPieces pieces(leaves, {}, reducer.GetNumberOfProcesses(), reducer);
    pieces.Link(false);
    for (std::size_t piece = 0; piece < pieces.GetSize(); ++piece)
    {
      const PieceLinks* links = pieces.GetOptions(piece).Links;
      const std::vector<std::uint64_t> bits =
        camaron::FindOuterFacets(pieces.GetTopology(piece), links ? &links->Faces : nullptr);
      vtkNew<vtkTypeUInt64Array> array;
      array->SetName(OuterFacetsName);
      array->SetNumberOfValues(static_cast<vtkIdType>(bits.size()));
      std::copy(bits.begin(), bits.end(), array->GetPointer(0));
      found.emplace_back(array);
    }
  }
  catch (const std::exception& error)
  {
    vtkWarningMacro("Faces between processes are drawn as if they were outside: " << error.what());
    found.clear();
  }
  return found;
}
