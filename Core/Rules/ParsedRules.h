// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ParsedRules.h
 * @brief Rules from texts and presets, with all of their problems, and the grammar of a line.
 */
#ifndef camaron_ParsedRules_h
#define camaron_ParsedRules_h

#include "Rules/Rule.h"

#include <string>      // for texts
#include <string_view> // for lines
#include <vector>      // for rules

namespace camaron
{
/// A text with a rule per line.
struct RulesText
{
  std::string Name; ///< for messages: the path of a file, or "rules"
  std::string Text; ///< UTF-8, with any line ends; a byte order mark is skipped
};

/// What is wrong in a text, or with a parameter.
struct RuleProblem
{
  std::string Source; ///< name of the text or of the parameter
  int Line = 0;       ///< from 1; 0 if the problem is not in a line
  std::string Text;   ///< "expected ..., found ..."

  /// "fem.rules:3: expected ..., found ..."
  std::string GetMessage() const;
};

struct ParsedRules
{
  std::vector<Rule> Rules; ///< those of presets first; empty if there are problems
  std::vector<RuleProblem> Problems;

  /// All problems, one per line.
  std::string GetMessage() const;
};

/**
 * Parses texts in order. A rule that is written out replaces that of a preset for the same
 * criterion and cells; a later preset replaces an earlier one; the same rule twice is a problem,
 * and so is no rule at all.
 *
 * @param preset name of a preset, in any case, which comes before the texts; empty: none
 * @param tolerance of rules that give none, such as "0.1%" or "3"; empty: 0
 */
ParsedRules ParseRules(const std::vector<RulesText>& texts, const std::string& preset = "",
  const std::string& tolerance = "");

/**
 * The acceptable ranges in a text. Each line has the name of a criterion and its lowest and highest
 * acceptable value; `*`, `-` and infinite numbers mean no limit. Angles are in degrees.
 *
 *     MinDihedralAngle  15  *    # of our solver
 *     TetRadiusRatio    0.2 1
 *
 * Throws std::runtime_error with file, line, expected and found text for the first unknown or
 * repeated criterion, limit that is not a number, or empty range.
 * @param find the criterion with a name, nullptr if there is none; criteria of cells by default
 */
std::vector<Preset::Rule> ParseRanges(
  const RulesText& text, const Criterion* (*find)(std::string_view) = FindCriterion);

/**
 * Reads a file of rules of at most 1 MiB; false with the reason in @a problem if it cannot be read,
 * or is a pipe or a device.
 */
bool ReadRulesFile(const std::string& path, std::string& text, RuleProblem& problem);

/// The rules of a preset with a range.
std::vector<Rule> GetRulesOfPreset(const Preset& preset, const Tolerance& tolerance);

/// The rules of a line: none if it is blank, one, or those of a preset. Rules without a tolerance
/// get @a tolerance. Throws RuleError (RuleLine.h).
std::vector<Rule> ParseRuleLine(std::string_view line, const Tolerance& tolerance);

/// Adds the range of a line, if any. Throws RuleError.
void ParseRangeLine(std::string_view line, const Criterion* (*find)(std::string_view),
  std::vector<Preset::Rule>& ranges);

/// "0.1%", or "5" or "5 cells". Throws RuleError.
Tolerance ParseTolerance(std::string_view text);

/// Names of all presets.
std::vector<std::string> GetPresetNames();
}

#endif
