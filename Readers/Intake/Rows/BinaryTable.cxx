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
// For others, one pass over the lengths finds the start of every 1024th row, and if only the first
// list varies, as is usual, its lengths.
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
  /// Number of values of a property of the first row.
  std::int32_t GetFirstLength(std::size_t property) const
  {
    const TableProperty& list = this->Stored[property];
    const std::ptrdiff_t bytes =
      this->Offsets[property + 1] - this->Offsets[property] - list.GetHeaderSize();
    return static_cast<std::int32_t>(bytes / GetSize(list.Type));
  }
  int FindProperties(const char*& place, const char* end, PropertyPlaces& places) const;
  bool FailAtRow(vtkIdType row, const char* place, const char* end, PropertyPlaces& places);
  bool HaveOneLength(const Progress& progress) const;
  template <typename Next>
  bool FindBlocks(const Progress& progress, Next&& next);
  bool FindFirstLists(const char* end, const Progress& progress);
  bool LoadBlock(const Request& request, PropertyPlaces& starts, Block& rows) const;

  BinaryScanner& Scanner;
  const char* Data = nullptr;
  const char* End = nullptr;           ///< of all rows
  std::ptrdiff_t Stride = 0;           ///< bytes from row to row if they have one length
  std::vector<std::ptrdiff_t> Offsets; ///< of the properties in the first row, and of its end
  std::vector<const char*> Starts;     ///< of blocks of rows of several lengths
  ///@{
  /// Of such rows of which only the first list varies: its property, or -1, bytes of a row beside
  /// its ids, and offsets of these, which are moved out by the first request.
  int List = -1;
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
    const std::int64_t header = property.GetHeaderSize();
    places[i] = place;
    std::int64_t length = property.Length, room = end - place - header;
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
  const auto found = static_cast<std::size_t>(this->FindProperties(place, end, places));
  const TableProperty& property = this->Stored[std::min(found, this->Stored.size() - 1)];
  const std::string bytesLeft = std::to_string(end - place) + " bytes left";
  const bool hasLength = property.IsList && end - place >= GetSize(property.CountType);
  const std::int64_t length = hasLength ? this->LoadLength(property.CountType, place) : 0;
  return this->Scanner.FailAt(place, length < 0 ? ErrorKind::Count : ErrorKind::Truncated,
    (property.IsList
        ? (this->Description.HasNamesOfFile ? "list " : "") + this->Quote(property.Name) + " of "
        : "") +
      this->Quote(this->Description.Name) + " " + std::to_string(row),
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
    least += property.IsList ? property.GetHeaderSize() : property.Length * GetSize(property.Type);
  }
  if (count == 0 || least == 0)
  {
    return true;
  }
  if (count > bytes / least)
  {
    return this->Fail(ErrorKind::Truncated,
      "at least " + std::to_string(count * least) + " bytes of " + this->CountRows(),
      std::to_string(bytes));
  }
  PropertyPlaces places(this->Stored.size());
  const char *place = this->Data, *const end = place + bytes;
  if (this->FindProperties(place, end, places) == static_cast<int>(places.size()))
  {
    places.push_back(place);
    std::transform(places.begin(), places.end(), std::back_inserter(this->Offsets),
      [this](const char* property) { return property - this->Data; });
    this->Stride = place - this->Data;
    this->End = this->Data + count * this->Stride;
    if (count <= bytes / this->Stride && this->HaveOneLength(progress))
    {
      this->Scanner.SetPosition(this->End);
      return !progress.IsStopped();
    }
    this->Stride = 0;
    if (this->FindFirstLists(end, progress))
    {
      return true;
    }
    this->List = -1;
    this->ListOffsets = Buffer<std::int32_t>();
  }
  return !progress.IsStopped() &&
    this->FindBlocks(progress,
      [&](vtkIdType row, const char*& next)
      {
        const char* const start = next;
        return this->FindProperties(next, end, places) == static_cast<int>(this->Stored.size()) ||
          this->FailAtRow(row, start, end, places);
      });
}

//------------------------------------------------------------------------------
// Whether the lists of all rows are as long as those of the first.
bool BinaryTable::HaveOneLength(const Progress& progress) const
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
        for (std::size_t i = 0; i < this->Stored.size(); ++i)
        {
          const auto check = [&](auto count)
          {
            const auto length = static_cast<decltype(count)>(this->GetFirstLength(i));
            const bool swap = this->Swap;
            const char* place = this->Data + this->Offsets[i] + begin * stride;
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
// The position of a row depends on the previous one, so this cannot be done in parallel.
// next(row, place) moves the place to the next row, or returns false.
template <typename Next>
bool BinaryTable::FindBlocks(const Progress& progress, Next&& next)
{
  const vtkIdType count = this->GetCount();
  const char* place = this->Data;
  this->Starts.clear();
  for (vtkIdType first = 0; first < count; first += BlockSize)
  {
    this->Starts.push_back(place);
    const vtkIdType last = std::min(first + BlockSize, count);
    for (vtkIdType row = first; row < last; ++row)
    {
      if (!next(row, place))
      {
        return false;
      }
    }
    if (!progress.Report(static_cast<double>(last) / count))
    {
      return false;
    }
  }
  this->End = place;
  this->Scanner.SetPosition(place);
  return true;
}

//------------------------------------------------------------------------------
// Finds rows of which only the first list varies; false if others do, or if there is an error.
bool BinaryTable::FindFirstLists(const char* end, const Progress& progress)
{
  const auto getLength = [&](const TableProperty& property, const char* place)
  { return this->LoadLength(property.CountType, place); };
  struct Other
  {
    const TableProperty* Property;
    std::ptrdiff_t Place; // without the ids of the first list
    std::int64_t Length;
  };
  std::vector<Other> others;
  std::ptrdiff_t before = 0, itemSize = 0, firstSize = 0;
  for (std::size_t i = 0; i < this->Stored.size(); ++i)
  {
    const TableProperty& property = this->Stored[i];
    if (property.IsList && this->List < 0)
    {
      this->List = static_cast<int>(i);
      before = this->Offsets[i];
      itemSize = GetSize(property.Type);
      firstSize = this->GetFirstLength(i) * itemSize;
    }
    else if (property.IsList)
    {
      others.push_back({ &property, this->Offsets[i] - firstSize, this->GetFirstLength(i) });
    }
  }
  const TableProperty& list = this->Stored[this->List];
  this->Rest = this->Offsets.back() - firstSize;
  this->ListOffsets = Buffer<std::int32_t>(this->GetCount() + 1);
  this->ListOffsets[0] = 0;
  std::int32_t* const offsets = this->ListOffsets.data();
  std::int64_t sum = 0;
  const std::ptrdiff_t rest = this->Rest;
  const auto find = [&](auto&& load)
  {
    return this->FindBlocks(progress,
      [&](vtkIdType row, const char*& place)
      {
        const std::ptrdiff_t room = end - place - rest;
        const std::int64_t length = room < 0 ? -1 : load(place + before);
        if (length < 0 || length > INT32_MAX || length * itemSize > room)
        {
          return false;
        }
        place += length * itemSize;
        for (const Other& other : others)
        {
          if (getLength(*other.Property, place + other.Place) != other.Length)
          {
            return false;
          }
        }
        place += rest;
        sum += length;
        offsets[row + 1] = static_cast<std::int32_t>(sum);
        return true;
      });
  };
  const bool isFound = list.CountType == ValueType::UInt8
    ? find([](const char* place) { return static_cast<unsigned char>(*place); })
    : find([&](const char* place) { return getLength(list, place); });
  return isFound && sum <= INT32_MAX;
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
  if (GetSize(stored.Type) != idSize || IsReal(stored.Type) ||
    (!this->HasOneLength() && this->List != property))
  {
    return false;
  }
  rows.Begin = this->Data + this->Offsets[property] + stored.GetHeaderSize();
  rows.Rest = this->HasOneLength() ? this->Stride - idSize * sizes.Common : this->Rest;
  rows.Swap = this->Swap;
  rows.Size = sizes.Common;
  rows.Offsets = sizes.Common < 0 ? sizes.Offsets.data() : nullptr;
  return true;
}

//------------------------------------------------------------------------------
bool BinaryTable::ReadSizes(int property, ListSizes& sizes, const Progress& progress)
{
  if (this->HasOneLength() || (this->List >= 0 && this->List != property))
  {
    sizes.Common = this->GetFirstLength(static_cast<std::size_t>(property));
    sizes.Total = sizes.Common * this->GetCount();
  }
  else if (this->List == property && this->ListOffsets.size() > 0)
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
  found += stored.GetHeaderSize() + item * GetSize(stored.Type);
  std::string number;
  WithType(
    stored.Type, [&](auto in) { AppendNumber(number, Load<decltype(in)>(found, this->Swap)); });
  const std::string& name = this->Description.Name;
  return this->Scanner.FailAt(found, ErrorKind::Index,
    DescribeIds(expected) +
      (name.empty() ? "" : " in " + this->Quote(name) + " " + std::to_string(row)),
    number);
}
}

//------------------------------------------------------------------------------
std::unique_ptr<TableRows> MakeBinaryRows(const Table& table, BinaryScanner& scanner)
{
  return std::make_unique<BinaryTable>(table, scanner);
}
}
