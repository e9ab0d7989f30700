// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ExactTotals
 * @brief Exact sums of doubles, and counts, over the parts of all threads and ranks.
 */
#ifndef camaron_ExactTotals_h
#define camaron_ExactTotals_h

#include "Base/ExactSum.h"
#include "Ranks/Reducer.h"

#include <algorithm>  // for sums of limbs
#include <functional> // for sums of limbs
#include <vector>     // for the sums

namespace camaron
{
class ExactTotals
{
public:
  explicit ExactTotals(std::size_t numberOfSums)
    : Rows(numberOfSums + 1)
  {
  }

  /// Adds a part to a sum.
  void Add(std::size_t sum, ExactSum& part) { Add(this->Rows[sum], part.GetLimbs()); }
  /// Adds a part to each sum.
  template <typename Parts>
  void AddEach(Parts& parts)
  {
    std::size_t sum = 0;
    for (ExactSum& part : parts)
    {
      this->Add(sum++, part);
    }
  }
  /// One of up to 70 counts.
  std::int64_t& Count(std::size_t count) { return this->Rows.back()[count]; }

  /// Collective. Adds up the sums and counts of all ranks.
  void Reduce(Reducer& reducer)
  {
    reducer.Sum(this->Rows[0].data(), this->Rows.size() * this->Rows[0].size());
  }
  /// Adds to every sum all previous ones.
  void Accumulate()
  {
    for (std::size_t sum = 1; sum + 1 < this->Rows.size(); ++sum)
    {
      Add(this->Rows[sum], this->Rows[sum - 1]);
    }
  }

  /// The double nearest to a sum divided by @a divisor, which must be positive.
  double Divide(std::size_t sum, std::int64_t divisor) const
  {
    return ExactSum::Divide(this->Rows[sum], divisor);
  }
  double Round(std::size_t sum) const { return this->Divide(sum, 1); }

private:
  static void Add(ExactSum::Limbs& to, const ExactSum::Limbs& limbs)
  {
    std::transform(limbs.begin(), limbs.end(), to.begin(), to.begin(), std::plus<>());
  }

  std::vector<ExactSum::Limbs> Rows; // the last one for counts
};
}

#endif
