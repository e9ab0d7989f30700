// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CostEstimate.h
 * @brief Estimates how long criteria will take, to warn users in advance.
 */
#ifndef camaron_CostEstimate_h
#define camaron_CostEstimate_h

#include "Criteria/Criterion.h"

#include <array>  // for the groups
#include <vector> // for the criteria

class vtkDataSet;

namespace camaron
{
/// Cells with different costs: of dimension 2, tetrahedra, and all others of dimension 3.
enum CostGroup
{
  CostOfPolygons,
  CostOfTetrahedra,
  CostOfPolyhedra,
  NumberOfCostGroups
};

/// Total number of points of the cells of each CostGroup.
using GroupCorners = std::array<double, NumberOfCostGroups>;

/// Of a mesh, in a single pass over its cell types; the cells of data sets with implicit cells
/// count as polyhedra.
GroupCorners CountCorners(vtkDataSet* mesh);

/**
 * Approximate time in seconds that the evaluation takes on current machines, correct within a
 * factor of two to three. For Cost::Clipping within a factor of five, because it depends on the
 * number of non-convex polyhedra.
 * @param threads number of threads
 */
double EstimateSeconds(
  const std::vector<const Criterion*>& criteria, const GroupCorners& corners, int threads);
}

#endif
