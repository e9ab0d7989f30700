// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/MeshContext.h"

#include "Base/Parallel.h"
#include "Cell/CellNeighborhood.h"
#include "Mesh/DuplicateCells.h"

#include "vtkDataArray.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
std::vector<Vector> ComputeCellVectors(const MeshView& mesh, const EvaluationOptions& options)
{
  std::vector<Vector> vectors(mesh.GetNumberOfCells());
  ParallelFor(mesh.GetNumberOfCells(), HeavyGrain,
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
  if (this->Options.CellNumbers)
  {
    return static_cast<double>(this->Options.CellNumbers[cell]);
  }
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
}
