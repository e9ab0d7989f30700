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
  std::set<std::string> names = this->Ignored.Names;
  names.insert(this->Skipped.Names.begin(), this->Skipped.Names.end());
  if (this->NumberOfUnknownParameters > static_cast<vtkIdType>(this->SkippedNodes.size()))
  {
    names.insert("commands with parameters of unknown value");
  }
  return node == 0 || names.empty()
    ? ""
    : ", which may be defined by commands that are not executed: " + JoinMAPDLNames(names);
}

//------------------------------------------------------------------------------
std::string JoinMAPDLNames(const std::set<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

//------------------------------------------------------------------------------
MAPDLGuess GuessMAPDL(const char* begin, const char* end)
{
  constexpr std::ptrdiff_t Enough = 1 << 18; // parameters and materials may come first
  const bool isAll = end - begin <= Enough;
  end = isAll ? end : begin + Enough;
  if (std::memchr(begin, '\0', std::min<std::ptrdiff_t>(end - begin, 4096)))
  {
    return MAPDLGuess::Other;
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
      return MAPDLGuess::Abaqus;
    }
    if (ClassifyMAPDLLine(line) != MAPDLLine::Command || !command.Take(field, line.End))
    {
      continue;
    }
    double number;
    if (command.Is("NBLOCK"))
    {
      return MAPDLGuess::Deck;
    }
    if (command.Is("N") && (command.GetNumberOfFields() > 2 || hasHint))
    {
      const bool hasId = parameters.Read(command.GetField(1), number) == Value::Number;
      const std::string kind = ToUpperMAPDL(command.GetField(2));
      if (kind == "LOC" || (hasId && parameters.Read(kind, number) != Value::Unknown))
      {
        return MAPDLGuess::Deck;
      }
    }
    hasHint = hasHint || command.Is("/PREP7") || command.Is("EBLOCK") ||
      (command.Is("ET") && parameters.Read(command.GetField(1), number) == Value::Number);
  }
  return hasHint && !isAll ? MAPDLGuess::Deck : MAPDLGuess::Other;
}
}
