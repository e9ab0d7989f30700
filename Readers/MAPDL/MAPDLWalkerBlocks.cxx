// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MAPDLWalker.h"

#include <algorithm>

namespace camaron
{
namespace
{
using Value = MAPDLParameters::Value;
}

//------------------------------------------------------------------------------
MAPDLRowFormat MAPDLWalker::TakeFormat(int integers, int columns)
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
bool MAPDLWalker::TakeKey(
  const char* command, std::initializer_list<std::string_view> keys, int& key)
{
  constexpr std::size_t KeyField = 2, Enough = 4; // letters
  const std::string_view field = TrimMAPDL(this->Command.GetField(KeyField));
  const std::string word = ToUpperMAPDL(field);
  key = 0;
  int number = 0;
  std::string expected;
  for (const std::string_view name : keys)
  {
    ++number;
    if (word.size() >= Enough && name.substr(0, word.size()) == word)
    {
      key = number;
    }
    expected += std::string(name) + " or ";
  }
  expected += "nothing as the key of " + std::string(command);
  if (key == 0 && !word.empty())
  {
    return this->Fault.Set(
      field.data(), ErrorKind::Unsupported, expected.c_str(), QuoteWord(field));
  }
  // A word anywhere else is a key in the wrong field, or an unknown layout.
  for (const std::size_t other : { KeyField - 1, KeyField + 1, KeyField + 2 })
  {
    const std::string_view value = TrimMAPDL(this->Command.GetField(other));
    std::int32_t ignored;
    if (this->Parameters.Read(value, ignored) == Value::Unknown)
    {
      expected = "a number or nothing as field " + std::to_string(other) + " of " + command;
      return this->Fault.Set(
        value.data(), ErrorKind::Unsupported, expected.c_str(), QuoteWord(value));
    }
  }
  return true;
}

//------------------------------------------------------------------------------
std::int32_t MAPDLWalker::GetPromisedRows() const
{
  constexpr std::size_t CountField = 4;
  std::int32_t count = 0;
  return this->Parameters.Read(this->Command.GetField(CountField), count) == Value::Number
    ? std::max(count, 0)
    : 0;
}

//------------------------------------------------------------------------------
template <typename CheckRows>
bool MAPDLWalker::CheckEnd(const MAPDLExtent& extent, const char* expected, CheckRows&& checkRows)
{
  const std::int32_t promised = this->GetPromisedRows();
  if (promised == 0 || extent.NumberOfRows < promised)
  {
    // Without an end mark, commands continue on the line after the rows.
    const bool isDamaged =
      extent.IsEnded && extent.Next == extent.End && !IsMAPDLCommand(Line(extent.End, this->End));
    if (!extent.IsEnded || isDamaged)
    {
      return checkRows() &&
        this->Fault.Set(SkipBlanks(extent.End, this->End),
          isDamaged ? ErrorKind::Syntax : ErrorKind::Truncated, expected);
    }
  }
  this->Deck.NumberOfMiscountedBlocks += promised > 0 && extent.NumberOfRows != promised;
  return true;
}

//------------------------------------------------------------------------------
bool MAPDLWalker::ReadNodeBlock()
{
  MAPDLNodeBlock block;
  int hasSolidModel = 0;
  if (!this->TakeKey("NBLOCK", { "SOLID" }, hasSolidModel))
  {
    return false;
  }
  constexpr int LeastColumns = 3; // id, x, y
  block.Format.Fields = this->TakeFormat(1, LeastColumns);
  const ColumnFormat* columns = block.Format.Fields.GetColumns();
  if (columns && columns->GetNumberOfLeadingIntegers() == columns->GetNumberOfColumns())
  {
    return this->Fault.Set(this->LineBegin, ErrorKind::Unsupported,
      "a format with columns for coordinates, such as (3i9,6e21.13e3)", "none");
  }
  block.Format.FirstCoordinate = columns ? columns->GetNumberOfLeadingIntegers()
    : hasSolidModel                      ? 3
                                         : 1;
  if (!MeasureMAPDLNodes(this->Text, this->End, this->Chunk, this->GetRest(), block.Extent))
  {
    return false;
  }
  const auto checkRows = [&]
  {
    return ForEachMAPDLNode(block.Extent,
      [&](const Line& line, vtkIdType)
      {
        std::int32_t id;
        double x[3];
        return block.Format.ReadId(line, id, this->Fault) &&
          block.Format.ReadCoordinates(line, x, this->Fault);
      });
  };
  if (!this->CheckEnd(block.Extent, "more nodes, or the end of their block", checkRows))
  {
    return false;
  }
  this->Text = block.Extent.Next;
  this->Deck.NodeBlocks.push_back(std::move(block));
  return true;
}

//------------------------------------------------------------------------------
int MAPDLWalker::CountFieldsOfRow() const
{
  constexpr int Least = 2, Most = 100; // number of the element, nodes
  const Line line(SkipBlankMAPDLLines(this->Text, this->End), this->End);
  return std::max(Least, MAPDLRowFormat().CountFields(line, Most));
}

//------------------------------------------------------------------------------
// Rows do not contain their number of nodes; their type determines it, or the number of rows.
bool MAPDLWalker::FindFurtherLines(MAPDLElementFormat& format)
{
  const int first = format.GetNodesOnFirstLine(), perLine = format.FieldsPerLine;
  const auto getFurtherLines = [&](int nodes)
  { return nodes > first ? (nodes - first + perLine - 1) / perLine : 0; };
  const std::int32_t id = format.Attributes.Type;
  const MAPDLType type = this->Deck.GetType(id);
  const int most = format.GetMostNodes(id);
  const bool isKnown = GetMAPDLNodes(type.Element, type.Shape) > 0;
  format.FurtherLines = isKnown ? getFurtherLines(most) : 0;
  MAPDLExtent lines;
  if (most > 0 && most <= first)
  {
    return true;
  }
  if (!MeasureMAPDLNodes(this->Text, this->End, this->Chunk, this->GetRest(), lines))
  {
    return false;
  }
  const std::int32_t promised = this->GetPromisedRows();
  const vtkIdType counted = promised > 0 ? lines.NumberOfRows / promised - 1 : 0;
  const bool isCounted = promised > 0 && lines.NumberOfRows == (counted + 1) * promised &&
    counted >= 0 && counted <= getFurtherLines(MaxMAPDLNodes);
  if (!isKnown && isCounted)
  {
    format.FurtherLines = static_cast<int>(counted);
    return true;
  }
  const bool isFull = !ForEachMAPDLNode(
    lines, [&](const Line& line, vtkIdType) { return format.PeekNumberOfNodes(line) < first; });
  if (isKnown)
  {
    return !isFull || !isCounted || counted == format.FurtherLines ||
      this->Fault.Set(this->LineBegin, ErrorKind::Count,
        ("elements with " + std::to_string(most) + " nodes, as their type has, on " +
          std::to_string(format.FurtherLines + 1) + " lines each")
          .c_str(),
        std::to_string(promised) + " elements on " + std::to_string(lines.NumberOfRows) + " lines");
  }
  return !isFull ||
    this->Fault.Set(this->LineBegin, ErrorKind::Unsupported,
      "a type that is defined (ET) before the block, or the number of elements in the block, as an "
      "element may continue on the next line",
      "type " + std::to_string(id));
}

//------------------------------------------------------------------------------
bool MAPDLWalker::ReadElementBlock()
{
  MAPDLElementBlock block;
  MAPDLElementFormat& format = block.Format;
  int key = 0;
  if (!this->TakeKey("EBLOCK", { "SOLID", "COMPACT" }, key))
  {
    return false;
  }
  constexpr MAPDLElementKey Keys[] = { MAPDLElementKey::None, MAPDLElementKey::Solid,
    MAPDLElementKey::Compact };
  format.Key = Keys[key];
  format.Attributes = this->Current;
  const int least = format.GetNumberOfHeaderFields() + 1;
  format.Fields = this->TakeFormat(least, least);
  constexpr int FreeSolidFields = 19, FreeFields = 15; // as the program writes
  const ColumnFormat* columns = format.Fields.GetColumns();
  format.FieldsPerLine = columns ? columns->GetNumberOfLeadingIntegers()
    : format.IsSolid()           ? FreeSolidFields
    : format.IsCompact()         ? this->CountFieldsOfRow()
                                 : FreeFields;
  for (const auto& [type, element] : this->Deck.Types)
  {
    const int nodes = GetMAPDLNodes(element.Element, element.Shape);
    format.MostNodes[type] =
      nodes > 0 ? nodes : GetMaxMAPDLNodes(GetMAPDLClass(element.Element, element.Shape));
  }
  if (format.IsCompact() && !this->FindFurtherLines(format))
  {
    return false;
  }
  if (!MeasureMAPDLElements(
        format, this->Text, this->End, this->Chunk, this->GetRest(), block.Extent))
  {
    return false;
  }
  const auto checkRows = [&]
  {
    return ForEachMAPDLElement(format, block.Extent, true, this->Fault,
      [](const Line&, vtkIdType, const MAPDLElement&) { return true; });
  };
  if (!this->CheckEnd(block.Extent, "more elements, or the end of their block", checkRows))
  {
    return false;
  }
  this->Text = block.Extent.Next;
  this->Deck.ElementBlocks.push_back(std::move(block));
  return true;
}

//------------------------------------------------------------------------------
void MAPDLWalker::ReadComponent()
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
void MAPDLWalker::ReadTypeBlock()
{
  const MAPDLRowFormat fields = this->TakeFormat(2, 2);
  while (this->Text < this->End)
  {
    const Line line(this->Text, this->End);
    const MAPDLLine kind = ClassifyMAPDLLine(line);
    this->Text = kind == MAPDLLine::Command ? this->Text : line.Next;
    if (kind == MAPDLLine::Command || kind == MAPDLLine::End)
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
}
