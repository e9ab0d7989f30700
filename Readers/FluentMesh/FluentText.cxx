// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentText.h"

#include <cstdint>

namespace camaron
{
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
