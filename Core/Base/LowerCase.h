// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LowerCase.h
 * @brief Text in lower case whatever the locale: only letters from A to Z change.
 */
#ifndef camaron_LowerCase_h
#define camaron_LowerCase_h

#include <string> // for text

namespace camaron
{
inline char ToLower(char c)
{
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

inline std::string ToLower(std::string text)
{
  for (char& c : text)
  {
    c = ToLower(c);
  }
  return text;
}
}

#endif
