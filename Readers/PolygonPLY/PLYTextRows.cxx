// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PLYTextRows.h"

#include "Base/Number.h"
#include "PLYColumnWriting.h"
#include "PLYLists.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <mutex>

namespace camaron
{
namespace
{
constexpr int ValueBytes = 2; // a digit and a blank or line end

//------------------------------------------------------------------------------
// Whether a number is representable in an integer type.
bool Fits(PLYType type, double value)
{
  return WithType(type,
    [&](auto number)
    {
      using Limits = std::numeric_limits<decltype(number)>;
      return value >= static_cast<double>(Limits::lowest()) &&
        value <= static_cast<double>(Limits::max()) &&
        value == static_cast<double>(static_cast<std::int64_t>(value));
    });
}

//------------------------------------------------------------------------------
// Needed because half of the numbers exceed the signed type.
bool ParseUnsigned(std::string_view word, std::uint64_t& value)
{
  const char* const end = word.data() + word.size();
  std::int64_t number;
  if (ParseInteger(word.data(), end, number) == end)
  {
    value = static_cast<std::uint64_t>(number);
    return number >= 0;
  }
  word.remove_prefix(!word.empty() && word[0] == '+');
  const auto result = std::from_chars(word.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

//------------------------------------------------------------------------------
// An id of type uint64, whose largest value means -1; others that exceed the signed type are
// invalid.
bool ReadUnsignedId(TextRow& row, std::int64_t& id, const std::string& what)
{
  std::string_view word;
  if (!row.ReadWord(word, what.c_str()))
  {
    return false;
  }
  const char* const end = word.data() + word.size();
  if (ParseInteger(word.data(), end, id) == end)
  {
    return true;
  }
  std::uint64_t number = 0;
  const bool good = ParseUnsigned(word, number);
  id = number == std::numeric_limits<std::uint64_t>::max() ? -1 : INT64_MAX;
  return good || row.FailAtLast(ErrorKind::Syntax, what);
}

//------------------------------------------------------------------------------
// An id of a real type, which has to be a whole number.
bool ReadRealId(TextRow& row, std::int64_t& id, const std::string& what)
{
  double number = 0;
  if (!row.ReadReal(number, what.c_str()))
  {
    return false;
  }
  const bool isWhole = number >= -1 && number <= INT32_MAX && std::trunc(number) == number;
  id = isWhole ? static_cast<std::int64_t>(number) : -1;
  return isWhole || row.FailAtLast(ErrorKind::Index, what);
}
}

//------------------------------------------------------------------------------
PLYTextRows::PLYTextRows(
  const PLYElement& element, TextScanner& scanner, const TextLines* lines, RowLayout layout)
  : PLYRows(element)
  , Scanner(scanner)
  , Lines(lines)
  , Layout(layout)
  , Begin(scanner)
{
  for (const PLYProperty& property : element.Properties)
  {
    const std::string name = QuoteWord(property.Name) + " of " + QuoteWord(element.Name);
    this->Values.push_back(
      (property.IsList ? "a value of " : "") + name + " (" + GetName(property.Type) + ")");
    this->Lengths.push_back("the length of the list " + name);
  }
}

//------------------------------------------------------------------------------
// Calls visit(row, TextRow&) for all rows; false with the error in the scanner, unless lines are
// used.
template <typename Visit>
bool PLYTextRows::ForEachRow(const Progress& progress, Visit&& visit)
{
  if (this->Lines)
  {
    return this->GetNumberOfProperties() == 0 || this->GetCount() == 0 ||
      VisitRows(*this->Lines, this->Section, this->Scanner.GetComment(), progress,
        [&](vtkIdType row, vtkIdType, TextRow& text) { return visit(row, text); });
  }
  TextScanner scanner = this->Begin;
  for (vtkIdType row = 0; row < this->GetCount(); ++row)
  {
    TextRow text(scanner, this->Layout);
    if (!visit(row, text) || scanner.HasFailed() ||
      !progress.Report(static_cast<double>(row) / this->GetCount()))
    {
      this->Scanner = scanner;
      return false;
    }
    if (this->Layout == RowLayout::OneLine)
    {
      scanner.SkipLine();
    }
  }
  if (!this->IsChecked)
  {
    this->Scanner = scanner; // now after the last row
  }
  return true;
}

//------------------------------------------------------------------------------
bool PLYTextRows::ReadLength(TextRow& row, int property, std::int64_t& length) const
{
  return row.ReadInteger(length, this->Lengths[property].c_str()) &&
    ((length >= 0 && length <= INT32_MAX) ||
      row.FailAtLast(ErrorKind::Count, this->Lengths[property]));
}

//------------------------------------------------------------------------------
bool PLYTextRows::SkipValues(TextRow& row, int property, std::int64_t number) const
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
bool PLYTextRows::Skip(TextRow& row, int begin, int end) const
{
  bool good = true;
  for (int i = begin; i < end && good; ++i)
  {
    std::int64_t length = 1;
    good = (!this->Element.Properties[i].IsList || this->ReadLength(row, i, length)) &&
      this->SkipValues(row, i, length);
  }
  return good;
}

//------------------------------------------------------------------------------
bool PLYTextRows::SkipRest(TextRow& row, int property) const
{
  return (this->IsChecked && this->Layout == RowLayout::OneLine) ||
    this->Skip(row, property, this->GetNumberOfProperties());
}

//------------------------------------------------------------------------------
void PLYTextRows::Finish(vtkIdType row, TextRow& text)
{
  if (!this->IsChecked && this->Layout == RowLayout::OneLine && text.HasMore())
  {
    static std::mutex mutex;
    const std::lock_guard<std::mutex> lock(mutex);
    this->LongRows.Add(row);
  }
}

//------------------------------------------------------------------------------
bool PLYTextRows::Locate(const Progress& progress)
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
      "at least " + std::to_string(this->GetCount() * least) + " bytes of " +
        std::to_string(this->GetCount()) + " elements " + QuoteWord(this->Element.Name),
      std::to_string(this->Scanner.GetBytesLeft()));
  }
  if (this->Lines)
  {
    this->Section = this->Lines->Find(this->Scanner.GetPosition(), this->GetCount());
    if (this->Section)
    {
      this->Scanner.SetPosition(this->Section.End);
    }
    return static_cast<bool>(this->Section);
  }
  return this->Check(progress);
}

//------------------------------------------------------------------------------
bool PLYTextRows::Check(const Progress& progress)
{
  if (!this->IsChecked)
  {
    this->IsChecked = this->ForEachRow(progress,
      [&](vtkIdType row, TextRow& text)
      {
        const bool good = this->SkipRest(text, 0);
        this->Finish(row, text);
        return good;
      });
  }
  return this->IsChecked;
}

//------------------------------------------------------------------------------
bool PLYTextRows::ReadSizes(int property, PLYSizes& sizes, const Progress& progress)
{
  if (this->GetCount() == 0)
  {
    return true;
  }
  sizes.Offsets = Buffer<std::int32_t>(this->GetCount() + 1);
  if (!this->ForEachRow(progress,
        [&](vtkIdType row, TextRow& text)
        {
          std::int64_t length = 0;
          const bool good =
            this->Skip(text, 0, property) && this->ReadLength(text, property, length);
          sizes.Offsets[row + 1] = static_cast<std::int32_t>(length);
          return good &&
            (this->Layout == RowLayout::OneLine ||
              (this->SkipValues(text, property, length) && this->SkipRest(text, property + 1)));
        }))
  {
    return false;
  }
  const bool fits = sizes.Finish();
  // Only the lengths in lines have been read so far; the file must have the values they declare
  // before memory is allocated.
  const vtkIdType bytes =
    this->Lines ? this->Section.End - this->Section.Begin : this->Begin.GetBytesLeft();
  if (!fits || sizes.Total > bytes / ValueBytes + 1)
  {
    return this->FailAt(0, property, fits ? ErrorKind::Truncated : ErrorKind::Unsupported,
      "at most 2147483647 values in all lists " +
        QuoteWord(this->Element.Properties[property].Name),
      std::to_string(sizes.Total));
  }
  return true;
}

//------------------------------------------------------------------------------
bool PLYTextRows::ReadIds(
  int property, const PLYIds& expected, const PLYLists& lists, const Progress& progress)
{
  const bool skips = this->IsChecked && this->Layout == RowLayout::OneLine;
  const std::int64_t least = expected.HasBreaks ? -1 : 0;
  const PLYType type = this->Element.Properties[property].Type;
  const bool isWide = type == PLYType::UInt64;
  // The value of an unsigned type that means -1; that of uint64 is read as -1.
  const std::int64_t greatest = WithType(type,
    [](auto value) -> std::int64_t
    {
      using In = decltype(value);
      constexpr bool isBreak = std::is_unsigned<In>::value && sizeof(In) < sizeof(std::int64_t);
      return isBreak ? static_cast<std::int64_t>(std::numeric_limits<In>::max()) : -1;
    });
  const std::string what = DescribeIds(expected);
  const bool good = this->ForEachRow(progress,
    [&](vtkIdType row, TextRow& text)
    {
      if (skips && !lists.Needs(row))
      {
        text.Skip();
        return true;
      }
      std::int64_t length = 0;
      bool rowIsGood = this->Skip(text, 0, property) && this->ReadLength(text, property, length) &&
        length == lists.Sizes.GetSize(row); // unless the file has changed
      std::int32_t* const ids = lists.Provide(row, 1);
      std::int32_t* id = ids;
      for (; rowIsGood && length > 0; --length)
      {
        std::int64_t value = 0;
        rowIsGood = isWide ? ReadUnsignedId(text, value, what)
          : IsReal(type)   ? ReadRealId(text, value, what)
                           : text.ReadInteger(value, what.c_str());
        value = least < 0 && value == greatest ? -1 : value;
        if (rowIsGood && (value < least || value >= expected.Limit))
        {
          rowIsGood = text.FailAtLast(ErrorKind::Index, what);
        }
        *id++ = static_cast<std::int32_t>(value);
      }
      rowIsGood = rowIsGood && this->SkipRest(text, property + 1);
      if (rowIsGood)
      {
        lists.Take(row, 1, ids);
      }
      this->Finish(row, text);
      return rowIsGood;
    });
  this->IsChecked = this->IsChecked || good;
  return good;
}

//------------------------------------------------------------------------------
bool PLYTextRows::ReadValue(TextRow& row, const PLYColumn& column, vtkIdType tuple) const
{
  const PLYType type = this->Element.Properties[column.Property].Type;
  const std::string& what = this->Values[column.Property];
  bool good = false;
  WithConversion(type, column, this->OddColors,
    [&](auto in, auto out, auto convert)
    {
      using In = decltype(in);
      In value = In();
      if constexpr (std::is_floating_point<In>::value)
      {
        good = row.ReadReal(value, what.c_str());
      }
      else if constexpr (sizeof(In) < 8)
      {
        // As double, which also accepts 255.0 for an integer.
        double number = 0;
        good = row.ReadReal(number, what.c_str()) &&
          (Fits(type, number) || row.FailAtLast(ErrorKind::Syntax, what));
        value = good ? static_cast<In>(number) : In();
      }
      else if constexpr (std::is_signed<In>::value)
      {
        std::int64_t number = 0;
        good = row.ReadInteger(number, what.c_str());
        value = number;
      }
      else
      {
        std::uint64_t number = 0;
        std::string_view word;
        good = row.ReadWord(word, what.c_str()) &&
          (ParseUnsigned(word, number) || row.FailAtLast(ErrorKind::Syntax, what));
        value = number;
      }
      if (tuple >= 0)
      {
        static_cast<decltype(out)*>(column.Values)[tuple * column.Stride] = convert(value);
      }
    });
  return good;
}

//------------------------------------------------------------------------------
// Items that no column requests are skipped.
bool PLYTextRows::ReadList(
  TextRow& row, int property, const std::vector<const PLYColumn*>& columns, vtkIdType tuple) const
{
  std::int64_t length = 0;
  bool good = this->ReadLength(row, property, length);
  std::int64_t item = 0;
  for (const PLYColumn* column : columns)
  {
    if (good && column->Item < 0 && tuple >= 0)
    {
      WithType(column->Type,
        [&](auto out)
        {
          static_cast<decltype(out)*>(column->Values)[tuple * column->Stride] =
            static_cast<decltype(out)>(length);
        });
    }
    else if (good && column->Item == item && item < length)
    {
      good = this->ReadValue(row, *column, tuple);
      ++item;
    }
  }
  return good && this->SkipValues(row, property, length - item);
}

//------------------------------------------------------------------------------
bool PLYTextRows::ReadColumns(
  const std::vector<PLYColumn>& columns, const PLYTargets& targets, const Progress& progress)
{
  if (columns.empty())
  {
    return true;
  }
  std::vector<std::vector<const PLYColumn*>> wanted(this->Element.Properties.size());
  int end = 0;
  for (const PLYColumn& column : columns)
  {
    wanted[column.Property].push_back(&column);
    end = std::max(end, column.Property + 1);
  }
  const bool good = this->ForEachRow(progress,
    [&](vtkIdType row, TextRow& text)
    {
      const vtkIdType tuple = targets.Find(row);
      bool rowIsGood = true;
      for (int i = 0; i < end && rowIsGood; ++i)
      {
        rowIsGood = wanted[i].empty()          ? this->Skip(text, i, i + 1)
          : this->Element.Properties[i].IsList ? this->ReadList(text, i, wanted[i], tuple)
                                               : this->ReadValue(text, *wanted[i][0], tuple);
      }
      rowIsGood = rowIsGood && this->SkipRest(text, end);
      this->Finish(row, text);
      return rowIsGood;
    });
  this->IsChecked = this->IsChecked || good;
  return good;
}

//------------------------------------------------------------------------------
bool PLYTextRows::FailAt(vtkIdType row, int property, ErrorKind kind, const std::string& expected,
  const std::string& found)
{
  if (this->Lines)
  {
    return false; // the text is read again without lines
  }
  const char* place = nullptr;
  const bool wasChecked = this->IsChecked;
  this->IsChecked = true;
  this->ForEachRow(Progress(),
    [&](vtkIdType i, TextRow& text)
    {
      this->Skip(text, 0, property);
      const bool isIt = i == row;
      place = isIt ? text.GetPosition() : place;
      // Without one row per line, rows end with their last property.
      if (!isIt)
      {
        this->Skip(text, property, this->GetNumberOfProperties());
      }
      return !isIt;
    });
  this->IsChecked = wasChecked;
  return this->Scanner.FailAt(place ? place : this->Begin.GetPosition(), kind, expected, found);
}
}
