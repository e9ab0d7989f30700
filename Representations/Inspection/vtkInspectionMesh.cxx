// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInspectionMesh.h"

#include "InspectionArrays.h"

#include "ControllerReducer.h"
#include "DistributedMesh.h"
#include "Drawing/DrawableFaces.h"
#include "ElementBlocks.h"
#include "Mesh/FacetLinks.h"
#include "Mesh/MeshCheck.h"
#include "MeshInput.h"
#include "vtkCamaronCompat.h"

#include "vtkAppendFilter.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkConstantArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProcessModule.h"
#include "vtkTypeUInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedIntArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <exception>
#include <map>
#include <set>

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
bool HasAny(vtkUnsignedCharArray* ghosts, int bits)
{
  return ghosts &&
    std::any_of(ghosts->GetPointer(0), ghosts->GetPointer(0) + ghosts->GetNumberOfValues(),
      [=](int ghost) { return (ghost & bits) != 0; });
}

//------------------------------------------------------------------------------
// Also hides refined cells, which finer cells replace, and cells with hidden points.
void HideCells(vtkUnstructuredGrid* grid)
{
  constexpr int unseen = vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;
  vtkUnsignedCharArray* cells = grid->GetCellGhostArray();
  vtkUnsignedCharArray* points = grid->GetPointGhostArray();
  const bool hasRefined = HasAny(cells, vtkDataSetAttributes::REFINEDCELL);
  const bool hasHiddenPoints = HasAny(points, vtkDataSetAttributes::HIDDENPOINT);
  if (!hasRefined && !hasHiddenPoints)
  {
    return;
  }
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(grid->GetNumberOfCells());
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const int ghost = cells ? cells->GetValue(cell) : 0;
    bool isUnseen = (ghost & unseen) != 0;
    if (hasHiddenPoints && !isUnseen)
    {
      grid->GetCellPoints(cell, corners);
      isUnseen = std::any_of(corners->begin(), corners->end(), [&](vtkIdType point)
        { return (points->GetValue(point) & vtkDataSetAttributes::HIDDENPOINT) != 0; });
    }
    ghosts->SetValue(
      cell, static_cast<unsigned char>(ghost | (isUnseen ? vtkDataSetAttributes::HIDDENCELL : 0)));
  }
  grid->GetCellData()->AddArray(ghosts);
}

//------------------------------------------------------------------------------
// A grid with the cells of `data`, which shares as much memory as possible.
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
  HideCells(grid);
  return grid;
}

//------------------------------------------------------------------------------
void AddConstant(vtkDataSetAttributes* data, vtkIdType size, const char* name, unsigned int value)
{
  vtkNew<vtkConstantArray<unsigned int>> values;
  values->SetName(name);
  values->ConstructBackend(value);
  values->SetNumberOfTuples(size);
  data->AddArray(values);
}

//------------------------------------------------------------------------------
// Adds the ids of elements, processes and blocks, for selections in the view.
void AddOrigins(vtkUnstructuredGrid* grid, bool hasBlocks, unsigned int block)
{
  grid->GetCellData()->RemoveArray(CellIdsName);
  grid->GetPointData()->RemoveArray(PointIdsName);
  AddIds(grid->GetCellData(), CellIdsName, grid->GetNumberOfCells());
  AddIds(grid->GetPointData(), PointIdsName, grid->GetNumberOfPoints());
  AddConstant(grid->GetCellData(), grid->GetNumberOfCells(), ProcessIdsName,
    static_cast<unsigned int>(ControllerReducer().GetProcess()));
  if (hasBlocks)
  {
    AddConstant(grid->GetCellData(), grid->GetNumberOfCells(), BlockIdsName, block);
  }
}

//------------------------------------------------------------------------------
// ParaView numbers the blocks of a vtkMultiBlockDataSet, including empty ones, to color them.
// Blocks of other composite data sets have their own numbers.
std::map<unsigned int, int> NumberBlocks(vtkDataObject* input)
{
  std::map<unsigned int, int> numbers;
  if (auto* tree = vtkMultiBlockDataSet::SafeDownCast(input))
  {
    vtkSmartPointer<vtkDataObjectTreeIterator> it;
    it.TakeReference(tree->NewTreeIterator());
    it->SkipEmptyNodesOff();
    it->VisitOnlyLeavesOn();
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      numbers.emplace(it->GetCurrentFlatIndex(), static_cast<int>(numbers.size()));
    }
  }
  return numbers;
}

//------------------------------------------------------------------------------
// Puts blocks at their position in the input, by flat index.
void FillTree(vtkDataObject* input,
  const std::map<unsigned int, vtkSmartPointer<vtkUnstructuredGrid>>& blocks,
  vtkDataObjectTree* output)
{
  vtkDataObjectTree* tree = GetTree(input);
  if (!tree)
  {
    auto* list = vtkMultiBlockDataSet::SafeDownCast(output);
    for (const auto& block : blocks)
    {
      list->SetBlock(list->GetNumberOfBlocks(), block.second);
    }
    return;
  }
  if (vtkPartitionedDataSet::SafeDownCast(input))
  {
    // One block with any number of pieces on each process.
    auto* list = vtkPartitionedDataSetCollection::SafeDownCast(output);
    list->SetNumberOfPartitionedDataSets(1);
    for (const auto& block : blocks)
    {
      list->SetPartition(0, list->GetNumberOfPartitions(0), block.second);
    }
    return;
  }
  output->CopyStructure(tree);
  vtkSmartPointer<vtkDataObjectTreeIterator> it;
  it.TakeReference(output->NewTreeIterator());
  it->SkipEmptyNodesOff();
  it->VisitOnlyLeavesOn();
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    const auto found = blocks.find(it->GetCurrentFlatIndex());
    if (found != blocks.end())
    {
      output->SetDataSet(it, found->second);
    }
  }
}

//------------------------------------------------------------------------------
// Whether the process has several pieces of a block, or a data set whose points may be in several
// pieces.
bool MayHavePieces(const std::vector<DataSetLeaf>& leaves)
{
  std::set<int> blocks;
  return std::any_of(leaves.begin(), leaves.end(), [&](const DataSetLeaf& leaf)
    { return leaf.Data->GetPointData()->GetGlobalIds() || !blocks.insert(leaf.Number).second; });
}

//------------------------------------------------------------------------------
// Whether cells of several processes are gathered, or the data leave their process.
bool IsDistributed()
{
  return vtkProcessModule::GetProcessType() != vtkProcessModule::PROCESS_CLIENT ||
    ControllerReducer().GetNumberOfProcesses() > 1;
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
int vtkInspectionMesh::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0], 0);
  const int type = !vtkCompositeDataSet::SafeDownCast(input) ? VTK_UNSTRUCTURED_GRID
    : vtkPartitionedDataSetCollection::SafeDownCast(GetTree(input)) ||
      vtkPartitionedDataSet::SafeDownCast(input)
    ? VTK_PARTITIONED_DATA_SET_COLLECTION
    : VTK_MULTIBLOCK_DATA_SET;
  return vtkDataObjectAlgorithm::SetOutputDataObject(
           type, outputVector->GetInformationObject(0), /*exact*/ true)
    ? 1
    : 0;
}

//------------------------------------------------------------------------------
int vtkInspectionMesh::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0], 0);
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  const bool hasBlocks = vtkCompositeDataSet::SafeDownCast(input) != nullptr;
  const std::vector<DataSetLeaf> leaves = this->FindDrawable(GetLeaves(input));
  const std::vector<vtkSmartPointer<vtkDataArray>> outerFacets = this->FindOuterFacets(leaves);
  const std::map<unsigned int, int> numbers = NumberBlocks(input);
  std::map<unsigned int, vtkSmartPointer<vtkUnstructuredGrid>> blocks;
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
      return 1;
    }
    grid->GetFieldData()->ShallowCopy(leaves[i].Data->GetFieldData());
    this->MarkBlock(grid, leaves[i].FlatIndex,
      numbers.count(leaves[i].FlatIndex) ? numbers.at(leaves[i].FlatIndex) : leaves[i].Number);
    blocks[leaves[i].FlatIndex] = grid;
  }
  if (hasBlocks)
  {
    FillTree(input, blocks, vtkDataObjectTree::SafeDownCast(output));
  }
  return 1;
}

//------------------------------------------------------------------------------
// Only reports the others: other processes continue, so everything that can be drawn is drawn.
std::vector<DataSetLeaf> vtkInspectionMesh::FindDrawable(const std::vector<DataSetLeaf>& leaves)
{
  std::vector<DataSetLeaf> drawable;
  PolyhedronFaces faces;
  const auto report = [this](auto&& check)
  {
    try
    {
      check();
    }
    catch (const std::exception& error)
    {
      vtkErrorMacro("Parts of the mesh are not drawn: " << error.what() << '.');
    }
  };
  for (const DataSetLeaf& leaf : leaves)
  {
    report(
      [&]
      {
        CheckLeaf(leaf);
        faces.Add(leaf.Data);
        drawable.push_back(leaf);
      });
  }
  report([&] { faces.Check(); });
  return drawable;
}

//------------------------------------------------------------------------------
// As ParaView does for Surface.
void vtkInspectionMesh::MarkBlock(vtkUnstructuredGrid* grid, unsigned int flatIndex, int number)
{
  AddConstant(grid->GetPointData(), grid->GetNumberOfPoints(), "vtkCompositeIndex", flatIndex);
  AddConstant(grid->GetCellData(), grid->GetNumberOfCells(), "vtkCompositeIndex", flatIndex);
  vtkNew<vtkUnsignedIntArray> color;
  color->SetName("vtkBlockColors");
  color->InsertNextValue(static_cast<unsigned int>(number % this->BlockColorsDistinctValues));
  grid->GetFieldData()->AddArray(color);
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkDataArray>> vtkInspectionMesh::FindOuterFacets(
  const std::vector<DataSetLeaf>& leaves)
{
  std::vector<vtkSmartPointer<vtkDataArray>> found;
  ControllerReducer reducer;
  const bool isAlone = reducer.GetNumberOfProcesses() == 1;
  if (isAlone && !MayHavePieces(leaves))
  {
    return found;
  }
  try
  {
    DistributedMesh pieces(leaves, {}, reducer.GetNumberOfProcesses(), reducer);
    if (isAlone && leaves.size() == 1 && pieces.GetFirstCopies(0).empty())
    {
      return found;
    }
    pieces.Link();
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
    vtkWarningMacro("Faces between pieces are drawn as outer faces: " << error.what());
    found.clear();
  }
  return found;
}
