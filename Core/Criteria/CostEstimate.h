// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CostEstimate.h
 * @brief How long criteria will take, to warn people before they start.
 */
#ifndef camaron_CostEstimate_h
#define camaron_CostEstimate_h

#include "Criteria/Criterion.h"

#include <array>  // for the groups
#include <vector> // for the criteria

class vtkDataSet;

namespace camaron
{
/// Cells that cost differently: of dimension 2, tetrahedra, and all others of dimension 3.
enum CostGroup
{
  CostOfPolygons,
  CostOfTetrahedra,
  CostOfPolyhedra,
  NumberOfCostGroups
};

/// Length of the lists of points of the cells of each CostGroup.
using GroupCorners = std::array<double, NumberOfCostGroups>;

/// Those of a mesh; boxes of a data set that lists no cells count as polyhedra. A single pass over
/// the types of cells.
GroupCorners CountCorners(vtkDataSet* mesh);

/**
 * About how many seconds the evaluation will take: right to a factor of two or three on machines of
 * today; for criteria of Cost::Clipping to one of five, as it depends on how many polyhedra are not
 * convex.
 * @param threads that work at the same time
 */
double EstimateSeconds(
  const std::vector<const Criterion*>& criteria, const GroupCorners& corners, int threads);
}

#endif
