// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Text.h"
#include "MAPDLWalker.h"

#include <algorithm>

namespace camaron
{
namespace
{
using Value = MAPDLParameters::Value;
constexpr std::size_t KeyField = 2, PromiseField = 4; // of NBLOCK and EBLOCK
}

//------------------------------------------------------------------------------
bool MAPDLWalker::TakeFormat(int integers, MAPDLRowFormat& format)
{
  const Line line(this->Text, this->End);
  this->Text = line.Next;
  return (format.Parse(line) && format.GetNumberOfIntegers() >= integers) ||
    this->Fault.Set(SkipBlanks(line.Begin, line.End), ErrorKind::Syntax,
      "a format of rows with at least " + CountOf(integers, "integer", "integers") +
        ", such as (3i9,6e21.13e3) for nodes or (19i10) for elements");
}

//------------------------------------------------------------------------------
bool MAPDLWalker::TakeKey(
  const char* command, std::initializer_list<std::string_view> keys, int& key)
{
  constexpr std::size_t Enough = 4; // letters
  const std::string_view field = this->Command.GetField(KeyField);
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
  if (key == 0 && !word.empty())
  {
    return this->Fault.Set(field.data(), ErrorKind::Unsupported,
      expected + "nothing as the key of " + command, QuoteWord(field));
  }
  // A word anywhere else is a key in the wrong field, or an unknown layout.
  for (const std::size_t other : { KeyField - 1, KeyField + 1, KeyField + 2 })
  {
    const std::string_view value = this->Command.GetField(other);
    std::int32_t ignored;
    if (this->Parameters.Read(value, ignored) == Value::Unknown)
    {
      return this->Fault.Set(value.data(), ErrorKind::Unsupported,
        "a number or nothing as field " + std::to_string(other) + " of " + command,
        QuoteWord(value));
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool MAPDLWalker::Measure(FunctionRef<int(const Line&)> getFurtherLines, MAPDLExtent& extent)
{
  return MeasureMAPDLBlock(getFurtherLines, this->Text, this->End, this->Chunk,
    this->Report.Part(this->GetProgress(this->Text), 1), extent);
}

//------------------------------------------------------------------------------
std::int32_t MAPDLWalker::GetPromisedRows() const
{
  std::int32_t count = 0;
  return this->Parameters.Read(this->Command.GetField(PromiseField), count) == Value::Number
    ? std::max(count, 0)
    : 0;
}

//------------------------------------------------------------------------------
template <typename Block>
bool MAPDLWalker::TakeEnd(const Block& block, const char* expected)
{
  const MAPDLExtent& extent = block.Extent;
  // Blocks end with -1; those of nodes also with N,R5.3,LOC,-1 or the like.
  MAPDLCommand command;
  const char* text = extent.End;
  const bool hasMark = extent.IsEnded &&
    (extent.Next != extent.End ||
      (command.Take(text, Line(text, this->End).End) && command.Is("N")));
  const std::int32_t promised = this->GetPromisedRows();
  if (!hasMark && (promised == 0 || extent.NumberOfRows < promised))
  {
    return block.ForEachRow(this->Fault, [](const auto&) {}) &&
      this->Fault.Set(SkipBlanks(extent.End, this->End),
        extent.IsEnded ? ErrorKind::Syntax : ErrorKind::Truncated, expected);
  }
  this->Deck.NumberOfMiscountedBlocks += promised > 0 && extent.NumberOfRows != promised;
  this->Text = extent.Next;
  return true;
}

//------------------------------------------------------------------------------
bool MAPDLWalker::ReadNodeBlock()
{
  MAPDLNodeBlock block;
  MAPDLRowFormat& format = block.Format.Fields;
  int key = 0;
  if (!this->TakeKey("NBLOCK", { "SOLID" }, key) || !this->TakeFormat(1, format))
  {
    return false;
  }
  if (format.GetNumberOfIntegers() == format.GetNumberOfColumns())
  {
    return this->Fault.Set(this->LineBegin, ErrorKind::Unsupported,
      "a format with columns for coordinates, such as (3i9,6e21.13e3)", "none");
  }
  if (!this->Measure([](const Line&) { return 0; }, block.Extent) ||
    !this->TakeEnd(block, "more nodes, or the end of their block"))
  {
    return false;
  }
  this->Deck.NodeBlocks.push_back(std::move(block));
  return true;
}

//------------------------------------------------------------------------------
// Compact rows do not contain their number of nodes, but all have the same number of lines.
bool MAPDLWalker::FindFurtherLines(MAPDLElementFormat& format)
{
  MAPDLExtent lines;
  if (!this->Measure([](const Line&) { return 0; }, lines))
  {
    return false;
  }
  const std::int32_t promised = this->GetPromisedRows();
  if (promised == 0 || lines.NumberOfRows % promised != 0)
  {
    return this->Fault.Set(this->LineBegin, ErrorKind::Count,
      "the number of elements as field " + std::to_string(PromiseField) +
        " of EBLOCK with the key COMPACT, each on the same number of lines",
      std::to_string(promised) + " elements on " + std::to_string(lines.NumberOfRows) + " lines");
  }
  format.FurtherLines = static_cast<int>(lines.NumberOfRows / promised) - 1;
  return true;
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
  if (!this->TakeFormat(format.GetNumberOfHeaderFields() + 1, format.Fields) ||
    (format.Key == MAPDLElementKey::Compact && !this->FindFurtherLines(format)))
  {
    return false;
  }
  if (!this->Measure([&format](const Line& line) { return format.GetNumberOfFurtherLines(line); },
        block.Extent) ||
    !this->TakeEnd(block, "more elements, or the end of their block"))
  {
    return false;
  }
  this->Deck.ElementBlocks.push_back(std::move(block));
  return true;
}

//------------------------------------------------------------------------------
bool MAPDLWalker::ReadComponent()
{
  MAPDLComponent component;
  component.Name = ToUpperMAPDL(this->Command.GetField(1));
  const std::string entity = ToUpperMAPDL(this->Command.GetField(2)).substr(0, 4);
  component.OfNodes = entity == "NODE";
  std::int32_t count = 0;
  const bool isCounted = this->ReadField(3, count) == Value::Number;
  if (!this->TakeFormat(1, component.Fields))
  {
    return false;
  }
  component.Begin = this->Text;
  std::int64_t lines = -1; // unknown
  if (isCounted)
  {
    component.NumberOfValues = count;
    const int perLine = component.Fields.GetNumberOfIntegers();
    lines = (std::int64_t(count) + perLine - 1) / perLine;
  }
  component.IsEnded = false;
  while (this->Text < this->End && !component.IsEnded)
  {
    const Line line(this->Text, this->End);
    const MAPDLLine kind = ClassifyMAPDLLine(line);
    component.IsEnded = lines == 0 || kind == MAPDLLine::Command || kind == MAPDLLine::End;
    lines -= kind == MAPDLLine::Row && lines > 0;
    this->Text = component.IsEnded ? this->Text : line.Next;
  }
  component.End = this->Text;
  if (component.OfNodes || entity == "ELEM")
  {
    this->Deck.Components.push_back(std::move(component));
  }
  return true;
}

//------------------------------------------------------------------------------
bool MAPDLWalker::ReadTypeBlock()
{
  MAPDLRowFormat format;
  MAPDLExtent rows;
  if (!this->TakeFormat(2, format) || !this->Measure([](const Line&) { return 0; }, rows))
  {
    return false;
  }
  this->Text = rows.Next;
  return ForEachMAPDLRow(rows, this->Fault,
    [&](const Line& line, vtkIdType)
    {
      std::int32_t type = 0;
      MAPDLType element;
      MAPDLFault ignored; // options may be words
      const bool good =
        format.ReadInteger(line, 0, "the number of an element type", type, this->Fault) &&
        format.ReadInteger(line, 1, "the number of an element", element.Element, this->Fault);
      format.ReadInteger(line, 2, "", element.Shape, ignored);
      if (good)
      {
        this->Deck.Types[type] = element;
      }
      return good ? line.Next : nullptr;
    });
}
}
