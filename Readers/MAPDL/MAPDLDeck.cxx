// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MAPDLDeck.h"

#include "MAPDLCommands.h"

#include <algorithm>
#include <cstring>

namespace camaron
{
namespace
{
using Value = MAPDLParameters::Value;

constexpr std::ptrdiff_t Enough = 1 << 18; // parameters and materials may come first

//------------------------------------------------------------------------------
// Whether a line, from its first field on, is a comment or keyword of Abaqus.
bool IsOfAbaqus(const char* field, const char* end)
{
  constexpr std::string_view Keywords[] = { "*HEADING", "*NODE", "*ELEMENT", "*PART", "*ASSEMBLY",
    "*MATERIAL", "*STEP", "*INCLUDE", "*PREPRINT", "*NSET", "*ELSET" };
  if (end - field < 2 || field[0] != '*')
  {
    return false;
  }
  const auto isEnd = [](char c) { return c == ',' || IsSpace(c); };
  const std::string word = ToUpperMAPDL(
    std::string_view(field, static_cast<std::size_t>(std::find_if(field, end, isEnd) - field)));
  return field[1] == '*' ||
    std::find(std::begin(Keywords), std::end(Keywords), word) != std::end(Keywords);
}
}

//------------------------------------------------------------------------------
MAPDLElement MAPDLDeck::GetElement(vtkIdType i) const
{
  const Element& from = this->Elements[i];
  MAPDLElement element = this->Attributes[from.Attributes];
  element.Id = from.Id;
  element.NumberOfNodes = static_cast<std::int32_t>(this->GetNumberOfNodes(i));
  for (std::int32_t node = 0; node < element.NumberOfNodes; ++node)
  {
    element.Nodes[node] = this->ElementNodes[from.FirstNode + node];
  }
  return element;
}

//------------------------------------------------------------------------------
std::string MAPDLDeck::GetReasonForMissing(std::int32_t node) const
{
  if (this->SkippedNodes.count(node) > 0)
  {
    return ", which is omitted because its N command needs a parameter of unknown value";
  }
  constexpr const char* NodeCommands[] = { "N", "NBLOCK", "FILL", "NGEN", "NSYM", "NSCALE",
    "TRANSFER", "AMESH", "LMESH", "VMESH", "VSWEEP", "ESURF", "SWGEN", "CDREAD", "/INPUT",
    "*REPEAT" };
  std::string names;
  for (const char* name : NodeCommands)
  {
    if (this->Ignored.Names.count(name) + this->Skipped.Names.count(name) > 0)
    {
      names += (names.empty() ? "" : ", ") + std::string(name);
    }
  }
  if (this->NumberOfUnknownParameters > static_cast<vtkIdType>(this->SkippedNodes.size()))
  {
    names += (names.empty() ? "" : ", ") + std::string("commands with parameters of unknown value");
  }
  return node == 0 || names.empty()
    ? ""
    : ", which may be defined by commands that are not executed: " + names;
}

//------------------------------------------------------------------------------
bool LooksLikeAbaqus(const char* begin, const char* end)
{
  end = std::min(end, begin + std::min(Enough, end - begin));
  for (const char* text = begin; text < end;)
  {
    const Line line(text, end);
    text = line.Next;
    if (IsOfAbaqus(SkipBlanks(line.Begin, line.End), line.End))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool LooksLikeMAPDL(const char* begin, const char* end)
{
  const bool isAll = end - begin <= Enough;
  end = isAll ? end : begin + Enough;
  if (std::memchr(begin, '\0', std::min<std::ptrdiff_t>(end - begin, 4096)))
  {
    return false;
  }
  const MAPDLParameters parameters;
  bool hasHint = false;
  MAPDLCommand command;
  for (const char* text = begin; text < end;)
  {
    const Line line(text, end);
    text = line.Next;
    const char* field = SkipBlanks(line.Begin, line.End);
    if (IsOfAbaqus(field, line.End))
    {
      return false;
    }
    if (ClassifyMAPDLLine(line) != MAPDLLine::Command || !command.Take(field, line.End))
    {
      continue;
    }
    double number;
    if (command.Is("NBLOCK"))
    {
      return true;
    }
    if (command.Is("N") && (command.GetNumberOfFields() > 2 || hasHint))
    {
      const bool hasId = parameters.Read(command.GetField(1), number) == Value::Number;
      const std::string kind = ToUpperMAPDL(command.GetField(2));
      if (kind == "LOC" || (hasId && parameters.Read(kind, number) != Value::Unknown))
      {
        return true;
      }
    }
    hasHint = hasHint || command.Is("/PREP7") || command.Is("EBLOCK") ||
      (command.Is("ET") && parameters.Read(command.GetField(1), number) == Value::Number);
  }
  return hasHint && !isAll;
}
}
