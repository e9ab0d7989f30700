// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AcceptableRanges.h
 * @brief What the table of criteria knows about an array that is named like a criterion.
 */
#ifndef camaron_AcceptableRanges_h
#define camaron_AcceptableRanges_h

#include "Statistics/Summary.h"
#include "Statistics/Worst.h"

#include <optional> // for what may be unknown
#include <string>   // for names

namespace camaron
{
/// Stands for the ranges of the table of criteria where the name of a preset is expected.
inline const char* GetDefaultRangesName()
{
  return "Default ranges";
}

/// True for GetDefaultRangesName() and the presets.
bool IsRangesName(const std::string& name);

/**
 * Range in which values of the criterion are acceptable: the one of the preset @a ranges, or else
 * that of the table of criteria. @a unit is that of the values: angles may be in "rad".
 */
std::optional<ValueRange> FindAcceptableRange(
  const std::string& criterion, const std::string& ranges, const std::string& unit);

/// Where the bad values of the criterion are, if it has a direction.
std::optional<WorstEnd> FindWorstEnd(const std::string& criterion);

/**
 * The same with the choice of a user: "By criterion", "Largest" or "Smallest"; throws
 * std::invalid_argument for any other.
 */
std::optional<WorstEnd> FindWorstEnd(const std::string& criterion, const std::string& choice);
}

#endif
