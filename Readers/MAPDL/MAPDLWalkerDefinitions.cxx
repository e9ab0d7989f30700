// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MAPDLWalker.h"

#include <algorithm>

namespace camaron
{
namespace
{
using Value = MAPDLParameters::Value;

//------------------------------------------------------------------------------
// Number in the name of an element: 185 in SOLID185, or the whole name.
int GetElementNumber(std::string_view name)
{
  std::size_t digits = name.size();
  while (digits > 0 && IsDigit(name[digits - 1]))
  {
    --digits;
  }
  std::int64_t number = 0;
  ParseInteger(name.data() + digits, name.data() + name.size(), number);
  constexpr std::int64_t Max = 100000; // far beyond any element
  return static_cast<int>(std::min(number, Max));
}

//------------------------------------------------------------------------------
// The block to which a command adds a row: the last one, if commands have begun it.
template <typename Block>
Block& GetCommandBlock(std::vector<Block>& blocks, std::size_t next)
{
  if (blocks.empty() || blocks.back().NumberOfCommands == 0)
  {
    blocks.emplace_back();
    blocks.back().FirstCommand = static_cast<vtkIdType>(next);
  }
  return blocks.back();
}
}

//------------------------------------------------------------------------------
bool MAPDLWalker::DefineType()
{
  std::int32_t type = 0, element = 0;
  switch (this->ReadField(1, type))
  {
    case Value::Unknown:
      return true;
    case Value::Absent:
      type = this->Deck.Types.empty()
        ? 1
        : static_cast<std::int32_t>(this->Deck.Types.rbegin()->first) + 1;
      [[fallthrough]];
    default:
      break;
  }
  const std::string_view name = this->Command.GetField(2);
  if (this->Parameters.Read(name, element) != Value::Number)
  {
    element = GetElementNumber(name);
  }
  std::int32_t shape = 0;
  this->ReadField(3, shape);
  this->Deck.Types[type] = { element, shape };
  return true;
}

//------------------------------------------------------------------------------
bool MAPDLWalker::DefineKeyOption()
{
  std::int32_t type = 0, key = 0, value = 0;
  if (this->Depth == 0 && this->ReadField(1, type) == Value::Number &&
    this->ReadField(2, key) == Value::Number && key == 1 &&
    this->Parameters.Read(this->Command.GetField(3), value) != Value::Unknown)
  {
    this->Deck.Types[type].Shape = value;
  }
  return true;
}

//------------------------------------------------------------------------------
// Number for a node or element without one, after the greatest so far.
template <typename Block>
std::int32_t MAPDLWalker::GetNext(
  const std::vector<Block>& blocks, std::size_t& known, std::int32_t& greatest)
{
  for (; known < blocks.size(); ++known)
  {
    MAPDLFault fault; // found again and reported when the block is read
    blocks[known].ForEachRow(
      fault, [&greatest](const auto& item) { greatest = std::max(greatest, item.Id); });
  }
  return greatest < MaxMAPDLId ? greatest + 1 : MaxMAPDLId;
}

//------------------------------------------------------------------------------
std::int32_t MAPDLWalker::GetNextNode()
{
  return GetNext(this->Deck.NodeBlocks, this->KnownNodeBlocks, this->GreatestNode);
}

//------------------------------------------------------------------------------
std::int32_t MAPDLWalker::GetNextElement()
{
  return GetNext(this->Deck.ElementBlocks, this->KnownElementBlocks, this->GreatestElement);
}

//------------------------------------------------------------------------------
bool MAPDLWalker::DefineNode()
{
  const std::string_view first = this->Command.GetField(1);
  std::int32_t id = 0;
  // The program writes nodes without blocks as N,R5.3,LOC,id,solid,place,x,y,z; id -1 ends them.
  if (!first.empty() &&
    (first[0] == 'R' || first[0] == 'r' || first[0] == 'U' || first[0] == 'u') &&
    this->Parameters.Read(first, id) == Value::Unknown)
  {
    constexpr std::size_t IdField = 3, CoordinateField = 6;
    const bool isPlace = ToUpperMAPDL(this->Command.GetField(2)) == "LOC";
    return !isPlace || this->ReadField(IdField, id) != Value::Number || id == -1 ||
      this->AddNode(id, CoordinateField);
  }
  switch (this->ReadField(1, id))
  {
    case Value::Unknown:
      this->NextNodeIsKnown = false;
      return true;
    case Value::Absent:
      if (!this->NextNodeIsKnown)
      {
        ++this->Deck.NumberOfUnknownParameters;
        return true;
      }
      id = this->GetNextNode();
      [[fallthrough]];
    default:
      this->Deck.NumberOfTurnedNodes += !this->IsGlobal;
      return this->AddNode(id, 2);
  }
}

//------------------------------------------------------------------------------
bool MAPDLWalker::AddNode(std::int32_t id, std::size_t firstCoordinate)
{
  if (id < 1)
  {
    return this->Fault.Set(this->LineBegin, ErrorKind::Syntax,
      "the number of a node from 1 to 2147483647", std::to_string(id));
  }
  this->GreatestNode = std::max(this->GreatestNode, id); // including nodes that are left out
  MAPDLNode node;
  node.Id = id;
  for (std::size_t c = 0; c < 3; ++c)
  {
    node.X[c] = 0;
    const std::string_view field = this->Command.GetField(firstCoordinate + c);
    const char* const end = field.data() + field.size();
    if (this->Parameters.Read(field, node.X[c]) == Value::Unknown &&
      ParseReal(field.data(), end, node.X[c]) != end) // nan, inf
    {
      // Parameters and expressions may have values in the program; anything else is an error.
      ++this->Deck.NumberOfUnknownParameters;
      this->Deck.SkippedNodes.insert(id);
      return IsMAPDLExpression(field) ||
        this->Fault.Set(field.data(), ErrorKind::Syntax, "a coordinate of a node");
    }
  }
  ++GetCommandBlock(this->Deck.NodeBlocks, this->Deck.Nodes.size()).NumberOfCommands;
  this->Deck.Nodes.push_back(node);
  return true;
}

//------------------------------------------------------------------------------
bool MAPDLWalker::DefineElement()
{
  return this->AddElement(this->GetNextElement()) && this->AddElementNodes(1);
}

//------------------------------------------------------------------------------
bool MAPDLWalker::DefineNumberedElement()
{
  const std::string_view first = this->Command.GetField(1);
  std::int32_t id = 0;
  if (!first.empty() && this->Parameters.Read(first, id) == Value::Unknown &&
    (ToUpperMAPDL(first) == "UNBL" || first[0] == 'R' || first[0] == 'r'))
  {
    return this->DefineUnblockedElement();
  }
  this->ElementIsOpen = false;
  const Value kind = this->ReadField(1, id);
  return kind == Value::Unknown ||
    (this->AddElement(kind == Value::Absent ? this->GetNextElement() : id) &&
      this->AddElementNodes(2));
}

//------------------------------------------------------------------------------
// The program writes elements without blocks as EN,R5.5,ATTR,number of nodes,material,type,real,
// section,system,id and EN,R5.5,NODE,nodes.
bool MAPDLWalker::DefineUnblockedElement()
{
  const std::string kind = ToUpperMAPDL(this->Command.GetField(2));
  if (kind == "NODE")
  {
    return !this->ElementIsOpen || this->AddElementNodes(3);
  }
  this->ElementIsOpen = false;
  std::int32_t number = -1, id = 0;
  if (kind != "ATTR" || this->ReadField(3, number) != Value::Number || number == -1)
  {
    return true;
  }
  const MAPDLElement before = this->Current;
  this->ReadField(4, this->Current.Material);
  this->ReadField(5, this->Current.Type);
  this->ReadField(6, this->Current.Real);
  this->ReadField(7, this->Current.Section);
  constexpr std::size_t IdField = 9;
  this->ReadField(IdField, id);
  this->AttributesChanged = true;
  const bool good = this->AddElement(id);
  this->Current = before;
  this->AttributesChanged = true;
  return good;
}

//------------------------------------------------------------------------------
bool MAPDLWalker::ContinueElement()
{
  return !this->ElementIsOpen || this->AddElementNodes(1);
}

//------------------------------------------------------------------------------
bool MAPDLWalker::AddElement(std::int32_t id)
{
  if (id < 1)
  {
    return this->Fault.Set(this->LineBegin, ErrorKind::Syntax,
      "the number of an element, at least 1", std::to_string(id));
  }
  if (this->AttributesChanged)
  {
    this->Deck.Attributes.push_back(this->Current);
    this->AttributesChanged = false;
  }
  this->GreatestElement = std::max(this->GreatestElement, id);
  ++GetCommandBlock(this->Deck.ElementBlocks, this->Deck.Elements.size()).NumberOfCommands;
  this->Deck.Elements.push_back({ id, static_cast<std::int32_t>(this->Deck.Attributes.size()) - 1,
    static_cast<vtkIdType>(this->Deck.ElementNodes.size()), this->LineBegin });
  this->ElementIsOpen = true;
  this->ElementLines = 0;
  return true;
}

//------------------------------------------------------------------------------
bool MAPDLWalker::AddElementNodes(std::size_t firstField)
{
  MAPDLDeck& deck = this->Deck;
  const auto last = static_cast<vtkIdType>(deck.Elements.size()) - 1;
  constexpr int NodesPerLine = 8;
  for (vtkIdType i = deck.GetNumberOfNodes(last);
    i < std::min(NodesPerLine * this->ElementLines, MaxMAPDLNodes); ++i)
  {
    deck.ElementNodes.push_back(0); // trailing nodes omitted on the lines before
  }
  ++this->ElementLines;
  std::size_t fields = this->Command.GetNumberOfFields();
  while (fields > firstField && this->Command.GetField(fields - 1).empty())
  {
    --fields;
  }
  for (std::size_t i = firstField; i < fields && deck.GetNumberOfNodes(last) < MaxMAPDLNodes; ++i)
  {
    std::int32_t node = 0;
    if (this->ReadField(i, node) == Value::Unknown)
    {
      // The element is left out.
      deck.ElementNodes.resize(deck.Elements.back().FirstNode);
      deck.Elements.pop_back();
      this->ElementIsOpen = false;
      if (--deck.ElementBlocks.back().NumberOfCommands == 0)
      {
        deck.ElementBlocks.pop_back();
      }
      const std::string_view field = this->Command.GetField(i);
      return IsMAPDLExpression(field) ||
        this->Fault.Set(field.data(), ErrorKind::Syntax, "a node of an element");
    }
    deck.ElementNodes.push_back(node);
  }
  return true;
}
}
