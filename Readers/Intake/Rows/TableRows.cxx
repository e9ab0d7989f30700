// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Rows/TableRows.h"

#include "Base/Parallel.h"
#include "Base/Text.h"

#include <algorithm>
#include <mutex>
#include <type_traits>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// A value from 0 to 255; counts values that are changed. NaN becomes 0.
template <typename In>
std::uint8_t ToColor(In value, std::atomic<vtkIdType>& changed)
{
  constexpr bool isReal = std::is_floating_point<In>::value;
  const bool isPositive = value >= In(0);
  const bool isLarge =
    isPositive && (isReal ? value > In(1) : static_cast<std::uint64_t>(value) > UINT8_MAX);
  if (!isPositive || isLarge)
  {
    changed.fetch_add(1, std::memory_order_relaxed);
    return isLarge ? UINT8_MAX : 0;
  }
  return static_cast<std::uint8_t>(isReal ? value * UINT8_MAX + In(0.5) : value);
}

//------------------------------------------------------------------------------
// Calls function(in, out, convert) with values of the types of a property and of its column.
template <typename Function>
void WithConversion(
  ValueType type, const TableColumn& column, std::atomic<vtkIdType>& oddColors, Function&& function)
{
  WithType(type,
    [&](auto in)
    {
      using In = decltype(in);
      if (column.Conversion == ValueConversion::Color)
      {
        function(in, std::uint8_t(), [&](In value) { return ToColor(value, oddColors); });
      }
      else if (column.Type == type)
      {
        function(in, in, [](In value) { return value; });
      }
      else if (column.Type == ValueType::Float)
      {
        function(in, float(), [](In value) { return static_cast<float>(value); });
      }
      else
      {
        function(in, double(), [](In value) { return static_cast<double>(value); });
      }
    });
}
}

//------------------------------------------------------------------------------
void ListSizes::Finish()
{
  constexpr vtkIdType Chunk = 1 << 16;
  const vtkIdType count = this->Offsets.size() - 1;
  std::int32_t* const sizes = this->Offsets.data() + 1;
  std::atomic<bool> isCommon{ true };
  const std::int32_t first = count > 0 ? sizes[0] : -1;
  this->Offsets[0] = 0;
  ParallelScan(
    count, Chunk,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType sum = 0;
      bool same = true;
      for (vtkIdType i = begin; i < end; ++i)
      {
        sum += sizes[i];
        same &= sizes[i] == first;
      }
      if (!same)
      {
        isCommon = false;
      }
      return sum;
    },
    [this](vtkIdType total) { this->Total = total; },
    [&](vtkIdType begin, vtkIdType end, vtkIdType before)
    {
      // The sum may be too large for the offsets.
      for (vtkIdType i = begin; i < end && this->Total <= INT32_MAX; ++i)
      {
        before += sizes[i];
        sizes[i] = static_cast<std::int32_t>(before);
      }
    });
  this->Common = isCommon ? first : -1;
  if (isCommon)
  {
    this->Offsets = Buffer<std::int32_t>();
  }
}

//------------------------------------------------------------------------------
std::string TableRows::DescribeIds(const ListIds& expected)
{
  const bool isFromOne = expected.AreFromOne || expected.HaveSigns;
  const std::string range = expected.Limit > 0 ? (isFromOne ? " from 1 to " : " from 0 to ") +
      std::to_string(expected.Limit - (isFromOne ? 0 : 1))
                                               : " (there are none)";
  return expected.What + range + (expected.HaveSigns ? ", or the negative of one" : "") +
    (expected.HasBreaks ? ", or -1" : "");
}

//------------------------------------------------------------------------------
std::int64_t TableRows::LoadLongLength(ValueType type, const char* place) const
{
  return WithType(type,
    [&](auto value)
    {
      value = Load<decltype(value)>(place, this->Swap);
      const auto length = static_cast<std::int64_t>(value);
      return value > 0 && length < 0 ? INT64_MAX : length;
    });
}

//------------------------------------------------------------------------------
bool TableRows::CheckTotal(int property, const ListSizes& sizes)
{
  return sizes.Total <= INT32_MAX ||
    this->Fail(ErrorKind::Unsupported,
      "at most 2147483647 values in all lists " +
        this->Quote(this->Description.Properties[property].Name),
      std::to_string(sizes.Total));
}

//------------------------------------------------------------------------------
// Converts lists of any type; false if they no longer have their sizes, because the file has
// changed.
bool TableRows::CopyIds(
  const Block& rows, int property, const ListSizes& sizes, std::int32_t* ids) const
{
  const TableProperty& stored = this->Stored[property];
  const std::ptrdiff_t header = stored.GetHeaderSize();
  const bool swap = this->Swap;
  bool good = true;
  WithType(stored.Type,
    [&](auto in)
    {
      using In = decltype(in);
      rows.Properties[property].ForEach(rows.Count,
        [&](int i, const char* place)
        {
          const vtkIdType size = sizes.GetSize(rows.First + i);
          good = good && (!stored.IsList || this->LoadLength(stored.CountType, place) == size);
          place += header;
          for (vtkIdType j = 0; good && j < size; ++j)
          {
            // As numbers with a sign, large ones are negative, and a break is -1.
            constexpr bool isWord = std::is_integral<In>::value && sizeof(In) == sizeof(*ids);
            *ids++ = isWord ? Load<std::int32_t>(place, swap) : ToId(Load<In>(place, swap));
            place += sizeof(In);
          }
        });
    });
  return good;
}

//------------------------------------------------------------------------------
bool TableRows::ReadIds(int property, const ListIds& expected, const ListSizes& sizes,
  std::int32_t* all, TakeIds take, const Needs* needs, const Progress& progress)
{
  this->ExpectIds(property, expected);
  Request request(*this);
  request.Rows = needs;
  ListRows lists;
  const bool isFast = this->FindLists(property, sizes, lists);
  if (!isFast)
  {
    request.Add(property);
  }
  std::mutex mutex;
  vtkIdType badRow = this->GetCount(), badItem = 0;
  const auto findBad = [&](const Block& rows, const std::int32_t* ids)
  {
    for (vtkIdType row = rows.First;; ++row)
    {
      for (vtkIdType item = 0; item < sizes.GetSize(row); ++item, ++ids)
      {
        if (!AreValid(ids, 1, expected))
        {
          const std::lock_guard<std::mutex> lock(mutex);
          badItem = row < badRow ? item : badItem;
          badRow = std::min(row, badRow);
          return false;
        }
      }
    }
  };
  const bool good = this->ForEachBlock(request, progress,
    [&](const Block& rows)
    {
      thread_local std::vector<std::int32_t> scratch;
      const vtkIdType last = rows.First + rows.Count;
      const vtkIdType size = sizes.GetOffset(last) - sizes.GetOffset(rows.First);
      scratch.resize(all ? 0 : static_cast<std::size_t>(size));
      std::int32_t* const ids = all ? all + sizes.GetOffset(rows.First) : scratch.data();
      if (isFast)
      {
        lists.Copy(rows.First, last, ids);
      }
      else if (!this->CopyIds(rows, property, sizes, ids))
      {
        return false;
      }
      if (!AreValid(ids, size, expected))
      {
        return findBad(rows, ids);
      }
      for (vtkIdType i = 0; expected.AreFromOne && i < size; ++i)
      {
        --ids[i];
      }
      take(rows.First, rows.Count, ids);
      return true;
    });
  return badRow < this->GetCount() ? this->FailAtId(badRow, property, badItem, expected) : good;
}

//------------------------------------------------------------------------------
bool TableRows::ReadLists(int property, const ListIds& expected, ListSizes& sizes,
  Buffer<std::int32_t>& all, const Progress& progress)
{
  if (!this->ReadSizes(property, sizes, progress.Part(0, 0.3)))
  {
    return false;
  }
  all = Buffer<std::int32_t>(sizes.Total);
  return this->ReadIds(
    property, expected, sizes, all.data(), [](vtkIdType, vtkIdType, const std::int32_t*) {},
    nullptr, progress.Part(0.3, 1));
}

//------------------------------------------------------------------------------
// Lists without an item keep the value in the array.
// @param tuples of the rows, -1 for none; or nullptr if they follow first, that of row 0
void TableRows::ReadColumn(
  const Block& rows, const TableColumn& column, const std::int32_t* tuples, vtkIdType first)
{
  const TableProperty& property = this->Stored[column.Property];
  const Places& places = rows.Properties[column.Property];
  const bool swap = this->Swap;
  const vtkIdType stride = column.Stride;
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
          { value = static_cast<decltype(out)>(this->LoadLength(property.CountType, place)); });
      });
    return;
  }
  WithConversion(property.Type, column, this->OddColors,
    [&](auto in, auto out, auto convert)
    {
      using In = decltype(in);
      const std::ptrdiff_t item = property.GetHeaderSize() +
        std::max(column.Item, 0) * static_cast<std::ptrdiff_t>(sizeof(In));
      if (!property.IsList)
      {
        forEach(out,
          [&](const char* place, auto& value) { value = convert(Load<In>(place + item, swap)); });
        return;
      }
      forEach(out,
        [&](const char* place, auto& value)
        {
          if (column.Item < this->LoadLength(property.CountType, place))
          {
            value = convert(Load<In>(place + item, swap));
          }
        });
    });
}

//------------------------------------------------------------------------------
bool TableRows::ReadColumns(
  const std::vector<TableColumn>& columns, const TableTargets& targets, const Progress& progress)
{
  Request request(*this);
  for (const TableColumn& column : columns)
  {
    request.Add(column.Property);
  }
  return columns.empty() ||
    this->ForEachBlock(request, progress,
      [&](const Block& rows)
      {
        std::int32_t tuples[BlockSize];
        for (int i = 0; !targets.AreRows() && i < rows.Count; ++i)
        {
          tuples[i] = static_cast<std::int32_t>(targets.Find(rows.First + i));
        }
        for (const TableColumn& column : columns)
        {
          this->ReadColumn(rows, column, targets.AreRows() ? nullptr : tuples, targets.First);
        }
        return true;
      });
}

//------------------------------------------------------------------------------
bool TableRows::ForEachPoint(
  const std::vector<int>& properties, FunctionRef<void(vtkIdType row, const double* x)> visit)
{
  Request request(*this);
  for (const int property : properties)
  {
    if (property >= 0)
    {
      request.Add(property);
    }
  }
  return this->ForEachBlock(request, Progress(),
    [&](const Block& rows)
    {
      float values[3 * BlockSize];
      std::fill_n(values, 3 * rows.Count, 0.F);
      for (int c = 0; c < 3; ++c)
      {
        if (properties[c] >= 0)
        {
          const int item = this->Stored[properties[c]].Length > 1 ? c : -1;
          const TableColumn column = { properties[c], item, ValueConversion::Value,
            ValueType::Float, values + c, 3 };
          this->ReadColumn(rows, column, nullptr, -rows.First);
        }
      }
      for (int i = 0; i < rows.Count; ++i)
      {
        const double x[3] = { values[3 * i], values[3 * i + 1], values[3 * i + 2] };
        visit(rows.First + i, x);
      }
      return true;
    });
}

//------------------------------------------------------------------------------
bool TableScanner::Locate(
  std::unique_ptr<TableRows>& rows, const Table& table, const Progress& progress, RowLayout layout)
{
  if (!this->Binary)
  {
    rows = MakeTextRows(table, this->Text, this->Lines, layout);
    return rows->Locate(progress);
  }
  this->Binary->SetPosition(this->Text.GetPosition());
  rows = MakeBinaryRows(table, *this->Binary);
  const bool good = rows->Locate(progress);
  this->Text.SetPosition(this->Binary->GetPosition());
  return good;
}

//------------------------------------------------------------------------------
bool TableScanner::ReadEnd()
{
  constexpr char end[] = "the end of the file";
  if (!this->Text.SkipSpace())
  {
    return true;
  }
  const char* const place = this->Text.GetPosition();
  return this->Binary ? this->Binary->FailAt(place, ErrorKind::Syntax, end,
                          CountOf(this->Text.GetBytesLeft(), "more byte", "more bytes"))
                      : this->Text.FailAt(place, ErrorKind::Syntax, end);
}

//------------------------------------------------------------------------------
bool ReadTextOrBinary(const MappedFile& file, std::optional<ByteOrder> order, char comment,
  vtkIdType chunk, ScanError& error, const Progress& progress,
  FunctionRef<bool(TableScanner&, const Progress&)> read)
{
  ScanError ofMesh;
  const auto readTables =
    [&](TextScanner& text, BinaryScanner* binary, const TextLines* lines, const Progress& part)
  {
    TableScanner scanner{ text, binary, lines, {} };
    const bool good = read(scanner, part);
    ofMesh = good ? ScanError() : scanner.Error;
    return good;
  };
  bool good = false;
  if (!order)
  {
    good = ReadText(file, comment, chunk, error, progress,
      [&](TextScanner& text, const TextLines* lines, const Progress& part)
      { return readTables(text, nullptr, lines, part); });
  }
  else
  {
    TextScanner text(file.GetName(), file.begin(), file.end());
    BinaryScanner binary(file.GetName(), file.begin(), file.end(), *order);
    good = readTables(text, &binary, nullptr, progress);
    error = binary.HasFailed() ? binary.GetError() : text.GetError();
  }
  if (ofMesh && !progress.IsStopped())
  {
    error = { ofMesh.Kind, file.GetName() + ": " + ofMesh.Message };
  }
  return good;
}
}
