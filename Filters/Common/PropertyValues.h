// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PropertyValues.h
 * @brief Checks and converts the values of properties.
 */
#ifndef camaron_PropertyValues_h
#define camaron_PropertyValues_h

#include <limits>    // for the default upper limit
#include <sstream>   // for the message
#include <stdexcept> // for errors
#include <string>    // for texts
#include <utility>   // for pairs
#include <vector>    // for choices

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

/// The value of the choice @a text. Throws std::invalid_argument for any other text; the message
/// names the property: "Side must be Inside or Outside, not 'Left'".
template <typename Value>
Value ParseChoice(const char* property, const std::string& text,
  const std::vector<std::pair<const char*, Value>>& choices)
{
  std::string known;
  for (const auto& choice : choices)
  {
    if (text == choice.first)
    {
      return choice.second;
    }
    known += known.empty() ? "" : &choice == &choices.back() ? " or " : ", ";
    known += choice.first;
  }
  throw std::invalid_argument(std::string(property) + " must be " + known + ", not '" + text + "'");
}
}

#endif
