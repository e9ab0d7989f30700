// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentMeshFile.h"

#include "Intake/Fluent/FluentText.h"
#include "Intake/Rows/Bytes.h"
#include "Scan/TextScanner.h"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Moves @a place past the parenthesis that closes @a depth open ones (0 if the first one follows)
// and those opened after it; false at the end of the text, with @a place unchanged. With @a quotes,
// parentheses between quotation marks, where a backslash escapes the next character, do not count.
bool SkipLists(const char*& place, const char* end, int depth, bool quotes)
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

//------------------------------------------------------------------------------
FluentMeshFile::FluentMeshFile(std::string name, const char* begin, const char* end)
  : FluentFile(std::move(name), begin, FindTextEnd(begin, end))
{
}

//------------------------------------------------------------------------------
std::string FluentMeshFile::Locate(const char* place) const
{
  // Line numbers are meaningless after binary data.
  const bool isText = !this->FirstBinary || place <= this->FirstBinary;
  return isText ? this->Name + ":" +
      std::to_string(TextScanner(this->Name, this->Begin, this->End).GetLine(place))
                : this->Name + ": byte " + std::to_string(place - this->Begin);
}

//------------------------------------------------------------------------------
bool FluentMeshFile::IsFluent(const char* begin, const char* end)
{
  const char* const text = SkipSpaceFrom(SkipByteOrderMark(begin, end), end);
  return text < end && *text == '(';
}

//------------------------------------------------------------------------------
bool FluentMeshFile::IsAtList()
{
  this->Position = SkipSpaceFrom(this->Position, this->End);
  return this->Position < this->End && *this->Position == '(';
}

//------------------------------------------------------------------------------
// Reads "(number" in decimal; returns its end, or nullptr.
const char* FluentMeshFile::ParseFirst(std::int64_t& value)
{
  return this->IsAtList()
    ? ParseInteger(SkipSpaceFrom(this->Position + 1, this->End), this->End, value)
    : nullptr;
}

//------------------------------------------------------------------------------
bool FluentMeshFile::SkipRest(int depth, const FluentSection& section)
{
  // In the text of a comment, a quotation mark may mean inch.
  constexpr int Comments = 1;
  const char* const text = SkipSpaceFrom(this->Position, this->End);
  const bool isProse = section.Index >= 0 && section.Index <= Comments &&
    !(text < this->End && (*text == '"' || *text == '('));
  if (this->TrustsQuotes && !isProse && SkipLists(this->Position, this->End, depth, true))
  {
    return true;
  }
  // Elsewhere, a single quotation mark hides everything after it.
  this->TrustsQuotes = this->TrustsQuotes && isProse;
  if (SkipLists(this->Position, this->End, depth, false))
  {
    return true;
  }
  this->FailAt(section.Place, ErrorKind::Truncated,
    "a closing parenthesis for the section that begins here", "the end of the file");
  return false;
}

//------------------------------------------------------------------------------
// Reads "(hexadecimal numbers)".
bool FluentMeshFile::ReadHeader(FluentSection& section)
{
  if (!this->IsAtList())
  {
    this->FailAt(this->Position,
      this->Position == this->End ? ErrorKind::Truncated : ErrorKind::Syntax,
      "the header of section " + std::to_string(section.Index) + " in parentheses");
    return false;
  }
  const char* text = this->Position + 1;
  const void* found = std::memchr(text, ')', static_cast<std::size_t>(this->End - text));
  if (!found)
  {
    this->FailAt(
      this->Position, ErrorKind::Truncated, "the end of the header", "the end of the file");
    return false;
  }
  const char* const end = static_cast<const char*>(found);
  for (text = SkipSpaceFrom(text, end); text < end; text = SkipSpaceFrom(text, end))
  {
    std::int64_t value = 0;
    const char* const next =
      section.HeaderSize < FluentSection::MaxHeader ? ParseHex(text, end, value) : nullptr;
    if (!next || value > INT32_MAX)
    {
      this->FailAt(text, next ? ErrorKind::Count : ErrorKind::Syntax,
        next ? "a number below 80000000" : "a hexadecimal number or the end of the header");
      return false;
    }
    section.Header[section.HeaderSize++] = value;
    text = next;
  }
  this->Position = end + 1;
  return true;
}

//------------------------------------------------------------------------------
bool FluentMeshFile::ReadDimension()
{
  const char* const place = this->Position;
  std::int64_t value = 0;
  const char* next = ParseInteger(SkipSpaceFrom(place, this->End), this->End, value);
  if (!next || (value != 2 && value != 3))
  {
    this->FailAt(place, ErrorKind::Syntax, "the dimension of the mesh, 2 or 3");
    return false;
  }
  this->Dimension = static_cast<int>(value);
  this->Position = next;
  return true;
}

//------------------------------------------------------------------------------
// "(60 ...": little endian; any other number, big endian.
void FluentMeshFile::ReadConfiguration()
{
  constexpr int LittleEndian = 60;
  std::int64_t value = 0;
  if (this->ParseFirst(value))
  {
    const ByteOrder order = value == LittleEndian ? ByteOrder::Little : ByteOrder::Big;
    this->Swap = order != GetByteOrder();
  }
}

//------------------------------------------------------------------------------
// "(id type name ...". An invalid zone gets no name.
void FluentMeshFile::ReadZone()
{
  std::int64_t id = 0;
  const char* text = this->ParseFirst(id);
  if (!text || id < 0 || id > INT32_MAX)
  {
    return;
  }
  const auto readWord = [&]
  {
    constexpr std::size_t MaxWord = 1000;
    text = SkipSpaceFrom(text, this->End);
    std::string word;
    const bool quoted = text < this->End && *text == '"';
    text += quoted;
    while (text < this->End && word.size() < MaxWord &&
      (quoted ? *text != '"' : !IsSpace(*text) && *text != '(' && *text != ')'))
    {
      word += *text++;
    }
    text += quoted && text < this->End;
    return word;
  };
  const std::string type = readWord(), name = readWord();
  if (!type.empty())
  {
    this->Zones.push_back({ static_cast<int>(id), type, name });
  }
}

//------------------------------------------------------------------------------
bool FluentMeshFile::CheckRange(const FluentSection& section)
{
  constexpr int LeastHeader = 3;
  const std::string what = section.Index == FluentSection::NodesIndex ? "nodes"
    : section.Index == FluentSection::CellsIndex                      ? "cells"
                                                                      : "faces";
  if (section.HeaderSize < LeastHeader)
  {
    this->FailAt(section.Place, ErrorKind::Syntax,
      "a header of " + what + " with a zone, the first and the last index",
      std::to_string(section.HeaderSize) + " numbers");
  }
  else if (section.Header[0] != 0 && (section.Header[1] < 1 || section.GetCount() < 0))
  {
    this->FailAt(section.Place, ErrorKind::Count, "the first and the last index of " + what,
      std::to_string(section.Header[1]) + " and " + std::to_string(section.Header[2]));
  }
  return !this->HasFailed();
}

//------------------------------------------------------------------------------
// Keeps a section with data; of zone 0 only the declared total.
void FluentMeshFile::Keep(FluentSection&& section)
{
  if (section.Index > FluentSection::FacesIndex)
  {
    const bool isTree = section.Index == FluentSection::FaceTreeIndex;
    if (section.HeaderSize > 1 && (section.Begin || !isTree))
    {
      (isTree ? this->FaceTrees : this->InterfaceFaces).push_back(std::move(section));
    }
    return;
  }
  const bool areNodes = section.Index == FluentSection::NodesIndex;
  const bool areCells = section.Index == FluentSection::CellsIndex;
  this->HasMeshSection = this->HasMeshSection || !areCells;
  if (section.Header[0] == 0)
  {
    (areNodes      ? this->DeclaredNodes
        : areCells ? this->DeclaredCells
                   : this->DeclaredFaces) = { section.Header[2], section.Place };
    const std::int64_t dimension = areNodes ? section.GetElement() : 0;
    if (this->Dimension == 0 && (dimension == 2 || dimension == 3))
    {
      this->Dimension = static_cast<int>(dimension);
    }
  }
  else if (section.GetCount() > 0)
  {
    (areNodes ? this->Nodes : areCells ? this->Cells : this->Faces).push_back(std::move(section));
  }
}

//------------------------------------------------------------------------------
// Reads a section with data of the mesh, from its header on.
bool FluentMeshFile::ReadMeshSection(FluentSection& section, int index)
{
  const bool isRange = section.Index <= FluentSection::FacesIndex; // of elements of a zone
  if (!this->ReadHeader(section) || (isRange && !this->CheckRange(section)))
  {
    return false;
  }
  const bool hasBody = this->IsAtList();
  bool good;
  if (section.IsText())
  {
    good = (!hasBody || section.Header[0] == 0 || this->ReadTextBody(section)) &&
      this->SkipRest(1, section);
  }
  else
  {
    // Cells of one type need no data; as in text, data that some writers add is ignored. For
    // interface faces, the range in the header is sufficient.
    const bool areCells = section.Index == FluentSection::CellsIndex;
    const bool reads = isRange
      ? (section.Header[0] != 0 || areCells) && !(areCells && section.GetElement() != 0 && hasBody)
      : section.Index == FluentSection::FaceTreeIndex && section.HeaderSize > 1;
    good = reads ? this->ReadBinaryBody(section, index) : this->SkipBinary(section, index);
  }
  if (good)
  {
    this->Keep(std::move(section));
  }
  return good;
}

//------------------------------------------------------------------------------
bool FluentMeshFile::ReadTextBody(FluentSection& section)
{
  const char* const body = this->Position + 1;
  const void* end = std::memchr(body, ')', static_cast<std::size_t>(this->End - body));
  const bool opens =
    end && std::memchr(body, '(', static_cast<std::size_t>(static_cast<const char*>(end) - body));
  if (!end || opens)
  {
    this->FailAt(section.Place, ErrorKind::Truncated,
      "a closing parenthesis for the section that begins here",
      opens ? "another opening one" : "the end of the file");
    return false;
  }
  section.Begin = body;
  section.End = static_cast<const char*>(end);
  this->Position = section.End + 1;
  return true;
}

//------------------------------------------------------------------------------
bool FluentMeshFile::ReadSection()
{
  FluentSection section;
  section.Place = this->Position;
  // If a number comes first, it is a section, possibly a damaged one; else a list such as
  // (cad/options 1), ("a" 1), ((a . 1)) or ().
  const char* text = this->IsAtList() ? SkipSpaceFrom(this->Position + 1, this->End) : nullptr;
  const char first = text && text < this->End ? *text : ' ';
  if (text && !IsDigit(first) && first != '-' && first != '+' && first != '.')
  {
    constexpr int NoIndex = -1;
    section.Index = NoIndex;
    return this->SkipRest(0, section);
  }
  constexpr std::int64_t MaxIndex = 999999;
  std::int64_t number = 0;
  text = IsDigit(first) ? ParseInteger(text, this->End, number) : nullptr;
  if (!text || number > MaxIndex || text == this->End ||
    !(IsSpace(*text) || *text == '(' || *text == ')' || *text == '"'))
  {
    this->FailAt(section.Place,
      this->HasMeshSection || this->Dimension > 0 ? ErrorKind::Syntax : ErrorKind::NotThisFormat,
      "a section of a Fluent mesh, which begins with '(' and an index, or another list");
    return false;
  }
  this->Position = text;
  constexpr int FirstSingle = 2000, FirstDouble = 3000, EndBinary = 4000;
  const int index = static_cast<int>(number);
  const bool isBinary = index >= FirstSingle && index < EndBinary;
  section.Index = isBinary ? index % 1000 : index;
  if (isBinary)
  {
    section.RealSize = index < FirstDouble ? 4 : 8;
    this->FirstBinary = this->FirstBinary ? this->FirstBinary : section.Place;
  }
  switch (section.Index)
  {
    case FluentSection::NodesIndex:
    case FluentSection::CellsIndex:
    case FluentSection::FacesIndex:
    case FluentSection::FaceTreeIndex:
    case FluentSection::InterfaceIndex:
      return this->ReadMeshSection(section, index);
    default:
      break;
  }
  if (isBinary)
  {
    return this->SkipBinary(section, index);
  }
  constexpr int Dimension = 2, Configuration = 4, OldZone = 45, Zone = 39;
  if (index == Configuration)
  {
    this->ReadConfiguration();
  }
  else if (index == Zone || index == OldZone)
  {
    this->ReadZone();
  }
  return (index != Dimension || this->ReadDimension()) && this->SkipRest(1, section);
}

//------------------------------------------------------------------------------
bool FluentMeshFile::Scan(const Progress& progress)
{
  this->Swap = GetByteOrder() != ByteOrder::Little;
  this->Position = SkipByteOrderMark(this->Begin, this->End);
  while (this->IsAtList() || this->Position < this->End)
  {
    if (!this->ReadSection() ||
      !progress.Report(static_cast<double>(this->Position - this->Begin) /
        static_cast<double>(this->End - this->Begin)))
    {
      return false;
    }
  }
  if (!this->HasMeshSection && this->Dimension == 0)
  {
    this->Fail(ErrorKind::NotThisFormat, "a Fluent mesh",
      this->Begin == this->End ? "an empty file" : "no nodes or faces");
    return false;
  }
  if (this->Dimension == 0)
  {
    // If all faces have two nodes, the mesh is two-dimensional.
    const bool isFlat = std::any_of(this->Faces.begin(), this->Faces.end(),
      [](const FluentSection& face) { return face.GetElement() == 2; });
    this->Dimension = isFlat ? 2 : 3;
  }
  return true;
}
}
