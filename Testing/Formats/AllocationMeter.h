// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::testing::AllocationMeter
 * @brief Measures how much memory the whole program asks for, in all threads and libraries.
 *
 * Counts what malloc and its relatives give, whether it is touched or not: with glibc by standing
 * in for them, under a sanitizer through its hooks. Elsewhere nothing is measured.
 */
#ifndef camaron_AllocationMeter_h
#define camaron_AllocationMeter_h

#include <cstddef> // for std::size_t

namespace camaron
{
namespace testing
{
class AllocationMeter
{
public:
  /// Starts measuring; one object at a time.
  AllocationMeter();

  static bool IsAvailable();

  /// The most that was in use at one time since the start, less what was in use then.
  std::size_t GetPeak() const;
  /// The largest request since the start, whether it was answered or not.
  std::size_t GetLargestRequest() const;

private:
  long long Before;
};
}
}

#endif
