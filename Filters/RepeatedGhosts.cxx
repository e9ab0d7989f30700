// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RepeatedGhosts.h"

#include "Mesh/MeshView.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace camaron
{
namespace
{
/// The points of a cell, sorted, and its global id.
using CellKey = std::pair<std::vector<vtkIdType>, double>;

//------------------------------------------------------------------------------
CellKey GetKey(const MeshView& mesh, vtkIdType cell, vtkDataArray* globalIds)
{
  const IndexRange points = mesh.GetCellPoints(cell);
  CellKey key({}, globalIds ? globalIds->GetComponent(cell, 0) : 0);
  for (vtkIdType i = 0; i < points.Size; ++i)
  {
    key.first.push_back(points[i]);
  }
  std::sort(key.first.begin(), key.first.end());
  return key;
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> FindRepeatedGhosts(
  const MeshView& mesh, vtkUnsignedCharArray* ghosts, vtkDataArray* globalIds)
{
  const auto isGhost = [ghosts](vtkIdType cell)
  { return (ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0; };
  std::vector<vtkIdType> repeated;
  std::map<CellKey, vtkIdType> copies; // the first of each
  std::vector<bool> isOfGhost(static_cast<std::size_t>(mesh.GetNumberOfPoints()));
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    if (!isGhost(cell))
    {
      continue;
    }
    const CellKey key = GetKey(mesh, cell, globalIds);
    if (!copies.emplace(key, cell).second)
    {
      repeated.push_back(cell);
    }
    for (const vtkIdType point : key.first)
    {
      isOfGhost[static_cast<std::size_t>(point)] = true;
    }
  }
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells() && !copies.empty(); ++cell)
  {
    const IndexRange points = mesh.GetCellPoints(cell);
    bool mayBe = !isGhost(cell);
    for (vtkIdType i = 0; i < points.Size && mayBe; ++i)
    {
      mayBe = isOfGhost[static_cast<std::size_t>(points[i])];
    }
    const auto copy = mayBe ? copies.find(GetKey(mesh, cell, globalIds)) : copies.end();
    if (copy != copies.end())
    {
      repeated.push_back(copy->second);
      copies.erase(copy);
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
  const std::vector<vtkIdType> repeated =
    FindRepeatedGhosts(view, ghosts, mesh->GetCellData()->GetGlobalIds());
  if (repeated.empty())
  {
    return mesh;
  }
  vtkNew<vtkUnsignedCharArray> marks;
  marks->DeepCopy(ghosts);
  for (const vtkIdType cell : repeated)
  {
    marks->SetValue(cell, marks->GetValue(cell) | vtkDataSetAttributes::HIDDENCELL);
  }
  const auto result = vtkSmartPointer<vtkDataSet>::Take(mesh->NewInstance());
  result->ShallowCopy(mesh);
  result->GetCellData()->AddArray(marks);
  return result;
}
}
