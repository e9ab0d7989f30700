// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TextRows.h
 * @brief Reads tables in text with one record per row; large tables in parallel.
 */
#ifndef camaron_TextRows_h
#define camaron_TextRows_h

#include "Intake/Rows/ShortNumbers.h"
#include "Intake/Rows/TextLines.h"
#include "Scan/MappedFile.h"

#include <memory>      // for the lines of a file
#include <string_view> // for words

namespace camaron
{
/// The layout of the rows of a table.
enum class RowLayout
{
  Free,   ///< a row may span several lines
  OneLine ///< a row that ends too early is an error
};

/**
 * @class camaron::TextRow
 * @brief One row of a table: a line of a large text, or the next values of a TextScanner.
 *
 * A row of a scanner creates error messages. A row of a line only fails, because the table is then
 * read again with a scanner. @a what describes the item being read, e.g. "a coordinate of a node".
 */
class TextRow
{
public:
  /// @param end of the text; the row ends with the line
  TextRow(const char* begin, const char* end, char comment)
    : Text(begin)
    , End(end)
    , Comment(comment)
  {
  }
  explicit TextRow(TextScanner& scanner, RowLayout layout = RowLayout::Free)
    : Comment(scanner.GetComment())
    , Scanner(&scanner)
    , Layout(layout)
  {
  }

  template <typename Real>
  bool ReadReal(Real& value, const char* what)
  {
    return this->Read(value, what);
  }
  bool ReadInteger(std::int64_t& value, const char* what)
  {
    // A digit and a blank, such as most sizes of lists.
    if (this->End - this->Text > 1 && IsDigit(this->Text[0]) && this->Text[1] == ' ')
    {
      value = *this->Text++ - '0';
      return true;
    }
    return this->Read(value, what);
  }
  /// Reads the number of items that follow, each of at least @a bytes bytes.
  bool ReadCount(std::int64_t& count, int bytes, const char* what)
  {
    return this->Scanner ? this->Scanner->ReadCount(count, bytes, what)
                         : this->ReadInteger(count, what) && count >= 0;
  }
  /// Reads three numbers.
  template <typename Real>
  bool ReadPoint(Real* x, const char* what)
  {
    return this->Read(x[0], what) && this->Read(x[1], what) && this->Read(x[2], what);
  }
  /// Reads an integer in [first, last]; else fails with @a kind.
  bool ReadInteger(
    std::int64_t& value, std::int64_t first, std::int64_t last, ErrorKind kind, const char* what)
  {
    return this->Scanner
      ? this->IsComplete(what) && this->Scanner->ReadInteger(value, first, last, kind, what)
      : this->Read(value, what) && value >= first && value <= last;
  }
  /// Reads an id in [first, last] and subtracts @a first.
  bool ReadId(std::int32_t& index, std::int64_t first, std::int64_t last, const char* what)
  {
    std::int64_t id;
    if (!this->ReadInteger(id, first, last, ErrorKind::Index, what))
    {
      return false;
    }
    index = static_cast<std::int32_t>(id - first);
    return true;
  }
  /// Reads @a count such ids.
  bool ReadIds(
    std::int32_t* indices, int count, std::int64_t first, std::int64_t last, const char* what)
  {
    bool good = true;
    for (int i = 0; i < count && good; ++i)
    {
      good = this->ReadId(indices[i], first, last, what);
    }
    return good;
  }
  /// Reads at most @a count ids in [0, limit) with few digits, see ReadShortNumbers; returns their
  /// number, which is 0 for a scanner.
  std::int32_t ReadShortIds(std::int32_t* ids, std::int32_t count, std::int64_t limit)
  {
    return this->Scanner ? 0 : ReadShortNumbers(this->Text, this->End, count, limit, ids);
  }
  /// Reads a word between white space, without copying it.
  bool ReadWord(std::string_view& word, const char* what)
  {
    if (this->Scanner)
    {
      return this->IsComplete(what) && this->Scanner->ReadWord(word, what);
    }
    this->SkipBlanks();
    const char* const begin = this->Text;
    while (this->Text < this->End && !IsSpace(*this->Text) &&
      (*this->Text != this->Comment || IsPartOfNumber(begin, this->Text, this->End)))
    {
      ++this->Text;
    }
    word = std::string_view(begin, static_cast<std::size_t>(this->Text - begin));
    return !word.empty();
  }

  /// Skips the rest of the line.
  void Skip()
  {
    if (this->Scanner)
    {
      this->Scanner->SkipSpace();
    }
  }

  /// Whether the line has more text that is not a comment.
  bool HasMore()
  {
    const char* text = this->Scanner ? this->Scanner->GetPosition() : this->Text;
    const char* const end = this->Scanner ? this->Scanner->GetEnd() : this->End;
    while (text < end && IsSpace(*text) && *text != '\n' && *text != '\r')
    {
      ++text;
    }
    return text < end && !IsSpace(*text) && (*text != this->Comment || *text == '\0');
  }

  ///@{
  /// The current position in the row.
  const char* GetPosition() const
  {
    return this->Scanner ? this->Scanner->GetPosition() : this->Text;
  }
  /// Reports an error at the word at a position; returns false.
  bool FailAt(const char* position, ErrorKind kind, const std::string& expected)
  {
    return this->Scanner && this->Scanner->FailAt(position, kind, expected);
  }
  bool FailAt(
    const char* position, ErrorKind kind, const std::string& expected, const std::string& found)
  {
    return this->Scanner && this->Scanner->FailAt(position, kind, expected, found);
  }
  /// Reports an error at the last word read.
  bool FailAtLast(ErrorKind kind, const std::string& expected)
  {
    if (this->Scanner)
    {
      const char* position = this->Scanner->GetPosition();
      const char* const begin = this->Scanner->GetBegin();
      do
      {
        position -= position > begin;
      } while (position > begin && !IsSpace(position[-1]));
      this->Scanner->FailAt(position, kind, expected);
    }
    return false;
  }
  ///@}

private:
  template <typename Number>
  bool Read(Number& value, const char* what)
  {
    if (this->Scanner)
    {
      return this->IsComplete(what) && this->Scanner->Read(value, what);
    }
    this->SkipBlanks();
    const char* const next = ParseNumber(this->Text, this->End, value);
    if (!next || (next < this->End && !IsSpace(*next) && *next != this->Comment))
    {
      return false;
    }
    this->Text = next;
    return true;
  }
  /// False if the row of a scanner is incomplete, but its line has ended.
  bool IsComplete(const char* what)
  {
    if (this->Layout == RowLayout::OneLine && this->HasBegun && !this->HasMore())
    {
      const bool isLast = !TextScanner(*this->Scanner).SkipSpace();
      this->Scanner->FailAt(this->Scanner->GetPosition(),
        isLast ? ErrorKind::Truncated : ErrorKind::Syntax, what,
        isLast ? "the end of the file" : "the end of the line");
      return false;
    }
    this->HasBegun = true;
    return true;
  }
  // A CR is at or before the end of the line; the scanner has to handle it.
  void SkipBlanks()
  {
    while (
      this->Text < this->End && IsSpace(*this->Text) && *this->Text != '\r' && *this->Text != '\n')
    {
      ++this->Text;
    }
  }

  const char* Text = nullptr;
  const char* End = nullptr;
  char Comment;
  TextScanner* Scanner = nullptr;
  RowLayout Layout = RowLayout::Free;
  bool HasBegun = false;
};

/// Moves to the next line, if this one has nothing more; else false with the error in the scanner.
inline bool EndLine(TextScanner& scanner)
{
  if (TextRow(scanner).HasMore())
  {
    scanner.SkipSpace();
    return scanner.FailAt(scanner.GetPosition(), ErrorKind::Syntax, "the end of the line");
  }
  scanner.SkipLine();
  return true;
}

/**
 * @class camaron::RowSequence
 * @brief The next rows of a text, to be read as often as needed: lines, in parallel, or one after
 * the other, which also reports errors.
 *
 * With lines, there must be one row per line; otherwise reading fails without an error, and the
 * text must be read without lines, see ReadText.
 */
class RowSequence
{
public:
  /**
   * Moves the scanner behind them if they are lines.
   * @param lines of a text large enough for parallel reading, else nullptr
   * @param skipsRest whether to ignore the rest of the line after every row; otherwise the next row
   * begins there
   */
  RowSequence(TextScanner& scanner, const TextLines* lines, vtkIdType count,
    RowLayout layout = RowLayout::Free, bool skipsRest = true)
    : Scanner(scanner)
    , Start(scanner)
    , Lines(lines)
    , Section(lines ? lines->Find(scanner.GetPosition(), count) : TextLines::Section())
    , Count(count)
    , Layout(layout)
    , SkipsRest(skipsRest)
  {
    if (this->Section)
    {
      scanner.SetPosition(this->Section.End);
    }
  }

  vtkIdType GetCount() const { return this->Count; }
  bool AreLines() const { return this->Lines != nullptr; }
  /// Whether the rows exist, as far as is known.
  explicit operator bool() const { return !this->Lines || this->Section; }
  const TextLines::Section& GetSection() const { return this->Section; }
  TextScanner& GetScanner() const { return this->Scanner; }

  /// Number of parts; the rows of a part are visited in order by one thread.
  std::size_t GetNumberOfParts() const
  {
    return this->Lines ? static_cast<std::size_t>(this->Lines->GetNumberOfPieces(this->Section))
                       : 1;
  }

  /// Calls @a visit(row, part, TextRow&) for all rows, and moves the scanner behind them if it is
  /// before; false if a visit did, with the error in the scanner, or if stopped.
  template <typename Visit>
  bool ForEach(const Progress& progress, Visit&& visit) const;

  /// Moves the scanner behind rows that are read later, when the needed ones are known: lines are
  /// not visited, others to find their end.
  template <typename Visit>
  bool Skip(const Progress& progress, Visit&& visit) const
  {
    return this->Lines ? static_cast<bool>(this->Section) : this->ForEach(progress, visit);
  }

private:
  TextScanner& Scanner;
  TextScanner Start;
  const TextLines* Lines;
  TextLines::Section Section;
  vtkIdType Count;
  RowLayout Layout;
  bool SkipsRest;
};

//------------------------------------------------------------------------------
template <typename Visit>
bool RowSequence::ForEach(const Progress& progress, Visit&& visit) const
{
  if (this->Lines)
  {
    return this->Section &&
      this->Lines->ForEachToEnd(this->Section, progress,
        [&, comment = this->Start.GetComment()](
          vtkIdType part, vtkIdType line, const char* text, const char* end)
        {
          TextRow row(text, end, comment);
          return visit(line, part, row) ? TextLines::GetEndOfLine(row.GetPosition(), end) : nullptr;
        });
  }
  TextScanner scanner = this->Start;
  bool isGood = true;
  for (vtkIdType row = 0; row < this->Count && isGood; ++row)
  {
    scanner.SkipSpace();
    TextRow text(scanner, this->Layout);
    isGood = progress.Report(static_cast<double>(row) / this->Count) &&
      visit(row, vtkIdType(0), text) && !scanner.HasFailed();
    if (isGood && this->SkipsRest)
    {
      scanner.SkipLine();
    }
  }
  if (!isGood || scanner.GetPosition() > this->Scanner.GetPosition())
  {
    this->Scanner = scanner;
  }
  return isGood && !progress.IsStopped();
}

/**
 * The frame of a text reader: calls @a read(TextScanner&, const TextLines*, const Progress&), with
 * lines if the text has at least two chunks. If that fails, calls it again without lines, so the
 * result and the error messages do not depend on the layout of the lines; @a read must start from
 * scratch then. False with the reason in @a error, which may be of another file that @a read read,
 * or without one if stopped.
 */
template <typename Read>
bool ReadText(const MappedFile& file, char comment, vtkIdType chunk, ScanError& error,
  const Progress& progress, Read&& read)
{
  TextScanner scanner(file.GetName(), file.begin(), FindTextEnd(file.begin(), file.end()), comment);
  if (scanner.GetBytesLeft() >= 2 * chunk)
  {
    const TextLines lines(scanner, progress.Part(0, 0.1), chunk);
    TextScanner attempt = scanner;
    if (progress.IsStopped() ||
      (read(attempt, static_cast<const TextLines*>(&lines), progress.Part(0.1, 1)) &&
        !attempt.HasFailed()))
    {
      return !progress.IsStopped();
    }
  }
  error = ScanError(); // of the attempt
  const bool good =
    !progress.IsStopped() && read(scanner, static_cast<const TextLines*>(nullptr), progress);
  if (progress.IsStopped() || scanner.HasFailed())
  {
    error = progress.IsStopped() ? ScanError() : scanner.GetError();
  }
  return good && !error && !progress.IsStopped();
}
}

#endif
