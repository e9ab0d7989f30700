// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/DuplicateCells.h"

#include "Base/Hash.h"
#include "Base/Parallel.h"
#include "Mesh/CellFacets.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// The dimension of a cell and its distinct points, ascending.
void GetSignature(
  const MeshView& mesh, vtkIdType cell, int dimension, std::vector<vtkIdType>& signature)
{
  const IndexRange points = mesh.GetCellPoints(cell);
  signature.assign(1, dimension);
  for (vtkIdType i = 0; i < points.Size; ++i)
  {
    signature.push_back(points[i]);
  }
  std::sort(signature.begin() + 1, signature.end());
  signature.erase(std::unique(signature.begin() + 1, signature.end()), signature.end());
}

//------------------------------------------------------------------------------
std::uint64_t Hash(const std::vector<vtkIdType>& signature)
{
  return std::accumulate(signature.begin(), signature.end(), std::uint64_t(signature.size()),
    [](std::uint64_t hash, vtkIdType item)
    { return MixHash(hash, static_cast<std::uint64_t>(item)); });
}

struct HashedCell
{
  std::uint64_t Hash;
  Index Cell;
  bool operator<(const HashedCell& other) const
  {
    return std::tie(this->Hash, this->Cell) < std::tie(other.Hash, other.Cell);
  }
};
}

//------------------------------------------------------------------------------
std::vector<std::vector<Index>> FindDuplicateCells(
  const MeshView& mesh, int leastDimension, const std::vector<Index>* among)
{
  const vtkIdType size = among ? static_cast<vtkIdType>(among->size()) : mesh.GetNumberOfCells();
  std::vector<HashedCell> cells(static_cast<std::size_t>(size));
  ParallelFor(size, MediumGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      const CellFacets facets(mesh);
      std::vector<vtkIdType> signature;
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Index cell = among ? (*among)[i] : static_cast<Index>(i);
        GetSignature(mesh, cell, facets.GetDimension(cell), signature);
        cells[i] = { Hash(signature), cell };
      }
    });
  WithThreads([&] { vtkSMPTools::Sort(cells.begin(), cells.end()); });

  const CellFacets facets(mesh);
  std::vector<std::vector<Index>> groups;
  std::vector<std::pair<std::vector<vtkIdType>, Index>> alike;
  for (auto first = cells.begin(); first != cells.end();)
  {
    const auto last = std::find_if(
      first, cells.end(), [&](const HashedCell& cell) { return cell.Hash != first->Hash; });
    // Cells with the same hash are sorted by their signature.
    alike.clear();
    for (auto cell = first; last - first > 1 && cell != last; ++cell)
    {
      const int dimension = facets.GetDimension(cell->Cell);
      if (dimension >= leastDimension)
      {
        alike.emplace_back(std::vector<vtkIdType>(), cell->Cell);
        GetSignature(mesh, cell->Cell, dimension, alike.back().first);
      }
    }
    std::sort(alike.begin(), alike.end());
    for (std::size_t i = 1; i < alike.size(); ++i)
    {
      if (alike[i].first == alike[i - 1].first)
      {
        const bool isNew = groups.empty() || groups.back().back() != alike[i - 1].second;
        if (isNew)
        {
          groups.push_back({ alike[i - 1].second });
        }
        groups.back().push_back(alike[i].second);
      }
    }
    first = last;
  }
  return groups;
}
}
