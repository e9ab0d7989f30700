// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rules/RuleLine.h"

#include "Base/Number.h"
#include "Base/Text.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
bool EndsWord(char character)
{
  return IsSpace(character) ||
    std::string_view("#\"'<>=").find(character) != std::string_view::npos;
}

//------------------------------------------------------------------------------
// Lines that were copied from a page may have no-break spaces.
std::string WithPlainSpaces(std::string_view line)
{
  constexpr std::string_view noBreakSpace = "\u00a0";
  std::string result(line);
  for (std::size_t at = 0; (at = result.find(noBreakSpace, at)) != std::string::npos;)
  {
    result.replace(at, noBreakSpace.size(), " ");
  }
  return result;
}

//------------------------------------------------------------------------------
// Decimal numbers and infinity.
std::optional<double> ParseNumber(const std::string& word)
{
  const char* const end = word.data() + word.size();
  double number;
  const bool isNumber = ParseReal(word.data(), end, number) == end && !std::isnan(number);
  return isNumber ? std::make_optional(number) : std::nullopt;
}
}

//------------------------------------------------------------------------------
RuleLine::RuleLine(std::string_view text)
{
  const std::string line = WithPlainSpaces(text);
  auto at = line.begin();
  const auto end = line.end();
  while (at = std::find_if_not(at, end, IsSpace), at != end && *at != '#')
  {
    auto next = at + 1;
    if (*at == '"' || *at == '\'')
    {
      next = std::find(next, end, *at);
      if (next == end)
      {
        throw RuleError("expected a closing " + std::string(1, *at) + ", found end of line");
      }
      this->Tokens.push_back({ Kind::Quoted, std::string(at + 1, next) });
      at = next + 1;
      continue;
    }
    Kind kind = Kind::Word;
    if (*at == '<' || *at == '>' || *at == '=')
    {
      kind = Kind::Sign;
      next += next != end && *next == '=';
    }
    else
    {
      next = std::find_if(next, end, EndsWord);
    }
    this->Tokens.push_back({ kind, std::string(at, next) });
    at = next;
  }
}

//------------------------------------------------------------------------------
RuleLine::Kind RuleLine::GetKind() const
{
  return this->Tokens.empty() ? Kind::End : this->Tokens.front().Kind;
}

//------------------------------------------------------------------------------
const std::string& RuleLine::GetText() const
{
  static const std::string none;
  return this->Tokens.empty() ? none : this->Tokens.front().Text;
}

//------------------------------------------------------------------------------
bool RuleLine::Is(Kind kind, std::string_view text) const
{
  return this->GetKind() == kind && this->GetText() == text;
}

//------------------------------------------------------------------------------
RuleError RuleLine::MakeError(
  const std::string& expected, const std::vector<std::string>& known) const
{
  const std::string found =
    this->GetKind() == Kind::End ? "end of line" : "'" + this->GetText() + "'";
  const std::string similar = FindSimilarName(this->GetText(), known);
  return RuleError("expected " + expected + ", found " + found +
    (similar.empty() ? "" : "; did you mean " + similar + "?"));
}

//------------------------------------------------------------------------------
std::string RuleLine::Take()
{
  std::string text = this->GetText();
  if (!this->Tokens.empty())
  {
    this->Tokens.pop_front();
  }
  return text;
}

//------------------------------------------------------------------------------
std::string RuleLine::TakeName(const std::string& expected)
{
  if (this->GetKind() != Kind::Word && this->GetKind() != Kind::Quoted)
  {
    throw this->MakeError(expected);
  }
  return this->Take();
}

//------------------------------------------------------------------------------
double RuleLine::TakeNumber(const std::string& expected)
{
  const std::optional<double> number =
    this->GetKind() == Kind::Word ? ParseNumber(this->GetText()) : std::nullopt;
  if (!number)
  {
    throw this->MakeError(expected);
  }
  this->Take();
  return *number;
}

//------------------------------------------------------------------------------
bool RuleLine::TakeIf(std::string_view word)
{
  const bool isNext = this->Is(Kind::Word, word);
  if (isNext)
  {
    this->Take();
  }
  return isNext;
}

//------------------------------------------------------------------------------
std::string QuoteName(const std::string& name)
{
  if (!name.empty() && std::none_of(name.begin(), name.end(), EndsWord))
  {
    return name;
  }
  const char* const mark = name.find('"') == std::string::npos ? "\"" : "'";
  return mark + name + mark;
}

//------------------------------------------------------------------------------
std::string MakeReadable(const std::string& message)
{
  constexpr std::ptrdiff_t longest = 79, shown = 60;
  std::string readable;
  for (auto at = message.begin(); at != message.end();)
  {
    const auto end = std::find(at, message.end(), ' ');
    readable.append(at, end - at > longest ? at + shown : end);
    readable += end - at > longest ? "..." : "";
    at = std::find_if_not(end, message.end(), IsSpace);
    readable.append(end, at);
  }
  return MakePrintable(readable);
}
}
