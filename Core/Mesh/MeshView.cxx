// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/MeshView.h"

#include "vtkCamaronCompat.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Refers an IndexArray to plain 32-bit or 64-bit storage; anything else is copied to 64 bits.
IndexArray View(vtkDataArray* array, bool plain, vtkSmartPointer<vtkDataArray>& owner)
{
  owner = array;
  if (!array)
  {
    return {};
  }
  if (plain && array->GetDataTypeSize() == 4)
  {
    return { static_cast<const std::int32_t*>(array->GetVoidPointer(0)), nullptr };
  }
  if (!plain || array->GetDataTypeSize() != 8)
  {
    vtkNew<vtkTypeInt64Array> copy;
    copy->DeepCopy(array);
    owner = copy;
  }
  return { nullptr, static_cast<const std::int64_t*>(owner->GetVoidPointer(0)) };
}
}

//------------------------------------------------------------------------------
IndexLists::IndexLists(vtkCellArray* cells)
{
  if (cells && cells->GetNumberOfCells() > 0)
  {
    const bool plain = HasPlainStorage(cells);
    this->NumberOfLists = cells->GetNumberOfCells();
    this->Offsets = View(cells->GetOffsetsArray(), plain, this->OffsetsOwner);
    this->Values = View(cells->GetConnectivityArray(), plain, this->ValuesOwner);
  }
}

//------------------------------------------------------------------------------
vtkIdType IndexLists::GetNumberOfValues() const
{
  return this->ValuesOwner ? this->ValuesOwner->GetNumberOfValues() : 0;
}

//------------------------------------------------------------------------------
MeshView::MeshView(vtkDataSet* mesh)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(mesh);
  auto* surface = vtkPolyData::SafeDownCast(mesh);
  vtkPoints* points = grid ? grid->GetPoints() : surface ? surface->GetPoints() : nullptr;
  if (points && points->GetNumberOfPoints() > 0)
  {
    this->NumberOfPoints = points->GetNumberOfPoints();
    this->PointsOwner = points->GetData();
    if (auto* floats = vtkAOSDataArrayTemplate<float>::FastDownCast(this->PointsOwner))
    {
      this->PointsFloat = floats->GetPointer(0);
    }
    else if (auto* doubles = vtkAOSDataArrayTemplate<double>::FastDownCast(this->PointsOwner))
    {
      this->PointsDouble = doubles->GetPointer(0);
    }
    else
    {
      vtkNew<vtkDoubleArray> copy;
      copy->DeepCopy(this->PointsOwner);
      this->PointsOwner = copy;
      this->PointsDouble = copy->GetPointer(0);
    }
  }

  if (grid && grid->GetNumberOfCells() > 0)
  {
    vtkDataArray* types = GetCellTypes(grid);
    this->TypesOwner = vtkUnsignedCharArray::FastDownCast(types);
    if (!this->TypesOwner)
    {
      this->TypesOwner = vtkSmartPointer<vtkUnsignedCharArray>::New();
      this->TypesOwner->DeepCopy(types);
    }
    this->Types = this->TypesOwner->GetPointer(0);
    this->Blocks[0] = IndexLists(grid->GetCells());
    this->Faces = IndexLists(grid->GetPolyhedronFaces());
    this->FaceLocations = IndexLists(grid->GetPolyhedronFaceLocations());
    this->Degrees = grid->GetCellData()->GetHigherOrderDegrees();
    this->Weights = grid->GetPointData()->GetRationalWeights();
  }
  else if (surface)
  {
    vtkCellArray* blocks[] = { surface->GetVerts(), surface->GetLines(), surface->GetPolys(),
      surface->GetStrips() };
    for (int block = 0; block < 4; ++block)
    {
      this->Blocks[block] = IndexLists(blocks[block]);
    }
  }
  for (int block = 0; block < 4; ++block)
  {
    this->FirstCells[block + 1] = this->FirstCells[block] + this->Blocks[block].NumberOfLists;
  }
  this->NumberOfCells = this->FirstCells[4];
}

//------------------------------------------------------------------------------
vtkIdType MeshView::GetNumberOfTypes() const
{
  return this->TypesOwner ? this->TypesOwner->GetNumberOfValues() : 0;
}

//------------------------------------------------------------------------------
// As VTK, which also takes a polygon of fewer than three points for an empty cell; here it is a
// defect of the mesh.
unsigned char MeshView::GetPolyDataCellType(vtkIdType cell) const
{
  const vtkIdType size = this->GetCellPoints(cell).Size;
  if (cell >= this->FirstCells[3])
  {
    return VTK_TRIANGLE_STRIP;
  }
  if (cell >= this->FirstCells[2])
  {
    return size == 3 ? VTK_TRIANGLE : size == 4 ? VTK_QUAD : VTK_POLYGON;
  }
  if (cell >= this->FirstCells[1])
  {
    return size > 2 ? VTK_POLY_LINE : size == 2 ? VTK_LINE : VTK_EMPTY_CELL;
  }
  return size > 1 ? VTK_POLY_VERTEX : size == 1 ? VTK_VERTEX : VTK_EMPTY_CELL;
}

//------------------------------------------------------------------------------
bool MeshView::IsBefore(vtkIdType a, vtkIdType b) const
{
  double p[3], q[3];
  this->GetPoint(a, p);
  this->GetPoint(b, q);
  const auto [of, other] = std::mismatch(p, p + 3, q);
  return of == p + 3 ? a < b : *of < *other;
}

//------------------------------------------------------------------------------
vtkIdType MeshView::FindFirstPoint(const vtkIdType* points, vtkIdType size) const
{
  return *std::min_element(
    points, points + size, [this](vtkIdType a, vtkIdType b) { return this->IsBefore(a, b); });
}

//------------------------------------------------------------------------------
std::vector<bool> MeshView::FindUsedPoints() const
{
  std::vector<bool> areUsed(static_cast<std::size_t>(this->NumberOfPoints));
  for (vtkIdType cell = 0; cell < this->NumberOfCells; ++cell)
  {
    const IndexRange points = this->GetCellPoints(cell);
    const vtkIdType size = this->GetCellType(cell) == VTK_EMPTY_CELL ? 0 : points.Size;
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (points[i] >= 0 && points[i] < this->NumberOfPoints)
      {
        areUsed[static_cast<std::size_t>(points[i])] = true;
      }
    }
  }
  return areUsed;
}

//------------------------------------------------------------------------------
std::array<int, 3> MeshView::ReadDegrees(vtkIdType cell) const
{
  std::array<int, 3> degrees = {};
  for (int i = 0; i < std::min(3, this->Degrees->GetNumberOfComponents()); ++i)
  {
    degrees[i] = static_cast<int>(this->Degrees->GetComponent(cell, i));
  }
  return degrees;
}

//------------------------------------------------------------------------------
bool MeshView::HaveOtherWeights(vtkIdType cell) const
{
  const unsigned char type = this->GetCellType(cell);
  if (type < VTK_BEZIER_CURVE || type > VTK_BEZIER_PYRAMID)
  {
    return false;
  }
  const IndexRange points = this->GetCellPoints(cell);
  const double first = this->Weights->GetComponent(points[0], 0);
  bool areOther = false;
  for (const vtkIdType id : points)
  {
    areOther = areOther || this->Weights->GetComponent(id, 0) != first;
  }
  return areOther;
}
}
