// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WorstCriterion.h
 * @brief Finds the criterion that best shows what is wrong with a mesh.
 *
 * vtkElementQuality makes it the active scalars. Criteria without a finite value are ignored, and
 * so are criteria of polygons if cells with a volume have values. Of the others the worst one is
 * 1. the one with the most cells outside its acceptable range; ranges that are only hints count
 *    after the others
 * 2. on a tie, the one whose median is farthest from the ideal value, first among those with an
 *    acceptable range
 * 3. the first one for which small or large values are better, then the first one
 *
 * Reports use the same rules (Scripts/camaron/common/assessment.py), except for medians that differ
 * by less than a bin.
 *
 * Cost: one pass over the values of each criterion, and one reduction for all together.
 */
#ifndef camaron_WorstCriterion_h
#define camaron_WorstCriterion_h

#include "AcceptableRanges.h"
#include "Criteria/Criterion.h"
#include "ElementBlocks.h"

#include "vtkDoubleArray.h"  // for the values
#include "vtkSmartPointer.h" // for the values

#include <map>    // for arrays of criteria
#include <string> // for their names
#include <vector> // for the data sets

namespace camaron
{
/**
 * Collective. The result is the same on all processes. Ghosts are ignored.
 *
 * @param arrays for each criterion, by name, its arrays for all data sets
 * @return nullptr if no criterion has a finite value
 */
const Criterion* FindWorstCriterion(const std::vector<const Criterion*>& criteria,
  const std::map<std::string, std::vector<vtkSmartPointer<vtkDoubleArray>>>& arrays,
  const std::vector<DataSetLeaf>& leaves, const AcceptableRanges& ranges, AngleUnit angles,
  Reducer& reducer);
}

#endif
