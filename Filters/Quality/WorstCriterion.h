// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WorstCriterion.h
 * @brief Which of several criteria shows best what is wrong with a mesh.
 *
 * Criteria without a finite value are no candidates; nor are those of polygons alone where cells
 * with a volume have values. Of the others the worst one is
 * 1. the one with the most cells outside its acceptable range; ranges that are hints only count
 * after the others;
 * 2. on a tie the one whose median is farthest from the ideal, first among those with an acceptable
 * range;
 * 3. the first one that has a better direction, then the first.
 * Reports take the same one (Scripts/camaron/common/assessment.py), but for medians that differ by
 * less than a bin.
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
 * Collective; the same on all processes, whichever has which cells. Ghosts do not count.
 * @param arrays of each criterion by its name those of all data sets
 * @return nullptr where no criterion has a finite value
 */
const Criterion* FindWorstCriterion(const std::vector<const Criterion*>& criteria,
  const std::map<std::string, std::vector<vtkSmartPointer<vtkDoubleArray>>>& arrays,
  const std::vector<DataSetLeaf>& leaves, const AcceptableRanges& ranges, AngleUnit angles,
  Reducer& reducer);
}

#endif
