// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkJoinedInspectionMesh.h"

#include "InspectionArrays.h"
#include "InspectionBlocks.h"

#include "ControllerReducer.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedIntArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <vector>

using namespace camaron;

vtkStandardNewMacro(vtkJoinedInspectionMesh);

namespace
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

//------------------------------------------------------------------------------
bool IsByte(int type)
{
  return type == VTK_UNSIGNED_CHAR || type == VTK_CHAR || type == VTK_SIGNED_CHAR;
}

/// An array that some blocks have.
struct SharedArray
{
  int Type = VTK_VOID;
  int NumberOfComponents = 1;
  std::size_t NumberOfBlocks = 0;
  bool IsOfOneType = true;
};

using SharedArrays = std::map<std::string, SharedArray>;

//------------------------------------------------------------------------------
SharedArrays FindArrays(const std::vector<Grid>& samples, int association)
{
  SharedArrays found;
  for (const Grid& sample : samples)
  {
    vtkDataSetAttributes* attributes = sample->GetAttributes(association);
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = attributes->GetAbstractArray(i);
      if (!array->GetName())
      {
        continue;
      }
      SharedArray& shared = found[array->GetName()];
      if (shared.NumberOfBlocks == 0)
      {
        shared.Type = array->GetDataType();
        shared.NumberOfComponents = array->GetNumberOfComponents();
      }
      shared.IsOfOneType = shared.IsOfOneType && array->GetDataType() == shared.Type;
      shared.NumberOfBlocks += array->GetNumberOfComponents() == shared.NumberOfComponents;
    }
  }
  for (auto& entry : found)
  {
    SharedArray& shared = entry.second;
    const bool isNumber = shared.Type != VTK_STRING && shared.Type != VTK_VARIANT;
    const bool hasNull =
      shared.Type == VTK_FLOAT || shared.Type == VTK_DOUBLE || IsByte(shared.Type);
    if (isNumber && (!shared.IsOfOneType || (shared.NumberOfBlocks < samples.size() && !hasNull)))
    {
      shared.Type = VTK_DOUBLE;
    }
  }
  return found;
}

//------------------------------------------------------------------------------
// An array of undefined values for a block that lacks the array.
vtkSmartPointer<vtkAbstractArray> MakeNulls(const SharedArray& like, vtkIdType size)
{
  vtkSmartPointer<vtkAbstractArray> made;
  made.TakeReference(vtkAbstractArray::CreateArray(like.Type));
  made->SetNumberOfComponents(like.NumberOfComponents);
  made->SetNumberOfTuples(size);
  if (auto* numbers = vtkDataArray::SafeDownCast(made))
  {
    numbers->Fill(IsByte(like.Type) ? 0.0 : vtkMath::Nan());
  }
  return made;
}

//------------------------------------------------------------------------------
// Gives the piece exactly these arrays, with these types. Attribute types are left to the names.
void ShareArrays(vtkUnstructuredGrid* piece, int association, const SharedArrays& arrays)
{
  vtkDataSetAttributes* attributes = piece->GetAttributes(association);
  vtkNew<vtkFieldData> own;
  own->ShallowCopy(attributes);
  attributes->Initialize();
  for (const auto& entry : arrays)
  {
    const char* name = entry.first.c_str();
    const SharedArray& shared = entry.second;
    vtkSmartPointer<vtkAbstractArray> array = own->GetAbstractArray(name);
    if (!array || array->GetNumberOfComponents() != shared.NumberOfComponents)
    {
      array = MakeNulls(shared, piece->GetNumberOfElements(association));
    }
    else if (array->GetDataType() != shared.Type && vtkDataArray::SafeDownCast(array))
    {
      vtkSmartPointer<vtkAbstractArray> other;
      other.TakeReference(vtkAbstractArray::CreateArray(shared.Type));
      other->DeepCopy(array);
      array = other;
    }
    array->SetName(name);
    attributes->AddArray(array);
  }
}

//------------------------------------------------------------------------------
// Copies arrays with one value each: the first value, or 0.
void CopySample(vtkFieldData* from, bool hasValues, vtkFieldData* to)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = from->GetAbstractArray(i);
    if (!array->GetName() || (hasValues && array->GetNumberOfTuples() == 0))
    {
      continue;
    }
    vtkSmartPointer<vtkAbstractArray> sample;
    sample.TakeReference(vtkAbstractArray::CreateArray(array->GetDataType()));
    sample->SetName(array->GetName());
    sample->SetNumberOfComponents(array->GetNumberOfComponents());
    sample->SetNumberOfTuples(1);
    if (hasValues)
    {
      sample->SetTuple(0, 0, array);
    }
    else if (auto* numbers = vtkDataArray::SafeDownCast(sample))
    {
      numbers->Fill(0);
    }
    to->AddArray(sample);
  }
}

//------------------------------------------------------------------------------
Grid MakeSample(vtkUnstructuredGrid* block)
{
  auto sample = Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(block->GetPoints()->GetDataType());
  points->InsertNextPoint(0, 0, 0);
  sample->SetPoints(points);
  const vtkIdType point = 0;
  sample->InsertNextCell(VTK_VERTEX, 1, &point);
  CopySample(block->GetPointData(), false, sample->GetPointData());
  CopySample(block->GetCellData(), false, sample->GetCellData());
  CopySample(block->GetFieldData(), true, sample->GetFieldData());
  if (vtkDataArray* normals = block->GetPointData()->GetNormals())
  {
    sample->GetPointData()->SetActiveNormals(normals->GetName());
  }
  return sample;
}

/// The samples of the blocks of all processes.
struct Samples
{
  std::vector<std::size_t> Begins; ///< first piece of each block, and the number of pieces
  std::vector<Grid> Pieces;
};

//------------------------------------------------------------------------------
// A block gets as many pieces as on the process where it has most. The first process that has a
// piece sends its sample to all others, in one message.
Samples MakeSamples(const std::vector<Block>& blocks, std::size_t numberOfBlocks, Reducer& reducer)
{
  std::vector<std::int64_t> sizes(numberOfBlocks, 0);
  std::transform(blocks.begin(), blocks.end(), sizes.begin(),
    [](const Block& block) { return static_cast<std::int64_t>(block.size()); });
  reducer.Max(sizes.data(), sizes.size());
  Samples samples;
  samples.Begins.resize(numberOfBlocks + 1, 0);
  std::partial_sum(sizes.begin(), sizes.end(), samples.Begins.begin() + 1);
  samples.Pieces.resize(samples.Begins.back());

  const int process = reducer.GetProcess();
  std::vector<std::int64_t> firsts(samples.Pieces.size(), VTK_INT_MAX);
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    std::fill_n(firsts.begin() + samples.Begins[i], blocks[i].size(), process);
  }
  reducer.Min(firsts.data(), firsts.size());
  vtkNew<vtkMultiBlockDataSet> toOthers;
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    for (std::size_t piece = 0; piece < blocks[i].size(); ++piece)
    {
      const std::size_t number = samples.Begins[i] + piece;
      if (firsts[number] == process)
      {
        samples.Pieces[number] = MakeSample(blocks[i][piece]);
        toOthers->SetBlock(toOthers->GetNumberOfBlocks(), samples.Pieces[number]);
      }
    }
  }
  if (reducer.GetNumberOfProcesses() == 1 || firsts.empty())
  {
    return samples;
  }
  std::vector<vtkSmartPointer<vtkDataObject>> fromAll;
  vtkMultiProcessController::GetGlobalController()->AllGather(toOthers, fromAll);
  std::vector<unsigned int> next(fromAll.size(), 0);
  for (std::size_t number = 0; number < firsts.size(); ++number)
  {
    // Also replaces own samples, because sending may change types of numbers.
    auto* sent = vtkMultiBlockDataSet::SafeDownCast(fromAll[firsts[number]]);
    vtkDataObject* sample = sent ? sent->GetBlock(next[firsts[number]]++) : nullptr;
    samples.Pieces[number] = vtkUnstructuredGrid::SafeDownCast(sample);
    if (!samples.Pieces[number])
    {
      samples.Pieces[number] = Grid::New();
    }
  }
  return samples;
}

//------------------------------------------------------------------------------
// Puts the samples at the positions of their blocks, starting with block number @a block, into a @a
// tree that already has its structure.
void PlaceSamples(vtkDataObjectTree* tree, const Samples& samples, std::size_t& block)
{
  if (auto* pieces = vtkPartitionedDataSet::SafeDownCast(tree))
  {
    const std::size_t begin = samples.Begins[block], end = samples.Begins[++block];
    pieces->SetNumberOfPartitions(static_cast<unsigned int>(end - begin));
    for (std::size_t i = begin; i < end; ++i)
    {
      pieces->SetPartition(static_cast<unsigned int>(i - begin), samples.Pieces[i]);
    }
    return;
  }
  for (unsigned int i = 0; i < tree->GetNumberOfChildren(); ++i)
  {
    if (auto* child = vtkDataObjectTree::SafeDownCast(tree->GetChild(i)))
    {
      PlaceSamples(child, samples, block);
      continue;
    }
    const std::size_t begin = samples.Begins[block], end = samples.Begins[++block];
    if (auto* list = vtkMultiBlockDataSet::SafeDownCast(tree))
    {
      list->SetBlock(i, begin < end ? samples.Pieces[begin] : nullptr);
    }
  }
}

//------------------------------------------------------------------------------
// The tree comes from the process with most blocks, because the tree of a process without data may
// be empty.
Samples PlaceSamples(
  const std::vector<Block>& blocks, vtkDataObjectTree* tree, vtkDataObjectTree* output)
{
  ControllerReducer reducer;
  const auto own = static_cast<std::int64_t>(blocks.size());
  std::int64_t most = own, least = own;
  reducer.Max(&most, 1);
  reducer.Min(&least, 1);
  const Samples samples = MakeSamples(blocks, static_cast<std::size_t>(most), reducer);
  output->CopyStructure(tree);
  std::size_t block = 0;
  PlaceSamples(output, samples, block);
  if (most != least)
  {
    std::int64_t whole = own == most ? reducer.GetProcess() : VTK_INT_MAX;
    reducer.Min(&whole, 1);
    vtkMultiProcessController::GetGlobalController()->Broadcast(output, static_cast<int>(whole));
  }
  return samples;
}

//------------------------------------------------------------------------------
void Join(const std::vector<Block>& blocks, const Samples& samples, vtkUnstructuredGrid* output)
{
  const SharedArrays ofPoints = FindArrays(samples.Pieces, vtkDataObject::POINT);
  const SharedArrays ofCells = FindArrays(samples.Pieces, vtkDataObject::CELL);
  vtkNew<vtkAppendFilter> append;
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    std::size_t number = samples.Begins[i];
    for (vtkUnstructuredGrid* piece : blocks[i])
    {
      vtkNew<vtkUnstructuredGrid> copy;
      copy->ShallowCopy(piece);
      ShareArrays(copy, vtkDataObject::POINT, ofPoints);
      ShareArrays(copy, vtkDataObject::CELL, ofCells);
      vtkNew<vtkUnsignedIntArray> numbers;
      numbers->SetName(LeavesName);
      numbers->SetNumberOfValues(piece->GetNumberOfCells());
      numbers->FillValue(static_cast<unsigned int>(number++));
      copy->GetCellData()->AddArray(numbers);
      append->AddInputData(copy);
      if (piece->GetPoints()->GetDataType() == VTK_DOUBLE)
      {
        append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
      }
    }
  }
  if (append->GetNumberOfInputConnections(0) == 0)
  {
    return;
  }
  append->Update();
  output->ShallowCopy(append->GetOutput());
  for (const Grid& sample : samples.Pieces)
  {
    if (vtkDataArray* normals = sample->GetPointData()->GetNormals())
    {
      output->GetPointData()->SetActiveNormals(normals->GetName());
    }
  }
}

//------------------------------------------------------------------------------
// When processes exchange cells, ParaView merges coincident points, whose values may differ between
// blocks. It compares global ids instead if there are any.
void KeepPointsApart(vtkUnstructuredGrid* mesh)
{
  const ControllerReducer reducer;
  if (reducer.GetNumberOfProcesses() == 1)
  {
    return;
  }
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(JoinedPointIdsName);
  ids->SetNumberOfValues(mesh->GetNumberOfPoints());
  const vtkIdType stride = reducer.GetNumberOfProcesses();
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    ids->SetValue(point, point * stride + reducer.GetProcess());
  }
  mesh->GetPointData()->SetGlobalIds(ids);
}
}

//------------------------------------------------------------------------------
vtkJoinedInspectionMesh::vtkJoinedInspectionMesh()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
int vtkJoinedInspectionMesh::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0], 0);
  const int types[] = { VTK_UNSTRUCTURED_GRID,
    input ? input->GetDataObjectType() : VTK_UNSTRUCTURED_GRID };
  for (int port = 0; port < 2; ++port)
  {
    if (!vtkDataObjectAlgorithm::SetOutputDataObject(
          types[port], outputVector->GetInformationObject(port), /*exact*/ true))
    {
      return 0;
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkJoinedInspectionMesh::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0], 0);
  auto* joined = vtkUnstructuredGrid::GetData(outputVector, 0);
  auto* tree = vtkDataObjectTree::SafeDownCast(input);
  if (!tree)
  {
    joined->ShallowCopy(input);
    return 1;
  }
  const std::vector<Block> blocks = FindBlocks(tree);
  auto* samplesTree = vtkDataObjectTree::SafeDownCast(vtkDataObject::GetData(outputVector, 1));
  const Samples samples = PlaceSamples(blocks, tree, samplesTree);
  Join(blocks, samples, joined);
  KeepPointsApart(joined);
  return 1;
}
