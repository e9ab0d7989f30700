// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MAPDLRows.h"

#include <algorithm>

namespace camaron
{
namespace
{
// Fields of rows with the key SOLID.
constexpr int CountField = 8; // number of nodes
constexpr int SolidIdField = 10;
// Beyond any element; a row that declares more is damaged, and treated as one without nodes until
// it is read.
constexpr std::int64_t MaxNodes = 1000;
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
    return line.End - text >= 2 && text[1] == '1' &&
        (next == line.End || IsSpace(*next) || *next == ',')
      ? MAPDLLine::End
      : MAPDLLine::Row;
  }
  const bool isCommand = (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '/' || c == '*' ||
    c == '_' || c == '~' || c == '$' || c == ':';
  return isCommand ? MAPDLLine::Command : MAPDLLine::Row;
}

//------------------------------------------------------------------------------
int MAPDLRowFormat::CountIntegers(const Line& line) const
{
  const char* end = line.End;
  while (end > line.Begin && IsSpace(end[-1]))
  {
    --end;
  }
  int number = 0;
  while (number < this->Integers && this->Columns[number].Begin < end - line.Begin)
  {
    ++number;
  }
  return number;
}

//------------------------------------------------------------------------------
// In rows that do not match the format, columns may contain parts of numbers.
bool MAPDLRowFormat::Fail(const ColumnText& text, int i, const char* what, MAPDLFault& fault) const
{
  const ColumnFormat::Column& column = this->Columns[i];
  const char* const place = SkipBlanks(text.Begin, text.End);
  const char* end = text.End;
  while (end > place && IsSpace(end[-1]))
  {
    --end;
  }
  const bool isPlain = std::all_of(place, end, [](char c) { return c >= ' ' && c <= '~'; });
  return fault.Set(place, ErrorKind::Syntax,
    std::string(what) + " in columns " + std::to_string(column.Begin + 1) + " to " +
      std::to_string(column.Begin + column.Width),
    isPlain ? "'" + std::string(place, end) + "'" : "");
}

//------------------------------------------------------------------------------
bool MAPDLRowFormat::ReadInteger(const Line& line, int i, const char* what, std::int32_t& value,
  MAPDLFault& fault, std::int32_t least) const
{
  std::int64_t number;
  if (!this->Read(line, i, what, number, fault))
  {
    return false;
  }
  value = static_cast<std::int32_t>(number);
  return (number >= least && number <= MaxMAPDLId) ||
    fault.Set(line.Begin, ErrorKind::Syntax, what, std::to_string(number));
}

//------------------------------------------------------------------------------
bool MAPDLNodeFormat::ReadId(const Line& line, std::int32_t& id, MAPDLFault& fault) const
{
  return this->Fields.ReadInteger(
    line, 0, "the number of a node from 1 to 2147483647", id, fault, 1);
}

//------------------------------------------------------------------------------
bool MAPDLNodeFormat::ReadPoint(const Line& line, double x[3], MAPDLFault& fault) const
{
  constexpr char Coordinate[] = "a coordinate of a node";
  const int first = this->Fields.GetNumberOfIntegers();
  return this->Fields.Read(line, first, Coordinate, x[0], fault) &&
    this->Fields.Read(line, first + 1, Coordinate, x[1], fault) &&
    this->Fields.Read(line, first + 2, Coordinate, x[2], fault);
}

//------------------------------------------------------------------------------
// Of a row with the key SOLID; 0 if it is damaged.
std::int64_t MAPDLElementFormat::GetDeclaredNodes(const Line& line) const
{
  MAPDLFault fault; // reported when the row is read
  std::int64_t count = 0;
  const bool good = this->Fields.Read(line, CountField, "", count, fault);
  return good && count >= 0 && count <= MaxNodes ? count : 0;
}

//------------------------------------------------------------------------------
int MAPDLElementFormat::GetNumberOfFurtherLines(const Line& line) const
{
  if (this->Key != MAPDLElementKey::Solid)
  {
    return this->FurtherLines;
  }
  const int perLine = this->Fields.GetNumberOfIntegers();
  const auto rest = static_cast<int>(this->GetDeclaredNodes(line)) - this->GetNodesOnFirstLine();
  return rest > 0 ? (rest + perLine - 1) / perLine : 0;
}

//------------------------------------------------------------------------------
bool MAPDLElementFormat::ReadHeader(
  const Line& line, MAPDLElement& element, MAPDLFault& fault) const
{
  constexpr char Id[] = "the number of an element, at least 1", Type[] = "the type of an element",
                 Material[] = "the material of an element",
                 Real[] = "the real constants of an element";
  const MAPDLRowFormat& fields = this->Fields;
  switch (this->Key)
  {
    case MAPDLElementKey::Solid:
      return fields.ReadInteger(line, 0, Material, element.Material, fault) &&
        fields.ReadInteger(line, 1, Type, element.Type, fault) &&
        fields.ReadInteger(line, 2, Real, element.Real, fault) &&
        fields.ReadInteger(line, 3, "the section of an element", element.Section, fault) &&
        fields.ReadInteger(line, SolidIdField, Id, element.Id, fault, 1);
    case MAPDLElementKey::Compact:
      element = this->Attributes;
      return fields.ReadInteger(line, 0, Id, element.Id, fault, 1);
    default:
      if (!fields.ReadInteger(line, 0, Id, element.Id, fault, 1) ||
        !fields.ReadInteger(line, 1, Type, element.Type, fault) ||
        !fields.ReadInteger(line, 2, Real, element.Real, fault) ||
        !fields.ReadInteger(line, 3, Material, element.Material, fault))
      {
        return false;
      }
      element.Section = element.Type; // one number for both
      return true;
  }
}

//------------------------------------------------------------------------------
const char* MAPDLElementFormat::Read(
  const Line& first, const char* end, MAPDLElement& element, MAPDLFault& fault) const
{
  if (!this->ReadHeader(first, element, fault))
  {
    return nullptr;
  }
  const bool isSolid = this->Key == MAPDLElementKey::Solid;
  std::int32_t declared = 0;
  if (isSolid)
  {
    constexpr char Count[] = "the number of nodes of an element from 0 to 1000";
    if (!this->Fields.ReadInteger(first, CountField, Count, declared, fault, 0))
    {
      return nullptr;
    }
    if (declared > MaxNodes)
    {
      fault.Set(first.Begin, ErrorKind::Count, Count, std::to_string(declared));
      return nullptr;
    }
  }
  element.NumberOfNodes = 0;
  // A line without a declared number of nodes ends with the last one.
  const auto read = [&](const Line& line, int field, bool isLast)
  {
    const int fields =
      isLast && !isSolid ? this->Fields.CountIntegers(line) : this->Fields.GetNumberOfIntegers();
    for (; field < fields && (!isSolid || element.NumberOfNodes < declared); ++field)
    {
      std::int32_t node;
      if (!this->Fields.ReadInteger(line, field, "a node of an element", node, fault))
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
  int furtherLines = this->GetNumberOfFurtherLines(first);
  if (!read(first, this->GetNumberOfHeaderFields(), furtherLines == 0))
  {
    return nullptr;
  }
  const char* next = first.Next;
  while (furtherLines > 0)
  {
    if (next == end)
    {
      fault.Set(next, ErrorKind::Truncated, "more nodes of an element");
      return nullptr;
    }
    const Line line(next, end);
    next = line.Next;
    if (ContinuesMAPDLRow(line))
    {
      --furtherLines;
      if (!read(line, 0, furtherLines == 0))
      {
        return nullptr;
      }
    }
  }
  element.NumberOfNodes = std::min<std::int32_t>(element.NumberOfNodes, MaxMAPDLNodes);
  return next;
}
}
