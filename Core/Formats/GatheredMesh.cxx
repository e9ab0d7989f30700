// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/GatheredMesh.h"

#include "Mesh/MeshView.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace camaron
{
namespace
{
constexpr int LeftOut = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;

//------------------------------------------------------------------------------
bool IsLeftOut(vtkUnsignedCharArray* ghosts, vtkIdType cell)
{
  return ghosts && (ghosts->GetValue(cell) & LeftOut) != 0;
}

//------------------------------------------------------------------------------
// The points that stay, in their new order, each with all its old ids: old ids sorted by new point, and
// where each new point begins.
struct PointGroups
{
  std::vector<vtkIdType> NewIds; // per old point; -1 if it is left out
  std::vector<vtkIdType> OldIds; // per new point one of the old ones
};

//------------------------------------------------------------------------------
PointGroups GroupPoints(vtkDataArray* globalIds, const std::vector<unsigned char>& stays)
{
  PointGroups groups;
  const auto size = static_cast<vtkIdType>(stays.size());
  groups.NewIds.assign(stays.size(), -1);
  std::vector<vtkIdType> order;
  for (vtkIdType id = 0; id < size; ++id)
  {
    if (stays[id])
    {
      order.push_back(id);
    }
  }
  std::vector<vtkIdType> global;
  if (globalIds)
  {
    global.resize(stays.size());
    for (vtkIdType id = 0; id < size; ++id)
    {
      global[id] = static_cast<vtkIdType>(globalIds->GetTuple1(id));
    }
    std::vector<vtkIdType> sorted = order;
    std::stable_sort(sorted.begin(), sorted.end(),
      [&global](vtkIdType a, vtkIdType b) { return global[a] < global[b]; });
    const bool haveTwins = std::adjacent_find(sorted.begin(), sorted.end(),
                             [&global](vtkIdType a, vtkIdType b)
                             { return global[a] == global[b]; }) != sorted.end();
    haveTwins ? order.swap(sorted) : global.clear();
  }
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    if (global.empty() || i == 0 || global[order[i]] != global[order[i - 1]])
    {
      groups.OldIds.push_back(order[i]);
    }
    groups.NewIds[order[i]] = static_cast<vtkIdType>(groups.OldIds.size()) - 1;
  }
  return groups;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> Rebuild(
  vtkPointSet* mesh, vtkUnsignedCharArray* ghosts, const PointGroups& groups)
{
  const MeshView view(mesh);
  vtkNew<vtkCellArray> cells, faces, locations;
  vtkNew<vtkUnsignedCharArray> types;
  const auto insert = [&groups](vtkCellArray* lists, const IndexRange& points)
  {
    const vtkIdType list = lists->InsertNextCell(static_cast<int>(points.Size));
    for (vtkIdType i = 0; i < points.Size; ++i)
    {
      lists->InsertCellPoint(groups.NewIds[points[i]]);
    }
    return list;
  };
  for (vtkIdType cell = 0; cell < view.GetNumberOfCells(); ++cell)
  {
    if (IsLeftOut(ghosts, cell))
    {
      continue;
    }
    types->InsertNextValue(view.GetCellType(cell));
    insert(cells, view.GetCellPoints(cell));
    if (view.HasPolyhedra())
    {
      const bool polyhedron = view.GetCellType(cell) == VTK_POLYHEDRON;
      const IndexRange cellFaces = polyhedron ? view.GetPolyhedronFaces(cell) : IndexRange();
      locations->InsertNextCell(static_cast<int>(cellFaces.Size));
      for (vtkIdType f = 0; f < cellFaces.Size; ++f)
      {
        locations->InsertCellPoint(insert(faces, view.GetPolyhedronFacePoints(cellFaces[f])));
      }
    }
  }

  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  points->SetNumberOfPoints(static_cast<vtkIdType>(groups.OldIds.size()));
  for (std::size_t i = 0; i < groups.OldIds.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), mesh->GetPoint(groups.OldIds[i]));
  }
  grid->SetPoints(points);
  if (view.HasPolyhedra())
  {
    grid->SetPolyhedralCells(types, cells, locations, faces);
  }
  else
  {
    grid->SetCells(types, cells);
  }
  return grid;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataSet> MergePieces(vtkDataSet* mesh)
{
  auto* pointSet = vtkPointSet::SafeDownCast(mesh);
  if (!pointSet || !pointSet->GetPoints())
  {
    return mesh;
  }
  vtkUnsignedCharArray* ghosts = mesh->GetCellGhostArray();
  vtkDataArray* globalIds = mesh->GetPointData()->GetGlobalIds();
  const MeshView view(mesh);
  bool changes = false;
  // Points that only cells use that are left out.
  std::vector<unsigned char> stays(static_cast<std::size_t>(view.GetNumberOfPoints()), 1);
  for (const unsigned char value : { 0, 1 })
  {
    for (vtkIdType cell = 0; ghosts && cell < view.GetNumberOfCells(); ++cell)
    {
      if (IsLeftOut(ghosts, cell) == (value == 0))
      {
        changes = changes || value == 0;
        const IndexRange points = view.GetCellPoints(cell);
        for (vtkIdType i = 0; i < points.Size; ++i)
        {
          stays[points[i]] = value;
        }
      }
    }
  }
  if (!changes && !globalIds)
  {
    return mesh;
  }
  const PointGroups groups = GroupPoints(globalIds, stays);
  if (!changes && groups.OldIds.size() == groups.NewIds.size())
  {
    return mesh;
  }
  return Rebuild(pointSet, ghosts, groups);
}
}
