// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::MissingValues
 * @brief The elements of a population whose value is missing, as a separate population.
 *
 * A value is missing if it is undefined for another reason than NotApplicable. These elements have
 * the value 0 and all others NaN, so FindWorst() lists them by their ids. Needs 8 bytes per
 * element.
 */
#ifndef camaron_MissingValues_h
#define camaron_MissingValues_h

#include "Statistics/Population.h"

#include <vector> // for values

namespace camaron
{
class MissingValues
{
public:
  explicit MissingValues(const Population& population);

  /// Has the blocks of the original population; valid while this object and these blocks exist.
  const Population& Get() const { return this->Blocks; }

private:
  Population Blocks;
  std::vector<std::vector<double>> Values;
};
}

#endif
