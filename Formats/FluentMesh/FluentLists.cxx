// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentLists.h"

#include "FluentText.h"

#include <cstdint>
#include <string_view>

namespace camaron
{
//------------------------------------------------------------------------------
bool IsNamedFluentList(const char* text, const char* end)
{
  constexpr std::string_view Signs = "!$%&*/:<=>?^_~";
  text = SkipSpaceFrom(text < end && *text == '(' ? text + 1 : end, end);
  return text < end &&
    (static_cast<unsigned char>((*text | 0x20) - 'a') < 26 || Signs.find(*text) != Signs.npos);
}

//------------------------------------------------------------------------------
bool SkipFluentLists(const char*& place, const char* end, int depth, bool quotes)
{
  std::int64_t open = depth;
  bool quoted = false;
  for (const char* text = place; text < end; ++text)
  {
    const char c = *text;
    if (quoted)
    {
      text += c == '\\' && end - text > 1;
      quoted = c != '"';
    }
    else if (c == '(')
    {
      ++open;
    }
    else if (c == ')')
    {
      if (--open == 0)
      {
        place = text + 1;
        return true;
      }
    }
    else
    {
      quoted = quotes && c == '"';
    }
  }
  return false;
}
}
