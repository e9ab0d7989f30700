// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Verdict.h
 * @brief The measures of Verdict, of VTK's copy of it, as criteria.
 *
 * They are evaluated for all cells of their shapes, those of general type included, by their corners.
 */
#ifndef camaron_Verdict_h
#define camaron_Verdict_h

#include "Criteria/Criterion.h"

#include <vector> // for the criteria

namespace camaron
{
/// One row per measure, for the table of criteria.
std::vector<Criterion> GetVerdictCriteria();
}

#endif
