// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Rows/TableRows.h"

#include "Base/Number.h"
#include "Base/Parallel.h"
#include "Intake/Rows/BinaryScanner.h"

#include <algorithm>
#include <atomic>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// The places of rows without lists, or with lists as long as those of the first row, are computed.
// For others, one pass over the lengths finds the start of every 1024th row.
class BinaryTable : public TableRows
{
public:
  BinaryTable(const Table& table, BinaryScanner& scanner)
    : TableRows(table, scanner.IsSwapped())
    , Scanner(scanner)
  {
  }

  bool Locate(const Progress& progress) override;
  bool Check(const Progress&) override { return true; } // done by Locate
  bool ReadSizes(int property, ListSizes& sizes, const Progress& progress) override;
  bool Fail(ErrorKind kind, const std::string& expected, const std::string& found) override
  {
    return this->Scanner.FailAt(this->Data, kind, expected, found);
  }

private:
  using PropertyPlaces = std::vector<const char*>;

  bool ForEachBlock(const Request& request, const Progress& progress, VisitBlock visit) override;
  bool FindLists(int property, const ListSizes& sizes, ListRows& rows) const override;
  bool FailAtId(vtkIdType row, int property, vtkIdType item, const ListIds& expected) override;

  bool HasOneLength() const { return this->Stride > 0; }
  int FindProperties(const char*& place, const char* end, PropertyPlaces& places) const;
  bool FailAtRow(vtkIdType row, const char* place, const char* end, PropertyPlaces& places);
  bool HaveOneLength(const PropertyPlaces& first, const Progress& progress) const;
  bool FindBlocks(const char* end, const Progress& progress);
  bool LoadBlock(const Request& request, PropertyPlaces& starts, Block& rows) const;

  BinaryScanner& Scanner;
  const char* Data = nullptr;
  const char* End = nullptr;           ///< of all rows
  std::ptrdiff_t Stride = 0;           ///< bytes from row to row if they have one length
  std::vector<std::ptrdiff_t> Offsets; ///< of the properties in such rows
  std::vector<const char*> Starts;     ///< of blocks of other rows
  ///@{
  /// Of other rows with one list: where its first ids are, bytes of a row beside the ids, and
  /// offsets of the lists, which are moved out by the first request.
  std::ptrdiff_t ListBegin = 0;
  std::ptrdiff_t Rest = 0;
  Buffer<std::int32_t> ListOffsets;
  ///@}
};

//------------------------------------------------------------------------------
// Finds the properties of a row, and moves to its end. Returns the first property that does not fit
// before the end, or their number.
int BinaryTable::FindProperties(const char*& place, const char* end, PropertyPlaces& places) const
{
  const auto count = static_cast<int>(this->Stored.size());
  for (int i = 0; i < count; ++i)
  {
    const TableProperty& property = this->Stored[i];
    const std::int64_t header = property.IsList ? GetSize(property.CountType) : 0;
    places[i] = place;
    std::int64_t length = 1, room = end - place - header;
    if (property.IsList && room >= 0)
    {
      length = this->LoadLength(property.CountType, place);
    }
    room = room < 0 ? -1 : room / GetSize(property.Type);
    if (length < 0 || length > std::min<std::int64_t>(room, INT32_MAX))
    {
      return i;
    }
    place += header + length * GetSize(property.Type);
  }
  return count;
}

//------------------------------------------------------------------------------
bool BinaryTable::FailAtRow(
  vtkIdType row, const char* place, const char* end, PropertyPlaces& places)
{
  const TableProperty& property = this->Stored[this->FindProperties(place, end, places)];
  const std::string bytesLeft = std::to_string(end - place) + " bytes left";
  const bool hasLength = property.IsList && end - place >= GetSize(property.CountType);
  const std::int64_t length = hasLength ? this->LoadLength(property.CountType, place) : 0;
  return this->Scanner.FailAt(place, length < 0 ? ErrorKind::Count : ErrorKind::Truncated,
    (property.IsList ? "list " + QuoteWord(property.Name) + " of " : "") +
      QuoteWord(this->Description.Name) + " " + std::to_string(row),
    hasLength ? "a length of " + std::to_string(length) + " with " + bytesLeft
              : "the end of the file");
}

//------------------------------------------------------------------------------
bool BinaryTable::Locate(const Progress& progress)
{
  this->Data = this->Scanner.GetPosition();
  if (this->Scanner.HasFailed())
  {
    return false;
  }
  const vtkIdType count = this->GetCount(), bytes = this->Scanner.GetBytesLeft();
  std::ptrdiff_t least = 0; // bytes of a row with empty lists
  for (const TableProperty& property : this->Stored)
  {
    least += GetSize(property.IsList ? property.CountType : property.Type);
  }
  if (count == 0 || least == 0)
  {
    return true;
  }
  if (count > bytes / least)
  {
    return this->Fail(ErrorKind::Truncated,
      "at least " + std::to_string(count * least) + " bytes of " + std::to_string(count) +
        " elements " + QuoteWord(this->Description.Name),
      std::to_string(bytes));
  }
  PropertyPlaces first(this->Stored.size());
  const char *place = this->Data, *const end = place + bytes;
  if (this->FindProperties(place, end, first) == static_cast<int>(first.size()))
  {
    this->Stride = place - this->Data;
    this->End = this->Data + count * this->Stride;
    if (count <= bytes / this->Stride && this->HaveOneLength(first, progress))
    {
      std::transform(first.begin(), first.end(), std::back_inserter(this->Offsets),
        [this](const char* property) { return property - this->Data; });
      this->Scanner.SetPosition(this->End);
      return !progress.IsStopped();
    }
    this->Stride = 0;
  }
  return !progress.IsStopped() && this->FindBlocks(end, progress);
}

//------------------------------------------------------------------------------
// Whether the lists of all rows are as long as those of the first.
bool BinaryTable::HaveOneLength(const PropertyPlaces& first, const Progress& progress) const
{
  const std::ptrdiff_t stride = this->Stride;
  std::atomic<bool> good{ true };
  progress.ForBlocks(this->GetCount(), BlockSize,
    [&](vtkIdType firstRow, vtkIdType lastRow)
    {
      for (vtkIdType begin = firstRow; begin < lastRow && good; begin += BlockSize)
      {
        const vtkIdType end = std::min(begin + BlockSize, lastRow);
        bool same = true;
        for (std::size_t i = 0; i < first.size(); ++i)
        {
          const auto check = [&](auto count)
          {
            const auto length = Load<decltype(count)>(first[i], this->Swap);
            const bool swap = this->Swap;
            const char* place = first[i] + begin * stride;
            bool alike = true;
            for (vtkIdType row = begin; row < end; ++row, place += stride)
            {
              alike &= Load<decltype(count)>(place, swap) == length;
            }
            return alike;
          };
          if (this->Stored[i].IsList)
          {
            same &= WithType(this->Stored[i].CountType, check);
          }
        }
        if (!same)
        {
          good = false;
        }
      }
    });
  return good;
}

//------------------------------------------------------------------------------
// The position of a row depends on the previous one, so this cannot be done in parallel. For rows
// with one list, as is usual, the lengths are kept.
bool BinaryTable::FindBlocks(const char* end, const Progress& progress)
{
  const vtkIdType count = this->GetCount();
  const auto isList = [](const TableProperty& property) { return property.IsList; };
  const auto list = std::find_if(this->Stored.begin(), this->Stored.end(), isList);
  const bool hasOneList = std::none_of(list + 1, this->Stored.end(), isList);
  const std::ptrdiff_t itemSize = GetSize(list->Type);
  std::ptrdiff_t before = 0, fixed = 0; // bytes of the other properties and of the length
  for (auto property = this->Stored.begin(); property != this->Stored.end(); ++property)
  {
    before = property == list ? fixed : before;
    fixed += GetSize(property == list ? list->CountType : property->Type);
  }
  if (hasOneList)
  {
    this->ListBegin = before + GetSize(list->CountType);
    this->Rest = fixed;
    this->ListOffsets = Buffer<std::int32_t>(count + 1);
    this->ListOffsets[0] = 0;
  }
  std::int32_t* const offsets = this->ListOffsets.data();
  PropertyPlaces places(this->Stored.size());
  const char* place = this->Data;
  std::int64_t sum = 0;
  for (vtkIdType first = 0; first < count; first += BlockSize)
  {
    this->Starts.push_back(place);
    const vtkIdType last = std::min(first + BlockSize, count);
    const bool isShort = hasOneList && list->CountType == ValueType::UInt8 &&
      (end - place) / (fixed + UINT8_MAX * itemSize) >= BlockSize;
    for (vtkIdType row = first; isShort && row < last; ++row)
    {
      const auto length = static_cast<unsigned char>(place[before]);
      place += fixed + length * itemSize;
      sum += length;
      offsets[row + 1] = static_cast<std::int32_t>(sum);
    }
    for (vtkIdType row = first; !isShort && row < last; ++row)
    {
      const char* const start = place;
      if (this->FindProperties(place, end, places) < static_cast<int>(places.size()))
      {
        return this->FailAtRow(row, start, end, places);
      }
      if (hasOneList)
      {
        sum += (place - start - fixed) / itemSize;
        offsets[row + 1] = static_cast<std::int32_t>(sum);
      }
    }
    if (!progress.Report(static_cast<double>(last) / count))
    {
      return false;
    }
  }
  if (sum > INT32_MAX)
  {
    this->ListOffsets = Buffer<std::int32_t>();
  }
  this->End = place;
  this->Scanner.SetPosition(place);
  return true;
}

//------------------------------------------------------------------------------
// Finds the requested properties of a block; false if the file has become too short for them,
// because it has changed.
bool BinaryTable::LoadBlock(const Request& request, PropertyPlaces& starts, Block& rows) const
{
  const auto count = static_cast<std::size_t>(request.End);
  rows.Properties.resize(count);
  if (count > 0 && !this->HasOneLength())
  {
    PropertyPlaces places(this->Stored.size());
    starts.resize(count * BlockSize);
    const char* place = this->Starts[rows.First / BlockSize];
    for (int i = 0; i < rows.Count; ++i)
    {
      if (this->FindProperties(place, this->End, places) < static_cast<int>(places.size()))
      {
        return false;
      }
      for (std::size_t property = 0; property < count; ++property)
      {
        starts[property * BlockSize + i] = places[property];
      }
    }
  }
  for (std::size_t property = 0; property < count; ++property)
  {
    rows.Properties[property] = this->HasOneLength()
      ? Places{ this->Data + rows.First * this->Stride + this->Offsets[property], this->Stride }
      : Places{ nullptr, 0, starts.data() + property * BlockSize };
  }
  return true;
}

//------------------------------------------------------------------------------
bool BinaryTable::ForEachBlock(const Request& request, const Progress& progress, VisitBlock visit)
{
  const vtkIdType blocks = (this->GetCount() + BlockSize - 1) / BlockSize;
  std::atomic<vtkIdType> failed{ blocks };
  const bool finished = progress.For(blocks,
    [&](vtkIdType first, vtkIdType last)
    {
      Block rows;
      PropertyPlaces starts;
      for (vtkIdType block = first; block < last && block < failed; ++block)
      {
        rows.First = block * BlockSize;
        rows.Count = static_cast<int>(std::min(BlockSize, this->GetCount() - rows.First));
        if ((!request.Rows || (*request.Rows)(rows.First, rows.Count)) &&
          !(this->LoadBlock(request, starts, rows) && visit(rows)))
        {
          LowerTo(failed, block);
        }
      }
    });
  return finished && failed == blocks;
}

//------------------------------------------------------------------------------
bool BinaryTable::FindLists(int property, const ListSizes& sizes, ListRows& rows) const
{
  const TableProperty& stored = this->Stored[property];
  constexpr std::ptrdiff_t idSize = sizeof(std::int32_t);
  if (!stored.IsList || GetSize(stored.Type) != idSize || IsReal(stored.Type) ||
    (!this->HasOneLength() && this->Rest == 0))
  {
    return false;
  }
  rows.Begin = this->Data +
    (this->HasOneLength() ? this->Offsets[property] + GetSize(stored.CountType) : this->ListBegin);
  rows.Rest = this->HasOneLength() ? this->Stride - idSize * sizes.Common : this->Rest;
  rows.Swap = this->Swap;
  rows.Size = sizes.Common;
  rows.Offsets = sizes.Common < 0 ? sizes.Offsets.data() : nullptr;
  return true;
}

//------------------------------------------------------------------------------
bool BinaryTable::ReadSizes(int property, ListSizes& sizes, const Progress& progress)
{
  if (this->HasOneLength())
  {
    const char* const first = this->Data + this->Offsets[property];
    sizes.Common =
      static_cast<std::int32_t>(this->LoadLength(this->Stored[property].CountType, first));
    sizes.Total = sizes.Common * this->GetCount();
  }
  else if (this->ListOffsets.size() > 0)
  {
    sizes.Offsets = std::move(this->ListOffsets);
    sizes.Total = sizes.Offsets[this->GetCount()];
  }
  else if (this->GetCount() > 0)
  {
    sizes.Offsets = Buffer<std::int32_t>(this->GetCount() + 1);
    const ValueType type = this->Stored[property].CountType;
    Request request(*this);
    request.Add(property);
    const auto read = [&](const Block& rows)
    {
      std::int32_t* const size = sizes.Offsets.data() + 1 + rows.First;
      rows.Properties[property].ForEach(rows.Count, [&](int i, const char* place)
        { size[i] = static_cast<std::int32_t>(this->LoadLength(type, place)); });
      return true;
    };
    if (!this->ForEachBlock(request, progress, read))
    {
      return false;
    }
    sizes.Finish();
  }
  return this->CheckTotal(property, sizes);
}

//------------------------------------------------------------------------------
bool BinaryTable::FailAtId(vtkIdType row, int property, vtkIdType item, const ListIds& expected)
{
  const TableProperty& stored = this->Stored[property];
  Request request(*this);
  request.Add(property);
  PropertyPlaces starts;
  Block rows;
  rows.First = row / BlockSize * BlockSize;
  rows.Count = static_cast<int>(row - rows.First + 1);
  if (!this->LoadBlock(request, starts, rows))
  {
    return false;
  }
  const char* found = nullptr;
  rows.Properties[property].ForEach(rows.Count, [&](int, const char* place) { found = place; });
  found += stored.IsList ? GetSize(stored.CountType) + item * GetSize(stored.Type) : 0;
  std::string number;
  WithType(
    stored.Type, [&](auto in) { AppendNumber(number, Load<decltype(in)>(found, this->Swap)); });
  return this->Scanner.FailAt(found, ErrorKind::Index,
    DescribeIds(expected) + " in " + QuoteWord(this->Description.Name) + " " + std::to_string(row),
    number);
}
}

//------------------------------------------------------------------------------
std::unique_ptr<TableRows> MakeBinaryRows(const Table& table, BinaryScanner& scanner)
{
  return std::make_unique<BinaryTable>(table, scanner);
}
}
