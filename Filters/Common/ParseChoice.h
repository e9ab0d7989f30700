// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ParseChoice.h
 * @brief Converts the texts of properties with a few choices.
 */
#ifndef camaron_ParseChoice_h
#define camaron_ParseChoice_h

#include "Base/FormerNames.h"

#include <stdexcept> // for errors
#include <string>    // for texts
#include <utility>   // for pairs
#include <vector>    // for choices

namespace camaron
{
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
  throw std::invalid_argument(std::string(property) + " must be " + known + ", not '" + text + "'" +
    DescribeFormerName(text));
}
}

#endif
