// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PLYBinaryRows.h"

#include "Base/Number.h"
#include "Base/Parallel.h"
#include "PLYColumnWriting.h"
#include "PLYLists.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <type_traits>

namespace camaron
{
//------------------------------------------------------------------------------
PLYBinaryRows::PLYBinaryRows(const PLYElement& element, BinaryScanner& scanner)
  : PLYRows(element)
  , Scanner(scanner)
{
  this->Parts.emplace_back();
  for (std::size_t i = 0; i < element.Properties.size(); ++i)
  {
    const PLYProperty& property = element.Properties[i];
    Part& part = this->Parts.back();
    this->Locations.push_back({ this->Parts.size() - 1, part.Size });
    if (!property.IsList)
    {
      part.Size += GetSize(property.Type);
      continue;
    }
    part.List = static_cast<int>(i);
    part.CountOffset = part.Size;
    part.CountType = property.CountType;
    part.ItemSize = GetSize(property.Type);
    part.Size += GetSize(property.CountType);
    this->Parts.emplace_back();
  }
}

//------------------------------------------------------------------------------
std::int64_t PLYBinaryRows::LoadLengthOf(PLYType type, const char* place) const
{
  return WithType(type,
    [&](auto value) -> std::int64_t
    {
      const auto length = camaron::Load<decltype(value)>(place, this->Scanner.IsSwapped());
      if constexpr (std::is_unsigned<decltype(value)>::value)
      {
        return length > static_cast<std::uint64_t>(INT32_MAX) ? INT64_MAX
                                                              : static_cast<std::int64_t>(length);
      }
      return static_cast<std::int64_t>(length);
    });
}

//------------------------------------------------------------------------------
bool PLYBinaryRows::Locate(const Progress& progress)
{
  this->Data = this->Scanner.GetPosition();
  if (this->Scanner.HasFailed())
  {
    return false;
  }
  const vtkIdType count = this->GetCount();
  std::ptrdiff_t least = 0; // bytes of a row with empty lists
  for (const Part& part : this->Parts)
  {
    least += part.Size;
  }
  if (count == 0 || least == 0)
  {
    return true;
  }
  if (count > this->Scanner.GetBytesLeft() / least)
  {
    return this->Scanner.FailAt(this->Data, ErrorKind::Truncated,
      "at least " + std::to_string(count * least) + " bytes of " + std::to_string(count) +
        " elements " + QuoteWord(this->Element.Name),
      std::to_string(this->Scanner.GetBytesLeft()));
  }
  const bool hasLists = this->Parts.size() > 1;
  if (!hasLists || (this->GuessLength() && this->HaveGuessedLength(progress)))
  {
    this->Stride = hasLists ? this->Stride : least;
    this->End = this->Data + count * this->Stride;
    this->Scanner.SetPosition(this->End);
    return !progress.IsStopped();
  }
  this->Stride = 0;
  return !progress.IsStopped() && this->FindBlocks(progress);
}

//------------------------------------------------------------------------------
// Assumes that the lists of all rows are as long as those of the first; false if they do not fit.
bool PLYBinaryRows::GuessLength()
{
  const char* const end = this->Data + this->Scanner.GetBytesLeft();
  const char* place = this->Data;
  for (Part& part : this->Parts)
  {
    part.Begin = place - this->Data;
    if (end - place < part.Size)
    {
      return false;
    }
    const std::int64_t length = part.List < 0 ? 0 : this->LoadLength(part, place);
    place += part.Size;
    if (length < 0 || length > INT32_MAX || length * part.ItemSize > end - place)
    {
      return false;
    }
    part.CommonLength = static_cast<std::int32_t>(length);
    place += length * part.ItemSize;
  }
  this->Stride = place - this->Data;
  return this->GetCount() <= (end - this->Data) / this->Stride;
}

//------------------------------------------------------------------------------
bool PLYBinaryRows::HaveGuessedLength(const Progress& progress) const
{
  std::atomic<bool> good{ true };
  const auto check = [&](vtkIdType begin, vtkIdType end)
  {
    for (const Part& part : this->Parts)
    {
      bool same = true;
      const char* place = this->Data + begin * this->Stride + part.Begin;
      for (vtkIdType row = begin; part.List >= 0 && row < end; ++row)
      {
        same &= this->LoadLength(part, place) == part.CommonLength;
        place += this->Stride;
      }
      if (!same)
      {
        good = false;
      }
    }
  };
  progress.ForBlocks(this->GetCount(), BlockSize,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType begin = first; begin < last && good; begin += BlockSize)
      {
        check(begin, std::min(begin + BlockSize, last));
      }
    });
  return good && !progress.IsStopped();
}

//------------------------------------------------------------------------------
// Moves past a row and sums the lengths of its lists; false with the error in the scanner.
bool PLYBinaryRows::PassRow(vtkIdType row, const char*& place, const char* end, std::int64_t& sum)
{
  for (const Part& part : this->Parts)
  {
    std::int64_t length = 0;
    bool good = end - place >= part.Size;
    if (good && part.List >= 0)
    {
      length = this->LoadLength(part, place);
      good =
        length >= 0 && length <= (end - place - part.Size) / part.ItemSize && length <= INT32_MAX;
    }
    if (!good)
    {
      const std::string what = QuoteWord(this->Element.Name) + " " + std::to_string(row);
      return this->Scanner.FailAt(place, length < 0 ? ErrorKind::Count : ErrorKind::Truncated,
        (part.List >= 0 ? "list " + QuoteWord(this->Element.Properties[part.List].Name) + " of "
                        : "") +
          what,
        length == 0             ? "the end of the file"
          : length == INT64_MAX ? "an impossible length"
                                : "a length of " + std::to_string(length) + " with " +
            std::to_string(end - place) + " bytes left");
    }
    place += part.Size + length * part.ItemSize;
    sum += length;
  }
  return true;
}

//------------------------------------------------------------------------------
// The position of a row depends on the previous one, so this cannot be done in parallel. For rows
// with one list, as is usual, the lengths are kept.
bool PLYBinaryRows::FindBlocks(const Progress& progress)
{
  const vtkIdType count = this->GetCount();
  const char* place = this->Data;
  const char* const end = place + this->Scanner.GetBytesLeft();
  this->Starts.reserve(static_cast<std::size_t>((count + BlockSize - 1) / BlockSize));
  const Part& list = this->Parts.front();
  const bool hasOneList = this->Parts.size() == 2;
  const bool isShort = hasOneList && list.CountType == PLYType::UInt8;
  const std::ptrdiff_t fixed = list.Size + this->Parts.back().Size;
  constexpr int MaxShort = 255;
  const std::ptrdiff_t greatest = fixed + MaxShort * list.ItemSize;
  std::int64_t sum = 0;
  if (hasOneList)
  {
    this->Offsets = Buffer<std::int32_t>(count + 1);
    this->Offsets[0] = 0;
  }
  std::int32_t* const offsets = this->Offsets.data();
  for (vtkIdType first = 0; first < count; first += BlockSize)
  {
    this->Starts.push_back(place);
    const vtkIdType last = std::min(first + BlockSize, count);
    if (isShort && (end - place) / greatest >= BlockSize)
    {
      for (vtkIdType row = first; row < last; ++row)
      {
        const auto length = static_cast<unsigned char>(place[list.CountOffset]);
        place += fixed + static_cast<std::ptrdiff_t>(length) * list.ItemSize;
        sum += length;
        offsets[row + 1] = static_cast<std::int32_t>(sum);
      }
    }
    else
    {
      for (vtkIdType row = first; row < last; ++row)
      {
        if (!this->PassRow(row, place, end, sum))
        {
          return false;
        }
        if (hasOneList)
        {
          offsets[row + 1] = static_cast<std::int32_t>(sum);
        }
      }
    }
    for (vtkIdType row = first; hasOneList && row < last; ++row)
    {
      this->Least = std::min(this->Least, offsets[row + 1] - offsets[row]);
    }
    if (!progress.Report(static_cast<double>(last) / count))
    {
      return false;
    }
  }
  if (sum > INT32_MAX)
  {
    this->Offsets = Buffer<std::int32_t>();
  }
  this->End = place;
  this->Scanner.SetPosition(place);
  return true;
}

//------------------------------------------------------------------------------
// False if the file has become too short for them, because it has changed.
bool PLYBinaryRows::Load(vtkIdType block, Block& rows) const
{
  rows.First = block * BlockSize;
  rows.Count = static_cast<int>(std::min(BlockSize, this->GetCount() - rows.First));
  if (this->HasOneLength())
  {
    rows.Begin = this->Data + rows.First * this->Stride;
    return true;
  }
  rows.Begin = this->Starts[block];
  rows.Parts.resize(this->Parts.size() * BlockSize);
  const char* place = rows.Begin;
  for (int i = 0; i < rows.Count; ++i)
  {
    const char** start = &rows.Parts[i];
    for (const Part& part : this->Parts)
    {
      *start = place;
      start += BlockSize;
      std::ptrdiff_t room = this->End - place - part.Size;
      const std::int64_t length = room < 0 || part.List < 0 ? 0 : this->LoadLength(part, place);
      room = length > 0 ? room / part.ItemSize - length : room;
      if (room < 0 || length < 0)
      {
        return false;
      }
      place += part.Size + length * part.ItemSize;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// Whether the lists of rows still have the measured lengths.
bool PLYBinaryRows::HaveSizes(const Block& rows, int property, const PLYSizes& sizes) const
{
  if (this->HasOneLength())
  {
    return true;
  }
  const std::size_t number = this->Locations[property].Part;
  const Part& part = this->Parts[number];
  const char* const* const starts = rows.Parts.data() + number * BlockSize;
  bool good = true;
  for (int i = 0; i < rows.Count; ++i)
  {
    good &= starts[i + BlockSize] - starts[i] ==
      part.Size + static_cast<std::ptrdiff_t>(sizes.GetSize(rows.First + i)) * part.ItemSize;
  }
  return good;
}

//------------------------------------------------------------------------------
bool PLYBinaryRows::FindLists(int property, const PLYSizes& sizes, ListRows& rows) const
{
  const Location& at = this->Locations[property];
  const Part& part = this->Parts[at.Part];
  const bool hasOneList = this->Parts.size() == 2;
  if (part.ItemSize != sizeof(std::int32_t) || IsReal(this->Element.Properties[property].Type) ||
    (!this->HasOneLength() && !hasOneList))
  {
    return false;
  }
  const std::ptrdiff_t header = GetSize(part.CountType);
  rows.Swap = this->Scanner.IsSwapped();
  rows.Begin = this->Data + part.Begin + at.Offset + header;
  rows.Size = sizes.Common;
  rows.Rest = this->HasOneLength()
    ? this->Stride - static_cast<std::ptrdiff_t>(sizeof(std::int32_t)) * sizes.Common
    : part.Size + this->Parts.back().Size;
  rows.Offsets = sizes.Common < 0 ? sizes.Offsets.data() : nullptr;
  return true;
}

//------------------------------------------------------------------------------
// Calls visit(rows) in parallel; false if aborted, or if the file has changed.
template <typename Visit>
bool PLYBinaryRows::ForEachBlock(const Progress& progress, Visit&& visit, bool loads) const
{
  std::atomic<bool> good{ true };
  const bool finished = progress.For((this->GetCount() + BlockSize - 1) / BlockSize,
    [&](vtkIdType first, vtkIdType last)
    {
      Block rows;
      for (vtkIdType block = first; block < last && good; ++block)
      {
        if (!loads)
        {
          rows.First = block * BlockSize;
          rows.Count = static_cast<int>(std::min(BlockSize, this->GetCount() - rows.First));
        }
        if (!loads || this->Load(block, rows))
        {
          visit(static_cast<const Block&>(rows));
        }
        else
        {
          good = false;
        }
      }
    });
  return finished && good;
}

//------------------------------------------------------------------------------
PLYBinaryRows::Places PLYBinaryRows::GetPlaces(const Block& rows, int property) const
{
  const Location& at = this->Locations[property];
  if (this->HasOneLength())
  {
    return { rows.Begin + this->Parts[at.Part].Begin + at.Offset, this->Stride, nullptr, 0 };
  }
  return { nullptr, 0, rows.Parts.data() + at.Part * BlockSize, at.Offset };
}

//------------------------------------------------------------------------------
const char* PLYBinaryRows::GetPlace(vtkIdType row, int property) const
{
  Block rows;
  const char* found = this->Data;
  if (this->Load(row / BlockSize, rows))
  {
    this->GetPlaces(rows, property)
      .ForEach(rows.Count,
        [&](int i, const char* place) { found = i == row - rows.First ? place : found; });
  }
  return found;
}

//------------------------------------------------------------------------------
bool PLYBinaryRows::ReadSizes(int property, PLYSizes& sizes, const Progress& progress)
{
  const Part& part = this->Parts[this->Locations[property].Part];
  if (this->GetCount() == 0)
  {
    return true;
  }
  if (this->HasOneLength())
  {
    sizes.Common = part.CommonLength;
    sizes.Total = sizes.Common * this->GetCount();
  }
  else if (this->Offsets.size() > 0)
  {
    sizes.Offsets = std::move(this->Offsets);
    sizes.Total = sizes.Offsets[this->GetCount()];
    sizes.Least = this->Least;
  }
  else
  {
    sizes.Offsets = Buffer<std::int32_t>(this->GetCount() + 1);
    if (!this->ForEachBlock(progress,
          [&](const Block& rows)
          {
            std::int32_t* const size = sizes.Offsets.data() + 1 + rows.First;
            const char* const* starts =
              rows.Parts.data() + this->Locations[property].Part * BlockSize;
            for (int i = 0; i < rows.Count; ++i)
            {
              size[i] = static_cast<std::int32_t>(this->LoadLength(part, starts[i]));
            }
          }))
    {
      return false;
    }
    sizes.Finish();
  }
  if (sizes.Total > INT32_MAX)
  {
    return this->Scanner.FailAt(this->Data, ErrorKind::Unsupported,
      "fewer than 2147483648 values in all lists " +
        QuoteWord(this->Element.Properties[property].Name),
      std::to_string(sizes.Total));
  }
  return true;
}

//------------------------------------------------------------------------------
template <typename In>
bool PLYBinaryRows::ReadIdsAs(
  int property, const PLYIds& expected, const PLYLists& lists, const Progress& progress)
{
  const PLYSizes& sizes = lists.Sizes;
  // Unsigned arithmetic checks both ends of the range at once; -1 is checked first where allowed.
  using Wide = std::uint64_t;
  const Wide shift = expected.HasBreaks ? 1 : 0;
  const auto limit = static_cast<Wide>(expected.Limit) + shift;
  const bool swap = this->Scanner.IsSwapped();
  const auto load = [&](const char* place)
  {
    const In id = camaron::Load<In>(place, swap);
    if constexpr (std::is_floating_point<In>::value)
    {
      constexpr Wide none = INT64_MAX; // for breaks, too
      const bool isWhole = id >= -1 && id <= INT32_MAX && std::trunc(id) == id;
      return isWhole ? static_cast<Wide>(static_cast<std::int64_t>(id)) : none;
    }
    else
    {
      const bool isBreak =
        std::is_unsigned<In>::value && shift && id == std::numeric_limits<In>::max();
      return isBreak ? ~Wide(0) : static_cast<Wide>(static_cast<std::int64_t>(id));
    }
  };
  const std::ptrdiff_t header = GetSize(this->Element.Properties[property].CountType);
  std::atomic<vtkIdType> bad{ this->GetCount() };
  std::atomic<bool> isSame{ true };
  ListRows alone;
  const bool isFast = this->FindLists(property, sizes, alone);
  const auto forEachList = [&](const Block& rows, auto&& visit)
  {
    for (int i = 0; isFast && i < rows.Count; ++i)
    {
      visit(rows.First + i, alone.GetPlace(rows.First + i));
    }
    if (!isFast)
    {
      this->GetPlaces(rows, property)
        .ForEach(
          rows.Count, [&](int i, const char* place) { visit(rows.First + i, place + header); });
    }
  };
  const auto read = [&](const Block& rows, std::int32_t* ids)
  {
    const vtkIdType last = rows.First + rows.Count;
    if (isFast)
    {
      alone.Copy(rows.First, last, ids);
      return AreIds(
        ids, alone.GetNumberOfIds(rows.First, last), expected.Limit, expected.HasBreaks);
    }
    bool valid = true;
    forEachList(rows,
      [&](vtkIdType row, const char* place)
      {
        for (vtkIdType j = sizes.GetSize(row); j > 0; --j)
        {
          const Wide value = load(place);
          valid &= value + shift < limit;
          *ids++ = static_cast<std::int32_t>(value);
          place += sizeof(In);
        }
      });
    return valid;
  };
  const bool done = this->ForEachBlock(
    progress,
    [&](const Block& rows)
    {
      if (rows.First >= bad || !lists.Needs(rows.First, rows.Count))
      {
        return;
      }
      if (!isFast && !this->HaveSizes(rows, property, sizes))
      {
        isSame = false;
        return;
      }
      std::int32_t* const ids = lists.Provide(rows.First, rows.Count);
      if (read(rows, ids))
      {
        lists.Take(rows.First, rows.Count, ids);
        return;
      }
      vtkIdType badRow = INT64_MAX;
      forEachList(rows,
        [&](vtkIdType row, const char* place)
        {
          for (vtkIdType j = sizes.GetSize(row); j > 0 && badRow == INT64_MAX; --j)
          {
            badRow = load(place) + shift < limit ? badRow : row;
            place += sizeof(In);
          }
        });
      LowerTo(bad, badRow);
    },
    !isFast);
  if (bad < this->GetCount())
  {
    const char* place = this->GetPlace(bad, property) + header;
    while (this->End - place >= 2 * static_cast<std::ptrdiff_t>(sizeof(In)) &&
      load(place) + shift < limit)
    {
      place += sizeof(In);
    }
    std::string found;
    AppendNumber(found, camaron::Load<In>(place, swap));
    return this->Scanner.FailAt(place, ErrorKind::Index,
      DescribeIds(expected) + " in " + QuoteWord(this->Element.Name) + " " + std::to_string(bad),
      found);
  }
  return done && isSame;
}

//------------------------------------------------------------------------------
bool PLYBinaryRows::ReadIds(
  int property, const PLYIds& expected, const PLYLists& lists, const Progress& progress)
{
  return WithType(this->Element.Properties[property].Type, [&](auto value)
    { return this->ReadIdsAs<decltype(value)>(property, expected, lists, progress); });
}

//------------------------------------------------------------------------------
// Lists without an item keep the value in the array.
void PLYBinaryRows::ReadColumn(
  const Block& rows, const PLYColumn& column, const std::int32_t* tuples, vtkIdType first) const
{
  const PLYProperty& property = this->Element.Properties[column.Property];
  const Places places = this->GetPlaces(rows, column.Property);
  const vtkIdType stride = column.Stride;
  const bool swap = this->Scanner.IsSwapped();
  const auto forEach = [&](auto out, auto&& read)
  {
    auto* const values = static_cast<decltype(out)*>(column.Values);
    if (!tuples)
    {
      auto* const value = values + (first + rows.First) * stride;
      places.ForEach(rows.Count, [&](int i, const char* place) { read(place, value[i * stride]); });
      return;
    }
    places.ForEach(rows.Count,
      [&](int i, const char* place)
      {
        if (tuples[i] >= 0)
        {
          read(place, values[tuples[i] * stride]);
        }
      });
  };
  if (property.IsList && column.Item < 0)
  {
    WithType(column.Type,
      [&](auto out)
      {
        forEach(out, [&](const char* place, auto& value)
          { value = static_cast<decltype(out)>(this->LoadLengthOf(property.CountType, place)); });
      });
    return;
  }
  WithConversion(property.Type, column, this->OddColors,
    [&](auto in, auto out, auto convert)
    {
      using In = decltype(in);
      if (!property.IsList)
      {
        forEach(out,
          [&](const char* place, auto& value) { value = convert(camaron::Load<In>(place, swap)); });
        return;
      }
      const std::ptrdiff_t item =
        GetSize(property.CountType) + column.Item * static_cast<std::ptrdiff_t>(sizeof(In));
      forEach(out,
        [&](const char* place, auto& value)
        {
          if (column.Item < this->LoadLengthOf(property.CountType, place))
          {
            value = convert(camaron::Load<In>(place + item, swap));
          }
        });
    });
}

//------------------------------------------------------------------------------
bool PLYBinaryRows::ReadColumns(
  const std::vector<PLYColumn>& columns, const PLYTargets& targets, const Progress& progress)
{
  return columns.empty() ||
    this->ForEachBlock(progress,
      [&](const Block& rows)
      {
        std::int32_t tuples[BlockSize];
        for (int i = 0; !targets.AreRows() && i < rows.Count; ++i)
        {
          tuples[i] = static_cast<std::int32_t>(targets.Find(rows.First + i));
        }
        for (const PLYColumn& column : columns)
        {
          this->ReadColumn(rows, column, targets.AreRows() ? nullptr : tuples, targets.First);
        }
      });
}

//------------------------------------------------------------------------------
bool PLYBinaryRows::FailAt(vtkIdType row, int property, ErrorKind kind, const std::string& expected,
  const std::string& found)
{
  return this->Scanner.FailAt(this->GetPlace(row, property), kind, expected, found);
}
}
