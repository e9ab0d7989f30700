// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CheckNumber.h
 * @brief Refuses numbers that a property cannot have.
 */
#ifndef camaron_CheckNumber_h
#define camaron_CheckNumber_h

#include <limits>    // for no limit
#include <sstream>   // for the message
#include <stdexcept> // for errors

namespace camaron
{
/// Throws std::invalid_argument unless @a value is @a least to @a most, which NaN never is.
template <typename Number>
void CheckNumber(const char* property, Number value, Number least,
  Number most = std::numeric_limits<Number>::max())
{
  if (value >= least && value <= most)
  {
    return;
  }
  std::ostringstream text;
  text << property << " must be " << least;
  if (most < std::numeric_limits<Number>::max())
  {
    text << " to " << most;
  }
  else
  {
    text << " or more";
  }
  text << ", not " << value;
  throw std::invalid_argument(text.str());
}
}

#endif
