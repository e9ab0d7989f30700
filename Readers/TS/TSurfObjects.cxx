// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The objects of a file, and their first lines.
#include "Base/Text.h"
#include "Intake/Rows/LineChunks.h"
#include "Intake/Rows/TextRows.h"
#include "TSurf.h"

#include <algorithm>
#include <utility>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
std::string_view Trim(std::string_view text)
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
// Words, each of which may be quoted.
std::vector<std::string_view> Split(std::string_view text)
{
  std::vector<std::string_view> words;
  for (text = Trim(text); !text.empty(); text = Trim(text))
  {
    const bool isQuoted = text.front() == '"';
    text.remove_prefix(isQuoted);
    const std::size_t size = std::min(text.find_first_of(isQuoted ? "\"" : " \t"), text.size());
    words.push_back(text.substr(0, size));
    text.remove_prefix(std::min(size + isQuoted, text.size()));
  }
  return words;
}

//------------------------------------------------------------------------------
// Reads a line that is not in braces.
bool ReadEntry(
  TextScanner& scanner, std::string_view keyword, std::string_view rest, TSurfObject& object)
{
  const std::vector<std::string_view> words = Split(rest);
  std::vector<TSurfProperty>& properties = object.Properties;
  const bool isSizes = keyword == "ESIZES";
  if (keyword == "ZPOSITIVE")
  {
    object.ZPositive = std::string(rest);
  }
  else if (keyword == "AXIS_UNIT")
  {
    object.AxisUnit = std::string(rest);
  }
  else if (keyword == "PROPERTIES")
  {
    properties.clear();
    for (const std::string_view word : words)
    {
      const std::string_view name = word.substr(0, word.find('\0')); // as of arrays
      properties.push_back({ name.empty() ? "Property" : std::string(name) });
    }
  }
  else if ((isSizes || keyword == "NO_DATA_VALUES") && properties.empty() && !words.empty())
  {
    return scanner.FailAt(
      keyword.data(), ErrorKind::Unsupported, "the line PROPERTIES before this one");
  }
  else if (isSizes || keyword == "NO_DATA_VALUES")
  {
    for (std::size_t i = 0; i < std::min(words.size(), properties.size()); ++i)
    {
      const char* const begin = words[i].data();
      const char* const end = begin + words[i].size();
      std::int64_t size = 0;
      if (!isSizes)
      {
        // A word that is not a number, such as none, means that all values are valid.
        properties[i].HasNoData = ParseReal(begin, end, properties[i].NoData) == end;
      }
      else if (ParseInteger(begin, end, size) != end || size < 1 || size > INT32_MAX)
      {
        return scanner.FailAt(
          begin, ErrorKind::Count, "the number of values of a property, at least 1");
      }
      else
      {
        properties[i].Size = static_cast<int>(size);
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// Reads the lines before the records of an object, and moves its beginning behind them.
bool ReadFirstLines(TextScanner& scanner, TSurfObject& object)
{
  bool isInBraces = false, isHeader = false;
  while (object.Begin < object.End)
  {
    const Line line(object.Begin, object.End);
    std::string_view text = Trim({ line.Begin, static_cast<std::size_t>(line.End - line.Begin) });
    const std::string_view keyword = text.substr(0, text.find_first_of(" \t{"));
    if (IsRecord(keyword) && !(keyword == "TFACE" && isInBraces))
    {
      break;
    }
    object.Begin = line.Next;
    if (text.empty() || text[0] == '#')
    {
      continue;
    }
    if (!isInBraces)
    {
      isHeader = keyword.empty() ? isHeader : keyword == "HEADER";
      const std::size_t brace = text.find('{');
      isInBraces = brace != text.npos;
      text.remove_prefix(isInBraces ? brace + 1 : keyword.size());
      if (!isInBraces && !ReadEntry(scanner, keyword, Trim(text), object))
      {
        return false;
      }
    }
    if (isInBraces)
    {
      constexpr std::string_view Name = "name:";
      const std::size_t brace = text.find('}');
      const std::string_view entry = Trim(text.substr(0, brace));
      isInBraces = brace == text.npos;
      if (isHeader && entry.substr(0, Name.size()) == Name)
      {
        object.Name = std::string(Trim(entry.substr(Name.size())));
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// The next line, from text on, whose first word is a keyword; or the end.
const char* FindLine(const char* text, const char* end, std::string_view keyword)
{
  const std::string_view all(text, static_cast<std::size_t>(end - text));
  for (std::size_t at = all.find(keyword); at != all.npos; at = all.find(keyword, at + 1))
  {
    const std::size_t next = at + keyword.size();
    const std::size_t before = all.find_last_not_of(" \t", at - (at > 0));
    const bool isFirst = at == 0 || before == all.npos || all[before] == '\n';
    if (isFirst && (next == all.size() || IsSpace(all[next])))
    {
      return text + at;
    }
  }
  return end;
}
}

//------------------------------------------------------------------------------
std::string_view GetGOCADType(TextScanner scanner)
{
  std::string_view word, type;
  const bool good = scanner.ReadWord(word, "") && EqualsInAnyCase(word, "gocad");
  TextRow row(scanner);
  return good && row.HasMore() && row.ReadWord(type, "") ? type : std::string_view();
}

//------------------------------------------------------------------------------
bool IsTSurf(std::string_view type)
{
  return EqualsInAnyCase(type, "tsurf");
}

//------------------------------------------------------------------------------
bool IsRecord(std::string_view keyword)
{
  return keyword == "VRTX" || keyword == "TRGL" || keyword == "PVRTX" || keyword == "ATOM" ||
    keyword == "PATOM" || keyword == "TFACE";
}

//------------------------------------------------------------------------------
bool FindObjects(TextScanner& scanner, std::vector<TSurfObject>& objects, Warnings& warnings)
{
  constexpr std::string_view Begin = "GOCAD", End = "END";
  scanner.SkipSpace();
  const char* const end = scanner.GetEnd();
  std::string otherType;
  vtkIdType others = 0;
  Tally behind;
  const char* next;
  for (const char* text = scanner.GetPosition(); text < end; text = next)
  {
    scanner.SetPosition(text);
    const std::string_view type = GetGOCADType(scanner);
    scanner.SkipLine();
    TSurfObject object;
    object.Begin = scanner.GetPosition();
    next = FindLine(object.Begin, end, Begin);
    if (!IsTSurf(type))
    {
      otherType = others++ == 0 ? std::string(type.substr(0, 30)) : otherType;
      continue;
    }
    object.End = FindLine(object.Begin, next, End);
    if (object.End == next)
    {
      return scanner.FailAt(next, ErrorKind::Truncated, "the line END of a TSurf");
    }
    const char* const rest = object.End + End.size();
    if (!Trim({ rest, static_cast<std::size_t>(next - rest) }).empty())
    {
      behind.Add(static_cast<vtkIdType>(objects.size()));
    }
    if (!ReadFirstLines(scanner, object))
    {
      return false;
    }
    objects.push_back(std::move(object));
  }
  if (objects.empty())
  {
    return scanner.FailAt(scanner.GetPosition(), ErrorKind::Unsupported, "an object of type TSurf",
      "only " + QuoteWord(otherType));
  }
  warnings.Add(behind, "surface", "surfaces", "with more data after END");
  if (others > 0)
  {
    warnings.Add("objects of types other than TSurf are not read: " + std::to_string(others) +
      ", the first is of type " + QuoteWord(otherType));
  }
  return true;
}
}
