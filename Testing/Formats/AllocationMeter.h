// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::testing::AllocationMeter
 * @brief Measures the memory that the whole program allocates, in all threads and libraries.
 *
 * Counts allocations through malloc and related functions, whether the memory is used or not: with
 * glibc by replacing them, under a sanitizer through its hooks. Elsewhere nothing is measured.
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
  /// Starts measuring; only one object at a time.
  AllocationMeter();

  static bool IsAvailable();

  /// The peak of memory in use since the start, minus that in use at the start.
  std::size_t GetPeak() const;
  /// The largest request since the start, whether it succeeded or not.
  std::size_t GetLargestRequest() const;

private:
  long long Before;
};
}
}

#endif
