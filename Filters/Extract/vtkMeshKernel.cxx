// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshKernel.h"

#include "ControllerReducer.h"
#include "ElementBlocks.h"
#include "Elements/KernelCells.h"
#include "MeshInput.h"
#include "RequestFailure.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkMeshKernel);

namespace
{
const std::string AllCells = "All cells";

//------------------------------------------------------------------------------
// The values of all processes, one process after the other, on the first process; none on others.
template <typename Value>
std::vector<Value> GatherOnFirst(std::vector<Value>&& own, camaron::Reducer& reducer)
{
  std::vector<std::vector<Value>> lists(reducer.GetNumberOfProcesses());
  lists[0] = std::move(own);
  std::vector<Value> all;
  for (const std::vector<Value>& list : reducer.ExchangeItems(std::move(lists)))
  {
    all.insert(all.end(), list.begin(), list.end());
  }
  return all;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataSet> GetMesh(const camaron::ElementBlock& block)
{
  return camaron::AsMesh(camaron::WithoutStrips(block.Data));
}

//------------------------------------------------------------------------------
void AddCopies(vtkIdType value, vtkIdType count, vtkIdTypeArray* array)
{
  for (vtkIdType i = 0; i < count; ++i)
  {
    array->InsertNextValue(value);
  }
}
}

//------------------------------------------------------------------------------
int vtkMeshKernel::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkUnstructuredGrid");
  return 1;
}

//------------------------------------------------------------------------------
bool vtkMeshKernel::GoesOn(double done)
{
  this->UpdateProgress(done);
  return !this->CheckAbort();
}

//------------------------------------------------------------------------------
int vtkMeshKernel::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  try
  {
    const camaron::EvaluationOptions options = this->GetEvaluationOptions();
    camaron::ControllerReducer reducer;
    const camaron::ElementBlocks blocks(vtkDataObject::GetData(inputVector[0]), reducer);
    camaron::CheckFaces({ blocks.Get().begin(), blocks.Get().end() }, reducer);
    std::int64_t hasOthers = std::any_of(blocks.Get().begin(), blocks.Get().end(),
      [](const camaron::ElementBlock& block) { return !vtkPolyData::SafeDownCast(block.Data); });
    reducer.Max(&hasOthers, 1);
    if (this->KernelOf == WHOLE_SURFACE || (this->KernelOf == AUTOMATIC && !hasOthers))
    {
      using camaron::SurfaceKernel;
      const auto found = static_cast<SurfaceKernel>(this->MakeOfSurface(blocks, output));
      const bool isFirst = reducer.GetProcess() == 0;
      const bool isError = found == SurfaceKernel::NotClosed || found == SurfaceKernel::NotFinite;
      if (!isError || this->KernelOf == WHOLE_SURFACE)
      {
        if (isError && isFirst)
        {
          vtkErrorMacro(
            "The surface has no kernel: " << (found == SurfaceKernel::NotFinite
                ? "a coordinate is not finite."
                : "its polygons do not enclose a volume. For a mesh of 3D cells, apply Mesh "
                  "Surface first, or create the kernel of each cell."));
        }
        if (found == SurfaceKernel::Empty && isFirst)
        {
          vtkWarningMacro("The kernel is empty: no point sees the whole surface.");
        }
        return isError && isFirst ? 0 : 1;
      }
    }
    this->MakeOfCells(blocks, options, output);
  }
  catch (...)
  {
    return camaron::FailRequest(this, "The kernel cannot be computed", outputVector);
  }
  return 1;
}

//------------------------------------------------------------------------------
// Returns a camaron::SurfaceKernel, which is the same on all processes.
int vtkMeshKernel::MakeOfSurface(const camaron::ElementBlocks& blocks, vtkUnstructuredGrid* output)
{
  camaron::SurfacePolygons polygons;
  for (const camaron::ElementBlock& block : blocks.Get())
  {
    const camaron::SurfacePolygons own = camaron::TakePolygons(GetMesh(block));
    polygons.Sizes.insert(polygons.Sizes.end(), own.Sizes.begin(), own.Sizes.end());
    polygons.Corners.insert(polygons.Corners.end(), own.Corners.begin(), own.Corners.end());
  }
  camaron::ControllerReducer reducer;
  polygons.Sizes = GatherOnFirst(std::move(polygons.Sizes), reducer);
  polygons.Corners = GatherOnFirst(std::move(polygons.Corners), reducer);
  std::int64_t found = 0;
  if (reducer.GetProcess() == 0)
  {
    found = static_cast<std::int64_t>(camaron::MakeSurfaceKernel(
      polygons, {}, [this](double done) { return this->GoesOn(done); }, output));
  }
  camaron::CheckAbortOnAllRanks(this, 1, reducer);
  reducer.Max(&found, 1);
  return static_cast<int>(found);
}

//------------------------------------------------------------------------------
void vtkMeshKernel::MakeOfCells(const camaron::ElementBlocks& blocks,
  const camaron::EvaluationOptions& options, vtkUnstructuredGrid* output)
{
  const bool isChosen = !this->ChosenBy.empty() && this->ChosenBy != AllCells;
  vtkNew<vtkAppendFilter> append;
  vtkNew<vtkIdTypeArray> without, blocksWithout;
  without->SetName("CellsWithoutKernel");
  blocksWithout->SetName("BlocksWithoutKernel");
  std::int64_t arrays = 0, cells = 0;
  const double numberOfBlocks = static_cast<double>(blocks.Get().size());
  double blocksDone = 0;
  bool isStopped = false;
  vtkNew<vtkUnstructuredGrid> kernels;
  for (const camaron::ElementBlock& block : blocks.Get())
  {
    const vtkSmartPointer<vtkDataSet> mesh = GetMesh(block);
    cells += mesh->GetNumberOfCells();
    vtkDataArray* chosen =
      isChosen ? mesh->GetCellData()->GetArray(this->ChosenBy.c_str()) : nullptr;
    arrays += chosen != nullptr;
    if (!isStopped && (chosen || !isChosen))
    {
      vtkNew<vtkUnstructuredGrid> part;
      isStopped = !camaron::MakeKernelCells(
        mesh, options, chosen,
        [&](double done) { return this->GoesOn((blocksDone + done) / numberOfBlocks); }, part);
      if (auto* ids = vtkIdTypeArray::SafeDownCast(
            part->GetFieldData()->GetAbstractArray(without->GetName())))
      {
        without->InsertTuples(without->GetNumberOfTuples(), ids->GetNumberOfTuples(), 0, ids);
        AddCopies(block.FlatIndex, ids->GetNumberOfTuples(), blocksWithout);
      }
      if (blocks.IsComposite())
      {
        vtkNew<vtkIdTypeArray> sources;
        sources->SetName("SourceBlock");
        AddCopies(block.FlatIndex, part->GetNumberOfCells(), sources);
        part->GetCellData()->AddArray(sources);
      }
      append->AddInputData(part);
      kernels->ShallowCopy(part);
    }
    ++blocksDone;
  }
  camaron::ControllerReducer reducer;
  std::int64_t sums[] = { arrays, cells, without->GetNumberOfTuples() };
  reducer.Sum(sums, 3);
  if (isChosen && sums[0] == 0 && sums[1] > 0)
  {
    throw std::runtime_error("there is no cell array " + this->ChosenBy);
  }
  camaron::CheckAbortOnAllRanks(this, 1, reducer, !isStopped);
  if (append->GetNumberOfInputConnections(0) > 1)
  {
    append->Update();
    kernels->ShallowCopy(append->GetOutput());
  }
  output->ShallowCopy(kernels);
  output->GetFieldData()->AddArray(without);
  if (blocks.IsComposite())
  {
    output->GetFieldData()->AddArray(blocksWithout);
  }
  if (sums[2] > 0 && reducer.GetProcess() == 0)
  {
    vtkWarningMacro(
      << sums[2]
      << " cells have no kernel because they are not star-shaped, are not closed, or have no "
         "volume or area. The field array CellsWithoutKernel lists them.");
  }
}
