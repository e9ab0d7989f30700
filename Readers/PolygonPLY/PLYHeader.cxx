// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PLYHeader.h"

#include "Base/Number.h"

#include <algorithm>
#include <string_view>
#include <unordered_set>

namespace camaron
{
namespace
{
constexpr vtkIdType MaxCount = INT32_MAX;
constexpr std::size_t MaxWords = 8; // more than any line needs
// Each property becomes an array, which VTK compares with all others.
constexpr std::size_t MostNames = 10000;

//------------------------------------------------------------------------------
// A line of the header: its end, the start of the next line, and its words.
struct HeaderLine
{
  const char* End;
  const char* Next;
  std::vector<std::string_view> Words;

  HeaderLine(const char* begin, const char* end)
    : End(FindLineEnd(begin, end))
  {
    const char* const lineEnd = this->End;
    for (const char* text = begin; text < lineEnd && this->Words.size() < MaxWords;)
    {
      const char* const word = text;
      while (text < lineEnd && !IsSpace(*text))
      {
        ++text;
      }
      if (text > word)
      {
        this->Words.emplace_back(word, static_cast<std::size_t>(text - word));
      }
      text += text < lineEnd;
    }
    this->Next = lineEnd + (end - lineEnd >= 2 && lineEnd[0] == '\r' && lineEnd[1] == '\n' ? 2 : 1);
    this->Next = std::min(this->Next, end);
  }
  bool IsEmpty() const { return this->Words.empty() || this->Words[0][0] == '#'; }
};

//------------------------------------------------------------------------------
bool ParseType(std::string_view name, ValueType& type)
{
  int i = 0;
  for (const auto& names : ValueTypeNames)
  {
    if (!name.empty() && (name == names[0] || name == names[1]))
    {
      type = static_cast<ValueType>(i);
      return true;
    }
    ++i;
  }
  return false;
}

//------------------------------------------------------------------------------
// Moves to the first line that is neither blank nor a comment; false at the end.
bool SkipEmptyLines(const char*& text, const char* end)
{
  while (text < end)
  {
    const HeaderLine line(text, end);
    if (!line.IsEmpty())
    {
      return true;
    }
    text = line.Next;
  }
  return false;
}

//------------------------------------------------------------------------------
// The start of the values after the line `end_header`, which ends like the line before it: values
// may begin with a byte that is a line end.
const char* FindBody(const char* begin, const HeaderLine& last, const char* end)
{
  const auto isLineEnd = [](char c) { return c == '\n' || c == '\r'; };
  const char* before = last.Words[0].data();
  while (before > begin && IsSpace(before[-1]) && !isLineEnd(before[-1]))
  {
    --before;
  }
  // LF, CR, CR LF or LF CR
  const bool isPair = before - begin >= 2 && isLineEnd(before[-2]) && before[-2] != before[-1];
  const std::ptrdiff_t size = isPair ? 2 : 1;
  return end - last.End >= size && std::equal(before - size, before, last.End) ? last.End + size
                                                                               : last.Next;
}

//------------------------------------------------------------------------------
bool IsMagic(const HeaderLine& line)
{
  return line.Words.size() == 1 && (line.Words[0] == "ply" || line.Words[0] == "PLY");
}

//------------------------------------------------------------------------------
class HeaderReading
{
public:
  HeaderReading(TextScanner& scanner, PLYHeader& header)
    : Scanner(scanner)
    , Header(header)
  {
  }
  bool Read();

private:
  bool Fail(const char* place, ErrorKind kind, const std::string& expected)
  {
    return this->Scanner.FailAt(place, kind, expected);
  }
  bool Fail(std::string_view word, ErrorKind kind, const std::string& expected)
  {
    return this->Fail(word.data(), kind, expected);
  }
  bool CheckName(std::string_view name);
  bool ReadFormat(const std::vector<std::string_view>& words);
  bool ReadElement(const std::vector<std::string_view>& words);
  bool ReadProperty(const std::vector<std::string_view>& words);
  void ReadComment(const std::vector<std::string_view>& words);

  TextScanner& Scanner;
  PLYHeader& Header;
  bool HasFormat = false;
  std::size_t NumberOfNames = 0;         // of elements and properties
  std::unordered_set<std::string> Names; // of the properties of the last element
};

//------------------------------------------------------------------------------
bool HeaderReading::CheckName(std::string_view name)
{
  if (++this->NumberOfNames > MostNames)
  {
    return this->Fail(name, ErrorKind::Unsupported,
      "at most " + std::to_string(MostNames) + " elements and properties");
  }
  const auto isControl = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; };
  return std::none_of(name.begin(), name.end(), isControl) ||
    this->Fail(name, ErrorKind::Syntax, "a name of printable characters");
}

//------------------------------------------------------------------------------
bool HeaderReading::ReadFormat(const std::vector<std::string_view>& words)
{
  const std::string_view word = words.size() > 1 ? words[1] : words[0];
  const auto* const known =
    std::find(std::begin(PLYEncodingNames), std::end(PLYEncodingNames), word);
  if (known == std::end(PLYEncodingNames))
  {
    return this->Fail(
      word, ErrorKind::Syntax, "'ascii', 'binary_little_endian' or 'binary_big_endian'");
  }
  this->Header.Encoding = static_cast<PLYEncoding>(known - std::begin(PLYEncodingNames));
  if (words.size() < 3 || words[2] != "1.0")
  {
    this->Header.Oddities.emplace_back("the version of the format is not 1.0");
  }
  this->HasFormat = true;
  return true;
}

//------------------------------------------------------------------------------
bool HeaderReading::ReadElement(const std::vector<std::string_view>& words)
{
  std::int64_t count = 0;
  if (words.size() < 3)
  {
    return this->Fail(words[0], ErrorKind::Syntax, "'element', a name and a count");
  }
  if (!this->CheckName(words[1]))
  {
    return false;
  }
  const std::string what = "the number of elements " + QuoteWord(words[1]);
  const char* const end = words[2].data() + words[2].size();
  if (ParseInteger(words[2].data(), end, count) != end)
  {
    return this->Fail(words[2], ErrorKind::Syntax, what);
  }
  if (count < 0 || count > MaxCount)
  {
    return this->Fail(words[2], ErrorKind::Count, what + " from 0 to 2147483647");
  }
  PLYElement element;
  element.HasNamesOfFile = true;
  element.Name = std::string(words[1]);
  element.Count = count;
  this->Header.Elements.push_back(element);
  this->Names.clear();
  return true;
}

//------------------------------------------------------------------------------
bool HeaderReading::ReadProperty(const std::vector<std::string_view>& words)
{
  if (this->Header.Elements.empty())
  {
    return this->Fail(words[0], ErrorKind::Syntax, "an element before its first property");
  }
  TableProperty property;
  property.IsList = words.size() > 1 && words[1] == "list";
  const std::size_t type = property.IsList ? 3 : 1;
  if (words.size() < type + 2)
  {
    return this->Fail(words[0], ErrorKind::Syntax,
      property.IsList ? "'property list', two types and a name" : "'property', a type and a name");
  }
  constexpr char Types[] =
    "char, uchar, short, ushort, int, uint, int64, uint64, float or double (or int8 ... float64)";
  if (!ParseType(words[type], property.Type))
  {
    return this->Fail(words[type], ErrorKind::Syntax, std::string("a type, ") + Types);
  }
  if (property.IsList && (!ParseType(words[2], property.CountType) || IsReal(property.CountType)))
  {
    return this->Fail(
      words[2], ErrorKind::Syntax, "an integer type for the length of a list, such as uchar");
  }
  property.Name = std::string(words[type + 1]);
  PLYElement& element = this->Header.Elements.back();
  if (!this->Names.insert((property.IsList ? "list " : "") + property.Name).second)
  {
    this->Header.Oddities.push_back("the element " + QuoteWord(element.Name) +
      " has the property " + QuoteWord(property.Name) + " more than once");
  }
  element.Properties.push_back(property);
  return this->CheckName(words[type + 1]);
}

//------------------------------------------------------------------------------
void HeaderReading::ReadComment(const std::vector<std::string_view>& words)
{
  std::int64_t number = 0;
  constexpr std::int64_t MaxComponents = 1 << 16;
  if (words.size() == 4 && words[1] == "components" &&
    ParseInteger(words[3].data(), words[3].data() + words[3].size(), number) && number > 1 &&
    number <= MaxComponents)
  {
    this->Header.Components[std::string(words[2])] = static_cast<int>(number);
  }
  if (words.size() == 2 && words[1] == BlankFacesOfCells)
  {
    this->Header.FacesOfCellsAreBlank = true;
  }
}

//------------------------------------------------------------------------------
bool HeaderReading::Read()
{
  const char* text = this->Scanner.GetPosition();
  const char* const end = this->Scanner.GetEnd();
  if (!SkipEmptyLines(text, end) || !IsMagic(HeaderLine(text, end)))
  {
    return this->Fail(text, ErrorKind::NotThisFormat, "a PLY file, whose first line is 'ply'");
  }
  const char* const begin = text;
  text = HeaderLine(text, end).Next;
  std::vector<std::string>& oddities = this->Header.Oddities;
  while (SkipEmptyLines(text, end))
  {
    const HeaderLine line(text, end);
    text = line.Next;
    const std::string_view keyword = line.Words[0];
    if (keyword == "end_header")
    {
      this->Header.Body = FindBody(begin, line, end);
      if (!this->HasFormat)
      {
        oddities.emplace_back("the header does not declare the format; ascii is assumed");
      }
      return true;
    }
    if (keyword == "format" || keyword == "element" || keyword == "property")
    {
      const bool good = keyword == "format" ? this->ReadFormat(line.Words)
        : keyword == "element"              ? this->ReadElement(line.Words)
                                            : this->ReadProperty(line.Words);
      if (!good)
      {
        return false;
      }
    }
    else if (keyword == "comment" || keyword == "obj_info")
    {
      this->ReadComment(line.Words);
    }
    else if (this->HasFormat && this->Header.Elements.empty())
    {
      // Old versions of Blender omitted the keyword `comment`.
      const std::string unknown = "a line of the header without known keyword is ignored";
      if (std::find(oddities.begin(), oddities.end(), unknown) == oddities.end())
      {
        oddities.push_back(unknown);
      }
    }
    else
    {
      // In a truncated header, or one without end, values follow.
      double value;
      const char* const wordEnd = keyword.data() + keyword.size();
      const bool isNumber = ParseReal(keyword.data(), wordEnd, value) == wordEnd;
      return this->Fail(keyword, isNumber || text == end ? ErrorKind::Truncated : ErrorKind::Syntax,
        "'end_header' or a keyword of the header (format, element, property, comment, obj_info)");
    }
  }
  return this->Fail(end, ErrorKind::Truncated, "'end_header'");
}
}

//------------------------------------------------------------------------------
int PLYElement::Find(std::initializer_list<const char*> names, bool isList) const
{
  for (std::size_t i = 0; i < this->Properties.size(); ++i)
  {
    const TableProperty& property = this->Properties[i];
    if (property.IsList == isList &&
      std::find(names.begin(), names.end(), property.Name) != names.end())
    {
      return static_cast<int>(i);
    }
  }
  return -1;
}

//------------------------------------------------------------------------------
bool ReadPLYHeader(TextScanner& scanner, PLYHeader& header)
{
  header = PLYHeader();
  return HeaderReading(scanner, header).Read();
}

//------------------------------------------------------------------------------
bool IsPLYStart(const char* begin, const char* end)
{
  const char* text = TextScanner("", begin, end).GetPosition(); // after a byte order mark
  constexpr vtkIdType Far = 1 << 16;                            // of comments before the first line
  end = end - text > Far ? text + Far : end;
  return SkipEmptyLines(text, end) && IsMagic(HeaderLine(text, end));
}
}
