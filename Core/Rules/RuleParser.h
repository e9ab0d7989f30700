// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RuleParser.h
 * @brief The grammar of a line of rules.
 */
#ifndef camaron_RuleParser_h
#define camaron_RuleParser_h

#include "Rules/Rule.h"

#include <string>      // for names
#include <string_view> // for lines
#include <vector>      // for rules

namespace camaron
{
/// The rules of a preset with a range.
std::vector<Rule> GetRulesOfPreset(const Preset& preset, const Tolerance& tolerance);

/// The rules of a line: none if it is blank, one, or those of a preset. Rules without a tolerance
/// get @a tolerance. Throws RuleError (RuleLine.h).
std::vector<Rule> ParseRuleLine(std::string_view line, const Tolerance& tolerance);

/// "0.1%", or "5" or "5 cells". Throws RuleError.
Tolerance ParseTolerance(std::string_view text);

/// Names of all presets.
std::vector<std::string> GetPresetNames();
}

#endif
