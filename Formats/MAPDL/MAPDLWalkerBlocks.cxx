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
    // Without an end mark the line after the rows is where commands go on.
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
  const auto checkRows = [&]
  {
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
    return good;
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
bool MAPDLWalker::ReadElementBlock()
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
  for (const auto& [type, element] : this->Deck.Types)
  {
    format.MostNodes[type] = GetMaxMAPDLNodes(GetMAPDLClass(element.Element, element.Shape));
  }
  if (!MeasureMAPDLElements(
        format, this->Text, this->End, this->Chunk, this->GetRest(), block.Extent))
  {
    return false;
  }
  const auto checkRows = [&]
  {
    bool good = true;
    for (std::size_t chunk = 0; chunk < block.Extent.Chunks.size() && good; ++chunk)
    {
      good = ForEachMAPDLElement(format, block.Extent, chunk, true, this->Fault,
        [](const Line&, vtkIdType, const MAPDLElement&) { return true; });
    }
    return good;
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
}
