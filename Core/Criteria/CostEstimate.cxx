// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/CostEstimate.h"

#include "Mesh/CellShape.h"
#include "Mesh/MeshView.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace camaron
{
namespace
{
// Processor time per point of a cell in nanoseconds, for one criterion of a class and for each
// additional one; approximately the output of BenchmarkCore.
struct ClassCost
{
  double One;
  double Another;
};

constexpr ClassCost Costs[][NumberOfCostGroups] = {
  // polygons, tetrahedra, other polyhedra
  { { 100, 18 }, { 45, 15 }, { 70, 10 } },   // Cost::Faces
  { { 150, 25 }, { 80, 25 }, { 100, 22 } },  // Cost::Edges
  { { 360, 30 }, { 170, 30 }, { 150, 20 } }, // Cost::Neighbors
  { { 360, 5 }, { 480, 5 }, { 400, 20 } },   // Cost::Iterative: all share one kernel
  // Cost::Clipping: 200 for convex polyhedra, 5000 for others; their fraction is unknown in advance
  { { 360, 5 }, { 480, 5 }, { 1000, 20 } },
};
constexpr ClassCost OfNondegenerateTetrahedra = { 12, 6 }; // of criteria with a TetrahedronFunction
constexpr ClassCost OfTheirAngles = { 40, 20 };

//------------------------------------------------------------------------------
bool AppliesTo(const Criterion& criterion, int group)
{
  constexpr unsigned shapes[] = { Polygons | Triangles | Quadrilaterals, Polyhedra | Tetrahedra,
    Polyhedra | Pyramids | Wedges | Hexahedra };
  return (criterion.AppliesTo & (shapes[group] | AnyCell)) != 0;
}

//------------------------------------------------------------------------------
// Nanoseconds per point of a cell.
double GetCost(const std::vector<const Criterion*>& criteria, int group)
{
  // Criteria of a cell share one pass, those with neighbors another one.
  double ofCells = 0, ofNeighbors = 0, added = 0;
  for (const Criterion* criterion : criteria)
  {
    if (!AppliesTo(*criterion, group))
    {
      // Cells are read only to determine that the criterion does not apply.
      ofCells = std::max(ofCells, Costs[static_cast<int>(Cost::Faces)][group].One);
      continue;
    }
    const bool isAngle = (criterion->Needs & NeedsAngles) != 0;
    const ClassCost& cost = group == CostOfTetrahedra && criterion->TetrahedronFunction
      ? (isAngle ? OfTheirAngles : OfNondegenerateTetrahedra)
      : Costs[static_cast<int>(criterion->Cost)][group];
    double& first = criterion->Cost == Cost::Neighbors ? ofNeighbors : ofCells;
    first = std::max(first, cost.One - cost.Another);
    added += cost.Another;
  }
  return ofCells + ofNeighbors + added;
}

//------------------------------------------------------------------------------
GroupCorners CountCornersOfGrid(vtkUnstructuredGrid* grid)
{
  GroupCorners corners = {};
  const MeshView mesh(grid); // not checked yet
  const vtkIdType size = std::min(mesh.GetNumberOfCells(), mesh.GetNumberOfTypes());
  for (vtkIdType cell = 0; cell < size; ++cell)
  {
    const CellShape& shape = GetCellShape(mesh.GetCellType(cell));
    if (shape.Dimension >= 2) // the cost of lines and points is negligible
    {
      const int number = shape.NumberOfCorners;
      const CostGroup group = shape.Dimension == 2 ? CostOfPolygons
        : number == 4                              ? CostOfTetrahedra
                                                   : CostOfPolyhedra;
      corners[group] += static_cast<double>(number > 0 ? number : mesh.GetCellPoints(cell).Size);
    }
  }
  return corners;
}
}

//------------------------------------------------------------------------------
GroupCorners CountCorners(vtkDataSet* mesh)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(mesh))
  {
    return CountCornersOfGrid(grid);
  }
  GroupCorners corners = {};
  if (auto* surface = vtkPolyData::SafeDownCast(mesh))
  {
    corners[CostOfPolygons] =
      static_cast<double>(surface->GetPolys()->GetNumberOfConnectivityIds() +
        surface->GetStrips()->GetNumberOfConnectivityIds());
    return corners;
  }
  constexpr double ofBox = 8;
  corners[CostOfPolyhedra] = ofBox * static_cast<double>(mesh->GetNumberOfCells());
  return corners;
}

//------------------------------------------------------------------------------
double EstimateSeconds(
  const std::vector<const Criterion*>& criteria, const GroupCorners& corners, int threads)
{
  constexpr double nanosecond = 1e-9;
  double sum = 0;
  for (int group = 0; group < NumberOfCostGroups; ++group)
  {
    sum += GetCost(criteria, group) * corners[group];
  }
  return nanosecond * sum / std::max(1, threads);
}
}
