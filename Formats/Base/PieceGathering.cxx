// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PieceGathering.h"

#include "GatheredMesh.h"

#include "vtkAppendFilter.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <utility>
#include <vector>

namespace camaron
{
namespace
{
constexpr int Tag = 7301; // any number that nobody else uses

//------------------------------------------------------------------------------
// Sends and receives the parts of a mesh in one order.
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
    // Each with what it is for, e.g. the normals or the global ids.
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
    this->Send(hasCells ? grid->GetCellTypesArray() : static_cast<vtkDataArray*>(nullptr));
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
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataSet> MergeLeaves(vtkDataObject* data)
{
  std::vector<vtkSmartPointer<vtkDataSet>> leaves;
  for (vtkDataSet* leaf : vtkCompositeDataSet::GetDataSets<vtkDataSet>(data))
  {
    if (leaf->IsA("vtkUnstructuredGrid") || leaf->IsA("vtkPolyData"))
    {
      leaves.emplace_back(leaf);
    }
    else
    {
      vtkNew<vtkAppendFilter> convert;
      convert->AddInputData(leaf);
      convert->Update();
      leaves.emplace_back(convert->GetOutput());
    }
  }
  if (leaves.size() == 1 && !HasSeams(leaves[0]))
  {
    return leaves[0];
  }
  return MergePieces(std::vector<vtkDataSet*>(leaves.begin(), leaves.end()));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataSet> Gather(vtkDataSet* mesh, vtkMultiProcessController* controller)
{
  const int processes = controller->GetNumberOfProcesses();
  if (processes == 1)
  {
    return mesh;
  }
  if (controller->GetLocalProcessId() != 0)
  {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(mesh);
    Channel(controller, 0).Send(grid ? grid : MergePieces({ mesh }).Get());
    return nullptr;
  }
  std::vector<vtkSmartPointer<vtkDataSet>> meshes;
  const auto add = [&meshes](vtkDataSet* piece)
  {
    // A process without cells may lack arrays that the others have.
    if (piece->GetNumberOfPoints() > 0)
    {
      meshes.emplace_back(piece);
    }
  };
  add(mesh);
  for (int process = 1; process < processes; ++process)
  {
    add(Channel(controller, process).ReceiveGrid());
  }
  return meshes.size() == 1
    ? meshes[0]
    : vtkSmartPointer<vtkDataSet>(
        MergePieces(std::vector<vtkDataSet*>(meshes.begin(), meshes.end())));
}
}
