// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ElementBlocks.h"

#include "Base/Buffer.h"
#include "Base/Parallel.h"
#include "Criteria/Criterion.h"
#include "DistributedMesh.h"
#include "Duplicates.h"
#include "Mesh/CellShape.h"
#include "Mesh/GhostArrays.h"
#include "MeshInput.h"
#include "PropertyValues.h"
#include "Ranks/Collective.h"
#include "Selection/SharedElements.h"
#include "vtkCamaronCompat.h"

#include "vtkArrayDispatch.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArrayRange.h"
#include "vtkDataObjectTree.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <type_traits>

namespace camaron
{
//------------------------------------------------------------------------------
ElementKind ParseElementKind(const std::string& name)
{
  return ParseChoice<ElementKind>(
    "Element Type", name, { { "Cells", ElementKind::Cells }, { "Points", ElementKind::Points } });
}

//------------------------------------------------------------------------------
unsigned char GetGhostMask(ElementKind kind)
{
  return kind == ElementKind::Cells
    ? vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL |
      vtkDataSetAttributes::REFINEDCELL
    : vtkDataSetAttributes::DUPLICATEPOINT | vtkDataSetAttributes::HIDDENPOINT;
}

namespace
{
static_assert(static_cast<int>(vtkDataSetAttributes::DUPLICATECELL) ==
    static_cast<int>(vtkDataSetAttributes::DUPLICATEPOINT),
  "duplicate cells and duplicate points have the same bit");

//------------------------------------------------------------------------------
// The path of a child node, such as "rotor/blades".
std::string GetChildName(
  const std::string& parent, vtkInformation* metaData, const std::string& fallback)
{
  const char* name = metaData ? metaData->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return (parent.empty() ? "" : parent + "/") + (name && name[0] ? name : fallback);
}

//------------------------------------------------------------------------------
// Numbers nodes like VTK: in preorder, including empty ones.
void AddTree(vtkDataObject* node, unsigned int& flatIndex, int number, const std::string& name,
  std::vector<DataSetLeaf>& leaves)
{
  if (auto* data = vtkDataSet::SafeDownCast(node))
  {
    leaves.push_back({ data, flatIndex, number, name });
  }
  else if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(node))
  {
    for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
    {
      ++flatIndex;
      // The flat index is no block number: it depends on the number of partitions on this process.
      AddTree(collection->GetPartitionedDataSet(i), flatIndex, static_cast<int>(i),
        GetChildName(name, collection->HasMetaData(i) ? collection->GetMetaData(i) : nullptr,
          "Block " + std::to_string(i)),
        leaves);
    }
  }
  else if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(node))
  {
    for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
    {
      ++flatIndex;
      AddTree(blocks->GetBlock(i), flatIndex, static_cast<int>(flatIndex),
        GetChildName(name, blocks->HasMetaData(i) ? blocks->GetMetaData(i) : nullptr,
          "Block " + std::to_string(flatIndex)),
        leaves);
    }
  }
  else if (auto* pieces = vtkPartitionedDataSet::SafeDownCast(node))
  {
    // Partitions are pieces of one block. Their number may differ between processes.
    for (unsigned int i = 0; i < pieces->GetNumberOfPartitions(); ++i)
    {
      ++flatIndex;
      AddTree(pieces->GetPartitionAsDataObject(i), flatIndex, number, name, leaves);
    }
  }
}
}

//------------------------------------------------------------------------------
std::vector<DataSetLeaf> GetOutputLeaves(vtkDataObject* input)
{
  std::vector<DataSetLeaf> leaves;
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (auto* data = vtkDataSet::SafeDownCast(input))
  {
    leaves.push_back({ data, 0, 0, "" });
  }
  else if (GetTree(input))
  {
    unsigned int flatIndex = 0;
    AddTree(input, flatIndex, 0, "", leaves);
  }
  else if (composite)
  {
    // Adaptive meshes have the same levels and boxes on all processes.
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      if (auto* data = vtkDataSet::SafeDownCast(it->GetCurrentDataObject()))
      {
        const unsigned int index = it->GetCurrentFlatIndex();
        leaves.push_back(
          { data, index, static_cast<int>(index), "Block " + std::to_string(index) });
      }
    }
  }
  return leaves;
}

//------------------------------------------------------------------------------
std::vector<DataSetLeaf> GetLeaves(vtkDataObject* input)
{
  std::vector<DataSetLeaf> leaves = GetOutputLeaves(input);
  for (DataSetLeaf& leaf : leaves)
  {
    leaf.Data = WithGhostBytes(leaf.Data);
  }
  return leaves;
}

//------------------------------------------------------------------------------
vtkIdType ElementBlock::GetSize() const
{
  return this->Data->GetNumberOfElements(static_cast<int>(this->Kind));
}

//------------------------------------------------------------------------------
vtkDataSetAttributes* ElementBlock::GetAttributes() const
{
  return this->Data->GetAttributes(static_cast<int>(this->Kind));
}

//------------------------------------------------------------------------------
vtkDataArray* ElementBlock::GetArray(const std::string& name) const
{
  vtkDataArray* array = this->GetAttributes()->GetArray(name.c_str());
  return array && array->GetNumberOfComponents() == 1 ? array : nullptr;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkIdTypeArray> ToIds(vtkDataArray* array)
{
  if (!array || vtkIdTypeArray::FastDownCast(array))
  {
    return vtkIdTypeArray::FastDownCast(array);
  }
  auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  ids->DeepCopy(array);
  const vtkIdType *begin = ids->GetPointer(0), *end = begin + ids->GetNumberOfValues();
  const bool isUnsigned = array->GetDataTypeMin() == 0;
  const bool fits = !isUnsigned || std::all_of(begin, end, [](vtkIdType id) { return id >= 0; });
  return fits ? ids : nullptr;
}

//------------------------------------------------------------------------------
ElementBlocks::ElementBlocks(vtkDataObject* input, Reducer& reducer, ElementKind kind)
  : Kind(kind)
{
  this->Composite = vtkCompositeDataSet::SafeDownCast(input) != nullptr;
  const std::vector<DataSetLeaf> leaves = GetMeshes(input, reducer);
  RunCollectively(reducer,
    [&]
    {
      for (const DataSetLeaf& leaf : leaves)
      {
        this->AddBlock(leaf);
      }
    });
  if (kind == ElementKind::Points)
  {
    this->FindCopiesOfPoints(reducer);
  }
  this->FindGlobalIds(reducer);
  this->FindIndices(reducer);
}

//------------------------------------------------------------------------------
void ElementBlocks::AddBlock(const DataSetLeaf& leaf)
{
  ElementBlock block;
  static_cast<DataSetLeaf&>(block) = leaf;
  block.Kind = this->Kind;
  if (block.GetSize() == 0)
  {
    return;
  }
  vtkUnsignedCharArray* ghosts = leaf.Data->GetGhostArray(static_cast<int>(this->Kind));
  const unsigned char* begin = ghosts ? ghosts->GetPointer(0) : nullptr;
  const unsigned char* end = ghosts ? begin + block.GetSize() : nullptr;
  const unsigned char mask = GetGhostMask(this->Kind);
  if (std::any_of(begin, end, [mask](unsigned char ghost) { return ghost & mask; }))
  {
    block.Skip.resize(end - begin);
    std::transform(begin, end, block.Skip.begin(),
      [mask](unsigned char ghost) { return static_cast<unsigned char>(ghost & mask); });
  }
  this->Blocks.push_back(block);
}

//------------------------------------------------------------------------------
void ElementBlocks::SkipPointsOfCopies(ElementBlock& block, const LinkedPiece& piece)
{
  if (!piece.Options.Ghosts)
  {
    return;
  }
  const MeshView& mesh = piece.Topology->GetMesh();
  std::vector<unsigned char> uses(block.GetSize()); // bit 1: by duplicate cells, bit 2: by others
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    const IndexRange points = mesh.GetCellPoints(cell);
    for (vtkIdType i = 0; i < points.Size; ++i)
    {
      uses[points[i]] |= piece.IsCopy(cell) ? 1 : 2;
    }
  }
  block.Skip.resize(block.GetSize());
  for (std::size_t point = 0; point < uses.size(); ++point)
  {
    block.Skip[point] |= uses[point] == 1 ? vtkDataSetAttributes::DUPLICATEPOINT : 0;
  }
}

//------------------------------------------------------------------------------
void ElementBlocks::FindCopiesOfPoints(Reducer& reducer)
{
  std::int64_t counts[2] = { static_cast<std::int64_t>(this->Blocks.size()), 0 };
  for (const ElementBlock& block : this->Blocks)
  {
    counts[1] += block.Data->GetCellGhostArray() || !FindFirstCopies(block.Data).empty();
  }
  reducer.Sum(counts, 2);
  if (counts[0] < 2 && counts[1] == 0)
  {
    return;
  }
  const DistributedMesh pieces({ this->Blocks.begin(), this->Blocks.end() }, EvaluationOptions(),
    reducer.GetNumberOfProcesses(), reducer);
  std::int64_t hasCopies = 0;
  for (std::size_t piece = 0; piece < pieces.GetSize(); ++piece)
  {
    ElementBlock& block = this->Blocks[piece];
    this->SkipPointsOfCopies(block, pieces.Get()[piece]);
    const std::vector<vtkIdType>& firsts = pieces.GetFirstCopies(piece);
    hasCopies |= !firsts.empty();
    block.Skip.resize(std::max(block.Skip.size(), firsts.size()));
    for (std::size_t point = 0; point < firsts.size(); ++point)
    {
      const bool isCopy = firsts[point] != static_cast<vtkIdType>(point);
      block.Skip[point] |= isCopy ? vtkDataSetAttributes::DUPLICATEPOINT : 0;
    }
  }
  SharedElements shared = SharedElements::OfPoints(pieces.Get(), reducer);
  std::vector<std::int64_t> owners;
  for (const SharedElements::Element& point : shared.Get())
  {
    owners.push_back(this->Blocks[point.Piece].IsGhost(point.Number)
        ? std::numeric_limits<std::int64_t>::max()
        : (static_cast<std::int64_t>(reducer.GetProcess()) << 32) + point.Piece);
  }
  hasCopies |= !owners.empty();
  reducer.Max(&hasCopies, 1);
  this->PointCopies = hasCopies != 0;
  const std::vector<std::int64_t> own = owners;
  shared.Minimize(owners);
  for (std::size_t i = 0; i < owners.size(); ++i)
  {
    ElementBlock& block = this->Blocks[shared.Get()[i].Piece];
    if (owners[i] != own[i])
    {
      block.Skip.resize(block.GetSize());
      block.Skip[shared.Get()[i].Number] |= vtkDataSetAttributes::DUPLICATEPOINT;
    }
  }
}

//------------------------------------------------------------------------------
// Uses global ids only if every element has one and vtkIdType can represent all of them.
void ElementBlocks::FindGlobalIds(Reducer& reducer)
{
  std::int64_t counts[2] = { 0, 0 };
  for (ElementBlock& block : this->Blocks)
  {
    block.GlobalIds = ToIds(block.GetAttributes()->GetGlobalIds());
    ++counts[block.GlobalIds ? 0 : 1];
  }
  reducer.Sum(counts, 2);
  this->GlobalIds = counts[0] > 0 && counts[1] == 0;
  for (ElementBlock& block : this->Blocks)
  {
    block.GlobalIds = this->GlobalIds ? block.GlobalIds : nullptr;
  }
}

//------------------------------------------------------------------------------
void ElementBlocks::FindIndices(Reducer& reducer)
{
  struct Piece
  {
    std::int64_t Number, Process, Order, Size;
  };
  std::vector<Piece> pieces;
  for (ElementBlock& block : this->Blocks)
  {
    // Count the elements that are not duplicates; duplicates usually come last.
    const vtkIdType size = block.GetSize();
    vtkIdType count = block.Skip.empty() ? size : 0;
    for (vtkIdType cell = 0; cell < static_cast<vtkIdType>(block.Skip.size()); ++cell)
    {
      const bool isCopy = block.Skip[cell] & vtkDataSetAttributes::DUPLICATECELL;
      if (!isCopy && count < cell && block.Indices.empty())
      {
        block.Indices.resize(size);
        for (vtkIdType i = 0; i < cell; ++i)
        {
          block.Indices[i] = std::min(i, count);
        }
      }
      if (!block.Indices.empty())
      {
        block.Indices[cell] = count;
      }
      count += !isCopy;
    }
    pieces.push_back(
      { block.Number, reducer.GetProcess(), static_cast<std::int64_t>(pieces.size()), count });
  }

  pieces = reducer.GatherItems(pieces);
  std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b)
    { return std::tie(a.Number, a.Process, a.Order) < std::tie(b.Number, b.Process, b.Order); });
  for (const Piece& piece : pieces)
  {
    if (piece.Process == reducer.GetProcess())
    {
      ElementBlock& block = this->Blocks[piece.Order];
      block.FirstIndex = this->NumberOfIndices;
      for (vtkIdType& index : block.Indices)
      {
        index += block.FirstIndex;
      }
    }
    this->NumberOfIndices += static_cast<vtkIdType>(piece.Size);
  }
}

//------------------------------------------------------------------------------
bool ElementBlocks::AreEmpty(Reducer& reducer) const
{
  auto count = static_cast<std::int64_t>(this->Blocks.size());
  reducer.Sum(&count, 1);
  return count == 0;
}

//------------------------------------------------------------------------------
void ElementBlocks::RequireAny(
  std::size_t count, const std::string& message, Reducer& reducer) const
{
  std::int64_t counts[2] = { static_cast<std::int64_t>(count),
    static_cast<std::int64_t>(this->Blocks.size()) };
  reducer.Sum(counts, 2);
  if (counts[0] == 0 && counts[1] > 0)
  {
    throw std::invalid_argument(message);
  }
}

//------------------------------------------------------------------------------
void ElementBlocks::Restrict(const std::vector<std::vector<unsigned char>>& marks)
{
  for (std::size_t b = 0; b < marks.size(); ++b)
  {
    std::vector<unsigned char>& skip = this->Blocks[b].Skip;
    skip.resize(marks[b].size());
    std::transform(marks[b].begin(), marks[b].end(), skip.begin(), skip.begin(),
      [](unsigned char mark, unsigned char ghost)
      { return static_cast<unsigned char>(ghost || !mark); });
  }
}

namespace
{
//------------------------------------------------------------------------------
// Whether the array has an integer of 2^53 or more in magnitude.
struct FindInexactInteger
{
  std::atomic<bool> Found = false;

  template <typename Array>
  void operator()(Array* array)
  {
    const auto values = vtk::DataArrayValueRange(array);
    using Value = typename decltype(values)::ValueType;
    constexpr auto limit = static_cast<Value>(LeastInexactInteger);
    ParallelFor(values.size(), LightGrain,
      [&](vtkIdType begin, vtkIdType end)
      {
        bool found = false;
        for (vtkIdType i = begin; i < end; ++i)
        {
          const Value value = values[i];
          found |= value >= limit || (std::is_signed_v<Value> && value <= -limit);
        }
        if (found)
        {
          this->Found = true;
        }
      });
  }
};

//------------------------------------------------------------------------------
bool HasExactIntegers(vtkDataArray* array)
{
  using LongIntegers = vtkTypeList::Create<long, unsigned long, long long, unsigned long long>;
  FindInexactInteger find;
  if (array->IsIntegral() && array->GetDataTypeSize() == sizeof(std::int64_t) &&
    !vtkArrayDispatch::DispatchByValueType<LongIntegers>::Execute(array, find))
  {
    find(array);
  }
  return !find.Found;
}
}

//------------------------------------------------------------------------------
void ElementBlocks::RequireExactIntegers(
  ElementKind kind, const std::string& arrayName, Reducer& reducer) const
{
  std::int64_t hasOthers = 0;
  for (const ElementBlock& block : this->Blocks)
  {
    vtkDataArray* array =
      block.Data->GetAttributes(static_cast<int>(kind))->GetArray(arrayName.c_str());
    hasOthers |= array && !HasExactIntegers(array);
  }
  reducer.Max(&hasOthers, 1);
  if (hasOthers)
  {
    throw std::invalid_argument("the array '" + arrayName +
      "' has integers beyond 2^53, which double precision cannot tell apart");
  }
}

//------------------------------------------------------------------------------
ValueBlock ElementBlocks::GetValueBlock(const ElementBlock& block) const
{
  ValueBlock values;
  values.Size = block.GetSize();
  values.Skip = block.Skip.empty() ? nullptr : block.Skip.data();
  values.FirstId = block.FirstIndex;
  if (block.GlobalIds)
  {
    values.Ids = vtkIdTypeArray::FastDownCast(block.GlobalIds)->GetPointer(0);
  }
  else if (!block.Indices.empty())
  {
    values.Ids = block.Indices.data();
  }
  return values;
}

namespace
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkDoubleArray> ToDoubles(vtkDataArray* array)
{
  auto* const ids = vtkIdTypeArray::FastDownCast(array);
  if (!ids)
  {
    auto doubles = vtkSmartPointer<vtkDoubleArray>::New();
    doubles->DeepCopy(array);
    return doubles;
  }
  // Arrays of criteria that are codes are vtkIdTypeArrays.
  const auto doubles = MakeLargeArray<vtkDoubleArray>(ids->GetNumberOfValues());
  doubles->SetName(ids->GetName());
  const vtkIdType* const from = ids->GetPointer(0);
  double* const to = doubles->GetPointer(0);
  ParallelForEach(ids->GetNumberOfValues(), LightGrain,
    [=](vtkIdType i) { to[i] = static_cast<double>(from[i]); });
  return doubles;
}

//------------------------------------------------------------------------------
// Sets NaN where a criterion with an integer array is undefined, as integers have no NaN.
void SetNulls(const ElementBlock& block, vtkDoubleArray* values)
{
  const Criterion* const criterion = FindCriterion(values->GetName() ? values->GetName() : "");
  if (block.Kind != ElementKind::Cells || !criterion || criterion->Kind != ValueKind::Code ||
    (criterion->AppliesTo & AnyCell))
  {
    return;
  }
  double* const to = values->GetPointer(0);
  for (vtkIdType cell = 0; cell < values->GetNumberOfValues(); ++cell)
  {
    const int dimension =
      GetCellShape(static_cast<unsigned char>(block.Data->GetCellType(cell))).Dimension;
    const unsigned shapes = dimension == 2 ? Polygons : dimension == 3 ? Polyhedra : 0u;
    if (!(criterion->AppliesTo & shapes))
    {
      to[cell] = Null(NullReason::NotApplicable);
    }
  }
}
}

//------------------------------------------------------------------------------
BlockValues::BlockValues(
  const ElementBlocks& blocks, const std::string& arrayName, Reducer& reducer)
{
  blocks.RequireExactIntegers(blocks.GetKind(), arrayName, reducer);
  for (std::size_t number = 0; number < blocks.Get().size(); ++number)
  {
    const ElementBlock& block = blocks.Get()[number];
    vtkSmartPointer<vtkDataArray> array = block.GetArray(arrayName);
    if (!array)
    {
      continue;
    }
    if (!vtkDoubleArray::FastDownCast(array))
    {
      const vtkSmartPointer<vtkDoubleArray> doubles = ToDoubles(array);
      SetNulls(block, doubles);
      array = doubles;
    }
    this->Owners.push_back(array);
    ValueBlock values = blocks.GetValueBlock(block);
    values.Values = vtkDoubleArray::FastDownCast(array)->GetPointer(0);
    if (auto* mask = vtkUnsignedCharArray::SafeDownCast(block.GetArray(arrayName + "_Undefined")))
    {
      values.NullReasons = mask->GetPointer(0);
    }
    this->Values.push_back(values);
    this->Numbers.push_back(number);
  }
}

//------------------------------------------------------------------------------
void BlockValues::SetShapes(const std::vector<std::vector<std::uint16_t>>& shapes, unsigned judged)
{
  for (std::size_t i = 0; i < this->Values.size(); ++i)
  {
    this->Values[i].Shapes = shapes[this->Numbers[i]].data();
    this->Values[i].JudgedShapes = judged;
  }
}

//------------------------------------------------------------------------------
BlockWeights::BlockWeights(
  const ElementBlocks& blocks, const std::string& arrayName, Reducer& reducer)
  : Values(blocks, arrayName, reducer)
  , Unit(FindWeightUnit(this->Values.Get(), reducer))
{
  vtkIdType largest = 0;
  for (const ElementBlock& block : blocks.Get())
  {
    largest = std::max(largest, block.GetSize());
  }
  if (this->Values.Get().size() < blocks.Get().size())
  {
    this->Zeros.resize(largest);
  }
  blocks.RequireAny(this->Values.Get().size(),
    "the weights need a one-component array named '" + arrayName + "', which does not exist",
    reducer);
}

//------------------------------------------------------------------------------
Weights BlockWeights::GetWeights(const BlockValues& values) const
{
  const std::vector<std::size_t>& having = this->Values.GetBlockNumbers();
  Weights weights;
  weights.Unit = this->Unit;
  for (std::size_t v = 0; v < values.Get().size(); ++v)
  {
    const auto found = std::find(having.begin(), having.end(), values.GetBlockNumbers()[v]);
    weights.Values.push_back(values.Get()[v].WithValues(found == having.end()
        ? this->Zeros.data()
        : this->Values.Get()[found - having.begin()].Values));
  }
  return weights;
}
}
