// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Counts, sizes and worst cells of rules, against plain loops over the same values.
#include "Rules/ParsedRules.h"
#include "Rules/RuleResults.h"
#include "StatisticsTesting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

using namespace camaron;
using namespace camaron::testing;

namespace
{
const std::string Rules =
  "Volume > 0\nVolume >= 0 undefined passes\nVolume * 0.1\nVolume -0.5 0.5\n"
  "Volume 0.01 * tolerate 30%\nVolume = 0.1 tolerate 2\nVolume * 1e300\n"
  "Volume > -1e300 < 1e300";

//------------------------------------------------------------------------------
std::vector<Rule> ParseAll()
{
  const ParsedRules parsed = ParseRules({ { "rules", Rules } });
  EXPECT_EQ(parsed.Rules.size(), 8u) << parsed.GetMessage();
  return parsed.Rules;
}

//------------------------------------------------------------------------------
std::vector<RuleResult> CheckRules(const std::vector<Rule>& rules, const Population& values,
  const std::vector<Weights>& sizes, int numberOfWorst)
{
  std::vector<const Rule*> pointers;
  for (const Rule& rule : rules)
  {
    pointers.push_back(&rule);
  }
  Reducer alone;
  return CheckRules(pointers, values, sizes, numberOfWorst, alone, [](WorstElement&) {});
}

//------------------------------------------------------------------------------
bool IsMissing(double value)
{
  return std::isnan(value) && GetNullReason(value) != NullReason::NotApplicable;
}

// Distance below or above the range; 0 inside, and for NaN.
double GetExcess(const Rule& rule, double value)
{
  return value < rule.GetLeast() ? rule.GetLeast() - value
    : value > rule.GetMost()     ? value - rule.GetMost()
                                 : 0;
}

//------------------------------------------------------------------------------
void ExpectResult(const Rule& rule, const RuleResult& result, const std::vector<double>& values,
  const std::vector<double>& sizes, std::size_t numberOfWorst)
{
  std::int64_t checked = 0, below = 0, above = 0, undefined = 0, infinite = 0;
  double whole = 0, bad = 0;
  std::vector<std::pair<double, vtkIdType>> outside;
  std::vector<vtkIdType> missing;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double value = values[i];
    const bool isMissing = IsMissing(value);
    if (std::isnan(value) && !isMissing)
    {
      continue;
    }
    ++checked;
    undefined += isMissing;
    infinite += std::isinf(value);
    below += value < rule.GetLeast();
    above += value > rule.GetMost();
    const bool isOutside = value < rule.GetLeast() || value > rule.GetMost();
    whole += sizes[i];
    bad += isOutside || (isMissing && rule.UndefinedFails) ? sizes[i] : 0;
    if (isOutside)
    {
      outside.emplace_back(-GetExcess(rule, value), static_cast<vtkIdType>(i));
    }
    if (isMissing && rule.UndefinedFails)
    {
      missing.push_back(static_cast<vtkIdType>(i));
    }
  }
  // Distances of different values may be equal after rounding: then the more extreme value counts.
  const auto isWorse = [&](const auto& a, const auto& b)
  {
    const double x = values[a.second], y = values[b.second];
    const bool isAbove = x > rule.GetMost(), isSameSide = isAbove == (y > rule.GetMost());
    return isSameSide && x != y ? (x > y) == isAbove : a < b;
  };
  std::sort(outside.begin(), outside.end(), isWorse);
  EXPECT_EQ(result.Cells, static_cast<std::int64_t>(values.size()));
  EXPECT_EQ(result.Checked, checked);
  EXPECT_EQ(result.Below, below);
  EXPECT_EQ(result.Above, above);
  EXPECT_EQ(result.Undefined, undefined);
  EXPECT_EQ(result.Infinite, infinite);
  const std::int64_t failing = below + above + (rule.UndefinedFails ? undefined : 0);
  EXPECT_EQ(result.Failing, failing);
  const bool passes = failing <= rule.Tolerance.GetCells(checked);
  EXPECT_EQ(result.Verdict, checked == 0 ? Verdict::Empty : passes ? Verdict::Pass : Verdict::Fail);
  if (checked == 0)
  {
    EXPECT_TRUE(std::isnan(result.FailingSizePercent));
    EXPECT_FALSE(result.Worst);
  }
  else
  {
    EXPECT_NEAR(result.FailingSizePercent, 100 * bad / whole, 1e-9);
  }
  ASSERT_EQ(result.List.size(), std::min(numberOfWorst, outside.size() + missing.size()));
  for (std::size_t i = 0; i < result.List.size(); ++i)
  {
    const FailingCell& cell = result.List[i];
    const bool isOutside = i < outside.size();
    EXPECT_EQ(cell.Why == FailingCell::Reason::Undefined, !isOutside);
    EXPECT_EQ(cell.Id, isOutside ? outside[i].second : missing[i - outside.size()]);
    EXPECT_EQ(std::isnan(cell.Value), !isOutside);
  }
  if (!outside.empty())
  {
    EXPECT_EQ(result.Worst->Id, outside[0].second);
  }
}
}

//------------------------------------------------------------------------------
TEST(RuleResults, AnyValues)
{
  const std::vector<Rule> rules = ParseAll();
  for (const std::vector<double>& values : DifficultLists(3000))
  {
    std::vector<double> sizes(values.size());
    for (std::size_t i = 0; i < sizes.size(); ++i)
    {
      sizes[i] = 0.25 + static_cast<double>(i % 7);
    }
    Reducer alone;
    const Population population = OneBlock(values), ofSizes = OneBlock(sizes);
    for (const int numberOfWorst : { 0, 1, 20, 5000 })
    {
      const std::vector<RuleResult> results = CheckRules(
        rules, population, { { ofSizes, FindWeightUnit(ofSizes, alone) } }, numberOfWorst);
      for (std::size_t i = 0; i < rules.size(); ++i)
      {
        ExpectResult(rules[i], results[i], values, sizes, numberOfWorst);
      }
    }
  }
}

//------------------------------------------------------------------------------
// The worst value is the one farthest outside, else the one nearest to a limit.
TEST(RuleResults, WorstValue)
{
  const std::vector<double> values = { 3, 1, NaN, 8, 5 };
  const auto getWorst = [&](const std::string& range)
  {
    const ParsedRules parsed = ParseRules({ { "rules", "Volume " + range } });
    const RuleResult result = CheckRules(parsed.Rules, OneBlock(values), {}, 3)[0];
    return result.Worst ? result.Worst->Value : NaN;
  };
  const std::pair<const char*, double> cases[] = { { ">= 0", 1 }, { "<= 9", 8 }, { "0.5 9", 1 },
    { "0 8.5", 8 }, { "0 9", 1 }, { ">= 2", 1 }, { "2 6", 8 }, { "4 9", 1 } };
  for (const auto& [range, worst] : cases)
  {
    EXPECT_EQ(getWorst(range), worst) << range;
  }
}

//------------------------------------------------------------------------------
// If the cells have no volume, their area counts; without sizes, there is no percentage.
TEST(RuleResults, Sizes)
{
  const std::vector<double> values = { -1, 1, 1, NaN }, zeros(4, 0), areas = { 1, 2, 3, 2 };
  const std::vector<Rule> rules = ParseAll();
  const Weights none = { OneBlock(zeros), 1 }, some = { OneBlock(areas), 0.125 };
  const auto getPercent = [&](const std::vector<Weights>& sizes)
  { return CheckRules(rules, OneBlock(values), sizes, 0)[0].FailingSizePercent; };
  EXPECT_EQ(getPercent({ none, some }), 37.5);
  EXPECT_EQ(getPercent({ some, none }), 37.5);
  EXPECT_TRUE(std::isnan(getPercent({ none })));
  EXPECT_TRUE(std::isnan(getPercent({})));
}

//------------------------------------------------------------------------------
TEST(RuleResults, NotesAndVerdicts)
{
  std::vector<Rule> rules = ParseAll();
  rules.resize(3);
  rules[2].IsHint = true;
  const std::vector<double> values = { 1, NaN };
  std::vector<RuleResult> results = CheckRules(rules, OneBlock(values), {}, 1);
  EXPECT_EQ(results[2].Verdict, Verdict::Warn);
  EXPECT_EQ(GetWorstVerdict(results), Verdict::Fail);
  EXPECT_EQ(GetNotes(rules, results),
    (std::vector<std::string>{ "Hints of a preset only warn: they are common practice, and some "
                               "meshes violate them on purpose.",
      "1 cell with an undefined value passed Volume >= 0." }));
  const std::vector<double> inapplicable(2, Null(NullReason::NotApplicable));
  results = CheckRules(rules, OneBlock(inapplicable), {}, 1);
  EXPECT_EQ(GetWorstVerdict(results), Verdict::Empty);
  EXPECT_EQ(GetNotes(rules, results),
    (std::vector<std::string>{
      "There are no cells to check for Volume > 0, Volume >= 0, Volume <= 0.1." }));
}
