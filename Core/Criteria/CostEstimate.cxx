// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/CostEstimate.h"

#include <algorithm>

namespace camaron
{
namespace
{
// Processor time for each corner of a cell in nanoseconds, of one criterion of a class and of each that is
// added to it; between what BenchmarkCore prints for tetrahedra and for truncated octahedra.
struct ClassCost
{
  double One;
  double Another;
};

//------------------------------------------------------------------------------
ClassCost GetClassCost(Cost cost)
{
  switch (cost)
  {
    case Cost::Faces:
      return { 75, 20 };
    case Cost::Edges:
      return { 170, 50 };
    case Cost::Neighbors:
      return { 220, 30 };
    default:
      return { 3000, 600 }; // of polyhedra; tetrahedra have less than a fifth
  }
}
}

//------------------------------------------------------------------------------
double EstimateSeconds(const std::vector<const Criterion*>& criteria, double corners, int threads)
{
  // Criteria of a cell share one pass, those with neighbours another one.
  double ofCells = 0, ofNeighbors = 0, added = 0;
  for (const Criterion* criterion : criteria)
  {
    const ClassCost cost = GetClassCost(criterion->Cost);
    double& first = criterion->Cost == Cost::Neighbors ? ofNeighbors : ofCells;
    first = std::max(first, cost.One - cost.Another);
    added += cost.Another;
  }
  constexpr double nanosecond = 1e-9;
  return nanosecond * (ofCells + ofNeighbors + added) * corners / std::max(1, threads);
}
}
