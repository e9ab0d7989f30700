// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RangesFile.h
 * @brief User-defined acceptable ranges from a text file.
 *
 * One line per criterion: its name, the lowest and the highest acceptable value, separated by
 * blanks. `*`, `-` and infinite numbers mean no limit. Angles are in degrees. `#` starts a comment.
 *
 *     MinDihedralAngle  15  *    # of our solver
 *     TetRadiusRatio    0.2 1
 */
#ifndef camaron_RangesFile_h
#define camaron_RangesFile_h

#include "Criteria/Criterion.h"
#include "Scan/ScanError.h"

#include <string>      // for names
#include <string_view> // for names
#include <vector>      // for rules

namespace camaron
{
/**
 * Parses the ranges in a text, in order. Errors state file, line, expected and found text: an
 * unknown or repeated criterion, a limit that is not a number, or an empty range.
 * @param file name for messages
 * @param find the criterion with a name, nullptr if there is none; criteria of cells by default
 */
std::vector<Preset::Rule> ParseRanges(const std::string& file, const char* begin, const char* end,
  ScanError& error, const Criterion* (*find)(std::string_view) = FindCriterion);

/// Name of the criterion that @a name may be a misspelling of; empty if none is similar.
std::string FindSimilarName(std::string_view name);
}

#endif
