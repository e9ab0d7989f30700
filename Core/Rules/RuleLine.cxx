// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rules/RuleLine.h"

#include "Base/Number.h"
#include "Base/Text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
bool EndsWord(char32_t character)
{
  return IsBlank(character) ||
    std::u32string_view(U"#\"'<>=").find(character) != std::u32string::npos;
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
RuleLine::RuleLine(std::string_view line)
{
  const std::u32string characters = ToCharacters(line);
  auto at = characters.begin();
  const auto end = characters.end();
  while (at = std::find_if_not(at, end, IsBlank), at != end && *at != '#')
  {
    auto next = at + 1;
    if (*at == '"' || *at == '\'')
    {
      next = std::find(next, end, *at);
      if (next == end)
      {
        throw RuleError(
          "expected a closing " + std::string(1, static_cast<char>(*at)) + ", found end of line");
      }
      this->Tokens.push_back({ Kind::Quoted, ToUtf8({ &*at + 1, std::size_t(next - at - 1) }) });
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
    this->Tokens.push_back({ kind, ToUtf8({ &*at, std::size_t(next - at) }) });
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
  const std::u32string characters = ToCharacters(name);
  if (!name.empty() && std::none_of(characters.begin(), characters.end(), EndsWord))
  {
    return name;
  }
  const char* const mark = name.find('"') == std::string::npos ? "\"" : "'";
  return mark + name + mark;
}

namespace
{
//------------------------------------------------------------------------------
// As Python writes it: \n, \x07, \u200b or \U000e0001.
void AppendEscaped(std::string& text, char32_t character)
{
  const std::u32string_view named = U"\t\n\r";
  const std::size_t name = named.find(character);
  if (name != std::u32string_view::npos)
  {
    text += { '\\', "tnr"[name] };
    return;
  }
  char code[16];
  const char* const format = character < 0x100 ? "\\x%02x"
    : character < 0x10000                      ? "\\u%04x"
                                               : "\\U%08x";
  std::snprintf(code, sizeof(code), format, static_cast<unsigned>(character));
  text += code;
}
}

//------------------------------------------------------------------------------
std::string MakeReadable(const std::string& message)
{
  constexpr std::ptrdiff_t longest = 79, shown = 60;
  const std::u32string characters = ToCharacters(message);
  std::string readable;
  const auto append = [&](char32_t character)
  {
    IsPrintable(character) ? AppendCharacter(readable, character)
                           : AppendEscaped(readable, character);
  };
  for (auto at = characters.begin(); at != characters.end();)
  {
    if (IsBlank(*at))
    {
      append(*at++);
      continue;
    }
    const auto end = std::find_if(at, characters.end(), IsBlank);
    std::for_each(at, end - at > longest ? at + shown : end, append);
    readable += end - at > longest ? "..." : "";
    at = end;
  }
  return readable;
}
}
