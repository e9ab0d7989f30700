// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MAPDLWalker.h"

#include <array>
#include <utility>

namespace camaron
{
namespace
{
using Value = MAPDLParameters::Value;

// Commands that define or clear a mesh, or define the elements of commands after them.
constexpr const char* DefiningCommands[] = { "N", "E", "EN", "NBLOCK", "EBLOCK", "CMBLOCK", "ET",
  "ETBLOCK", "TYPE", "MAT", "REAL", "SECNUM", "/CLEAR" };
// Commands that create, move or delete nodes and elements by rules of the program.
constexpr const char* MeshCommands[] = { "/INPUT", "AMESH", "CDREAD", "EDELE", "EGEN", "EINTF",
  "EMODIF", "ENGEN", "ENSYM", "ESURF", "ESYM", "FILL", "LMESH", "NDELE", "NGEN", "NMODIF", "NSCALE",
  "NSYM", "NUMMRG", "NUMCMP", "SWGEN", "TRANSFER", "VMESH", "VSWEEP" };
// Commands that define a coordinate system and activate it for later nodes.
constexpr const char* SystemCommands[] = { "LOCAL", "CLOCAL", "CS", "CSKP", "CSWPLA" };
}

//------------------------------------------------------------------------------
bool MAPDLWalker::Walk()
{
  constexpr int LinesPerReport = 4096;
  int lines = 0;
  while (this->Text < this->End && !this->Ended)
  {
    const Line line(this->Text, this->End);
    this->LineBegin = line.Begin;
    this->Text = line.Next;
    if (++lines == LinesPerReport)
    {
      lines = 0;
      if (!this->Report.Report(this->GetProgress(this->Text)))
      {
        return false;
      }
    }
    if (ClassifyMAPDLLine(line) != MAPDLLine::Command)
    {
      continue; // data of blocks without mesh
    }
    for (const char* text = line.Begin; this->Command.Take(text, line.End) && !this->Ended;)
    {
      if (!(this->Depth > 0 ? this->ExecuteInBranch() : this->Execute()))
      {
        return false;
      }
    }
  }
  return !this->Report.IsStopped();
}

//------------------------------------------------------------------------------
template <typename Names>
void MAPDLWalker::NoteSkipped(const Names& names, MAPDLSkipped& skipped)
{
  for (const char* name : names)
  {
    // The coordinate system of an element is irrelevant here.
    if (this->Command.Is(name) && ToUpperMAPDL(this->Command.GetField(2)) != "ESYS")
    {
      ++skipped.Number;
      skipped.Names.insert(name);
    }
  }
}

//------------------------------------------------------------------------------
// The effect of branches and loops depends on more than the deck; they rarely define a mesh.
bool MAPDLWalker::ExecuteInBranch()
{
  const MAPDLCommand& command = this->Command;
  std::string_view value;
  if (command.Is("*ENDIF") || command.Is("*ENDDO") || command.Is("*END"))
  {
    --this->Depth;
  }
  else if (command.Is("*DO") || command.Is("*DOWHILE") || command.Is("*CREATE") ||
    command.Is("*IF"))
  {
    if (command.Is("*DO"))
    {
      this->Parameters.Set(command.GetField(1), {});
    }
    bool begins = !command.Is("*IF");
    for (std::size_t i = 1; i < command.GetNumberOfFields() && !begins; ++i)
    {
      begins = ToUpperMAPDL(command.GetField(i)) == "THEN";
    }
    this->Depth += begins;
  }
  else if (command.Is("*SET") || command.Is("*GET"))
  {
    this->Parameters.Set(command.GetField(1), {}); // its value is unknown
  }
  else if (const std::string_view parameter = command.GetAssignment(value); !parameter.empty())
  {
    this->Parameters.Set(parameter, {});
  }
  else if (const std::int32_t system = this->GetNewSystem(); system != NoSystem)
  {
    this->CoordinateSystem = system == this->CoordinateSystem ? system : UnknownSystem;
  }
  else
  {
    this->NoteSkipped(DefiningCommands, this->Deck.Skipped);
    this->NoteSkipped(MeshCommands, this->Deck.Skipped);
  }
  return true;
}

//------------------------------------------------------------------------------
// The number of the coordinate system that a command activates, NoSystem if it does not.
std::int32_t MAPDLWalker::GetNewSystem()
{
  std::int32_t system = 0;
  if (this->Command.Is("CSYS"))
  {
    return this->ReadField(1, system) == Value::Unknown ? UnknownSystem : system;
  }
  for (const char* name : SystemCommands)
  {
    if (this->Command.Is(name))
    {
      // Files of the program have other words there.
      return this->Parameters.Read(this->Command.GetField(1), system) == Value::Number
        ? system
        : UnknownSystem;
    }
  }
  return NoSystem;
}

//------------------------------------------------------------------------------
void MAPDLWalker::Clear()
{
  vtkIdType cleared = this->Deck.NumberOfClearedRows;
  for (const MAPDLNodeBlock& block : this->Deck.NodeBlocks)
  {
    cleared += block.GetNumberOfRows();
  }
  for (const MAPDLElementBlock& block : this->Deck.ElementBlocks)
  {
    cleared += block.GetNumberOfRows();
  }
  this->Deck = MAPDLDeck();
  this->Deck.Attributes.emplace_back();
  this->Deck.NumberOfClearedRows = cleared;
  this->Parameters = MAPDLParameters();
  this->CoordinateSystem = 0;
  this->Current = MAPDLElement();
  this->AttributesChanged = false;
  this->GreatestNode = this->GreatestElement = 0;
  this->KnownNodeBlocks = this->KnownElementBlocks = 0;
  this->NextNodeIsKnown = true;
}

//------------------------------------------------------------------------------
bool MAPDLWalker::Execute()
{
  const MAPDLCommand& command = this->Command;
  const std::string_view name = command.GetField(0);
  std::string_view value;
  static constexpr std::pair<const char*, void (MAPDLWalker::*)()> Definitions[] = {
    { "CMBLOCK", &MAPDLWalker::ReadComponent }, { "ETBLOCK", &MAPDLWalker::ReadTypeBlock },
    { "ET", &MAPDLWalker::DefineType }, { "KEYOPT", &MAPDLWalker::DefineKeyOption }
  };
  static constexpr std::pair<const char*, std::int32_t MAPDLElement::*> Attributes[] = {
    { "TYPE", &MAPDLElement::Type }, { "MAT", &MAPDLElement::Material },
    { "REAL", &MAPDLElement::Real }, { "SECNUM", &MAPDLElement::Section }
  };
  const bool followsDefinition = std::exchange(this->Defines, false);
  if (command.Is("N"))
  {
    this->Defines = true;
    return this->DefineNode();
  }
  if (command.Is("EN") || command.Is("E"))
  {
    this->Defines = true;
    return this->DefineElement(command.Is("EN"));
  }
  if (command.Is("EMORE"))
  {
    return !this->ElementIsOpen || this->AddElementNodes(1);
  }
  this->ElementIsOpen = false;
  if (command.Is("NBLOCK"))
  {
    return this->ReadNodeBlock();
  }
  if (command.Is("EBLOCK"))
  {
    return this->ReadElementBlock();
  }
  for (const auto& [definition, define] : Definitions)
  {
    if (command.Is(definition))
    {
      (this->*define)();
      return true;
    }
  }
  for (const auto& [attribute, member] : Attributes)
  {
    if (command.Is(attribute))
    {
      this->SetAttribute(member);
      return true;
    }
  }
  if (command.Is("*SET"))
  {
    this->Parameters.Set(command.GetField(1), command.GetField(2));
  }
  else if (name.size() > 1 && name[0] == '*')
  {
    if (command.Is("*DO") || command.Is("*DOWHILE") || command.Is("*CREATE") || command.Is("*IF"))
    {
      return this->ExecuteInBranch();
    }
    if (command.Is("*GET"))
    {
      this->Parameters.Set(command.GetField(1), {});
    }
    if (followsDefinition)
    {
      this->NoteSkipped(std::array{ "*REPEAT" }, this->Deck.Ignored);
    }
  }
  else if (command.Is("/EOF") || command.Is("/EXIT"))
  {
    this->Ended = true;
  }
  else if (command.Is("/CLEAR"))
  {
    this->Clear();
  }
  else if (const std::string_view parameter = command.GetAssignment(value); !parameter.empty())
  {
    this->Parameters.Set(parameter, value);
  }
  else
  {
    this->NoteSkipped(MeshCommands, this->Deck.Ignored);
    const std::int32_t system = this->GetNewSystem();
    this->CoordinateSystem = system == NoSystem ? this->CoordinateSystem : system;
  }
  return true;
}

//------------------------------------------------------------------------------
Value MAPDLWalker::ReadField(std::size_t i, std::int32_t& value)
{
  const Value kind = this->Parameters.Read(this->Command.GetField(i), value);
  this->Deck.NumberOfUnknownParameters += kind == Value::Unknown;
  return kind;
}
}
