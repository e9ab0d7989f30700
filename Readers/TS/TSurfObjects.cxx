// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TSurfObjects.h"

#include "Base/Text.h"
#include "Intake/Rows/LineChunks.h"

#include <algorithm>

namespace camaron
{
namespace
{
constexpr std::string_view ObjectKeyword = "GOCAD"; // begins an object

//------------------------------------------------------------------------------
bool IsBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\r';
}

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
std::vector<std::string> Split(std::string_view text)
{
  std::vector<std::string> words;
  for (text = Trim(text); !text.empty(); text = Trim(text))
  {
    const bool isQuoted = text.front() == '"';
    text.remove_prefix(isQuoted);
    std::size_t size = 0;
    while (size < text.size() && (isQuoted ? text[size] != '"' : !IsSpace(text[size])))
    {
      ++size;
    }
    words.emplace_back(text.substr(0, size));
    text.remove_prefix(std::min(size + isQuoted, text.size()));
  }
  return words;
}

//------------------------------------------------------------------------------
// Reads the lines before the records of an object.
class Preamble
{
public:
  Preamble(TextScanner& scanner, TSurfObject& object)
    : Scanner(scanner)
    , Object(object)
  {
  }

  /// Sets Begin of the object; false with the error in the scanner.
  bool Read()
  {
    const char* text = this->Object.Begin;
    while (text < this->Object.End)
    {
      const Line line(text, this->Object.End);
      const char* keyword = line.Begin;
      const TSurfLine what = ReadKeyword(keyword, line.End);
      if (what != TSurfLine::Other && !(what == TSurfLine::Face && this->IsInBraces))
      {
        break;
      }
      if (!this->ReadLine(std::string_view(line.Begin, line.End - line.Begin)))
      {
        return false;
      }
      text = line.Next;
    }
    this->Object.Begin = text;
    return true;
  }

private:
  bool ReadLine(std::string_view line)
  {
    line = Trim(line);
    if (line.empty() || line[0] == '#')
    {
      return true;
    }
    if (this->IsInBraces || line[0] == '{')
    {
      this->ReadEntries(line[0] == '{' ? line.substr(1) : line);
      return true;
    }
    std::size_t size = 0;
    while (size < line.size() && !IsSpace(line[size]) && line[size] != '{')
    {
      ++size;
    }
    const std::string_view keyword = line.substr(0, size), rest = Trim(line.substr(size));
    this->IsHeader = keyword == "HEADER";
    const std::size_t brace = rest.find('{');
    if (brace != std::string_view::npos)
    {
      this->ReadEntries(rest.substr(brace + 1));
      return true;
    }
    return this->ReadEntry(keyword, rest);
  }

  /// Reads text inside braces, or one line of it.
  void ReadEntries(std::string_view text)
  {
    const std::size_t brace = text.find('}');
    this->IsInBraces = brace == std::string_view::npos;
    text = Trim(text.substr(0, brace));
    constexpr std::string_view Name = "name:";
    if (this->IsHeader && text.substr(0, Name.size()) == Name)
    {
      this->Object.Name = std::string(Trim(text.substr(Name.size())));
    }
  }

  bool ReadEntry(std::string_view keyword, std::string_view rest)
  {
    std::vector<TSurfProperty>& properties = this->Object.Properties;
    if (keyword == "ZPOSITIVE")
    {
      this->Object.ZPositive = std::string(rest);
    }
    else if (keyword == "AXIS_UNIT")
    {
      this->Object.AxisUnit = std::string(rest);
    }
    else if (keyword == "PROPERTIES")
    {
      properties.clear();
      for (const std::string& name : Split(rest))
      {
        properties.emplace_back();
        properties.back().Name = name.c_str(); // array names end at a zero byte
      }
      return this->ReadEach(this->Sizes, &Preamble::ReadSize) &&
        this->ReadEach(this->NoData, &Preamble::ReadNoData);
    }
    else if (keyword == "ESIZES")
    {
      this->Sizes = rest;
      return this->ReadEach(rest, &Preamble::ReadSize);
    }
    else if (keyword == "NO_DATA_VALUES")
    {
      this->NoData = rest;
      return this->ReadEach(rest, &Preamble::ReadNoData);
    }
    return true;
  }

  /// Calls @a read with a word of the line for every property known so far.
  bool ReadEach(std::string_view words, bool (Preamble::*read)(TSurfProperty&))
  {
    if (words.empty())
    {
      return true;
    }
    this->Scanner.SetPosition(words.data());
    for (TSurfProperty& property : this->Object.Properties)
    {
      TextRow row(this->Scanner);
      if (this->Scanner.GetPosition() >= words.data() + words.size() || !row.HasMore())
      {
        break; // the others keep the default
      }
      if (!(this->*read)(property))
      {
        return false;
      }
    }
    return true;
  }

  bool ReadSize(TSurfProperty& property)
  {
    std::int64_t size = 1;
    const bool good = this->Scanner.ReadInteger(size, 1, this->Scanner.GetBytesLeft(),
      ErrorKind::Count, "the number of values of a property");
    property.Size = static_cast<int>(std::min<std::int64_t>(size, INT32_MAX));
    return good;
  }

  /// A word that is not a number, such as none, means that all values are valid.
  bool ReadNoData(TSurfProperty& property)
  {
    std::string_view word;
    this->Scanner.ReadWord(word, "");
    const char* const end = word.data() + word.size();
    property.HasNoData = ParseReal(word.data(), end, property.NoData) == end;
    return true;
  }

  TextScanner& Scanner;
  TSurfObject& Object;
  std::string_view Sizes, NoData; ///< content of these lines, which may precede the names
  bool IsInBraces = false;
  bool IsHeader = false;
};

//------------------------------------------------------------------------------
// Whether only blanks precede a position on its line; the text begins with a line.
bool IsFirstOfLine(std::string_view text, std::size_t at)
{
  while (at > 0 && IsBlank(text[at - 1]))
  {
    --at;
  }
  return at == 0 || text[at - 1] == '\n';
}

//------------------------------------------------------------------------------
// The next line, from text on, that begins with a keyword and a blank or nothing else; or the end.
const char* FindLine(const char* text, const char* end, std::string_view keyword)
{
  const std::string_view all(text, static_cast<std::size_t>(end - text));
  for (std::size_t at = all.find(keyword); at != std::string_view::npos;
    at = all.find(keyword, at + 1))
  {
    const std::size_t next = at + keyword.size();
    if (IsFirstOfLine(all, at) && next < all.size() && IsBlank(all[next]))
    {
      return text + at;
    }
  }
  return end;
}

//------------------------------------------------------------------------------
// The last line that is END, or the end of the text.
const char* FindEnd(const char* text, const char* end)
{
  constexpr std::string_view Keyword = "END";
  const std::string_view all(text, static_cast<std::size_t>(end - text));
  std::size_t at = all.rfind(Keyword);
  while (at != std::string_view::npos)
  {
    const std::size_t next = at + Keyword.size();
    if ((next == all.size() || IsSpace(all[next])) && IsFirstOfLine(all, at))
    {
      return text + at;
    }
    at = at == 0 ? std::string_view::npos : all.rfind(Keyword, at - 1);
  }
  return end;
}

//------------------------------------------------------------------------------
bool ReadFirstLine(TextScanner& scanner, std::string_view& type)
{
  std::string_view word;
  const bool good = scanner.ReadWord(word, "") && EqualsInAnyCase(word, "gocad");
  TextRow row(scanner);
  return good && row.HasMore() && row.ReadWord(type, "");
}
}

//------------------------------------------------------------------------------
TSurfLine ReadKeyword(const char*& text, const char* end)
{
  const char* p = text;
  while (p < end && IsBlank(*p))
  {
    ++p;
  }
  const auto is = [&](std::string_view keyword)
  {
    const auto size = static_cast<std::ptrdiff_t>(keyword.size());
    if (end - p < size || std::memcmp(p, keyword.data(), keyword.size()) != 0 ||
      (end - p > size && !IsBlank(p[size])))
    {
      return false;
    }
    text = p + size;
    return true;
  };
  switch (p < end ? *p : '\0')
  {
    case 'T':
      return is("TRGL") ? TSurfLine::Triangle : is("TFACE") ? TSurfLine::Face : TSurfLine::Other;
    case 'V':
      return is("VRTX") ? TSurfLine::Vertex : TSurfLine::Other;
    case 'P':
      return is("PVRTX") ? TSurfLine::PropertyVertex
        : is("PATOM")    ? TSurfLine::PropertyAtom
                         : TSurfLine::Other;
    case 'A':
      return is("ATOM") ? TSurfLine::Atom : TSurfLine::Other;
    default:
      return TSurfLine::Other;
  }
}

//------------------------------------------------------------------------------
bool FindObjects(TextScanner& scanner, std::vector<TSurfObject>& objects, Warnings& warnings)
{
  scanner.SkipSpace();
  const char* const end = scanner.GetEnd();
  std::string otherType;
  vtkIdType others = 0;
  Tally behind;
  for (const char* text = scanner.GetPosition(); text < end;)
  {
    scanner.SetPosition(text);
    std::string_view type;
    ReadFirstLine(scanner, type);
    scanner.SkipLine();
    TSurfObject object;
    object.Begin = scanner.GetPosition();
    const char* const next = FindLine(object.Begin, end, ObjectKeyword);
    if (!EqualsInAnyCase(type, "tsurf"))
    {
      otherType = others++ == 0 ? std::string(type.substr(0, 30)) : otherType;
      text = next;
      continue;
    }
    object.End = FindEnd(object.Begin, next);
    if (object.End == end)
    {
      return scanner.FailAt(end, ErrorKind::Truncated, "the line END of a TSurf");
    }
    if (object.End < next &&
      !Trim(std::string_view(object.End, next - object.End).substr(3)).empty())
    {
      behind.Add(static_cast<vtkIdType>(objects.size()));
    }
    if (!Preamble(scanner, object).Read())
    {
      return false;
    }
    objects.push_back(std::move(object));
    text = next;
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

//------------------------------------------------------------------------------
bool IsGOCAD(TextScanner scanner)
{
  std::string_view type;
  return ReadFirstLine(scanner, type);
}

//------------------------------------------------------------------------------
bool IsTSurf(TextScanner scanner)
{
  std::string_view type;
  if (!ReadFirstLine(scanner, type))
  {
    return false;
  }
  const char* const end = scanner.GetEnd();
  while (!EqualsInAnyCase(type, "tsurf"))
  {
    scanner.SkipLine();
    const char* const next = FindLine(scanner.GetPosition(), end, ObjectKeyword);
    if (next == end)
    {
      return false;
    }
    scanner.SetPosition(next);
    type = std::string_view();
    ReadFirstLine(scanner, type);
  }
  return true;
}
}
