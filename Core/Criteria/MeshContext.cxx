// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/MeshContext.h"

#include "Criteria/CellNeighborhood.h"
#include "Mesh/CellFacets.h"
#include "Mesh/DuplicateCells.h"
#include "Mesh/FacetLinks.h"
#include "Parallel.h"

#include "vtkDataArray.h"

#include <algorithm>

namespace camaron
{
namespace
{
constexpr vtkIdType Grain = 1024;

//------------------------------------------------------------------------------
std::vector<Vector> ComputeCellVectors(const MeshView& mesh, const EvaluationOptions& options)
{
  std::vector<Vector> vectors(mesh.GetNumberOfCells());
  ParallelFor(mesh.GetNumberOfCells(), Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      CellGeometry cell;
      for (vtkIdType id = begin; id < end; ++id)
      {
        vectors[id] = GetCellVector(mesh, id, options, cell);
      }
    });
  return vectors;
}

//------------------------------------------------------------------------------
std::vector<unsigned char> FindUnknownPoints(
  const MeshTopology& topology, const EvaluationOptions& options)
{
  std::vector<unsigned char> isUnknown;
  if (options.Ghosts || !options.Links)
  {
    return isUnknown;
  }
  const MeshView& view = topology.GetMesh();
  isUnknown.resize(view.GetNumberOfPoints());
  CellFacets facets(view);
  for (vtkIdType cell = 0; cell < view.GetNumberOfCells(); ++cell)
  {
    const int dimension = facets.GetDimension(cell);
    if (dimension < 2)
    {
      continue;
    }
    const FacetTable& table = topology.GetFacets(dimension);
    const FacetLinks& links = options.Links->GetFacets(dimension);
    const FacetTable::Range uses = table.GetCellFacets(cell);
    if (std::none_of(uses.begin(), uses.end(), [&](CellFacet use) { return links.Has(use.Facet()); }))
    {
      continue;
    }
    facets.ForEach(cell,
      [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
      {
        for (vtkIdType i = 0; i < size && links.Has(uses[static_cast<Index>(local)].Facet()); ++i)
        {
          isUnknown[points[i]] = 1;
        }
      });
  }
  return isUnknown;
}
}

//------------------------------------------------------------------------------
const std::vector<Vector>& MeshContext::GetCellVectors() const
{
  std::call_once(this->CellVectorsOnce,
    [this] { this->CellVectors = ComputeCellVectors(this->Topology.GetMesh(), this->Options); });
  return this->CellVectors;
}

//------------------------------------------------------------------------------
double MeshContext::GetId(vtkIdType cell) const
{
  vtkDataArray* ids = this->Options.GlobalIds;
  return ids ? ids->GetComponent(cell, 0) : static_cast<double>(cell);
}

//------------------------------------------------------------------------------
const std::vector<double>& MeshContext::GetDuplicateIds() const
{
  std::call_once(this->DuplicateIdsOnce,
    [this]
    {
      const MeshView& mesh = this->Topology.GetMesh();
      this->DuplicateIds.assign(static_cast<std::size_t>(mesh.GetNumberOfCells()), -1);
      for (const std::vector<Index>& group : FindDuplicateCells(mesh))
      {
        double lowest = this->GetId(group[0]);
        for (const Index cell : group)
        {
          lowest = std::min(lowest, this->GetId(cell));
        }
        for (const Index cell : group)
        {
          this->DuplicateIds[cell] = lowest;
        }
      }
    });
  return this->DuplicateIds;
}

//------------------------------------------------------------------------------
const std::vector<unsigned char>& MeshContext::GetUnknownPoints() const
{
  std::call_once(this->UnknownPointsOnce,
    [this] { this->UnknownPoints = FindUnknownPoints(this->Topology, this->Options); });
  return this->UnknownPoints;
}
}
