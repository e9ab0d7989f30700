// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Evaluation.h
 * @brief Evaluates criteria for all cells of a mesh in one parallel pass.
 */
#ifndef camaron_Evaluation_h
#define camaron_Evaluation_h

#include "Cell/CellGeometry.h"
#include "Criteria/Criterion.h"
#include "Mesh/MeshTopology.h"

#include <functional> // for progress
#include <vector>     // for the criteria

namespace camaron
{
/// A criterion and its array of values, one per cell, filled by Evaluate.
struct CriterionValues
{
  const camaron::Criterion* Criterion;
  double* Values;
};

/// The union of the Needs of criteria.
unsigned GetNeeds(const std::vector<const Criterion*>& criteria);

/**
 * Evaluates criteria in parallel. Geometry is computed once per cell and shared by all criteria;
 * parts that no criterion needs are not computed. Values do not depend on the number of threads.
 * @param progress called about 100 times with the completed fraction; return false to stop
 * @return false if stopped
 */
bool Evaluate(const MeshTopology& topology, const EvaluationOptions& options,
  const std::vector<CriterionValues>& criteria, const std::function<bool(double)>& progress);
}

#endif
