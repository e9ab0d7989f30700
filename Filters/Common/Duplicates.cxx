// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Duplicates.h"

#include "Mesh/DuplicateCells.h"
#include "Mesh/MeshView.h"
#include "vtkCamaronCompat.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <tuple>
#include <vector>

namespace camaron
{
namespace
{
using Ids = std::vector<vtkIdType>;

//------------------------------------------------------------------------------
// Avoids sorting if ids ascend, or if their range is not much larger than the mesh.
bool AreDifferent(const Ids& ids)
{
  constexpr vtkIdType perPoint = 64; // largest number of bits per point
  if (std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>()) == ids.end())
  {
    return true;
  }
  const auto [least, greatest] = std::minmax_element(ids.begin(), ids.end());
  if (static_cast<double>(*greatest) - static_cast<double>(*least) >
    static_cast<double>(perPoint) * static_cast<double>(ids.size()))
  {
    return false;
  }
  std::vector<bool> isKnown(static_cast<std::size_t>(*greatest - *least) + 1);
  const vtkIdType first = *least;
  return std::none_of(ids.begin(), ids.end(),
    [&](vtkIdType id)
    {
      const auto place = static_cast<std::size_t>(id - first);
      const bool wasKnown = isKnown[place];
      isKnown[place] = true;
      return wasKnown;
    });
}

//------------------------------------------------------------------------------
void MarkCopies(const Ids& firsts, vtkDataSet* mesh)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  if (vtkUnsignedCharArray* const known = mesh->GetPointGhostArray())
  {
    ghosts->DeepCopy(known);
  }
  else
  {
    ghosts->SetNumberOfValues(mesh->GetNumberOfPoints());
    ghosts->FillValue(0);
  }
  for (vtkIdType point = 0; point < ghosts->GetNumberOfValues(); ++point)
  {
    const bool isCopy = firsts[point] != point;
    ghosts->SetValue(
      point, ghosts->GetValue(point) | (isCopy ? vtkDataSetAttributes::DUPLICATEPOINT : 0));
  }
  mesh->GetPointData()->AddArray(ghosts);
}

//------------------------------------------------------------------------------
// The lists of points with each point replaced by its first duplicate. Faces without a cell may
// have invalid ids.
vtkSmartPointer<vtkCellArray> Renumber(vtkCellArray* lists, const Ids& firsts)
{
  const auto result = vtkSmartPointer<vtkCellArray>::New();
  const auto size = static_cast<vtkIdType>(firsts.size());
  vtkNew<vtkIdList> points;
  for (vtkIdType list = 0; lists && list < lists->GetNumberOfCells(); ++list)
  {
    lists->GetCellAtId(list, points);
    std::transform(points->begin(), points->end(), points->begin(),
      [&](vtkIdType id) { return id >= 0 && id < size ? firsts[id] : id; });
    result->InsertNextCell(points);
  }
  return result;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataSet> MakeGrid(vtkUnstructuredGrid* grid, const Ids& firsts)
{
  vtkNew<vtkUnsignedCharArray> types;
  types->DeepCopy(GetCellTypes(grid));
  vtkCellArray* const faces = grid->GetPolyhedronFaces();
  const auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  result->SetPoints(grid->GetPoints());
  result->SetPolyhedralCells(types, Renumber(grid->GetCells(), firsts),
    grid->GetPolyhedronFaceLocations(),
    faces ? Renumber(faces, firsts) : vtkSmartPointer<vtkCellArray>());
  return result;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataSet> MakeSurface(vtkPolyData* surface, const Ids& firsts)
{
  const auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(surface->GetPoints());
  result->SetVerts(Renumber(surface->GetVerts(), firsts));
  result->SetLines(Renumber(surface->GetLines(), firsts));
  result->SetPolys(Renumber(surface->GetPolys(), firsts));
  result->SetStrips(Renumber(surface->GetStrips(), firsts));
  return result;
}
}

//------------------------------------------------------------------------------
Ids FindFirstCopies(vtkDataSet* mesh)
{
  vtkDataArray* const array = mesh->GetPointData()->GetGlobalIds();
  const vtkIdType size = mesh->GetNumberOfPoints();
  const bool isMesh = vtkUnstructuredGrid::SafeDownCast(mesh) || vtkPolyData::SafeDownCast(mesh);
  if (!isMesh || !array || array->GetNumberOfTuples() != size)
  {
    return {};
  }
  Ids ids(static_cast<std::size_t>(size));
  auto* const exact = vtkIdTypeArray::FastDownCast(array);
  for (vtkIdType i = 0; i < size; ++i)
  {
    ids[i] = exact ? exact->GetValue(i) : static_cast<vtkIdType>(array->GetComponent(i, 0));
  }
  if (AreDifferent(ids))
  {
    return {};
  }
  Ids order(ids.size()), firsts(ids.size());
  std::iota(order.begin(), order.end(), 0);
  std::iota(firsts.begin(), firsts.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&ids](vtkIdType a, vtkIdType b) { return ids[a] < ids[b]; });
  const MeshView view(mesh);
  bool hasCopies = false;
  for (std::size_t i = 1, first = 0; i < order.size(); ++i)
  {
    std::array<double, 3> a, b;
    view.GetPoint(order[first], a.data());
    view.GetPoint(order[i], b.data());
    const bool isCopy = ids[order[i]] == ids[order[first]] &&
      std::equal(a.begin(), a.end(), b.begin(),
        [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
    firsts[order[i]] = isCopy ? order[first] : order[i];
    first = isCopy ? first : i;
    hasCopies = hasCopies || isCopy;
  }
  return hasCopies ? firsts : Ids();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataSet> ShareCopiesOfPoints(vtkDataSet* mesh, const Ids& firsts)
{
  if (firsts.empty())
  {
    return mesh;
  }
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(mesh);
  const vtkSmartPointer<vtkDataSet> result =
    grid ? MakeGrid(grid, firsts) : MakeSurface(vtkPolyData::SafeDownCast(mesh), firsts);
  result->GetPointData()->ShallowCopy(mesh->GetPointData());
  result->GetCellData()->ShallowCopy(mesh->GetCellData());
  result->GetFieldData()->ShallowCopy(mesh->GetFieldData());
  MarkCopies(firsts, result);
  return result;
}

namespace
{
//------------------------------------------------------------------------------
// The ghost cells, and other cells all of whose points belong to ghost cells.
std::vector<Index> FindCandidates(const MeshView& mesh, const std::vector<bool>& isGhost)
{
  std::vector<bool> isOfGhost(static_cast<std::size_t>(mesh.GetNumberOfPoints()));
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    const IndexRange points = mesh.GetCellPoints(cell);
    for (vtkIdType i = 0; i < points.Size && isGhost[cell]; ++i)
    {
      isOfGhost[points[i]] = true;
    }
  }
  std::vector<Index> candidates;
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    const IndexRange points = mesh.GetCellPoints(cell);
    vtkIdType i = 0;
    while (i < points.Size && isOfGhost[points[i]])
    {
      ++i;
    }
    if (i == points.Size)
    {
      candidates.push_back(static_cast<Index>(cell));
    }
  }
  return candidates;
}

//------------------------------------------------------------------------------
std::vector<Index> FindRepeatedGhosts(
  const MeshView& mesh, const std::vector<bool>& isGhost, vtkDataArray* globalIds)
{
  const auto getId = [globalIds](Index cell)
  { return globalIds ? globalIds->GetComponent(cell, 0) : 0; };
  const std::vector<Index> candidates = FindCandidates(mesh, isGhost);
  std::vector<Index> repeated;
  for (std::vector<Index>& group : FindDuplicateCells(mesh, 0, &candidates))
  {
    // The first cell of each id is kept: the original if there is one.
    std::sort(group.begin(), group.end(),
      [&](Index a, Index b)
      {
        return std::make_tuple(getId(a), bool(isGhost[a]), a) <
          std::make_tuple(getId(b), bool(isGhost[b]), b);
      });
    for (std::size_t i = 1; i < group.size(); ++i)
    {
      if (isGhost[group[i]] && getId(group[i]) == getId(group[i - 1]))
      {
        repeated.push_back(group[i]);
      }
    }
  }
  return repeated;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataSet> HideRepeatedGhosts(vtkDataSet* mesh)
{
  vtkUnsignedCharArray* const ghosts = mesh->GetCellGhostArray();
  const MeshView view(mesh);
  if (!ghosts || view.GetNumberOfCells() != ghosts->GetNumberOfValues())
  {
    return mesh;
  }
  std::vector<bool> isGhost;
  for (vtkIdType cell = 0; cell < ghosts->GetNumberOfValues(); ++cell)
  {
    isGhost.push_back(ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL);
  }
  if (std::find(isGhost.begin(), isGhost.end(), true) == isGhost.end())
  {
    return mesh;
  }
  const std::vector<Index> repeated =
    FindRepeatedGhosts(view, isGhost, mesh->GetCellData()->GetGlobalIds());
  if (repeated.empty())
  {
    return mesh;
  }
  vtkNew<vtkUnsignedCharArray> marks;
  marks->DeepCopy(ghosts);
  for (const Index cell : repeated)
  {
    marks->SetValue(cell, marks->GetValue(cell) | vtkDataSetAttributes::HIDDENCELL);
  }
  const auto result = vtkSmartPointer<vtkDataSet>::Take(mesh->NewInstance());
  result->ShallowCopy(mesh);
  result->GetCellData()->AddArray(marks);
  return result;
}
}
