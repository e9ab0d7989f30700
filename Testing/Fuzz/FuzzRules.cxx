// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// A libFuzzer target: its inputs are texts of rules. It ends if a text has neither rules nor
// problems, if a rule as a line has another meaning, or if a message is not UTF-8.
#include "Base/Text.h"
#include "Rules/ParsedRules.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

using namespace camaron;

namespace
{
//------------------------------------------------------------------------------
void Require(bool condition, const std::string& text)
{
  if (!condition)
  {
    std::fprintf(stderr, "wrong: %s\n", text.c_str());
    std::abort();
  }
}
}

//------------------------------------------------------------------------------
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text(reinterpret_cast<const char*>(data), size);
  const ParsedRules parsed = ParseRules({ { "rules", text } });
  Require(parsed.Rules.empty() != parsed.Problems.empty(), text);
  Require(IsUtf8(parsed.GetMessage()), parsed.GetMessage());
  for (const Rule& rule : parsed.Rules)
  {
    const std::string line = rule.GetLineText();
    const ParsedRules again = ParseRules({ { "rules", line } });
    Require(again.Rules.size() == 1 && again.Rules[0].GetLineText() == line, line);
    Require(again.Rules[0].Scope == rule.Scope && again.Rules[0].GetMost() == rule.GetMost(), line);
  }
  return 0;
}
