// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MAPDLRows.h"

#include <algorithm>

namespace camaron
{
namespace
{
constexpr int CountField = 8;    // of an element of a SOLID block: number of nodes
constexpr int SolidIdField = 10; // the number of the element
// Beyond any element; a row that declares more is damaged, and treated as one without nodes until
// it is read.
constexpr std::int64_t MaxNodes = 1000;

//------------------------------------------------------------------------------
bool IsDivider(char c)
{
  return IsSpace(c) || c == ',';
}

bool ParseToken(const char* text, const char* end, std::int64_t& value)
{
  return ParseInteger(text, end, value) == end;
}
bool ParseToken(const char* text, const char* end, double& value)
{
  return ParseReal(text, end, value) == end;
}
}

//------------------------------------------------------------------------------
MAPDLLine ClassifyMAPDLLine(const Line& line)
{
  const char* const text = SkipBlanks(line.Begin, line.End);
  if (text == line.End || *text == '!')
  {
    return MAPDLLine::Blank;
  }
  const char c = *text;
  if (c == '-')
  {
    const char* const next = text + 2;
    return line.End - text >= 2 && text[1] == '1' && (next == line.End || IsDivider(*next))
      ? MAPDLLine::End
      : MAPDLLine::Row;
  }
  const bool isCommand = (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '/' || c == '*' ||
    c == '_' || c == '~' || c == '$' || c == ':';
  return isCommand ? MAPDLLine::Command : MAPDLLine::Row;
}

//------------------------------------------------------------------------------
const char* SkipBlankMAPDLLines(const char* text, const char* end)
{
  while (text < end && ClassifyMAPDLLine(Line(text, end)) == MAPDLLine::Blank)
  {
    text = Line(text, end).Next;
  }
  return text;
}

//------------------------------------------------------------------------------
int MAPDLRowFormat::CountFields(const Line& line, int limit) const
{
  const char* end = line.End;
  while (end > line.Begin && IsDivider(end[-1]))
  {
    --end;
  }
  int number = 0;
  if (this->Columns)
  {
    limit = std::min(limit, this->Columns->GetNumberOfColumns());
    while (number < limit && (*this->Columns)[number].Begin < end - line.Begin)
    {
      ++number;
    }
    return number;
  }
  for (const char* text = line.Begin; text < end && number < limit; ++text)
  {
    number += !IsDivider(*text) && (text == line.Begin || IsDivider(text[-1]));
  }
  return number;
}

//------------------------------------------------------------------------------
template <typename Number>
bool MAPDLRowFormat::ReadToken(const Line& line, int i, Number& value, const char*& place) const
{
  const char* text = line.Begin;
  for (int token = 0;; ++token)
  {
    while (text < line.End && IsDivider(*text))
    {
      ++text;
    }
    const char* const begin = text;
    while (text < line.End && !IsDivider(*text))
    {
      ++text;
    }
    if (begin == text || *begin == '!')
    {
      value = 0;
      return true;
    }
    if (token == i)
    {
      place = begin;
      return ParseToken(begin, text, value);
    }
  }
}

template bool MAPDLRowFormat::ReadToken(const Line&, int, std::int64_t&, const char*&) const;
template bool MAPDLRowFormat::ReadToken(const Line&, int, double&, const char*&) const;

//------------------------------------------------------------------------------
bool MAPDLRowFormat::SetFault(
  const Line& line, int i, const char* place, const char* expected, MAPDLFault& fault) const
{
  fault.Set(place, ErrorKind::Syntax, expected);
  if (this->Columns)
  {
    // In rows that do not match the format, columns may contain parts of numbers.
    const ColumnFormat::Column& column = (*this->Columns)[i];
    const ColumnText text(line.Begin, line.End, column);
    fault.Expected += " in columns " + std::to_string(column.Begin + 1) + " to " +
      std::to_string(column.Begin + column.Width);
    const char* end = text.End;
    while (end > place && IsSpace(end[-1]))
    {
      --end;
    }
    const bool isPlain = std::all_of(place, end, [](char c) { return c >= ' ' && c <= '~'; });
    fault.Found = isPlain ? "'" + std::string(place, end) + "'" : "";
  }
  return false;
}

//------------------------------------------------------------------------------
bool MAPDLNodeFormat::ReadId(const Line& line, std::int32_t& id, MAPDLFault& fault) const
{
  constexpr char Expected[] = "the number of a node from 1 to 2147483647";
  std::int64_t value;
  const char* place;
  if (!this->Fields.Read(line, 0, value, place))
  {
    return this->Fields.SetFault(line, 0, place, Expected, fault);
  }
  if (value < 1 || value > MaxMAPDLId)
  {
    return fault.Set(line.Begin, ErrorKind::Syntax, Expected, std::to_string(value));
  }
  id = static_cast<std::int32_t>(value);
  return true;
}

//------------------------------------------------------------------------------
bool MAPDLNodeFormat::ReadCoordinates(const Line& line, double x[3], MAPDLFault& fault) const
{
  for (int c = 0; c < 3; ++c)
  {
    const char* place;
    const int field = this->FirstCoordinate + c;
    if (!this->Fields.Read(line, field, x[c], place))
    {
      return this->Fields.SetFault(line, field, place, "a coordinate of a node", fault);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
std::int64_t MAPDLElementFormat::PeekType(const Line& line) const
{
  if (this->IsCompact())
  {
    return this->Attributes.Type;
  }
  std::int64_t type = 0;
  const char* place;
  return this->Fields.Read(line, 1, type, place) ? type : 0;
}

//------------------------------------------------------------------------------
int MAPDLElementFormat::PeekNumberOfNodes(const Line& line) const
{
  if (this->IsSolid())
  {
    std::int64_t count = 0;
    const char* place;
    return this->Fields.Read(line, CountField, count, place) && count >= 0 && count <= MaxNodes
      ? static_cast<int>(count)
      : 0;
  }
  return std::max(
    0, this->Fields.CountFields(line, this->FieldsPerLine) - this->GetNumberOfHeaderFields());
}

//------------------------------------------------------------------------------
int MAPDLElementFormat::GetMostNodes(std::int64_t type) const
{
  const auto found = this->MostNodes.find(type);
  return found == this->MostNodes.end() ? 0 : found->second;
}

//------------------------------------------------------------------------------
int MAPDLElementFormat::GetNumberOfFurtherLines(int nodes, std::int64_t type) const
{
  const int first = this->GetNodesOnFirstLine();
  if (this->IsSolid())
  {
    return nodes > first ? (nodes - first + this->FieldsPerLine - 1) / this->FieldsPerLine : 0;
  }
  return nodes < first                 ? 0
    : this->IsCompact()                ? this->FurtherLines
    : this->GetMostNodes(type) > first ? 1
                                       : 0;
}

//------------------------------------------------------------------------------
// Rows without SOLID do not declare their number of nodes. A continuation line has at most the
// number of nodes of the first line, as no element has more than 20.
bool MAPDLElementFormat::CheckEnd(
  const Line& line, const char* end, std::int64_t type, MAPDLFault& fault) const
{
  const int first = this->GetNodesOnFirstLine();
  if (this->IsSolid() || this->IsCompact() || this->PeekNumberOfNodes(line) < first)
  {
    return true;
  }
  const int most = this->GetMostNodes(type);
  const char* const text = SkipBlankMAPDLLines(line.Next, end);
  const bool isRest = text < end &&
    this->Fields.CountFields(Line(text, end), this->FieldsPerLine) <= MaxMAPDLNodes - first;
  if (most > 0)
  {
    // A line without numbers is also a continuation.
    return most <= first || isRest || text != line.Next ||
      fault.Set(
        text, ErrorKind::Count, "the other nodes of an element with up to 20 nodes", "another row");
  }
  return !isRest ||
    fault.Set(line.Begin, ErrorKind::Unsupported,
      "a type that is defined (ET) before the block, as elements with more nodes than fit on a "
      "line continue on the next one",
      "type " + std::to_string(type));
}

//------------------------------------------------------------------------------
bool MAPDLElementFormat::ReadInteger(
  const Line& line, int field, const char* what, std::int32_t& value, MAPDLFault& fault) const
{
  std::int64_t number;
  const char* place;
  if (!this->Fields.Read(line, field, number, place))
  {
    return this->Fields.SetFault(line, field, place, what, fault);
  }
  if (number < -MaxMAPDLId || number > MaxMAPDLId)
  {
    return fault.Set(line.Begin, ErrorKind::Syntax, what, std::to_string(number));
  }
  value = static_cast<std::int32_t>(number);
  return true;
}

//------------------------------------------------------------------------------
bool MAPDLElementFormat::ReadHeader(
  const Line& line, MAPDLElement& element, MAPDLFault& fault) const
{
  bool good;
  if (this->IsSolid())
  {
    good = this->ReadInteger(line, 0, "the material of an element", element.Material, fault) &&
      this->ReadInteger(line, 1, "the type of an element", element.Type, fault) &&
      this->ReadInteger(line, 2, "the real constants of an element", element.Real, fault) &&
      this->ReadInteger(line, 3, "the section of an element", element.Section, fault) &&
      this->ReadInteger(line, SolidIdField, "the number of an element", element.Id, fault);
  }
  else if (this->IsCompact())
  {
    element = this->Attributes;
    good = this->ReadInteger(line, 0, "the number of an element", element.Id, fault);
  }
  else
  {
    good = this->ReadInteger(line, 0, "the number of an element", element.Id, fault) &&
      this->ReadInteger(line, 1, "the type of an element", element.Type, fault) &&
      this->ReadInteger(line, 2, "the real constants of an element", element.Real, fault) &&
      this->ReadInteger(line, 3, "the material of an element", element.Material, fault);
    element.Section = element.Type; // one number for both
  }
  if (good && element.Id < 1)
  {
    return fault.Set(line.Begin, ErrorKind::Syntax, "the number of an element, at least 1",
      std::to_string(element.Id));
  }
  return good;
}

//------------------------------------------------------------------------------
const char* MAPDLElementFormat::ReadNodes(const Line& first, const char* end, int furtherLines,
  MAPDLElement& element, MAPDLFault& fault) const
{
  std::int32_t count = this->PeekNumberOfNodes(first);
  if (this->IsSolid())
  {
    std::int32_t written = 0;
    if (!this->ReadInteger(first, CountField, "the number of nodes of an element", written, fault))
    {
      return nullptr;
    }
    if (written != count)
    {
      fault.Set(first.Begin, ErrorKind::Count, "the number of nodes of an element from 0 to 1000",
        std::to_string(written));
      return nullptr;
    }
  }
  const auto read = [&](const Line& line, int field, int fields)
  {
    for (; field < fields && element.NumberOfNodes < count; ++field)
    {
      std::int32_t node;
      if (!this->ReadInteger(line, field, "a node of an element", node, fault))
      {
        return false;
      }
      if (element.NumberOfNodes < MaxMAPDLNodes)
      {
        element.Nodes[element.NumberOfNodes] = node;
      }
      ++element.NumberOfNodes;
    }
    return true;
  };
  element.NumberOfNodes = 0;
  const char* next = first.Next;
  if (!read(first, this->GetNumberOfHeaderFields(), this->FieldsPerLine))
  {
    return nullptr;
  }
  while (furtherLines > 0)
  {
    if (next == end)
    {
      fault.Set(next, ErrorKind::Truncated, "more nodes of an element");
      return nullptr;
    }
    const Line line(next, end);
    next = line.Next;
    const char* const text = SkipBlanks(line.Begin, line.End);
    if (text < line.End && *text == '!')
    {
      continue;
    }
    int fields = this->FieldsPerLine;
    if (!this->IsSolid())
    {
      fields = this->Fields.CountFields(line, fields);
      count += fields;
    }
    if (this->IsCompact() && furtherLines > 1 && fields < this->FieldsPerLine)
    {
      fault.Set(line.Begin, ErrorKind::Count,
        "a full line, as the element continues on the next one", std::to_string(fields) + " nodes");
      return nullptr;
    }
    if (!read(line, 0, fields))
    {
      return nullptr;
    }
    --furtherLines;
  }
  element.NumberOfNodes = std::min<std::int32_t>(element.NumberOfNodes, MaxMAPDLNodes);
  return next;
}
}
