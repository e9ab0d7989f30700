// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MAPDLCommands.h"

#include "Intake/Rows/FixedColumns.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
char ToUpper(char c)
{
  return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
}

//------------------------------------------------------------------------------
bool StartsWith(std::string_view text, std::string_view name)
{
  return text.size() >= name.size() &&
    std::equal(
      name.begin(), name.end(), text.begin(), [](char a, char b) { return a == ToUpper(b); });
}

//------------------------------------------------------------------------------
bool IsNamePart(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}
}

//------------------------------------------------------------------------------
bool IsMAPDLExpression(std::string_view field)
{
  constexpr std::string_view Operators = "+-*/<>()%";
  const char* const end = field.data() + field.size();
  double value;
  const char* text = ParseReal(field.data(), end, value);
  text = SkipBlanks(text ? text : field.data(), end);
  const bool isNumber = text > field.data();
  return text < end &&
    (Operators.find(*text) != std::string_view::npos ||
      (!isNumber && !IsDigit(*text) && IsNamePart(*text)));
}

//------------------------------------------------------------------------------
std::string_view TrimMAPDL(std::string_view text)
{
  while (!text.empty() && IsSpace(text.front()))
  {
    text.remove_prefix(1);
  }
  while (!text.empty() && IsSpace(text.back()))
  {
    text.remove_suffix(1);
  }
  return text;
}

//------------------------------------------------------------------------------
std::string ToUpperMAPDL(std::string_view text)
{
  std::string upper(text);
  std::transform(upper.begin(), upper.end(), upper.begin(), ToUpper);
  return upper;
}

//------------------------------------------------------------------------------
bool MAPDLCommand::Take(const char*& text, const char* end)
{
  this->Fields.clear();
  text = SkipBlanks(text, end);
  if (text == end || *text == '!')
  {
    return false;
  }
  const char* const begin = text;
  const std::string_view line(begin, static_cast<std::size_t>(end - begin));
  const bool isComment =
    StartsWith(line, "/COM") || StartsWith(line, "/TIT") || StartsWith(line, "C***");
  const char* field = begin;
  bool quoted = false;
  for (; text < end; ++text)
  {
    quoted = quoted != (*text == '\'');
    if (*text == '!' || (*text == '$' && !quoted && !isComment))
    {
      break;
    }
    // Commands do not have more fields; further ones are dropped.
    constexpr std::size_t MaxFields = 64;
    if (*text == ',' && !quoted && this->Fields.size() < MaxFields)
    {
      this->Fields.push_back(TrimMAPDL({ field, static_cast<std::size_t>(text - field) }));
      field = text + 1;
    }
  }
  this->Fields.push_back(TrimMAPDL({ field, static_cast<std::size_t>(text - field) }));
  this->Text = { begin, static_cast<std::size_t>(text - begin) };
  text = text < end && *text == '$' ? text + 1 : end;
  return true;
}

//------------------------------------------------------------------------------
bool MAPDLCommand::Is(std::string_view name) const
{
  constexpr std::size_t Significant = 4; // characters of a command, excluding / or *
  const std::size_t least = name[0] == '/' || name[0] == '*' ? Significant + 1 : Significant;
  std::string_view word = this->GetField(0);
  word = word.substr(0, name[0] == '/' ? word.find(' ') : word.npos); // /INPUT file.ans
  return word.size() <= name.size() && word.size() >= std::min(least, name.size()) &&
    StartsWith(word, name.substr(0, word.size()));
}

//------------------------------------------------------------------------------
std::string_view MAPDLCommand::GetAssignment(std::string_view& value) const
{
  const std::size_t sign = this->Text.find('=');
  if (sign == std::string_view::npos)
  {
    return {};
  }
  const std::string_view name = TrimMAPDL(this->Text.substr(0, sign));
  if (name.empty() || IsDigit(name[0]) || !std::all_of(name.begin(), name.end(), IsNamePart))
  {
    return {};
  }
  value = this->Text.substr(sign + 1);
  value = TrimMAPDL(value.substr(0, value.find(',')));
  return name;
}

//------------------------------------------------------------------------------
void MAPDLParameters::Set(std::string_view name, std::string_view value)
{
  double number;
  std::string key = ToUpperMAPDL(name);
  if (this->Read(value, number) == Value::Number)
  {
    this->Values[std::move(key)] = number;
  }
  else
  {
    this->Values.erase(key);
  }
}

//------------------------------------------------------------------------------
MAPDLParameters::Value MAPDLParameters::Read(std::string_view field, double& value) const
{
  if (field.empty())
  {
    return Value::Absent;
  }
  const char* const end = field.data() + field.size();
  if (IsDigit(field[0]) || field[0] == '-' || field[0] == '+' || field[0] == '.')
  {
    return ParseReal(field.data(), end, value) == end ? Value::Number : Value::Unknown;
  }
  const auto found = this->Values.find(ToUpperMAPDL(field));
  if (found == this->Values.end())
  {
    return Value::Unknown;
  }
  value = found->second;
  return Value::Number;
}

//------------------------------------------------------------------------------
MAPDLParameters::Value MAPDLParameters::Read(std::string_view field, std::int32_t& value) const
{
  double number;
  const Value kind = this->Read(field, number);
  if (kind == Value::Number)
  {
    if (!(std::abs(number) <= std::numeric_limits<std::int32_t>::max()))
    {
      return Value::Unknown;
    }
    value = static_cast<std::int32_t>(std::lround(number));
  }
  return kind;
}
}
