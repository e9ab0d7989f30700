// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/FaceMesh/GridArrays.h"

#include "Base/Parallel.h"
#include "Intake/Pieces/PieceRequest.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <vector>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
template <typename Real, typename Array>
void TakePointsAs(FaceMesh& mesh, Buffer<Real>& owned, const FaceMeshPiece& piece,
  vtkUnstructuredGrid* grid, const Progress& progress)
{
  PointSource& source = mesh.Points;
  const bool isWhole = piece.IsWhole();
  Buffer<Real> coordinates;
  if (owned.size() == 3 * piece.GetNumberOfPoints())
  {
    coordinates = std::move(owned);
  }
  else
  {
    coordinates = Buffer<Real>(3 * piece.GetNumberOfPoints());
    const std::vector<std::int32_t> ids =
      isWhole ? std::vector<std::int32_t>() : piece.GetPoints().GetMembers();
    progress.ForBlocks(piece.GetNumberOfPoints(), HeavyGrain,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          source.GetAs(ids.empty() ? i : ids[i], &coordinates[3 * i]);
        }
      });
  }
  // From here on, the aligned copy in native byte order is the faster source, and only has the
  // required points.
  source = PointSource(
    reinterpret_cast<const char*>(coordinates.data()), piece.GetNumberOfPoints(), source.IsDouble);
  source.Kept = isWhole ? nullptr : &piece.GetPoints();
  owned = Buffer<Real>();
  vtkNew<vtkPoints> points;
  points->SetData(coordinates.template TakeArray<Array>(3));
  grid->SetPoints(points);
}
}

//------------------------------------------------------------------------------
bool TakePoints(
  FaceMesh& mesh, const FaceMeshPiece& piece, vtkUnstructuredGrid* grid, const Progress& progress)
{
  if (mesh.ReadPoints)
  {
    mesh.Floats = Buffer<float>(3 * piece.GetNumberOfPoints());
    const IdSet& points = piece.GetPoints();
    if (!mesh.ReadPoints(
          &points, [&](vtkIdType point, const float* x)
          { std::copy(x, x + 3, mesh.Floats.data() + 3 * points.GetNumber(point)); }, progress))
    {
      return false;
    }
  }
  if (mesh.Points.IsDouble)
  {
    TakePointsAs<double, vtkDoubleArray>(mesh, mesh.Doubles, piece, grid, progress);
  }
  else
  {
    TakePointsAs<float, vtkFloatArray>(mesh, mesh.Floats, piece, grid, progress);
  }
  return true;
}

//------------------------------------------------------------------------------
void AddPieceIds(const FaceMeshPiece& piece, const PieceRequest& request, vtkUnstructuredGrid* grid)
{
  if (piece.IsWhole())
  {
    return;
  }
  const std::vector<std::int32_t> points = piece.GetPoints().GetMembers();
  const auto numberOfPoints = static_cast<vtkIdType>(points.size());
  const vtkIdType numberOfCells = piece.GetNumberOfItems();
  Buffer<vtkIdType> pointIds(numberOfPoints), cellIds(numberOfCells);
  std::copy(points.begin(), points.end(), pointIds.data());
  for (vtkIdType i = 0; i < numberOfCells; ++i)
  {
    cellIds[i] = piece.GetItem(i);
  }
  SetGlobalIds(grid->GetPointData(), std::move(pointIds), "GlobalPointIds");
  SetGlobalIds(grid->GetCellData(), std::move(cellIds), "GlobalCellIds");

  if (request.GhostLevels > 0 && !piece.IsCloud())
  {
    Buffer<unsigned char> pointGhosts(numberOfPoints), cellGhosts(numberOfCells);
    for (vtkIdType i = 0; i < numberOfPoints; ++i)
    {
      pointGhosts[i] = piece.IsGhostPoint(points[i]) ? vtkDataSetAttributes::DUPLICATEPOINT : 0;
    }
    for (vtkIdType i = 0; i < numberOfCells; ++i)
    {
      cellGhosts[i] = i < piece.GetNumberOfOwnedItems() ? 0 : vtkDataSetAttributes::DUPLICATECELL;
    }
    SetGhosts(grid->GetPointData(), std::move(pointGhosts));
    SetGhosts(grid->GetCellData(), std::move(cellGhosts));
  }
}
}
