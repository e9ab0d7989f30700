// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DuplicateGhosts.h"

#include "Mesh/DuplicateCells.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace camaron
{
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
