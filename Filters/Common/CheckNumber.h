// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CheckNumber.h
 * @brief Range checks of numeric properties.
 */
#ifndef camaron_CheckNumber_h
#define camaron_CheckNumber_h

#include <limits>    // for the default upper limit
#include <sstream>   // for the message
#include <stdexcept> // for errors

namespace camaron
{
/// Throws std::invalid_argument unless @a value is between @a least and @a most, both included. NaN
/// is always rejected. The message names the property: "Tolerance must be 0 to 1, not 3".
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
