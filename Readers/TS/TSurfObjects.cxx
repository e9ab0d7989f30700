// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TSurfObjects.h"

#include "Base/Text.h"
#include "Intake/Rows/LineChunks.h"

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
// Reads a line before the records that is not in braces.
bool ReadEntry(
  TextScanner& scanner, std::string_view keyword, std::string_view rest, TSurfObject& object)
{
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
    for (const std::string_view name : Split(rest))
    {
      properties.emplace_back();
      properties.back().Name = std::string(name.substr(0, name.find('\0'))); // as of arrays
    }
  }
  else if (isSizes || keyword == "NO_DATA_VALUES")
  {
    const std::vector<std::string_view> words = Split(rest);
    if (properties.empty() && !words.empty())
    {
      return scanner.FailAt(
        keyword.data(), ErrorKind::Unsupported, "the line PROPERTIES before this one");
    }
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
      else if (ParseInteger(begin, end, size) == end && size >= 1 && size <= INT32_MAX)
      {
        properties[i].Size = static_cast<int>(size);
      }
      else
      {
        return scanner.FailAt(
          begin, ErrorKind::Count, "the number of values of a property, at least 1");
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// Reads the lines before the records of an object, and moves its beginning behind them.
bool ReadPreamble(TextScanner& scanner, TSurfObject& object)
{
  bool isInBraces = false, isHeader = false;
  while (object.Begin < object.End)
  {
    const Line line(object.Begin, object.End);
    TextRow row(line.Begin, line.End, '#');
    const TSurfLine what = ReadKeyword(row);
    if (what != TSurfLine::Other && !(what == TSurfLine::Face && isInBraces))
    {
      break;
    }
    object.Begin = line.Next;
    std::string_view text = Trim({ line.Begin, static_cast<std::size_t>(line.End - line.Begin) });
    if (text.empty() || text[0] == '#')
    {
      continue;
    }
    if (!isInBraces)
    {
      const std::string_view keyword = text.substr(0, text.find_first_of(" \t{"));
      isHeader = keyword.empty() ? isHeader : keyword == "HEADER";
      const std::size_t brace = text.find('{');
      isInBraces = brace != text.npos;
      if (!isInBraces && !ReadEntry(scanner, keyword, Trim(text.substr(keyword.size())), object))
      {
        return false;
      }
      text = text.substr(isInBraces ? brace + 1 : 0);
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
TSurfLine ReadKeyword(TextRow& row)
{
  static constexpr std::pair<std::string_view, TSurfLine> Keywords[] = {
    { "VRTX", TSurfLine::Vertex }, { "TRGL", TSurfLine::Triangle },
    { "PVRTX", TSurfLine::PropertyVertex }, { "ATOM", TSurfLine::Atom },
    { "PATOM", TSurfLine::PropertyAtom }, { "TFACE", TSurfLine::Face }
  };
  std::string_view word;
  row.ReadWord(word, "");
  for (const auto& [keyword, what] : Keywords)
  {
    if (word == keyword)
    {
      return what;
    }
  }
  return TSurfLine::Other;
}

//------------------------------------------------------------------------------
bool IsGOCAD(TextScanner scanner, std::string_view& type)
{
  std::string_view word;
  const bool good = scanner.ReadWord(word, "") && EqualsInAnyCase(word, "gocad");
  TextRow row(scanner);
  return good && row.HasMore() && row.ReadWord(type, "");
}

//------------------------------------------------------------------------------
bool IsTSurf(std::string_view type)
{
  return EqualsInAnyCase(type, "tsurf");
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
    std::string_view type;
    IsGOCAD(scanner, type);
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
    if (!ReadPreamble(scanner, object))
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
