// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Rows/TableRows.h"

#include "Base/Number.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <mutex>
#include <optional>

namespace camaron
{
namespace
{
constexpr int ValueBytes = 2; // a digit and a blank or line end

//------------------------------------------------------------------------------
// Integers of at most 32 bits also as real numbers, such as 255.0.
template <typename Value>
bool ReadValue(TextRow& row, Value& value, const std::string& what)
{
  if constexpr (std::is_floating_point<Value>::value)
  {
    return row.ReadReal(value, what.c_str());
  }
  else
  {
    using Limits = std::numeric_limits<Value>;
    double number = 0;
    if (!row.ReadReal(number, what.c_str()))
    {
      return false;
    }
    const bool fits = number >= Limits::lowest() && number <= Limits::max() &&
      number == static_cast<double>(static_cast<std::int64_t>(number));
    value = fits ? static_cast<Value>(number) : Value(0);
    return fits || row.FailAtLast(ErrorKind::Syntax, what);
  }
}

//------------------------------------------------------------------------------
bool ReadValue(TextRow& row, std::int64_t& value, const std::string& what)
{
  return row.ReadInteger(value, what.c_str());
}

//------------------------------------------------------------------------------
// Half of the numbers exceed the signed type.
bool ReadValue(TextRow& row, std::uint64_t& value, const std::string& what)
{
  std::string_view word;
  if (!row.ReadWord(word, what.c_str()))
  {
    return false;
  }
  word.remove_prefix(word[0] == '+' ? 1 : 0);
  const char* const end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, value);
  return (result.ec == std::errc() && result.ptr == end) || row.FailAtLast(ErrorKind::Syntax, what);
}

//------------------------------------------------------------------------------
// With lines, rows are read in parallel; otherwise serially, one per line or as a sequence of
// numbers, which also reports errors.
class TextTable : public TableRows
{
public:
  TextTable(const Table& table, TextScanner& scanner, const TextLines* lines, RowLayout layout);

  bool Locate(const Progress& progress) override;
  bool Check(const Progress& progress) override;
  bool ReadSizes(int property, ListSizes& sizes, const Progress& progress) override;
  bool Fail(ErrorKind kind, const std::string& expected, const std::string& found) override
  {
    return this->FailInRow(0, kind, expected, found);
  }
  bool FailInRow(
    vtkIdType row, ErrorKind kind, const std::string& expected, const std::string& found) override;

private:
  bool ForEachBlock(const Request& request, const Progress& progress, VisitBlock visit) override;
  void ExpectIds(int property, const ListIds& expected) override;

  /// Rows that a thread has converted to those of a binary file.
  struct Converted
  {
    Block Rows{ -1, 0, {} };
    std::vector<char> Bytes;
    std::size_t Size = 0;
    bool IsFixed = false;             ///< whether all rows have the same size
    std::vector<std::size_t> Offsets; ///< of the properties of every row, or of the first
    std::vector<const char*> Places;

    void Put(const void* value, std::size_t size)
    {
      if (this->Bytes.size() <= this->Size + size) // never without memory
      {
        this->Bytes.resize(2 * (this->Size + size) + 1);
      }
      std::memcpy(this->Bytes.data() + this->Size, value, size);
      this->Size += size;
    }
    const Block& GetBlock(const Request& request);
  };
  static constexpr int MostRows = 128; ///< converted at a time

  /// Calls visit(row, part, TextRow&) for all rows; false with the error in the scanner, unless
  /// lines are used.
  template <typename Visit>
  bool ForEachRow(const Progress& progress, Visit&& visit)
  {
    return !this->Rows || this->Rows->ForEach(progress, visit);
  }
  bool ReadLength(TextRow& row, int property, std::int64_t& length) const;
  bool Skip(TextRow& row, int property, std::int64_t number) const;
  bool SkipProperties(TextRow& row, int first, int last) const;
  bool Convert(TextRow& row, const Request& request, Converted& to) const;
  bool ConvertValue(TextRow& row, int property, Converted& to) const;
  bool ConvertIds(TextRow& row, int property, std::int64_t count, Converted& to) const;
  int GetNumberOfProperties() const { return static_cast<int>(this->Stored.size()); }

  TextScanner& Scanner;
  const TextLines* Lines;
  RowLayout Layout;
  std::optional<RowSequence> Rows; ///< if there are any values
  TextScanner Begin;               ///< at the start of the rows
  bool IsChecked = false;
  std::vector<std::string> Values;                 ///< of properties, for messages
  std::vector<std::string> Lengths;                ///< of lists, for messages
  std::vector<std::optional<ListIds>> ExpectedIds; ///< of properties that are ids
};

//------------------------------------------------------------------------------
TextTable::TextTable(
  const Table& table, TextScanner& scanner, const TextLines* lines, RowLayout layout)
  : TableRows(table, false)
  , Scanner(scanner)
  , Lines(lines)
  , Layout(layout)
  , Begin(scanner)
  , ExpectedIds(table.Properties.size())
{
  for (TableProperty& property : this->Stored)
  {
    if (table.HasNamesOfFile)
    {
      const std::string name = QuoteWord(property.Name) + " of " + QuoteWord(table.Name);
      this->Values.push_back(
        (property.IsList ? "a value of " : "") + name + " (" + GetName(property.Type) + ")");
      this->Lengths.push_back("the length of the list " + name);
    }
    else
    {
      const std::string name = property.Name + " of a " + table.Name;
      this->Values.push_back((property.IsList ? "one of the " : "") + name);
      this->Lengths.push_back("the number of " + name);
    }
    property.CountType = ValueType::Int32;
  }
}

//------------------------------------------------------------------------------
bool TextTable::ReadLength(TextRow& row, int property, std::int64_t& length) const
{
  return row.ReadInteger(length, this->Lengths[property].c_str()) &&
    ((length >= 0 && length <= INT32_MAX) ||
      row.FailAtLast(ErrorKind::Count, this->Lengths[property]));
}

//------------------------------------------------------------------------------
bool TextTable::Skip(TextRow& row, int property, std::int64_t number) const
{
  std::string_view word;
  bool good = true;
  for (; number > 0 && good; --number)
  {
    good = row.ReadWord(word, this->Values[property].c_str());
  }
  return good;
}

//------------------------------------------------------------------------------
bool TextTable::SkipProperties(TextRow& row, int first, int last) const
{
  bool good = true;
  for (int i = first; i < last && good; ++i)
  {
    std::int64_t length = 1;
    good =
      (!this->Stored[i].IsList || this->ReadLength(row, i, length)) && this->Skip(row, i, length);
  }
  return good;
}

//------------------------------------------------------------------------------
void TextTable::ExpectIds(int property, const ListIds& expected)
{
  this->Stored[property].Type = ValueType::Int32;
  this->Values[property] = DescribeIds(expected);
  this->ExpectedIds[property] = expected;
}

//------------------------------------------------------------------------------
bool TextTable::ConvertValue(TextRow& row, int property, Converted& to) const
{
  return WithType(this->Stored[property].Type,
    [&](auto value)
    {
      const bool good = ReadValue(row, value, this->Values[property]);
      to.Put(&value, sizeof(value));
      return good;
    });
}

//------------------------------------------------------------------------------
// Ids are read as written, whatever the range of their type.
bool TextTable::ConvertIds(TextRow& row, int property, std::int64_t count, Converted& to) const
{
  const ValueType type = this->Description.Properties[property].Type;
  const ListIds& expected = *this->ExpectedIds[property];
  const std::string& what = this->Values[property];
  const auto convert = [&](auto value)
  {
    const bool good = ReadValue(row, value, what);
    const std::int32_t id = ToId(value);
    to.Put(&id, sizeof(id));
    return good && (AreValid(&id, 1, expected) || row.FailAtLast(ErrorKind::Index, what));
  };
  bool good = true;
  while (count > 0 && good)
  {
    constexpr std::int64_t atOnce = 64;
    std::int32_t ids[atOnce];
    const bool isPlain =
      !expected.HasBreaks && !expected.AreFromOne && !expected.HaveSigns && !IsReal(type);
    const std::int32_t usual = !isPlain
      ? 0
      : row.ReadShortIds(ids, static_cast<std::int32_t>(std::min(count, atOnce)), expected.Limit);
    to.Put(ids, usual * sizeof(std::int32_t));
    count -= usual;
    if (count > 0 && usual == 0)
    {
      good = IsReal(type) ? convert(0.) : convert(std::int64_t(0));
      --count;
    }
  }
  return good;
}

//------------------------------------------------------------------------------
// Skips the rest of the row, if its end is unknown or not yet checked.
bool TextTable::Convert(TextRow& row, const Request& request, Converted& to) const
{
  for (int i = 0; i < request.End; ++i)
  {
    std::int64_t length = 1;
    if (!to.IsFixed || to.Rows.Count == 0)
    {
      to.Offsets[static_cast<std::size_t>(i * MostRows + to.Rows.Count)] = to.Size;
    }
    if (this->Stored[i].IsList)
    {
      if (!this->ReadLength(row, i, length))
      {
        return false;
      }
      const auto size = static_cast<std::int32_t>(length);
      to.Put(&size, sizeof(size));
    }
    const bool converts = request.Properties[i];
    const bool areIds = this->ExpectedIds[i].has_value();
    bool good = !converts ? this->Skip(row, i, length)
      : areIds            ? this->ConvertIds(row, i, length, to)
                          : true;
    for (; converts && !areIds && good && length > 0; --length)
    {
      good = this->ConvertValue(row, i, to);
    }
    if (!good)
    {
      return false;
    }
  }
  return (this->IsChecked && this->Layout == RowLayout::OneLine) ||
    this->SkipProperties(row, request.End, this->GetNumberOfProperties());
}

//------------------------------------------------------------------------------
const TableRows::Block& TextTable::Converted::GetBlock(const Request& request)
{
  const auto stride = static_cast<std::ptrdiff_t>(this->Size) / this->Rows.Count;
  this->Places.resize(this->IsFixed ? 0 : this->Offsets.size());
  this->Rows.Properties.resize(static_cast<std::size_t>(request.End));
  for (int i = 0; i < request.End; ++i)
  {
    const std::size_t first = static_cast<std::size_t>(i) * MostRows;
    for (std::size_t row = first; row < first + this->Rows.Count && !this->IsFixed; ++row)
    {
      this->Places[row] = this->Bytes.data() + this->Offsets[row];
    }
    this->Rows.Properties[i] = { this->Bytes.data() + this->Offsets[first], stride,
      this->IsFixed ? nullptr : this->Places.data() + first };
  }
  return this->Rows;
}

//------------------------------------------------------------------------------
bool TextTable::ForEachBlock(const Request& request, const Progress& progress, VisitBlock visit)
{
  const bool isOneLine = this->Layout == RowLayout::OneLine;
  const bool isChecked = this->IsChecked && isOneLine;
  const bool counts = isOneLine && !this->IsChecked;
  const std::size_t parts = this->Rows ? this->Rows->GetNumberOfParts() : 1;
  bool isFixed = true;
  for (int i = 0; i < request.End; ++i)
  {
    isFixed = isFixed && !(request.Properties[i] && this->Stored[i].IsList);
  }
  std::vector<Converted> converted(parts);
  std::mutex mutex;
  const auto flush = [&](Converted& rows)
  {
    const bool good = rows.Rows.Count == 0 || visit(rows.GetBlock(request));
    rows.Rows.Count = 0;
    rows.Size = 0;
    return good;
  };
  bool good = this->ForEachRow(progress,
    [&](vtkIdType row, vtkIdType part, TextRow& text)
    {
      Converted& rows = converted[static_cast<std::size_t>(part)];
      if (isChecked && request.Rows && !(*request.Rows)(row, 1))
      {
        text.Skip();
        return true;
      }
      if (rows.Rows.Count == MostRows || row != rows.Rows.First + rows.Rows.Count)
      {
        if (!flush(rows))
        {
          return false;
        }
        rows.Rows.First = row;
        rows.IsFixed = isFixed;
        rows.Offsets.resize(static_cast<std::size_t>(request.End * MostRows));
      }
      if (!this->Convert(text, request, rows))
      {
        return false;
      }
      ++rows.Rows.Count;
      if (counts && text.HasMore())
      {
        const std::lock_guard<std::mutex> lock(mutex);
        this->LongRows.Add(row);
      }
      return true;
    });
  for (Converted& rest : converted)
  {
    good = good && flush(rest);
  }
  this->IsChecked = this->IsChecked || good;
  return good;
}

//------------------------------------------------------------------------------
bool TextTable::Locate(const Progress& progress)
{
  if (this->Scanner.HasFailed())
  {
    return false;
  }
  const vtkIdType least = std::max(1, this->GetNumberOfProperties()) * ValueBytes;
  if (this->GetCount() == 0 || this->GetNumberOfProperties() == 0)
  {
    this->IsChecked = true;
    return true;
  }
  if (this->GetCount() > (this->Scanner.GetBytesLeft() + 1) / least)
  {
    return this->Scanner.FailAt(this->Scanner.GetPosition(), ErrorKind::Truncated,
      "at least " + std::to_string(this->GetCount() * least) + " bytes of " + this->CountRows(),
      std::to_string(this->Scanner.GetBytesLeft()));
  }
  this->Rows.emplace(
    this->Scanner, this->Lines, this->GetCount(), this->Layout, this->Layout == RowLayout::OneLine);
  return this->Lines ? static_cast<bool>(*this->Rows) : this->Check(progress);
}

//------------------------------------------------------------------------------
bool TextTable::Check(const Progress& progress)
{
  return this->IsChecked ||
    this->ForEachBlock(Request(*this), progress, [](const Block&) { return true; });
}

//------------------------------------------------------------------------------
bool TextTable::ReadSizes(int property, ListSizes& sizes, const Progress& progress)
{
  if (this->GetCount() == 0)
  {
    return true;
  }
  sizes.Offsets = Buffer<std::int32_t>(this->GetCount() + 1);
  const auto read = [&](vtkIdType row, vtkIdType, TextRow& text)
  {
    std::int64_t length = 0;
    const bool good =
      this->SkipProperties(text, 0, property) && this->ReadLength(text, property, length);
    sizes.Offsets[row + 1] = static_cast<std::int32_t>(length);
    return good &&
      (this->Layout == RowLayout::OneLine ||
        (this->Skip(text, property, length) &&
          this->SkipProperties(text, property + 1, this->GetNumberOfProperties())));
  };
  if (!this->ForEachRow(progress, read))
  {
    return false;
  }
  sizes.Finish();
  // Only the lengths in lines have been read so far; the file must have the values they declare
  // before memory is allocated.
  const TextLines::Section& lines = this->Rows->GetSection();
  const vtkIdType bytes = this->Lines ? lines.End - lines.Begin : this->Begin.GetBytesLeft();
  return this->CheckTotal(property, sizes) &&
    (sizes.Total <= bytes / ValueBytes + 1 ||
      this->Fail(ErrorKind::Truncated,
        "at most 2147483647 values in all lists " +
          this->Quote(this->Description.Properties[property].Name),
        std::to_string(sizes.Total)));
}

//------------------------------------------------------------------------------
bool TextTable::FailInRow(
  vtkIdType row, ErrorKind kind, const std::string& expected, const std::string& found)
{
  TextScanner scanner = this->Begin;
  scanner.SkipSpace();
  for (; row > 0 && this->Layout == RowLayout::OneLine; --row)
  {
    scanner.SkipLine();
    scanner.SkipSpace();
  }
  return !this->Lines && this->Scanner.FailAt(scanner.GetPosition(), kind, expected, found);
}
}

//------------------------------------------------------------------------------
std::unique_ptr<TableRows> MakeTextRows(
  const Table& table, TextScanner& scanner, const TextLines* lines, RowLayout layout)
{
  return std::make_unique<TextTable>(table, scanner, lines, layout);
}
}
