// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TextRows.h
 * @brief Reads tables in text: one record per row, large ones in parallel.
 */
#ifndef camaron_TextRows_h
#define camaron_TextRows_h

#include "Scan/MappedFile.h"
#include "Scan/TextLines.h"

#include <memory>      // for the lines of a file
#include <string_view> // for words

namespace camaron
{
/// How the rows of a table are laid out.
enum class RowLayout
{
  Free,   ///< a row may go on over several lines
  OneLine ///< a row that ends too early is wrong
};

/**
 * @class camaron::TextRow
 * @brief One row of a table: a line of a large text, or what a TextScanner finds next.
 *
 * Of a scanner, what is wrong is worded; of a line, it is enough to say that something is wrong, as
 * the table is then read again with a scanner. @a what says what is read, e.g. "a coordinate of a
 * node".
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

  bool ReadReal(double& value, const char* what) { return this->Read(value, what); }
  bool ReadReal(float& value, const char* what) { return this->Read(value, what); }
  bool ReadInteger(std::int64_t& value, const char* what) { return this->Read(value, what); }
  /// Reads three numbers.
  bool ReadPoint(double* x, const char* what)
  {
    return this->Read(x[0], what) && this->Read(x[1], what) && this->Read(x[2], what);
  }
  /// Reads an id in [first, last], less @a first.
  bool ReadId(std::int32_t& index, std::int64_t first, std::int64_t last, const char* what)
  {
    std::int64_t id;
    if (this->Scanner ? !this->IsComplete(what) ||
          !this->Scanner->ReadInteger(id, first, last, ErrorKind::Index, what)
                      : !this->Read(id, what) || id < first || id > last)
    {
      return false;
    }
    index = static_cast<std::int32_t>(id - first);
    return true;
  }
  /// Reads what is between white space; it stays where it is in the text.
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

  /// Leaves a line unread.
  void Skip()
  {
    if (this->Scanner)
    {
      this->Scanner->SkipSpace();
    }
  }

  /// Whether the line goes on with something that is no comment.
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
  /// Where the row is read next.
  const char* GetPosition() const
  {
    return this->Scanner ? this->Scanner->GetPosition() : this->Text;
  }
  /// Says what is wrong with the word at a position; returns false.
  bool FailAt(const char* position, ErrorKind kind, const std::string& expected)
  {
    if (this->Scanner)
    {
      this->Scanner->FailAt(position, kind, expected);
    }
    return false;
  }
  /// The same of the word that was read last.
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
  static bool ReadNext(TextScanner& scanner, std::int64_t& value, const char* what)
  {
    return scanner.ReadInteger(value, what);
  }
  template <typename Real>
  static bool ReadNext(TextScanner& scanner, Real& value, const char* what)
  {
    return scanner.ReadReal(value, what);
  }
  static const char* Parse(const char* text, const char* end, std::int64_t& value)
  {
    return ParseInteger(text, end, value);
  }
  template <typename Real>
  static const char* Parse(const char* text, const char* end, Real& value)
  {
    return ParseReal(text, end, value);
  }

  template <typename Number>
  bool Read(Number& value, const char* what)
  {
    if (this->Scanner)
    {
      return this->IsComplete(what) && ReadNext(*this->Scanner, value, what);
    }
    this->SkipBlanks();
    const char* const next = Parse(this->Text, this->End, value);
    if (!next || (next < this->End && !IsSpace(*next) && *next != this->Comment))
    {
      return false;
    }
    this->Text = next;
    return true;
  }
  /// False if the row of a scanner should go on, but its line has ended.
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
  // A CR is at the end of the line or ends it, and then the scanner has to see to it.
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

/**
 * Calls @a visit(row, piece, TextRow&) for the next @a count lines of a large text in parallel; a
 * piece is visited in order by one thread, and there are lines->GetNumberOfPieces(section) of them.
 * Returns false if a visit did, or if stopped.
 */
template <typename Visit>
bool VisitRows(const TextLines& lines, const TextLines::Section& section, char comment,
  const Progress& progress, Visit&& visit)
{
  return lines.ForEachToEnd(section, progress,
    [&](vtkIdType piece, vtkIdType line, const char* text, const char* end)
    {
      TextRow row(text, end, comment);
      return visit(line, piece, row) ? TextLines::GetEndOfLine(row.GetPosition(), end) : nullptr;
    });
}

/**
 * Reads @a count rows by @a visit(row, TextRow&), which returns false when something is wrong with
 * one and may be called by several threads; the rest of the line after each row is ignored. False
 * with the error in the scanner, or if stopped.
 * @param lines of the text if it is large enough to read it in parallel, else nullptr
 */
template <typename Visit>
bool ReadRows(TextScanner& scanner, const TextLines* lines, vtkIdType count,
  const Progress& progress, Visit&& visit, RowLayout layout = RowLayout::Free)
{
  const TextLines::Section section =
    lines ? lines->Find(scanner.GetPosition(), count) : TextLines::Section();
  if (section &&
    VisitRows(*lines, section, scanner.GetComment(), progress,
      [&](vtkIdType row, vtkIdType, TextRow& text) { return visit(row, text); }))
  {
    scanner.SetPosition(section.End);
    return true;
  }
  // Not one row per line, or wrong: row by row.
  for (vtkIdType row = 0; row < count && !progress.IsStopped(); ++row)
  {
    TextRow text(scanner, layout);
    if (!visit(row, text) || scanner.HasFailed())
    {
      return false;
    }
    scanner.SkipLine();
  }
  return !progress.IsStopped();
}

/**
 * As ReadRows, but visits every row once, so that it can be counted, say. Where there are lines,
 * rows must be one per line; else it fails without an error, and the text has to be read without
 * lines.
 */
template <typename Visit>
bool ReadRowsOnce(TextScanner& scanner, const TextLines* lines, vtkIdType count,
  const Progress& progress, Visit&& visit, RowLayout layout = RowLayout::Free)
{
  if (!lines)
  {
    return ReadRows(scanner, nullptr, count, progress, visit, layout);
  }
  const TextLines::Section section = lines->Find(scanner.GetPosition(), count);
  if (!section ||
    !VisitRows(*lines, section, scanner.GetComment(), progress,
      [&](vtkIdType row, vtkIdType, TextRow& text) { return visit(row, text); }))
  {
    return false;
  }
  scanner.SetPosition(section.End);
  return true;
}

/**
 * Moves behind @a count rows that are read later, when it is known which of them are needed. If
 * they are not one per line, they are read by @a visit, as ReadRows does, to find their end.
 */
template <typename Visit>
bool SkipRows(TextScanner& scanner, const TextLines* lines, vtkIdType count,
  const Progress& progress, Visit&& visit, RowLayout layout = RowLayout::Free)
{
  if (const TextLines::Section section =
        lines ? lines->Find(scanner.GetPosition(), count) : TextLines::Section())
  {
    scanner.SetPosition(section.End);
    return true;
  }
  return ReadRows(scanner, nullptr, count, progress, visit, layout);
}

/**
 * The frame of a reader of text: calls @a read(TextScanner&, const TextLines*, const Progress&),
 * with lines if the text is of two chunks or more. If that fails, it is called once more without,
 * so that what a file means and what is wrong with it does not depend on how its lines are laid
 * out; it must start anew then. False with the reason in @a error, or without one if stopped.
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
  const bool good =
    !progress.IsStopped() && read(scanner, static_cast<const TextLines*>(nullptr), progress);
  error = progress.IsStopped() ? ScanError() : scanner.GetError();
  return good && !error && !progress.IsStopped();
}

/**
 * Reads @a rows rows of @a columns real numbers each into @a values; the rest of the line after
 * each row is ignored. False with the error in the scanner, or if stopped.
 * @param lines of the text if it is large enough to read it in parallel, else nullptr
 * @param what a number is, for errors, e.g. "a coordinate of a vertex"
 */
template <typename Real>
bool ReadTable(TextScanner& scanner, const TextLines* lines, vtkIdType rows, int columns,
  Real* values, const char* what, const Progress& progress)
{
  return ReadRows(scanner, lines, rows, progress,
    [&](vtkIdType row, TextRow& text)
    {
      bool good = true;
      for (int c = 0; c < columns && good; ++c)
      {
        good = text.ReadReal(values[row * columns + c], what);
      }
      return good;
    });
}
}

#endif
