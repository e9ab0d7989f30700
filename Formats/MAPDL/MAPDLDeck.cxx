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

// Commands that create, move or delete nodes and elements by rules of the program.
constexpr const char* MeshCommands[] = { "/INPUT", "AMESH", "CDREAD", "EDELE", "EGEN", "EINTF",
  "EMODIF", "ENGEN", "ENSYM", "ESURF", "ESYM", "FILL", "LMESH", "NDELE", "NGEN", "NMODIF", "NSCALE",
  "NSYM", "NUMMRG", "NUMCMP", "SWGEN", "TRANSFER", "VMESH", "VSWEEP" };

//------------------------------------------------------------------------------
// Number in the name of an element: 185 of SOLID185, or the name itself.
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
class Walker
{
public:
  Walker(const char* begin, const char* end, vtkIdType chunk, const Progress& progress,
    MAPDLDeck& deck, MAPDLFault& fault)
    : Begin(begin)
    , End(end)
    , Text(begin)
    , Chunk(chunk)
    , Report(progress)
    , Deck(deck)
    , Fault(fault)
  {
    this->Deck.Attributes.emplace_back();
  }

  bool Walk();

private:
  bool Execute();
  bool ExecuteInBranch();
  bool ReadNodeBlock();
  bool ReadElementBlock();
  void ReadComponent();
  void ReadTypeBlock();
  bool DefineNode();
  bool AddNode(std::int32_t id, std::size_t firstCoordinate);
  bool DefineElement(bool isNumbered);
  void AddElement(std::int32_t id);
  bool AddElementNodes(std::size_t firstField);
  void DefineType();
  void DefineKeyOption();
  void SetAttribute(std::int32_t MAPDLElement::*attribute);
  std::int32_t GetNextNode();
  std::int32_t GetNextElement();

  /// Number in a field; 0 if it is blank; counts what is unknown.
  Value ReadField(std::size_t i, std::int32_t& value);
  double GetProgress(const char* text) const
  {
    return static_cast<double>(text - this->Begin) / static_cast<double>(this->End - this->Begin);
  }
  Progress GetRest() const { return this->Report.Part(this->GetProgress(this->Text), 1); }
  /// Takes the format line of a block, if there is one, for at least @a columns integer columns.
  MAPDLRowFormat TakeFormat(int integers, int columns);
  /// Whether a block has its end, or as many rows as it promises.
  bool IsComplete(const MAPDLExtent& extent) const;

  const char* Begin;
  const char* End;
  const char* Text;
  const char* LineBegin = nullptr;
  vtkIdType Chunk;
  Progress Report;
  MAPDLDeck& Deck;
  MAPDLFault& Fault;
  MAPDLCommand Command;
  MAPDLParameters Parameters;
  int Depth = 0; ///< of branches and loops that are skipped
  bool Ended = false;
  std::int32_t CoordinateSystem = 0;
  MAPDLElement Current; ///< attributes for E and EN
  bool AttributesChanged = false;
  bool ElementIsOpen = false; ///< EMORE may follow
  int ElementLines = 0;       ///< of nodes of the open element
  ///@{
  /// Greatest ids of the first so many blocks, found when a command without an id needs them.
  std::int32_t GreatestNode = 0, GreatestElement = 0;
  std::size_t KnownNodeBlocks = 0, KnownElementBlocks = 0;
  ///@}
};

//------------------------------------------------------------------------------
bool Walker::Walk()
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
      continue; // data of blocks that have no mesh
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
// What happens in branches and loops depends on more than the deck; they hold no mesh as a rule.
bool Walker::ExecuteInBranch()
{
  const MAPDLCommand& command = this->Command;
  if (command.Is("*ENDIF") || command.Is("*ENDDO") || command.Is("*END"))
  {
    --this->Depth;
  }
  else if (command.Is("*DO") || command.Is("*DOWHILE") || command.Is("*CREATE") ||
    (command.Is("*IF") &&
      ToUpperMAPDL(command.GetField(command.GetNumberOfFields() - 1)) == "THEN"))
  {
    ++this->Depth;
  }
  else if (command.Is("N") || command.Is("E") || command.Is("EN") || command.Is("NBLOCK") ||
    command.Is("EBLOCK"))
  {
    ++this->Deck.NumberOfSkipped;
  }
  return true;
}

//------------------------------------------------------------------------------
bool Walker::Execute()
{
  const MAPDLCommand& command = this->Command;
  const std::string_view name = command.GetField(0);
  std::string_view value;
  if (command.Is("N"))
  {
    return this->DefineNode();
  }
  if (command.Is("EN") || command.Is("E"))
  {
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
  if (command.Is("CMBLOCK"))
  {
    this->ReadComponent();
  }
  else if (command.Is("ETBLOCK"))
  {
    this->ReadTypeBlock();
  }
  else if (command.Is("ET"))
  {
    this->DefineType();
  }
  else if (command.Is("KEYOPT"))
  {
    this->DefineKeyOption();
  }
  else if (command.Is("TYPE"))
  {
    this->SetAttribute(&MAPDLElement::Type);
  }
  else if (command.Is("MAT"))
  {
    this->SetAttribute(&MAPDLElement::Material);
  }
  else if (command.Is("REAL"))
  {
    this->SetAttribute(&MAPDLElement::Real);
  }
  else if (command.Is("SECNUM"))
  {
    this->SetAttribute(&MAPDLElement::Section);
  }
  else if (command.Is("*SET"))
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
  }
  else if (command.Is("/EOF") || command.Is("/EXIT"))
  {
    this->Ended = true;
  }
  else if (const std::string_view parameter = command.GetAssignment(value); !parameter.empty())
  {
    this->Parameters.Set(parameter, value);
  }
  else
  {
    for (const char* mesh : MeshCommands)
    {
      // The coordinate system of an element does not matter here.
      if (command.Is(mesh) && ToUpperMAPDL(command.GetField(2)) != "ESYS")
      {
        ++this->Deck.NumberOfIgnored;
        this->Deck.IgnoredNames.insert(mesh);
      }
    }
    if (command.Is("CSYS"))
    {
      std::int32_t system = 0;
      this->ReadField(1, system);
      this->CoordinateSystem = system;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
Value Walker::ReadField(std::size_t i, std::int32_t& value)
{
  const Value kind = this->Parameters.Read(this->Command.GetField(i), value);
  this->Deck.NumberOfUnknownParameters += kind == Value::Unknown;
  return kind;
}

//------------------------------------------------------------------------------
MAPDLRowFormat Walker::TakeFormat(int integers, int columns)
{
  const Line line(this->Text, this->End);
  const char* const text = SkipBlanks(line.Begin, line.End);
  if (text < line.End && *text == '(')
  {
    this->Text = line.Next;
    auto format = std::make_shared<ColumnFormat>();
    if (format->Parse(line.Begin, line.End) && format->GetNumberOfColumns() >= columns &&
      format->GetNumberOfLeadingIntegers() >= integers)
    {
      return MAPDLRowFormat(std::move(format));
    }
  }
  ++this->Deck.NumberOfFreeBlocks;
  return MAPDLRowFormat();
}

//------------------------------------------------------------------------------
bool Walker::IsComplete(const MAPDLExtent& extent) const
{
  constexpr std::size_t CountField = 4;
  std::int32_t count = 0;
  return extent.IsEnded ||
    (this->Parameters.Read(this->Command.GetField(CountField), count) == Value::Number &&
      extent.NumberOfRows >= count);
}

//------------------------------------------------------------------------------
bool Walker::ReadNodeBlock()
{
  MAPDLNodeBlock block;
  constexpr int LeastColumns = 3; // id, x, y
  block.Format.Fields = this->TakeFormat(1, LeastColumns);
  const ColumnFormat* columns = block.Format.Fields.GetColumns();
  const bool hasSolidModel = !TrimMAPDL(this->Command.GetField(2)).empty();
  block.Format.FirstCoordinate = columns ? columns->GetNumberOfLeadingIntegers()
    : hasSolidModel                      ? 3
                                         : 1;
  if (!MeasureMAPDLNodes(this->Text, this->End, this->Chunk, this->GetRest(), block.Extent))
  {
    return false;
  }
  if (!this->IsComplete(block.Extent))
  {
    // What is wrong with a row may be why there is no end.
    bool good = true;
    for (std::size_t chunk = 0; chunk < block.Extent.Chunks.size() && good; ++chunk)
    {
      good = ForEachMAPDLNode(block.Extent, chunk,
        [&](const Line& line, vtkIdType)
        {
          std::int32_t id;
          double x[3];
          return block.Format.ReadId(line, id, this->Fault) &&
            block.Format.ReadCoordinates(line, x, this->Fault);
        });
    }
    return good &&
      this->Fault.Set(this->End, ErrorKind::Truncated, "more nodes, or the end of their block");
  }
  this->Text = block.Extent.Next;
  this->Deck.NodeBlocks.push_back(std::move(block));
  return true;
}

//------------------------------------------------------------------------------
bool Walker::ReadElementBlock()
{
  MAPDLElementBlock block;
  MAPDLElementFormat& format = block.Format;
  const std::string key = ToUpperMAPDL(this->Command.GetField(2)).substr(0, 4);
  format.IsSolid = key == "SOLI";
  const int least = format.GetNumberOfHeaderFields() + 1;
  format.Fields = this->TakeFormat(least, least);
  constexpr int FreeSolidFields = 19, FreeFields = 15; // as the program writes
  const ColumnFormat* columns = format.Fields.GetColumns();
  format.FieldsPerLine = columns ? columns->GetNumberOfLeadingIntegers()
    : format.IsSolid             ? FreeSolidFields
                                 : FreeFields;
  const auto most = [this](std::int64_t type) { return this->Deck.GetMostNodes(type); };
  if (!MeasureMAPDLElements(
        format, most, this->Text, this->End, this->Chunk, this->GetRest(), block.Extent))
  {
    return false;
  }
  if (!this->IsComplete(block.Extent))
  {
    bool good = true;
    for (std::size_t chunk = 0; chunk < block.Extent.Chunks.size() && good; ++chunk)
    {
      good = ForEachMAPDLElement(format, most, block.Extent, chunk, true, this->Fault,
        [](const Line&, vtkIdType, const MAPDLElement&) { return true; });
    }
    return good &&
      this->Fault.Set(this->End, ErrorKind::Truncated, "more elements, or the end of their block");
  }
  this->Text = block.Extent.Next;
  this->Deck.ElementBlocks.push_back(std::move(block));
  return true;
}

//------------------------------------------------------------------------------
void Walker::ReadComponent()
{
  MAPDLComponent component;
  component.Name = ToUpperMAPDL(this->Command.GetField(1));
  const std::string entity = ToUpperMAPDL(this->Command.GetField(2)).substr(0, 4);
  component.OfNodes = entity == "NODE";
  std::int32_t count = 0;
  const bool isCounted = this->ReadField(3, count) == Value::Number;
  component.Fields = this->TakeFormat(1, 1);
  const ColumnFormat* columns = component.Fields.GetColumns();
  component.Begin = this->Text;
  std::int64_t lines = -1; // unknown
  if (isCounted)
  {
    component.NumberOfValues = count;
    if (columns)
    {
      const int perLine = columns->GetNumberOfLeadingIntegers();
      lines = (std::int64_t(count) + perLine - 1) / perLine;
    }
  }
  component.IsEnded = false;
  while (this->Text < this->End)
  {
    const Line line(this->Text, this->End);
    const MAPDLLine kind = ClassifyMAPDLLine(line);
    if (lines == 0 || kind == MAPDLLine::Command || kind == MAPDLLine::End)
    {
      component.IsEnded = true;
      break;
    }
    lines -= kind == MAPDLLine::Row && lines > 0;
    this->Text = line.Next;
  }
  component.End = this->Text;
  if (component.OfNodes || entity == "ELEM")
  {
    this->Deck.Components.push_back(std::move(component));
  }
}

//------------------------------------------------------------------------------
void Walker::ReadTypeBlock()
{
  const MAPDLRowFormat fields = this->TakeFormat(2, 2);
  while (this->Text < this->End)
  {
    const Line line(this->Text, this->End);
    const MAPDLLine kind = ClassifyMAPDLLine(line);
    if (kind == MAPDLLine::Command)
    {
      return;
    }
    this->Text = line.Next;
    if (kind == MAPDLLine::End)
    {
      return;
    }
    std::int64_t type = 0, element = 0, shape = 0;
    const char* place;
    if (kind == MAPDLLine::Row && fields.Read(line, 0, type, place) &&
      fields.Read(line, 1, element, place))
    {
      shape = fields.Read(line, 2, shape, place) ? shape : 0;
      const auto clamp = [](std::int64_t n)
      { return static_cast<int>(std::clamp<std::int64_t>(n, -1, INT32_MAX)); };
      this->Deck.Types[type] = { clamp(element), clamp(shape) };
    }
  }
}

//------------------------------------------------------------------------------
void Walker::DefineType()
{
  std::int32_t type = 0, element = 0;
  const Value kind = this->Parameters.Read(this->Command.GetField(1), type);
  if (kind == Value::Unknown)
  {
    // ETCON,SET and the like are other commands; a parameter without value is not.
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
void Walker::DefineKeyOption()
{
  std::int32_t type = 0, key = 0, value = 0;
  if (this->ReadField(1, type) == Value::Number && this->ReadField(2, key) == Value::Number &&
    key == 1 && this->Parameters.Read(this->Command.GetField(3), value) != Value::Unknown)
  {
    this->Deck.Types[type].Shape = value;
  }
}

//------------------------------------------------------------------------------
void Walker::SetAttribute(std::int32_t MAPDLElement::*attribute)
{
  std::int32_t value = 1;
  if (this->ReadField(1, value) != Value::Unknown)
  {
    this->AttributesChanged = true;
    this->Current.*attribute = value;
  }
}

//------------------------------------------------------------------------------
std::int32_t Walker::GetNextNode()
{
  for (; this->KnownNodeBlocks < this->Deck.NodeBlocks.size(); ++this->KnownNodeBlocks)
  {
    const MAPDLNodeBlock& block = this->Deck.NodeBlocks[this->KnownNodeBlocks];
    for (std::size_t chunk = 0; chunk < block.Extent.Chunks.size(); ++chunk)
    {
      ForEachMAPDLNode(block.Extent, chunk,
        [&](const Line& line, vtkIdType)
        {
          MAPDLFault fault; // found again, and reported, when the block is read
          std::int32_t id;
          if (block.Format.ReadId(line, id, fault))
          {
            this->GreatestNode = std::max(this->GreatestNode, id);
          }
          return true;
        });
    }
  }
  return this->GreatestNode < INT32_MAX ? this->GreatestNode + 1 : INT32_MAX;
}

//------------------------------------------------------------------------------
std::int32_t Walker::GetNextElement()
{
  for (; this->KnownElementBlocks < this->Deck.ElementBlocks.size(); ++this->KnownElementBlocks)
  {
    const MAPDLElementBlock& block = this->Deck.ElementBlocks[this->KnownElementBlocks];
    for (std::size_t chunk = 0; chunk < block.Extent.Chunks.size(); ++chunk)
    {
      MAPDLFault fault;
      ForEachMAPDLElement(
        block.Format, [this](std::int64_t type) { return this->Deck.GetMostNodes(type); },
        block.Extent, chunk, false, fault,
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
bool Walker::DefineNode()
{
  const std::string_view first = this->Command.GetField(1);
  std::int32_t id = 0;
  // N,R5.3,LOC,id,solid,place,x,y,z is how the program writes nodes without blocks; id -1 ends
  // them.
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
      return true;
    case Value::Absent:
      return this->AddNode(this->GetNextNode(), 2);
    default:
      this->Deck.NumberOfTurnedNodes += this->CoordinateSystem != 0;
      return this->AddNode(id, 2);
  }
}

//------------------------------------------------------------------------------
bool Walker::AddNode(std::int32_t id, std::size_t firstCoordinate)
{
  if (id < 1)
  {
    return this->Fault.Set(this->LineBegin, ErrorKind::Syntax,
      "the number of a node from 1 to 2147483647", std::to_string(id));
  }
  MAPDLNode node;
  node.Id = id;
  for (std::size_t c = 0; c < 3; ++c)
  {
    node.X[c] = 0;
    const std::string_view field = this->Command.GetField(firstCoordinate + c);
    if (this->Parameters.Read(field, node.X[c]) == Value::Unknown)
    {
      // A parameter may be known to the program; anything else is damage.
      const bool isName =
        ClassifyMAPDLLine(Line(field.data(), field.data() + field.size())) == MAPDLLine::Command;
      if (!isName)
      {
        return this->Fault.Set(field.data(), ErrorKind::Syntax, "a coordinate of a node");
      }
      const char* const end = field.data() + field.size();
      if (ParseReal(field.data(), end, node.X[c]) != end) // nan, inf
      {
        ++this->Deck.NumberOfUnknownParameters;
        return true;
      }
    }
  }
  this->GreatestNode = std::max(this->GreatestNode, id);
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
bool Walker::DefineElement(bool isNumbered)
{
  const std::string_view first = this->Command.GetField(1);
  std::int32_t id = 0;
  // EN,R5.5,ATTR,number of nodes,material,type,real,section,system,id and EN,R5.5,NODE,nodes is how
  // the program writes elements without blocks.
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
void Walker::AddElement(std::int32_t id)
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
bool Walker::AddElementNodes(std::size_t firstField)
{
  const auto last = static_cast<vtkIdType>(this->Deck.Elements.size()) - 1;
  const auto addNode = [&](std::int32_t node)
  {
    this->Deck.ElementNodes.push_back(node);
    ++this->Deck.ElementBlocks.back().NumberOfCommandNodes;
  };
  constexpr int NodesPerLine = 8;
  for (vtkIdType i = this->Deck.GetNumberOfNodes(last);
       i < std::min(NodesPerLine * this->ElementLines, MaxMAPDLNodes); ++i)
  {
    addNode(0); // trailing ones that the lines before lack
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
    if (kind == Value::Unknown && !isName)
    {
      return this->Fault.Set(field.data(), ErrorKind::Syntax, "a node of an element");
    }
    if (kind == Value::Unknown)
    {
      // The element is left out.
      MAPDLElementBlock& block = this->Deck.ElementBlocks.back();
      block.NumberOfCommandNodes -= this->Deck.GetNumberOfNodes(last);
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
    addNode(node);
  }
  return true;
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
int MAPDLDeck::GetMostNodes(std::int64_t type) const
{
  const auto found = this->Types.find(type);
  return found == this->Types.end()
    ? 0
    : GetMaxMAPDLNodes(GetMAPDLClass(found->second.Element, found->second.Shape));
}

//------------------------------------------------------------------------------
bool LooksLikeMAPDL(const char* begin, const char* end)
{
  constexpr std::ptrdiff_t Enough = 1 << 18; // parameters and materials may come first
  const bool isAll = end - begin <= Enough;
  end = isAll ? end : begin + Enough;
  if (std::memchr(begin, '\0', std::min<std::ptrdiff_t>(end - begin, 4096)))
  {
    return false;
  }
  // Keywords of Abaqus, whose decks have the same extension.
  constexpr std::string_view Others[] = { "*HEADING", "*NODE", "*ELEMENT", "*PART", "*ASSEMBLY",
    "*MATERIAL", "*STEP", "*INCLUDE", "*PREPRINT", "*NSET", "*ELSET" };
  const MAPDLParameters parameters;
  bool hasHint = false;
  MAPDLCommand command;
  for (const char* text = begin; text < end;)
  {
    const Line line(text, end);
    text = line.Next;
    const char* field = SkipBlanks(line.Begin, line.End);
    if (line.End - field >= 2 && field[0] == '*' && field[1] == '*')
    {
      return false; // a comment of Abaqus
    }
    if (ClassifyMAPDLLine(line) != MAPDLLine::Command || !command.Take(field, line.End))
    {
      continue;
    }
    const std::string_view name = command.GetField(0);
    if (!name.empty() && name[0] == '*' &&
      std::find(std::begin(Others), std::end(Others), ToUpperMAPDL(name)) != std::end(Others))
    {
      return false;
    }
    double number;
    if (command.Is("NBLOCK"))
    {
      return true;
    }
    if (command.Is("N") && command.GetNumberOfFields() > 2)
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

//------------------------------------------------------------------------------
bool WalkMAPDL(const char* begin, const char* end, vtkIdType chunk, const Progress& progress,
  MAPDLDeck& deck, MAPDLFault& fault)
{
  return Walker(begin, end, chunk, progress, deck, fault).Walk();
}
}
