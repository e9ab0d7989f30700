// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RangesFile.h
 * @brief Acceptable ranges of a user's own, from a text file.
 *
 * One line for each criterion: its name, the lowest and the highest acceptable value, between
 * blanks.
 * `*`, `-` and infinite numbers leave an end open. Angles are in degrees. `#` starts a comment.
 *
 *     MinDihedralAngle  15  *    # of our solver
 *     TetRadiusRatio    0.2 1
 */
#ifndef camaron_RangesFile_h
#define camaron_RangesFile_h

#include "Criteria/Criterion.h"
#include "Scan/ScanError.h"

#include <string> // for names
#include <vector> // for rules

namespace camaron
{
/**
 * The ranges in a text, in its order. Errors say file, line, what was expected and what was found:
 * a name that no criterion has, or that was there before, a limit that is no number, a range
 * without values.
 * @param file name for messages
 */
std::vector<Preset::Rule> ParseRanges(
  const std::string& file, const char* begin, const char* end, ScanError& error);

/// Name of the criterion that @a name may be a misspelling of; empty if none comes close.
std::string FindSimilarName(std::string_view name);
}

#endif
