// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/CellMesh/CellGrid.h"

#include "Base/Parallel.h"
#include "Intake/Pieces/PieceRequest.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTypeInt32Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
void SetCells(CellMesh& mesh, vtkUnstructuredGrid* grid)
{
  const vtkIdType size = mesh.NumberOfCells;
  if (mesh.Types.size() != size)
  {
    mesh.Types = Buffer<unsigned char>(size);
    ParallelFor(size, LightGrain, [&](vtkIdType begin, vtkIdType end)
      { std::fill(mesh.Types.data() + begin, mesh.Types.data() + end, mesh.CommonType); });
  }
  if (mesh.Offsets.size() != size + 1)
  {
    mesh.Offsets = Buffer<std::int32_t>(size + 1);
    ParallelFor(size + 1, LightGrain,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          mesh.Offsets[i] = static_cast<std::int32_t>(i) * mesh.CommonSize;
        }
      });
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(
    mesh.Offsets.TakeArray<vtkTypeInt32Array>(), mesh.Connectivity.TakeArray<vtkTypeInt32Array>());
  // SetCells would search for polyhedra.
  grid->SetPolyhedralCells(mesh.Types.TakeArray<vtkUnsignedCharArray>(), cells, nullptr, nullptr);
}
}

//------------------------------------------------------------------------------
void FillGrid(
  CellMesh& mesh, const CellMeshPiece& piece, vtkDataArray* points, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkPoints> gridPoints;
  gridPoints->SetData(points);
  grid->SetPoints(gridPoints);
  SetCells(mesh, grid);
  AddPieceIds(piece, grid);
}

//------------------------------------------------------------------------------
void AddPieceIds(const CellMeshPiece& piece, vtkUnstructuredGrid* grid)
{
  const auto add = [&piece](vtkDataSetAttributes* attributes, const IdSet& members,
                     const char* name, int flag, auto&& isGhost)
  {
    const std::vector<std::int32_t> ids = members.GetMembers();
    Buffer<vtkIdType> values(static_cast<vtkIdType>(ids.size()));
    std::copy(ids.begin(), ids.end(), values.data());
    SetGlobalIds(attributes, std::move(values), name);
    if (piece.HasGhosts())
    {
      Buffer<unsigned char> flags(static_cast<vtkIdType>(ids.size()));
      std::transform(ids.begin(), ids.end(), flags.data(),
        [&](std::int32_t id) { return static_cast<unsigned char>(isGhost(id) ? flag : 0); });
      SetGhosts(attributes, std::move(flags));
    }
  };
  if (!piece.IsWhole())
  {
    add(grid->GetPointData(), piece.GetPoints(), "GlobalPointIds",
      vtkDataSetAttributes::DUPLICATEPOINT, [&](vtkIdType id) { return piece.IsGhostPoint(id); });
    add(grid->GetCellData(), piece.GetCells(), "GlobalCellIds", vtkDataSetAttributes::DUPLICATECELL,
      [&](vtkIdType id) { return piece.IsGhostCell(id); });
  }
}
}
