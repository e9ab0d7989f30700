// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MAPDLWalker.h"

#include <utility>

namespace camaron
{
namespace
{
using Value = MAPDLParameters::Value;

// Commands that create, move or delete nodes and elements by rules of the program.
constexpr const char* MeshCommands[] = { "/INPUT", "*REPEAT", "AMESH", "CDREAD", "EDELE", "EGEN",
  "EINTF", "EMODIF", "ENGEN", "ENSYM", "ESURF", "ESYM", "FILL", "LMESH", "NDELE", "NGEN", "NMODIF",
  "NSCALE", "NSYM", "NUMMRG", "NUMCMP", "SWGEN", "TRANSFER", "VMESH", "VSWEEP" };
}

//------------------------------------------------------------------------------
template <std::int32_t MAPDLElement::* Attribute>
bool MAPDLWalker::SetAttribute()
{
  std::int32_t value = 1;
  if (this->ReadField(1, value) != Value::Unknown)
  {
    this->AttributesChanged = true;
    this->Current.*Attribute = value;
  }
  return true;
}

//------------------------------------------------------------------------------
// In the order of their frequency: every command is looked for here.
const MAPDLWalker::Effect MAPDLWalker::Effects[] = {
  { "N", &MAPDLWalker::DefineNode },
  { "E", &MAPDLWalker::DefineElement },
  { "EN", &MAPDLWalker::DefineNumberedElement },
  { "EMORE", &MAPDLWalker::ContinueElement, false },
  { "NBLOCK", &MAPDLWalker::ReadNodeBlock },
  { "EBLOCK", &MAPDLWalker::ReadElementBlock },
  { "CMBLOCK", &MAPDLWalker::ReadComponent },
  { "ET", &MAPDLWalker::DefineType },
  { "ETBLOCK", &MAPDLWalker::ReadTypeBlock },
  { "KEYOPT", &MAPDLWalker::DefineKeyOption, false },
  { "TYPE", &MAPDLWalker::SetAttribute<&MAPDLElement::Type> },
  { "MAT", &MAPDLWalker::SetAttribute<&MAPDLElement::Material> },
  { "REAL", &MAPDLWalker::SetAttribute<&MAPDLElement::Real> },
  { "SECNUM", &MAPDLWalker::SetAttribute<&MAPDLElement::Section> },
  { "*SET", &MAPDLWalker::SetParameter, false },
  { "*GET", &MAPDLWalker::SetParameter, false },
  { "/CLEAR", &MAPDLWalker::Clear },
  { "/EOF", &MAPDLWalker::Finish, false },
  { "/EXIT", &MAPDLWalker::Finish, false },

  // The effect of branches and loops depends on more than the deck; they rarely define a mesh.
  { "*IF", &MAPDLWalker::BeginBranch, false },
  { "*DO", &MAPDLWalker::BeginBranch, false },
  { "*DOWHILE", &MAPDLWalker::BeginBranch, false },
  { "*CREATE", &MAPDLWalker::BeginBranch, false },
  { "*ENDIF", &MAPDLWalker::EndBranch, false },
  { "*ENDDO", &MAPDLWalker::EndBranch, false },
  { "*END", &MAPDLWalker::EndBranch, false },

  // These define a coordinate system and activate it for later nodes, or activate one.
  { "CSYS", &MAPDLWalker::SetSystem, false },
  { "LOCAL", &MAPDLWalker::SetSystem, false },
  { "CLOCAL", &MAPDLWalker::SetSystem, false },
  { "CS", &MAPDLWalker::SetSystem, false },
  { "CSKP", &MAPDLWalker::SetSystem, false },
  { "CSWPLA", &MAPDLWalker::SetSystem, false },
};

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
      if (!this->Execute())
      {
        return false;
      }
    }
  }
  return !this->Report.IsStopped();
}

//------------------------------------------------------------------------------
bool MAPDLWalker::Execute()
{
  const MAPDLCommand& command = this->Command;
  const bool followsDefinition =
    std::exchange(this->DefinesItem, command.Is("N") || command.Is("E") || command.Is("EN"));
  this->ElementIsOpen = this->ElementIsOpen && (command.Is("EMORE") || command.Is("EN"));
  for (const Effect& effect : Effects)
  {
    if (command.Is(effect.Name))
    {
      if (this->Depth == 0 || !effect.DefinesMesh)
      {
        return (this->*effect.Execute)();
      }
      this->Deck.Skipped.Add(effect.Name);
      return true;
    }
  }
  for (const char* name : MeshCommands)
  {
    // Loads may be repeated, and the coordinate system of an element is irrelevant here.
    if (command.Is(name) && (followsDefinition || !command.Is("*REPEAT")) &&
      ToUpperMAPDL(command.GetField(2)) != "ESYS")
    {
      (this->Depth > 0 ? this->Deck.Skipped : this->Deck.Ignored).Add(name);
      return true;
    }
  }
  std::string_view value;
  if (const std::string_view parameter = command.GetAssignment(value); !parameter.empty())
  {
    this->Parameters.Set(parameter, this->Depth > 0 ? std::string_view() : value);
  }
  return true;
}

//------------------------------------------------------------------------------
bool MAPDLWalker::BeginBranch()
{
  const MAPDLCommand& command = this->Command;
  bool begins = !command.Is("*IF");
  for (std::size_t i = 1; i < command.GetNumberOfFields() && !begins; ++i)
  {
    begins = ToUpperMAPDL(command.GetField(i)) == "THEN";
  }
  this->Depth += begins;
  return !command.Is("*DO") || this->SetParameter();
}

//------------------------------------------------------------------------------
bool MAPDLWalker::EndBranch()
{
  this->Depth -= this->Depth > 0;
  return true;
}

//------------------------------------------------------------------------------
bool MAPDLWalker::SetParameter()
{
  const bool isKnown = this->Depth == 0 && this->Command.Is("*SET");
  this->Parameters.Set(
    this->Command.GetField(1), isKnown ? this->Command.GetField(2) : std::string_view());
  return true;
}

//------------------------------------------------------------------------------
bool MAPDLWalker::SetSystem()
{
  std::int32_t system = 0;
  const Value kind = this->Parameters.Read(this->Command.GetField(1), system);
  const bool isGlobal = this->Command.Is("CSYS") && kind != Value::Unknown && system == 0;
  this->IsGlobal = isGlobal && (this->IsGlobal || this->Depth == 0);
  return true;
}

//------------------------------------------------------------------------------
bool MAPDLWalker::Clear()
{
  return (this->Deck.NodeBlocks.empty() && this->Deck.ElementBlocks.empty()) ||
    this->Fault.Set(this->LineBegin, ErrorKind::Unsupported, "one model per deck",
      "/CLEAR after nodes or elements");
}

//------------------------------------------------------------------------------
bool MAPDLWalker::Finish()
{
  this->Ended = this->Depth == 0;
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
