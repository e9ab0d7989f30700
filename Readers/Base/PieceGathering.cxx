// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PieceGathering.h"

#include "Base/Text.h"
#include "BlockZones.h"
#include "Mesh/GhostArrays.h"
#include "Mesh/MeshCheck.h"
#include "Mesh/PointSetHulls.h"
#include "vtkCamaronCompat.h"

#include "vtkAppendFilter.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace camaron
{
namespace
{
constexpr int Tag = 7301; // arbitrary, unused elsewhere

//------------------------------------------------------------------------------
// Sends or receives the parts of a mesh; both go through the arrays in the same order.
class Channel
{
public:
  Channel(vtkMultiProcessController* controller, int other)
    : Controller(controller)
    , Other(other)
  {
  }

  void Send(int value) { this->Controller->Send(&value, 1, this->Other, Tag); }
  void Send(vtkDataArray* array)
  {
    this->Send(array ? array->GetDataType() : -1);
    if (array)
    {
      this->Controller->Send(array, this->Other, Tag);
    }
  }
  void Send(vtkCellArray* lists)
  {
    this->Send(lists ? lists->GetOffsetsArray() : nullptr);
    this->Send(lists ? lists->GetConnectivityArray() : nullptr);
  }
  void Send(vtkDataSetAttributes* data)
  {
    // Each with its attribute type, e.g. normals or global ids.
    std::vector<std::pair<vtkDataArray*, int>> arrays;
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      if (vtkDataArray* array = data->GetArray(i))
      {
        arrays.emplace_back(array, data->IsArrayAnAttribute(i));
      }
    }
    this->Send(static_cast<int>(arrays.size()));
    for (const auto& array : arrays)
    {
      this->Send(array.first);
      this->Send(array.second);
    }
  }
  void Send(vtkUnstructuredGrid* grid)
  {
    this->Send(grid->GetPoints() ? grid->GetPoints()->GetData() : nullptr);
    const bool hasCells = grid->GetNumberOfCells() > 0;
    this->Send(hasCells ? GetCellTypes(grid) : nullptr);
    this->Send(hasCells ? grid->GetCells() : nullptr);
    this->Send(hasCells ? grid->GetPolyhedronFaces() : nullptr);
    this->Send(hasCells ? grid->GetPolyhedronFaceLocations() : nullptr);
    this->Send(grid->GetPointData());
    this->Send(grid->GetCellData());
  }

  int ReceiveNumber()
  {
    int value = 0;
    this->Controller->Receive(&value, 1, this->Other, Tag);
    return value;
  }
  vtkSmartPointer<vtkDataArray> ReceiveArray()
  {
    const int type = this->ReceiveNumber();
    if (type < 0)
    {
      return nullptr;
    }
    auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
    this->Controller->Receive(array, this->Other, Tag);
    return array;
  }
  vtkSmartPointer<vtkCellArray> ReceiveLists()
  {
    const auto offsets = this->ReceiveArray();
    const auto values = this->ReceiveArray();
    if (!offsets || !values)
    {
      return nullptr;
    }
    auto lists = vtkSmartPointer<vtkCellArray>::New();
    lists->SetData(offsets.Get(), values.Get());
    return lists;
  }
  void ReceiveData(vtkDataSetAttributes* data)
  {
    const int size = this->ReceiveNumber();
    for (int i = 0; i < size; ++i)
    {
      const auto array = this->ReceiveArray();
      const int attribute = this->ReceiveNumber();
      const int index = data->AddArray(array);
      if (attribute >= 0)
      {
        data->SetActiveAttribute(index, attribute);
      }
    }
  }
  vtkSmartPointer<vtkUnstructuredGrid> ReceiveGrid()
  {
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    if (const auto coordinates = this->ReceiveArray())
    {
      vtkNew<vtkPoints> points;
      points->SetData(coordinates);
      grid->SetPoints(points);
    }
    const auto types = this->ReceiveArray();
    const auto cells = this->ReceiveLists();
    const auto faces = this->ReceiveLists();
    const auto locations = this->ReceiveLists();
    if (auto* typeArray = vtkUnsignedCharArray::SafeDownCast(types))
    {
      if (faces)
      {
        grid->SetPolyhedralCells(typeArray, cells, locations, faces);
      }
      else
      {
        grid->SetCells(typeArray, cells);
      }
    }
    this->ReceiveData(grid->GetPointData());
    this->ReceiveData(grid->GetCellData());
    return grid;
  }

private:
  vtkMultiProcessController* Controller;
  int Other;
};

//------------------------------------------------------------------------------
// Lists the leaves of data as parts and numbers the blocks identically on all processes.
class PartList
{
public:
  explicit PartList(vtkDataObject* data) { this->Add(data, nullptr); }
  std::vector<MeshPart>& GetParts() { return this->Parts; }
  /// Of all blocks; empty for those without.
  const std::vector<std::string>& GetNames() const { return this->Names; }
  /// Throws the same on all processes if a leaf on any process is invalid.
  void Check(vtkMultiProcessController* controller) const
  {
    const std::int64_t own[] = { this->Faces.NumberWithFaces, this->Faces.NumberOfPolyhedra };
    std::int64_t all[] = { own[0], own[1] };
    std::string error = this->Error;
    if (controller && controller->GetNumberOfProcesses() > 1)
    {
      controller->AllReduce(own, all, 2, vtkCommunicator::SUM_OP);
      ShareFirst(error, controller);
    }
    if (!error.empty())
    {
      throw std::runtime_error(error);
    }
    PolyhedronFaces{ all[0], all[1] }.Check();
  }

private:
  /// Replaces texts by that of the first process that has one.
  static void ShareFirst(std::string& text, vtkMultiProcessController* controller)
  {
    const int own =
      text.empty() ? controller->GetNumberOfProcesses() : controller->GetLocalProcessId();
    int first = own;
    controller->AllReduce(&own, &first, 1, vtkCommunicator::MIN_OP);
    if (first < controller->GetNumberOfProcesses())
    {
      auto size = static_cast<vtkIdType>(text.size());
      controller->Broadcast(&size, 1, first);
      text.resize(static_cast<std::size_t>(size));
      controller->Broadcast(text.data(), size, first);
    }
  }

  /// @param about the data in what contains them, or nullptr
  void Add(vtkDataObject* data, vtkInformation* about)
  {
    if (auto* const blocks = vtkMultiBlockDataSet::SafeDownCast(data))
    {
      for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
      {
        this->Add(blocks->GetBlock(i), blocks->HasMetaData(i) ? blocks->GetMetaData(i) : nullptr);
      }
    }
    else if (auto* const collection = vtkPartitionedDataSetCollection::SafeDownCast(GetTree(data)))
    {
      for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
      {
        this->Add(collection->GetPartitionedDataSet(i),
          collection->HasMetaData(i) ? collection->GetMetaData(i) : nullptr);
      }
    }
    else if (auto* const pieces = vtkPartitionedDataSet::SafeDownCast(data))
    {
      for (unsigned int i = 0; i < pieces->GetNumberOfPartitions(); ++i)
      {
        this->AddLeaf(pieces->GetPartition(i));
      }
      this->EndBlock(about);
    }
    else if (auto* const composite = vtkCompositeDataSet::SafeDownCast(data))
    {
      const auto leaf = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
      leaf->SkipEmptyNodesOff();
      for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
      {
        this->AddLeaf(vtkDataSet::SafeDownCast(leaf->GetCurrentDataObject()));
        this->EndBlock(nullptr);
      }
    }
    else
    {
      this->AddLeaf(vtkDataSet::SafeDownCast(data));
      this->EndBlock(about);
    }
  }
  void EndBlock(vtkInformation* about)
  {
    const char* const name = about ? about->Get(vtkCompositeDataSet::NAME()) : nullptr;
    this->Names.emplace_back(name ? name : "");
    ++this->Block;
  }

  void AddLeaf(vtkDataSet* data)
  {
    if (!data)
    {
      return;
    }
    const vtkSmartPointer<vtkDataSet> leaf = WithGhostBytes(data);
    try
    {
      CheckGhosts(leaf);
      CheckCells(leaf);
    }
    catch (const std::exception& error)
    {
      this->Error = this->Error.empty() ? GetReason(error) : this->Error;
      return;
    }
    this->Faces.Add(leaf);
    if (auto* const grid = vtkUnstructuredGrid::SafeDownCast(leaf))
    {
      this->Parts.push_back({ WithHulls(grid, VTK_POLYHEDRON), this->Block });
    }
    else if (leaf->IsA("vtkPolyData"))
    {
      this->Parts.push_back({ leaf, this->Block });
    }
    else
    {
      vtkNew<vtkAppendFilter> convert;
      convert->AddInputData(leaf);
      if (!vtkPointSet::SafeDownCast(leaf))
      {
        convert->SetOutputPointsPrecision(
          vtkAlgorithm::DOUBLE_PRECISION); // coordinates are computed
      }
      convert->Update();
      this->Parts.push_back({ convert->GetOutput(), this->Block });
    }
  }

  std::vector<MeshPart> Parts;
  std::vector<std::string> Names;
  int Block = 0;
  PolyhedronFaces Faces;
  std::string Error;
};
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataSet> Gather(
  vtkDataObject* data, vtkMultiProcessController* controller, bool namesZones, Warnings& warnings)
{
  PartList list(data);
  list.Check(controller);
  std::vector<MeshPart>& parts = list.GetParts();
  const int processes = controller ? controller->GetNumberOfProcesses() : 1;
  if (processes > 1 && controller->GetLocalProcessId() != 0)
  {
    Channel channel(controller, 0);
    channel.Send(static_cast<int>(parts.size()));
    for (const MeshPart& part : parts)
    {
      channel.Send(part.Block);
      auto* const grid = vtkUnstructuredGrid::SafeDownCast(part.Mesh);
      channel.Send(grid && !HasSeams(grid) ? grid : MergeParts({ part }, warnings).Get());
    }
    return nullptr;
  }
  for (int process = 1; process < processes; ++process)
  {
    Channel channel(controller, process);
    for (int size = channel.ReceiveNumber(); size > 0; --size)
    {
      const int block = channel.ReceiveNumber();
      parts.push_back({ channel.ReceiveGrid(), block });
    }
  }
  std::stable_sort(parts.begin(), parts.end(),
    [](const MeshPart& a, const MeshPart& b) { return a.Block < b.Block; });
  if (namesZones)
  {
    NameZones(parts, list.GetNames());
  }
  const bool isReady = parts.size() == 1 && !HasSeams(parts[0].Mesh);
  return isReady ? parts[0].Mesh : vtkSmartPointer<vtkDataSet>(MergeParts(parts, warnings));
}
}
