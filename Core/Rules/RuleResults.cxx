// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rules/RuleResults.h"

#include "Base/Number.h"
#include "Base/Text.h"
#include "Statistics/Quantiles.h"
#include "Statistics/Worst.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace camaron
{
namespace
{
using Reason = FailingCell::Reason;

//------------------------------------------------------------------------------
// The largest number below the range.
double GetLastBelow(const Rule& rule)
{
  return std::nextafter(rule.GetLeast(), -Infinity);
}

//------------------------------------------------------------------------------
// Counts and sizes of the cells up to limits.
class Curve
{
public:
  // Collective.
  Curve(const Population& values, const std::vector<double>& limits, const Weights* sizes,
    Reducer& reducer)
    : Points(MakeCumulativeCurve(
        values, Summary(), { values, Summary(), {}, reducer }, 0, sizes, reducer, limits))
  {
  }

  std::int64_t CountUpTo(double limit) const { return this->Points.CountsUpTo[this->Find(limit)]; }
  double SizeUpTo(double limit) const { return this->Points.WeightsUpTo[this->Find(limit)]; }

private:
  std::size_t Find(double limit) const
  {
    const std::vector<double>& values = this->Points.Values;
    return std::lower_bound(values.begin(), values.end(), limit) - values.begin();
  }

  CumulativeCurve Points;
};

//------------------------------------------------------------------------------
// The values of a criterion, and the lists of its worst cells, which several rules share.
class CheckedValues
{
public:
  // Collective.
  CheckedValues(const Population& values, int numberOfWorst, Reducer& reducer,
    const std::function<void(WorstElement&)>& describe)
    : Values(values)
    , Totals(Summarize(values, ValueRange(), reducer))
    , Missing(this->CountMissing() > 0 ? values : Population())
    , NumberOfWorst(numberOfWorst)
    , Reduce(reducer)
    , Describe(describe)
  {
  }

  const Summary& GetTotals() const { return this->Totals; }
  std::int64_t CountMissing() const
  {
    return this->Totals.UndefinedCount - this->Totals.NotApplicableCount;
  }

  // Collective.
  double GetMissingSize(const Weights& sizes)
  {
    return Curve(this->Missing.Get(), { 0.0 }, &sizes, this->Reduce).SizeUpTo(0.0);
  }

  // Collective. At least one cell, if there is one.
  const std::vector<WorstElement>& GetWorst(Reason reason)
  {
    std::optional<std::vector<WorstElement>>& list = this->Lists[static_cast<int>(reason)];
    if (!list)
    {
      list = FindWorst(reason == Reason::Undefined ? this->Missing.Get() : this->Values,
        std::max(this->NumberOfWorst, 1),
        reason == Reason::Above ? WorstEnd::Largest : WorstEnd::Smallest, this->Reduce,
        this->Describe);
    }
    return *list;
  }

private:
  const Population& Values;
  Summary Totals;
  MissingValues Missing;
  int NumberOfWorst;
  Reducer& Reduce;
  const std::function<void(WorstElement&)>& Describe;
  std::optional<std::vector<WorstElement>> Lists[3]; // by Reason
};

//------------------------------------------------------------------------------
// Sets the percentage for each rule. Collective. False if the checked cells have no size.
bool SetSizes(const std::vector<const Rule*>& rules, CheckedValues& checked, const Curve& curve,
  const Weights& sizes, std::vector<RuleResult>& results)
{
  const double ofValues = curve.SizeUpTo(Infinity);
  const double ofMissing = checked.CountMissing() > 0 ? checked.GetMissingSize(sizes) : 0;
  const double whole = ofValues + ofMissing;
  for (std::size_t i = 0; i < rules.size() && whole > 0; ++i)
  {
    const double failing = curve.SizeUpTo(GetLastBelow(*rules[i])) +
      (ofValues - curve.SizeUpTo(rules[i]->GetMost())) + (rules[i]->UndefinedFails ? ofMissing : 0);
    results[i].FailingSizePercent = 100 * (failing / whole);
  }
  return whole > 0;
}

//------------------------------------------------------------------------------
// Collective. Failing cells, worst first; at least as many as wanted, if there are.
std::vector<FailingCell> ListFailing(
  const Rule& rule, const RuleResult& result, CheckedValues& checked)
{
  const auto list = [&](Reason reason, std::int64_t count)
  {
    std::vector<FailingCell> cells;
    for (const WorstElement& element :
      count > 0 ? checked.GetWorst(reason) : std::vector<WorstElement>())
    {
      if (reason == Reason::Below ? element.Value < rule.GetLeast()
                                  : reason != Reason::Above || element.Value > rule.GetMost())
      {
        cells.push_back({ element, reason });
      }
    }
    return cells;
  };
  // Each list is in order; distances are rounded, so they only compare cells of different lists.
  const auto getDistance = [&](const FailingCell& cell)
  {
    return std::make_pair(
      cell.Why == Reason::Below ? cell.Value - rule.GetLeast() : rule.GetMost() - cell.Value,
      cell.Id);
  };
  const std::vector<FailingCell> below = list(Reason::Below, result.Below);
  const std::vector<FailingCell> above = list(Reason::Above, result.Above);
  std::vector<FailingCell> cells;
  std::merge(below.begin(), below.end(), above.begin(), above.end(), std::back_inserter(cells),
    [&](const FailingCell& a, const FailingCell& b) { return getDistance(a) < getDistance(b); });
  for (FailingCell& cell : list(Reason::Undefined, rule.UndefinedFails ? result.Undefined : 0))
  {
    cell.Value = std::numeric_limits<double>::quiet_NaN();
    cells.push_back(cell);
  }
  return cells;
}

//------------------------------------------------------------------------------
// Collective. The cell whose value is nearest to a limit.
std::optional<WorstElement> FindNearest(
  const Rule& rule, const RuleResult& result, CheckedValues& checked)
{
  if (std::isnan(result.Min))
  {
    return std::nullopt;
  }
  const bool isLow = rule.Low > -Infinity &&
    !(rule.High < Infinity && result.Min - rule.Low > rule.High - result.Max);
  return checked.GetWorst(isLow ? Reason::Below : Reason::Above).front();
}
}

//------------------------------------------------------------------------------
const char* GetName(Verdict verdict)
{
  constexpr const char* names[] = { "empty", "pass", "warn", "fail" };
  return names[static_cast<int>(verdict)];
}

//------------------------------------------------------------------------------
const char* GetName(FailingCell::Reason reason)
{
  constexpr const char* names[] = { "below", "above", "undefined" };
  return names[static_cast<int>(reason)];
}

//------------------------------------------------------------------------------
std::vector<RuleResult> CheckRules(const std::vector<const Rule*>& rules, const Population& values,
  const std::vector<Weights>& sizes, int numberOfWorst, Reducer& reducer,
  const std::function<void(WorstElement&)>& describe)
{
  CheckedValues checked(values, numberOfWorst, reducer, describe);
  const Summary& totals = checked.GetTotals();
  std::vector<double> limits = { Infinity };
  for (const Rule* rule : rules)
  {
    limits.insert(limits.end(), { GetLastBelow(*rule), rule->GetMost() });
  }
  std::vector<RuleResult> results(rules.size());
  const Curve counts(values, limits, sizes.empty() ? nullptr : &sizes[0], reducer);
  bool hasSize = sizes.empty() || SetSizes(rules, checked, counts, sizes[0], results);
  for (std::size_t s = 1; s < sizes.size() && !hasSize; ++s)
  {
    hasSize =
      SetSizes(rules, checked, Curve(values, limits, &sizes[s], reducer), sizes[s], results);
  }
  for (std::size_t i = 0; i < rules.size(); ++i)
  {
    const Rule& rule = *rules[i];
    RuleResult& result = results[i];
    result.Cells = totals.Count;
    result.Checked = totals.GetApplicableCount();
    result.Below = counts.CountUpTo(GetLastBelow(rule));
    result.Above = counts.CountUpTo(Infinity) - counts.CountUpTo(rule.GetMost());
    result.Undefined = checked.CountMissing();
    result.Infinite = totals.InfiniteCount;
    result.Failing = result.Below + result.Above + (rule.UndefinedFails ? result.Undefined : 0);
    result.Tolerated = rule.Tolerance.GetCells(result.Checked);
    result.Verdict = result.Checked == 0   ? Verdict::Empty
      : result.Failing <= result.Tolerated ? Verdict::Pass
      : rule.IsHint                        ? Verdict::Warn
                                           : Verdict::Fail;
    result.Min = totals.Min;
    result.Max = totals.Max;
    result.List = ListFailing(rule, result, checked);
    if (!result.List.empty() && result.List[0].Why != Reason::Undefined)
    {
      result.Worst = result.List[0];
    }
    else
    {
      result.Worst = FindNearest(rule, result, checked);
    }
    result.List.resize(
      std::min(result.List.size(), static_cast<std::size_t>(std::max(numberOfWorst, 0))));
  }
  return results;
}

//------------------------------------------------------------------------------
Verdict GetWorstVerdict(const std::vector<RuleResult>& results)
{
  Verdict worst = Verdict::Empty;
  for (const RuleResult& result : results)
  {
    worst = std::max(worst, result.Verdict);
  }
  return worst;
}

//------------------------------------------------------------------------------
std::vector<std::string> GetNotes(
  const std::vector<Rule>& rules, const std::vector<RuleResult>& results)
{
  std::string empty;
  bool warns = false;
  std::vector<std::string> ofUndefined;
  for (std::size_t i = 0; i < rules.size(); ++i)
  {
    const std::string text = rules[i].GetText();
    if (results[i].Verdict == Verdict::Empty)
    {
      empty += (empty.empty() ? "" : ", ") + text;
    }
    warns = warns || results[i].Verdict == Verdict::Warn;
    if (results[i].Undefined > 0 && !rules[i].UndefinedFails)
    {
      const std::int64_t count = results[i].Undefined;
      ofUndefined.push_back(std::to_string(count) + " " + rules[i].GetElements(count) +
        " with an undefined value passed " + text + ".");
    }
  }
  std::vector<std::string> notes;
  if (!empty.empty())
  {
    notes.push_back("There are no cells to check for " + empty + ".");
  }
  if (warns)
  {
    notes.emplace_back("Hints of a preset only warn: they are common practice, and some meshes "
                       "violate them on purpose.");
  }
  notes.insert(notes.end(), ofUndefined.begin(), ofUndefined.end());
  return notes;
}
}
