// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rules/ParsedRules.h"

#include "Base/Number.h"
#include "Base/Text.h"
#include "Rules/RuleLine.h"
#include "Statistics/Population.h"
#include "vtkCamaronCompat.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
using Kind = RuleLine::Kind;

const std::vector<std::string> FamilySets = { "2D cells", "3D cells" };

//------------------------------------------------------------------------------
template <typename List>
std::vector<std::string> GetNames(const List& list)
{
  std::vector<std::string> names;
  for (const auto& item : list)
  {
    names.emplace_back(item.Name);
  }
  return names;
}

//------------------------------------------------------------------------------
bool Contains(const std::vector<std::string>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

//------------------------------------------------------------------------------
// VTK's names of cell types without "vtk", as in the tables of statistics.
const std::vector<std::string>& GetCellTypes()
{
  static const std::vector<std::string> types = []
  {
    const std::string prefix = "vtk";
    std::vector<std::string> names;
    for (int type = 0; type < VTK_NUMBER_OF_CELL_TYPES; ++type)
    {
      const std::string name = GetCellClassName(type);
      if (name.compare(0, prefix.size(), prefix) == 0)
      {
        names.push_back(name.substr(prefix.size()));
      }
    }
    return names;
  }();
  return types;
}

//------------------------------------------------------------------------------
double TakeLimit(RuleLine& line, const char* expected, double open)
{
  return line.TakeIf("*") || line.TakeIf("-") ? open : line.TakeNumber(expected);
}

//------------------------------------------------------------------------------
// A lower and an upper limit.
void TakeLimits(RuleLine& line, double& low, double& high)
{
  low = TakeLimit(line, "the lower limit: a number, or * for none", -Infinity);
  high = TakeLimit(line, "the upper limit: a number, or * for none", Infinity);
}

//------------------------------------------------------------------------------
// One or two of >= x, > x, <= x, < x or = x.
void TakeComparisons(RuleLine& line, Rule& rule)
{
  while (line.GetKind() == Kind::Sign)
  {
    const std::string sign = line.GetText();
    const bool isLow = sign[0] != '<', isHigh = sign[0] != '>';
    if ((isLow && rule.Low > -Infinity) || (isHigh && rule.High < Infinity))
    {
      throw RuleError("expected one lower and one upper limit, found another: '" + sign + "'");
    }
    line.Take();
    const double limit = line.TakeNumber("a number");
    if (std::isinf(limit))
    {
      throw RuleError(
        "expected a finite number after " + sign + ", found " + (limit > 0 ? "inf" : "-inf"));
    }
    rule.Low = isLow ? limit : rule.Low;
    rule.High = isHigh ? limit : rule.High;
    rule.LowIncluded = rule.LowIncluded && sign != ">";
    rule.HighIncluded = rule.HighIncluded && sign != "<";
  }
}

//------------------------------------------------------------------------------
void TakeRange(RuleLine& line, Rule& rule)
{
  if (line.GetKind() == Kind::End)
  {
    throw line.MakeError("a range: >= 10, or a lower and an upper limit");
  }
  if (line.GetKind() == Kind::Sign)
  {
    TakeComparisons(line, rule);
  }
  else
  {
    TakeLimits(line, rule.Low, rule.High);
  }
  if (rule.Low == Infinity || rule.High == -Infinity)
  {
    throw RuleError("expected a range with values, found none of " + rule.Criterion);
  }
  if (rule.GetLeast() > rule.GetMost())
  {
    throw RuleError("expected a lower limit that is not above the upper limit, found " +
      rule.Criterion + " " + rule.GetRangeText());
  }
}

//------------------------------------------------------------------------------
// The family or the set of families that a word names in the singular or plural, or the word.
std::string ToFamily(const std::string& word)
{
  constexpr std::pair<const char*, const char*> others[] = { { "tetrahedron", "tetrahedra" },
    { "hexahedron", "hexahedra" }, { "polyhedron", "polyhedra" }, { "2d", "2D cells" },
    { "3d", "3D cells" } };
  for (const auto& [singular, plural] : others)
  {
    if (word == singular)
    {
      return plural;
    }
  }
  return Contains(GetNames(GetCellFamilies()), word) ? word : word + "s";
}

//------------------------------------------------------------------------------
// Faces, edges and vertices in the plural.
std::string ToPlural(const std::string& word)
{
  return word == "face" || word == "edge" ? word + "s" : word == "vertex" ? "vertices" : word;
}

//------------------------------------------------------------------------------
// Names of the criteria of all elements.
std::vector<std::string> GetAllCriteria()
{
  std::vector<std::string> names;
  for (const std::string& elements : GetJudgedElements())
  {
    const std::vector<std::string> own = GetNames(*GetCriteriaOf(elements));
    names.insert(names.end(), own.begin(), own.end());
  }
  return names;
}

//------------------------------------------------------------------------------
// Throws unless the elements of the rule have its criterion.
void CheckCriterion(const Rule& rule)
{
  if (rule.FindCriterion())
  {
    return;
  }
  std::string others, first;
  for (const std::string& other : GetJudgedElements())
  {
    if (Contains(GetNames(*GetCriteriaOf(other)), rule.Criterion))
    {
      others += (others.empty() ? "" : " and ") + other;
      first = first.empty() ? other : first;
    }
  }
  throw RuleError("expected a criterion of " + rule.GetElements() + ", found '" + rule.Criterion +
    "', one of " + others + (rule.IsOfCells() ? "; did you mean of " + first + "?" : ""));
}

//------------------------------------------------------------------------------
Scope TakeShapes(RuleLine& line)
{
  if (line.TakeIf("type"))
  {
    if (!Contains(GetCellTypes(), line.GetText()))
    {
      throw line.MakeError("VTK's name of a cell type, such as Tetra", GetCellTypes());
    }
    return { ScopeKind::CellType, line.Take(), "" };
  }
  const std::string other = ToPlural(ToLower(line.GetText()));
  if (other != "cells" && GetCriteriaOf(other))
  {
    line.Take();
    return { ScopeKind::Elements, other, "" };
  }
  const std::vector<std::string> families = GetNames(GetCellFamilies());
  Scope scope;
  for (bool goesOn = true; goesOn;)
  {
    std::string word = ToLower(line.GetText());
    goesOn = !word.empty() && word.back() == ',';
    word.erase(word.find_last_not_of(',') + 1);
    const std::string family = ToFamily(word);
    const bool isSet = Contains(FamilySets, family);
    if (!isSet && !Contains(families, family))
    {
      std::string known;
      for (const std::string& name : families)
      {
        known += name + ", ";
      }
      throw line.MakeError("type, or a shape: " + known + FamilySets[0] + ", " + FamilySets[1] +
          "; or faces, edges or vertices",
        families);
    }
    line.Take();
    if (isSet)
    {
      line.TakeIf("cells");
    }
    scope.Value += (scope.Value.empty() ? "" : ", ") + family;
  }
  return scope;
}

//------------------------------------------------------------------------------
Scope TakeBlock(RuleLine& line)
{
  return { ScopeKind::Block, line.TakeName("the name of a block"), "" };
}

//------------------------------------------------------------------------------
Scope TakeValue(RuleLine& line)
{
  const std::string array = line.TakeName("the name of a cell array");
  if (!line.Is(Kind::Sign, "=") && !line.Is(Kind::Sign, "=="))
  {
    throw line.MakeError("= after " + array);
  }
  line.Take();
  const std::string word = line.GetText();
  line.TakeNumber("an integer");
  const char* const end = word.data() + word.size();
  double number; // may have a point or an exponent
  if (ParseReal(word.data(), end, number) != end || !IsExactInteger(number))
  {
    throw RuleError("expected an integer below 2^53, found '" + word + "'");
  }
  return { ScopeKind::Array, std::to_string(static_cast<std::int64_t>(number)), array };
}

//------------------------------------------------------------------------------
Tolerance TakeTolerance(RuleLine& line)
{
  constexpr const char* expected = "a percentage such as 0.1%, or a number of cells";
  constexpr double ofAll = 100;
  if (line.GetKind() != Kind::Word)
  {
    throw line.MakeError(expected);
  }
  const std::string word = line.Take();
  const bool isPercent = word.back() == '%' || line.TakeIf("%");
  if (!isPercent && !line.TakeIf("cells"))
  {
    line.TakeIf("cell");
  }
  const std::string digits = word.substr(0, word.size() - (word.back() == '%' ? 1 : 0));
  const char* const end = digits.data() + digits.size();
  double number;
  // Neither infinity nor exponents of Fortran.
  if (ParseReal(digits.data(), end, number) != end || digits[0] == '-' ||
    digits.find_first_not_of("+-.0123456789eE") != std::string::npos)
  {
    throw RuleError("expected " + std::string(expected) + ", found '" + word + "'");
  }
  if (isPercent && number > ofAll)
  {
    throw RuleError("expected a percentage of at most 100%, found '" + word + "'");
  }
  if (isPercent)
  {
    return Tolerance::OfPercent(number, digits.substr(digits[0] == '+') + "%");
  }
  if (number != std::trunc(number))
  {
    throw RuleError(
      "expected " + std::string(expected) + ", found '" + word + "'; did you mean " + word + "%?");
  }
  // No mesh has as many cells as the largest number.
  return Tolerance::OfCells(IsExactInteger(number) ? static_cast<std::int64_t>(number)
                                                   : std::numeric_limits<std::int64_t>::max());
}

//------------------------------------------------------------------------------
bool TakeUndefined(RuleLine& line)
{
  if (line.GetText() != "fails" && line.GetText() != "passes")
  {
    throw line.MakeError("fails or passes after undefined", { "fails", "passes" });
  }
  return line.Take() == "fails";
}

//------------------------------------------------------------------------------
// What follows a criterion with its range, or the name of a preset.
struct Clauses
{
  std::optional<camaron::Scope> Scope;
  std::optional<camaron::Tolerance> Tolerance;
  std::optional<bool> UndefinedFails;

  explicit Clauses(RuleLine& line)
  {
    const std::vector<std::string> words = { "of", "in", "where", "tolerate", "undefined" };
    while (line.GetKind() != Kind::End)
    {
      const std::string word = line.GetText();
      if (line.GetKind() != Kind::Word || !Contains(words, word))
      {
        throw line.MakeError("of, in, where, tolerate, undefined or end of line", words);
      }
      const auto refuse = [&](const char* expected)
      { throw RuleError(std::string("expected ") + expected + ", found another: '" + word + "'"); };
      const bool isTolerance = word == "tolerate", isUndefined = word == "undefined";
      if (isTolerance && this->Tolerance)
      {
        refuse("one tolerate");
      }
      if (isUndefined && this->UndefinedFails)
      {
        refuse("one undefined");
      }
      if (!isTolerance && !isUndefined && this->Scope)
      {
        refuse("one of the words of, in and where");
      }
      line.Take();
      if (isTolerance)
      {
        this->Tolerance = TakeTolerance(line);
      }
      else if (isUndefined)
      {
        this->UndefinedFails = TakeUndefined(line);
      }
      else
      {
        this->Scope = word == "of" ? TakeShapes(line)
          : word == "in"           ? TakeBlock(line)
                                   : TakeValue(line);
      }
    }
  }

  void ApplyTo(Rule& rule) const
  {
    rule.Scope = this->Scope ? this->Scope : rule.Scope;
    rule.Tolerance = this->Tolerance.value_or(rule.Tolerance);
    rule.UndefinedFails = this->UndefinedFails.value_or(rule.UndefinedFails);
  }
};

//------------------------------------------------------------------------------
const Preset& TakePreset(RuleLine& line)
{
  constexpr const char* expected = "the name of a preset";
  if (line.GetKind() != Kind::Word && line.GetKind() != Kind::Quoted)
  {
    throw line.MakeError(expected);
  }
  const std::string name = ToLower(line.GetText());
  for (const Preset& preset : GetPresets())
  {
    if (ToLower(std::string(preset.Name)) == name)
    {
      line.Take();
      return preset;
    }
  }
  throw line.MakeError(expected, GetPresetNames());
}
}

//------------------------------------------------------------------------------
std::vector<std::string> GetPresetNames()
{
  return GetNames(GetPresets());
}

//------------------------------------------------------------------------------
std::vector<Rule> GetRulesOfPreset(const Preset& preset, const Tolerance& tolerance)
{
  std::vector<Rule> rules;
  for (const Preset::Rule& range : preset.Rules)
  {
    Rule rule;
    rule.Criterion = range.Criterion;
    rule.Low = range.Acceptable[0];
    rule.High = range.Acceptable[1];
    rule.Scope = ToScope(range.AcceptableFor);
    rule.Tolerance = tolerance;
    rule.IsHint = range.IsHint;
    rule.Preset = preset.Name;
    if (rule.HasRange())
    {
      rules.push_back(rule);
    }
  }
  return rules;
}

//------------------------------------------------------------------------------
std::vector<Rule> ParseRuleLine(std::string_view text, const Tolerance& tolerance)
{
  RuleLine line(text);
  std::vector<Rule> rules;
  if (line.GetKind() == Kind::End)
  {
    return rules;
  }
  if (line.TakeIf("preset"))
  {
    rules = GetRulesOfPreset(TakePreset(line), tolerance);
  }
  else
  {
    if (!Contains(GetAllCriteria(), line.GetText()))
    {
      throw line.MakeError("the name of a criterion", GetAllCriteria());
    }
    Rule rule;
    rule.Criterion = line.TakeName("a name");
    rule.Tolerance = tolerance;
    TakeRange(line, rule);
    rules.push_back(rule);
  }
  const Clauses clauses(line);
  for (Rule& rule : rules)
  {
    clauses.ApplyTo(rule);
    CheckCriterion(rule);
  }
  return rules;
}

//------------------------------------------------------------------------------
void ParseRangeLine(std::string_view text, const Criterion* (*find)(std::string_view),
  std::vector<Preset::Rule>& ranges)
{
  RuleLine line(text);
  if (line.GetKind() == Kind::End)
  {
    return;
  }
  const std::string name = line.GetText();
  const Criterion* const criterion = find(name);
  if (!criterion)
  {
    throw line.MakeError("the name of a criterion", GetNames(GetCriteria()));
  }
  if (std::any_of(ranges.begin(), ranges.end(),
        [&](const Preset::Rule& range) { return name == range.Criterion; }))
  {
    throw RuleError("expected one range per criterion, found another range of " + name);
  }
  line.Take();
  Preset::Rule range = { criterion->Name, {} };
  TakeLimits(line, range.Acceptable[0], range.Acceptable[1]);
  if (line.GetKind() != Kind::End)
  {
    throw line.MakeError("end of line");
  }
  if (range.Acceptable[0] > range.Acceptable[1] || range.Acceptable[0] == Infinity ||
    range.Acceptable[1] == -Infinity)
  {
    throw RuleError("expected a lower limit that is not above the upper one, found a range of " +
      name + " without values");
  }
  ranges.push_back(range);
}

//------------------------------------------------------------------------------
Tolerance ParseTolerance(std::string_view text)
{
  RuleLine line(text);
  const Tolerance tolerance = TakeTolerance(line);
  if (line.GetKind() != Kind::End)
  {
    throw line.MakeError("end of text");
  }
  return tolerance;
}
}
