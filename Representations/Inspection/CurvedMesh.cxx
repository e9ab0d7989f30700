// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CurvedMesh.h"

#include "Mesh/MeshTopology.h"

#include "vtkAbstractArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Arrays of integers and copies with room for more: numbers and labels, between which there are no
// others. Some of them, such as global ids, VTK does not interpolate.
std::vector<std::pair<vtkAbstractArray*, vtkAbstractArray*>> FindIntegers(
  vtkPointData* from, vtkPointData* to, vtkIdType before, vtkIdType size)
{
  std::vector<std::pair<vtkAbstractArray*, vtkAbstractArray*>> found;
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = from->GetAbstractArray(i);
    if (!array->IsIntegral() || !array->GetName())
    {
      continue;
    }
    if (!to->HasArray(array->GetName()))
    {
      const auto copy = vtk::TakeSmartPointer(array->NewInstance());
      copy->SetName(array->GetName());
      copy->SetNumberOfComponents(array->GetNumberOfComponents());
      copy->SetNumberOfTuples(size);
      copy->InsertTuples(0, before, 0, array);
      to->AddArray(copy);
    }
    found.emplace_back(array, to->GetAbstractArray(array->GetName()));
  }
  return found;
}
}

//------------------------------------------------------------------------------
// The nearest node is that with the most weight.
vtkSmartPointer<vtkUnstructuredGrid> AddPoints(vtkUnstructuredGrid* grid, vtkIdType added,
  const std::function<SubdividedFacets::Stencil(vtkIdType)>& getStencil)
{
  const vtkIdType before = grid->GetNumberOfPoints();
  auto made = vtkSmartPointer<vtkUnstructuredGrid>::New();
  made->ShallowCopy(grid);
  vtkNew<vtkPoints> points;
  points->SetDataType(grid->GetPoints()->GetDataType());
  points->SetNumberOfPoints(before + added);
  points->InsertPoints(0, before, 0, grid->GetPoints());
  vtkNew<vtkPointData> data;
  data->CopyAllOn();
  data->CopyGlobalIdsOn();
  data->InterpolateAllocate(grid->GetPointData(), before + added);
  data->SetNumberOfTuples(before + added);
  data->CopyData(grid->GetPointData(), 0, before, 0);
  const auto integers = FindIntegers(grid->GetPointData(), data, before, before + added);
  vtkNew<vtkIdList> nodes, ofCell;
  for (vtkIdType i = 0; i < added; ++i)
  {
    const SubdividedFacets::Stencil stencil = getStencil(i);
    grid->GetCellPoints(stencil.Cell, ofCell);
    nodes->SetNumberOfIds(stencil.Size);
    double place[3] = { 0, 0, 0 };
    for (int k = 0; k < stencil.Size; ++k)
    {
      nodes->SetId(k, ofCell->GetId(stencil.Nodes[k]));
      double x[3];
      grid->GetPoint(nodes->GetId(k), x);
      for (int d = 0; d < 3; ++d)
      {
        place[d] += stencil.Weights[k] * x[d];
      }
    }
    points->SetPoint(before + i, place);
    data->InterpolatePoint(
      grid->GetPointData(), before + i, nodes, const_cast<double*>(stencil.Weights));
    const auto nearest = std::max_element(stencil.Weights, stencil.Weights + stencil.Size);
    for (const auto& [from, to] : integers)
    {
      to->SetTuple(before + i, nodes->GetId(nearest - stencil.Weights), from);
    }
  }
  // No labels are put at new points.
  vtkUnsignedCharArray* const given = grid->GetPointGhostArray();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(before + added);
  for (vtkIdType i = 0; i < before + added; ++i)
  {
    ghosts->SetValue(i,
      i >= before ? vtkDataSetAttributes::DUPLICATEPOINT
        : given   ? given->GetValue(i)
                  : 0);
  }
  data->AddArray(ghosts);
  made->SetPoints(points);
  made->GetPointData()->ShallowCopy(data);
  return made;
}

//------------------------------------------------------------------------------
vtkUnstructuredGrid* CurvedMesh::Update(
  vtkUnstructuredGrid* grid, int level, SubdividedFacets::Extent drawn)
{
  const vtkMTimeType time = grid ? grid->GetMTime() : 0;
  const bool isNew = grid != this->Given || time != this->Time || level != this->Level;
  if (isNew || drawn > this->Extent)
  {
    this->Given = grid;
    this->Time = time;
    this->Level = level;
    this->Extent = isNew ? drawn : std::max(drawn, this->Extent);
    this->Facets = HasHigherOrderCells(grid)
      ? SubdividedFacets::Make(MeshTopology(grid), level, this->Extent)
      : nullptr;
    this->Drawn = grid;
    if (this->Facets && this->Facets->GetNumberOfNewPoints() > 0)
    {
      this->Drawn = AddPoints(grid, this->Facets->GetNumberOfNewPoints(),
        [this](vtkIdType point) { return this->Facets->GetStencil(point); });
    }
  }
  return this->Drawn;
}

//------------------------------------------------------------------------------
std::string CurvedMesh::GetNewWarning()
{
  const int drawn = this->Facets ? this->Facets->GetLevel() : this->Level;
  const bool isNew = drawn < this->Level && drawn != this->WarnedOfLevel;
  this->WarnedOfLevel = drawn < this->Level ? drawn : -1;
  return isNew ? "Nonlinear Subdivision Level " + std::to_string(this->Level) +
      " would divide the cells into too many parts for the memory; " + std::to_string(drawn) +
      " is drawn."
               : "";
}
}
