// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RuleResults.h
 * @brief Counts the cells that violate rules, and judges them.
 *
 * Every number is bitwise identical for any number of threads and ranks.
 */
#ifndef camaron_RuleResults_h
#define camaron_RuleResults_h

#include "Rules/Rule.h"
#include "Statistics/Weights.h"
#include "Statistics/Worst.h"

#include <functional> // for the describing function
#include <optional>   // for cells
#include <string>     // for sentences
#include <vector>     // for lists

namespace camaron
{
enum class Verdict
{
  Empty, ///< there are no cells to check
  Pass,
  Warn, ///< a violated hint
  Fail
};
/// "empty", "pass", "warn" or "fail".
const char* GetName(Verdict verdict);

/// A failing cell. The Value of undefined ones is NaN.
struct FailingCell : WorstElement
{
  enum class Reason
  {
    Below,
    Above,
    Undefined
  } Why = Reason::Below;
};
/// "below", "above" or "undefined".
const char* GetName(FailingCell::Reason reason);

struct RuleResult
{
  std::int64_t Cells = 0;     ///< in the scope of the rule
  std::int64_t Checked = 0;   ///< of these, cells to which the criterion applies
  std::int64_t Below = 0;     ///< checked cells with a value below the range, including -Inf
  std::int64_t Above = 0;     ///< and above the range, including +Inf
  std::int64_t Undefined = 0; ///< checked cells with an undefined value
  std::int64_t Infinite = 0;  ///< checked cells with an infinite value
  std::int64_t Failing = 0;
  std::int64_t Tolerated = 0;
  camaron::Verdict Verdict = Verdict::Empty;
  ///@{
  /// Of the finite values; NaN if there are none.
  double Min = std::numeric_limits<double>::quiet_NaN();
  double Max = std::numeric_limits<double>::quiet_NaN();
  ///@}
  /// Percentage of the size of the checked cells that fails; NaN if they have no size.
  double FailingSizePercent = std::numeric_limits<double>::quiet_NaN();
  /// The cell whose value is farthest outside the range, else the one nearest to a limit, else
  /// none.
  std::optional<WorstElement> Worst;
  /// Failing cells: farthest outside the range first, then undefined values; equal ones by id.
  std::vector<FailingCell> List;
};

/**
 * Collective. The results of rules with the same criterion and the same cells.
 *
 * @param values the values of the criterion for all cells of the scope
 * @param sizes alternatives, such as volumes and areas: the first one that is not 0 for all checked
 * cells counts
 * @param numberOfWorst maximum number of failing cells to list, 0 or more
 * @param describe see FindWorst
 */
std::vector<RuleResult> CheckRules(const std::vector<const Rule*>& rules, const Population& values,
  const std::vector<Weights>& sizes, int numberOfWorst, Reducer& reducer,
  const std::function<void(WorstElement&)>& describe);

/// The verdict on all rules: the worst one; Empty only if all of them are.
Verdict GetWorstVerdict(const std::vector<RuleResult>& results);

/// Sentences about verdicts that may surprise: rules without cells, hints, undefined values that
/// pass.
std::vector<std::string> GetNotes(
  const std::vector<Rule>& rules, const std::vector<RuleResult>& results);
}

#endif
