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
}

//------------------------------------------------------------------------------
void MAPDLWalker::DefineType()
{
  std::int32_t type = 0, element = 0;
  const Value kind = this->Parameters.Read(this->Command.GetField(1), type);
  if (kind == Value::Unknown)
  {
    // ETCON,SET and the like are other commands; a parameter of unknown value is not.
    ++this->Deck.NumberOfUnknownParameters;
    return;
  }
  if (kind == Value::Absent)
  {
    type = this->Deck.Types.empty()
      ? 1
      : static_cast<std::int32_t>(this->Deck.Types.rbegin()->first) + 1;
  }
  const std::string_view name = this->Command.GetField(2);
  if (this->Parameters.Read(name, element) != Value::Number)
  {
    element = GetElementNumber(name);
  }
  std::int32_t shape = 0;
  this->ReadField(3, shape);
  this->Deck.Types[type] = { element, shape };
}

//------------------------------------------------------------------------------
void MAPDLWalker::DefineKeyOption()
{
  std::int32_t type = 0, key = 0, value = 0;
  if (this->ReadField(1, type) == Value::Number && this->ReadField(2, key) == Value::Number &&
    key == 1 && this->Parameters.Read(this->Command.GetField(3), value) != Value::Unknown)
  {
    this->Deck.Types[type].Shape = value;
  }
}

//------------------------------------------------------------------------------
void MAPDLWalker::SetAttribute(std::int32_t MAPDLElement::* attribute)
{
  std::int32_t value = 1;
  if (this->ReadField(1, value) != Value::Unknown)
  {
    this->AttributesChanged = true;
    this->Current.*attribute = value;
  }
}

//------------------------------------------------------------------------------
std::int32_t MAPDLWalker::GetNextNode()
{
  for (; this->KnownNodeBlocks < this->Deck.NodeBlocks.size(); ++this->KnownNodeBlocks)
  {
    const MAPDLNodeBlock& block = this->Deck.NodeBlocks[this->KnownNodeBlocks];
    ForEachMAPDLNode(block.Extent,
      [&](const Line& line, vtkIdType)
      {
        MAPDLFault fault; // found again and reported when the block is read
        std::int32_t id;
        if (block.Format.ReadId(line, id, fault))
        {
          this->GreatestNode = std::max(this->GreatestNode, id);
        }
        return true;
      });
  }
  return this->GreatestNode < INT32_MAX ? this->GreatestNode + 1 : INT32_MAX;
}

//------------------------------------------------------------------------------
std::int32_t MAPDLWalker::GetNextElement()
{
  for (; this->KnownElementBlocks < this->Deck.ElementBlocks.size(); ++this->KnownElementBlocks)
  {
    const MAPDLElementBlock& block = this->Deck.ElementBlocks[this->KnownElementBlocks];
    for (std::size_t chunk = 0; chunk < block.Extent.Chunks.size(); ++chunk)
    {
      MAPDLFault fault;
      ForEachMAPDLElement(block.Format, block.Extent, chunk, false, fault,
        [this](const Line&, vtkIdType, const MAPDLElement& element)
        {
          this->GreatestElement = std::max(this->GreatestElement, element.Id);
          return true;
        });
    }
  }
  return this->GreatestElement < INT32_MAX ? this->GreatestElement + 1 : INT32_MAX;
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
      this->Deck.NumberOfTurnedNodes += this->CoordinateSystem != 0;
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
    if (this->Parameters.Read(field, node.X[c]) == Value::Unknown)
    {
      // Parameters and expressions may have values in the program; anything else is an error.
      const bool isName =
        ClassifyMAPDLLine(Line(field.data(), field.data() + field.size())) == MAPDLLine::Command;
      if (!isName && !IsMAPDLExpression(field))
      {
        return this->Fault.Set(field.data(), ErrorKind::Syntax, "a coordinate of a node");
      }
      const char* const end = field.data() + field.size();
      if (ParseReal(field.data(), end, node.X[c]) != end) // nan, inf
      {
        ++this->Deck.NumberOfUnknownParameters;
        this->Deck.SkippedNodes.insert(id);
        return true;
      }
    }
  }
  std::vector<MAPDLNodeBlock>& blocks = this->Deck.NodeBlocks;
  if (blocks.empty() || blocks.back().NumberOfCommands == 0)
  {
    blocks.emplace_back();
    blocks.back().FirstCommand = static_cast<vtkIdType>(this->Deck.Nodes.size());
  }
  ++blocks.back().NumberOfCommands;
  this->Deck.Nodes.push_back(node);
  return true;
}

//------------------------------------------------------------------------------
bool MAPDLWalker::DefineElement(bool isNumbered)
{
  const std::string_view first = this->Command.GetField(1);
  std::int32_t id = 0;
  // The program writes elements without blocks as EN,R5.5,ATTR,number of nodes,material,type,real,
  // section,system,id and EN,R5.5,NODE,nodes.
  if (isNumbered && !first.empty() && !IsDigit(first[0]) &&
    this->Parameters.Read(first, id) == Value::Unknown &&
    (ToUpperMAPDL(first) == "UNBL" || first[0] == 'R' || first[0] == 'r'))
  {
    const std::string kind = ToUpperMAPDL(this->Command.GetField(2));
    if (kind == "NODE")
    {
      return !this->ElementIsOpen || this->AddElementNodes(3);
    }
    this->ElementIsOpen = false;
    std::int32_t number = -1;
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
    if (id >= 1)
    {
      this->AddElement(id);
    }
    this->Current = before;
    this->AttributesChanged = true;
    return id >= 1 ||
      this->Fault.Set(this->LineBegin, ErrorKind::Syntax, "the number of an element, at least 1",
        std::to_string(id));
  }
  this->ElementIsOpen = false;
  if (isNumbered)
  {
    const Value kind = this->ReadField(1, id);
    if (kind == Value::Unknown)
    {
      return true;
    }
    if (kind == Value::Number && id < 1)
    {
      return this->Fault.Set(this->LineBegin, ErrorKind::Syntax,
        "the number of an element, at least 1", std::to_string(id));
    }
  }
  this->AddElement(id > 0 ? id : this->GetNextElement());
  return this->AddElementNodes(isNumbered ? 2 : 1);
}

//------------------------------------------------------------------------------
void MAPDLWalker::AddElement(std::int32_t id)
{
  if (this->AttributesChanged)
  {
    this->Deck.Attributes.push_back(this->Current);
    this->AttributesChanged = false;
  }
  this->GreatestElement = std::max(this->GreatestElement, id);
  std::vector<MAPDLElementBlock>& blocks = this->Deck.ElementBlocks;
  if (blocks.empty() || blocks.back().NumberOfCommands == 0)
  {
    blocks.emplace_back();
    blocks.back().FirstCommand = static_cast<vtkIdType>(this->Deck.Elements.size());
  }
  ++blocks.back().NumberOfCommands;
  this->Deck.Elements.push_back({ id, static_cast<std::int32_t>(this->Deck.Attributes.size()) - 1,
    static_cast<vtkIdType>(this->Deck.ElementNodes.size()), this->LineBegin });
  this->ElementIsOpen = true;
  this->ElementLines = 0;
}

//------------------------------------------------------------------------------
bool MAPDLWalker::AddElementNodes(std::size_t firstField)
{
  const auto last = static_cast<vtkIdType>(this->Deck.Elements.size()) - 1;
  constexpr int NodesPerLine = 8;
  for (vtkIdType i = this->Deck.GetNumberOfNodes(last);
    i < std::min(NodesPerLine * this->ElementLines, MaxMAPDLNodes); ++i)
  {
    this->Deck.ElementNodes.push_back(0); // trailing nodes omitted on the lines before
  }
  ++this->ElementLines;
  std::size_t fields = this->Command.GetNumberOfFields();
  while (fields > firstField && this->Command.GetField(fields - 1).empty())
  {
    --fields;
  }
  for (std::size_t i = firstField; i < fields && this->Deck.GetNumberOfNodes(last) < MaxMAPDLNodes;
    ++i)
  {
    std::int32_t node = 0;
    const std::string_view field = this->Command.GetField(i);
    const Value kind = this->ReadField(i, node);
    const bool isName = !field.empty() &&
      ClassifyMAPDLLine(Line(field.data(), field.data() + field.size())) == MAPDLLine::Command;
    if (kind == Value::Unknown && !isName && !IsMAPDLExpression(field))
    {
      return this->Fault.Set(field.data(), ErrorKind::Syntax, "a node of an element");
    }
    if (kind == Value::Unknown)
    {
      // The element is left out.
      MAPDLElementBlock& block = this->Deck.ElementBlocks.back();
      --block.NumberOfCommands;
      this->Deck.ElementNodes.resize(this->Deck.Elements.back().FirstNode);
      this->Deck.Elements.pop_back();
      this->ElementIsOpen = false;
      if (block.NumberOfCommands == 0)
      {
        this->Deck.ElementBlocks.pop_back();
      }
      return true;
    }
    this->Deck.ElementNodes.push_back(node);
  }
  return true;
}
}
