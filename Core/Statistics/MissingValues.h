// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::MissingValues
 * @brief The elements of a population whose value is missing, as a population of its own.
 *
 * Missing is what is null for another reason than that the value has no meaning for the element.
 * Such elements have the value 0 and all others NaN, so that FindWorst() lists them by their
 * identities. Takes 8 bytes per element.
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

  /// Has the blocks of the population that it was made from; valid as long as this object and those
  /// are.
  const Population& Get() const { return this->Blocks; }

private:
  Population Blocks;
  std::vector<std::vector<double>> Values;
};
}

#endif
