// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PLYRows.h"

#include "Base/Number.h"
#include "Intake/Rows/Bytes.h"
#include "Intake/Rows/TextRows.h"

#include <algorithm>
#include <charconv>
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
class TextRows : public PLYRows
{
public:
  TextRows(
    const PLYElement& element, TextScanner& scanner, const TextLines* lines, RowLayout layout);

  bool Locate(const Progress& progress) override;
  bool Check(const Progress& progress) override;
  bool ReadSizes(int property, PLYSizes& sizes, const Progress& progress) override;
  bool Fail(ErrorKind kind, const std::string& expected, const std::string& found) override;

private:
  bool ForEachBlock(const Request& request, const Progress& progress, VisitBlock visit) override;
  void ExpectIds(int property, const PLYIds& expected) override;

  template <typename Visit>
  bool ForEachRow(const Progress& progress, Visit&& visit);
  bool ReadLength(TextRow& row, int property, std::int64_t& length) const;
  bool Skip(TextRow& row, int property, std::int64_t number) const;
  bool SkipProperties(TextRow& row, int first) const;
  bool Convert(TextRow& row, const Request& request, std::string& bytes,
    std::vector<std::size_t>& offsets) const;
  bool ConvertValue(TextRow& row, int property, std::string& bytes) const;
  int GetNumberOfProperties() const { return static_cast<int>(this->Stored.size()); }

  TextScanner& Scanner;
  const TextLines* Lines;
  RowLayout Layout;
  TextLines::Section Section;
  TextScanner Begin; ///< at the start of the rows
  bool IsChecked = false;
  std::vector<std::string> Values;                ///< of properties, for messages
  std::vector<std::string> Lengths;               ///< of lists, for messages
  std::vector<std::optional<PLYIds>> ExpectedIds; ///< of properties that are ids
};

//------------------------------------------------------------------------------
TextRows::TextRows(
  const PLYElement& element, TextScanner& scanner, const TextLines* lines, RowLayout layout)
  : PLYRows(element, false)
  , Scanner(scanner)
  , Lines(lines)
  , Layout(layout)
  , Begin(scanner)
  , ExpectedIds(element.Properties.size())
{
  for (PLYProperty& property : this->Stored)
  {
    const std::string name = QuoteWord(property.Name) + " of " + QuoteWord(element.Name);
    this->Values.push_back(
      (property.IsList ? "a value of " : "") + name + " (" + GetName(property.Type) + ")");
    this->Lengths.push_back("the length of the list " + name);
    property.CountType = PLYType::Int32;
  }
}

//------------------------------------------------------------------------------
// Calls visit(row, TextRow&) for all rows; false with the error in the scanner, unless lines are
// used.
template <typename Visit>
bool TextRows::ForEachRow(const Progress& progress, Visit&& visit)
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
bool TextRows::ReadLength(TextRow& row, int property, std::int64_t& length) const
{
  return row.ReadInteger(length, this->Lengths[property].c_str()) &&
    ((length >= 0 && length <= INT32_MAX) ||
      row.FailAtLast(ErrorKind::Count, this->Lengths[property]));
}

//------------------------------------------------------------------------------
bool TextRows::Skip(TextRow& row, int property, std::int64_t number) const
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
// Skips all properties from one on.
bool TextRows::SkipProperties(TextRow& row, int first) const
{
  bool good = true;
  for (int i = first; i < this->GetNumberOfProperties() && good; ++i)
  {
    std::int64_t length = 1;
    good =
      (!this->Stored[i].IsList || this->ReadLength(row, i, length)) && this->Skip(row, i, length);
  }
  return good;
}

//------------------------------------------------------------------------------
void TextRows::ExpectIds(int property, const PLYIds& expected)
{
  this->Stored[property].Type = PLYType::Int32;
  this->Values[property] = DescribeIds(expected);
  this->ExpectedIds[property] = expected;
}

//------------------------------------------------------------------------------
// Ids are read as written, whatever the range of their type.
bool TextRows::ConvertValue(TextRow& row, int property, std::string& bytes) const
{
  const std::string& what = this->Values[property];
  const PLYType type = this->Element.Properties[property].Type;
  const std::optional<PLYIds>& expected = this->ExpectedIds[property];
  if (!expected)
  {
    return WithType(type,
      [&](auto value)
      {
        const bool good = ReadValue(row, value, what);
        AppendBytes(bytes, value, false);
        return good;
      });
  }
  const auto convert = [&](auto value)
  {
    const bool good = ReadValue(row, value, what);
    const std::int32_t id = ToId(value, GetBreakValue(type, *expected));
    AppendBytes(bytes, id, false);
    return good &&
      (AreIds(&id, 1, expected->Limit, expected->HasBreaks) ||
        row.FailAtLast(ErrorKind::Index, what));
  };
  return IsReal(type)         ? convert(0.)
    : type == PLYType::UInt64 ? convert(std::uint64_t(0))
                              : convert(std::int64_t(0));
}

//------------------------------------------------------------------------------
// Converts the requested properties of a row to those of a binary file. Skips the rest of the row,
// if its end is unknown or not yet checked.
bool TextRows::Convert(
  TextRow& row, const Request& request, std::string& bytes, std::vector<std::size_t>& offsets) const
{
  bytes.clear();
  for (int i = 0; i < request.End; ++i)
  {
    std::int64_t length = 1;
    offsets[static_cast<std::size_t>(i)] = bytes.size();
    if (this->Stored[i].IsList)
    {
      if (!this->ReadLength(row, i, length))
      {
        return false;
      }
      AppendBytes(bytes, static_cast<std::int32_t>(length), false);
      if (request.OnlySizes && i == request.End - 1 && this->Layout == RowLayout::OneLine)
      {
        return true;
      }
    }
    const bool converts = request.Properties[i] && !request.OnlySizes;
    bool good = converts || this->Skip(row, i, length);
    for (; converts && good && length > 0; --length)
    {
      good = this->ConvertValue(row, i, bytes);
    }
    if (!good)
    {
      return false;
    }
  }
  return (this->IsChecked && this->Layout == RowLayout::OneLine) ||
    this->SkipProperties(row, request.End);
}

//------------------------------------------------------------------------------
bool TextRows::ForEachBlock(const Request& request, const Progress& progress, VisitBlock visit)
{
  const bool isOneLine = this->Layout == RowLayout::OneLine;
  const bool good = this->ForEachRow(progress,
    [&](vtkIdType row, TextRow& text)
    {
      thread_local std::string bytes;
      thread_local std::vector<std::size_t> offsets;
      thread_local Block rows;
      if (this->IsChecked && isOneLine && request.Rows && !(*request.Rows)(row, 1))
      {
        text.Skip();
        return true;
      }
      offsets.resize(static_cast<std::size_t>(request.End));
      if (!this->Convert(text, request, bytes, offsets))
      {
        return false;
      }
      if (isOneLine && !this->IsChecked && !request.OnlySizes && text.HasMore())
      {
        static std::mutex mutex;
        const std::lock_guard<std::mutex> lock(mutex);
        this->LongRows.Add(row);
      }
      rows.First = row;
      rows.Count = 1;
      rows.Properties.resize(offsets.size());
      for (std::size_t i = 0; i < offsets.size(); ++i)
      {
        rows.Properties[i].Begin = bytes.data() + offsets[i];
      }
      return visit(rows);
    });
  this->IsChecked = this->IsChecked || (good && !request.OnlySizes);
  return good;
}

//------------------------------------------------------------------------------
bool TextRows::Locate(const Progress& progress)
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
bool TextRows::Check(const Progress& progress)
{
  return this->IsChecked ||
    this->ForEachBlock(Request(*this), progress, [](const Block&) { return true; });
}

//------------------------------------------------------------------------------
bool TextRows::ReadSizes(int property, PLYSizes& sizes, const Progress& progress)
{
  if (!PLYRows::ReadSizes(property, sizes, progress))
  {
    return false;
  }
  // Only the lengths in lines have been read so far; the file must have the values they declare
  // before memory is allocated.
  const vtkIdType bytes =
    this->Lines ? this->Section.End - this->Section.Begin : this->Begin.GetBytesLeft();
  return sizes.Total <= bytes / ValueBytes + 1 ||
    this->Fail(ErrorKind::Truncated,
      "at most 2147483647 values in all lists " +
        QuoteWord(this->Element.Properties[property].Name),
      std::to_string(sizes.Total));
}

//------------------------------------------------------------------------------
bool TextRows::Fail(ErrorKind kind, const std::string& expected, const std::string& found)
{
  TextScanner begin = this->Begin;
  begin.SkipSpace();
  return !this->Lines && this->Scanner.FailAt(begin.GetPosition(), kind, expected, found);
}

}

//------------------------------------------------------------------------------
std::unique_ptr<PLYRows> MakeTextRows(
  const PLYElement& element, TextScanner& scanner, const TextLines* lines, RowLayout layout)
{
  return std::make_unique<TextRows>(element, scanner, lines, layout);
}
}
