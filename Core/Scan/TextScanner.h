// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TextScanner
 * @brief Reads numbers and words from text in memory, skipping white space and comments.
 *
 * Lines end with LF, CRLF or a lone CR. After the first error, all reads fail and leave their
 * value unchanged, so callers may check once after several reads. Lines are only counted to create
 * an error message.
 *
 *     TextScanner scanner(name, begin, end, '#');
 *     std::int64_t count;
 *     if (!scanner.ReadCount(count, 6, "the number of vertices"))
 *     {
 *       error = scanner.GetError();
 *     }
 */
#ifndef camaron_TextScanner_h
#define camaron_TextScanner_h

#include "Scan/ScanError.h"

#include <cstdint>     // for integers of known size
#include <string>      // for messages
#include <string_view> // for words

namespace camaron
{
class TextScanner
{
public:
  /**
   * @param name of the file, for messages
   * @param begin,end the text; a UTF-8 byte order mark at its start is skipped
   * @param comment starts a comment that runs to the end of the line; '\0' for none
   */
  TextScanner(std::string name, const char* begin, const char* end, char comment = '\0');

  const char* GetPosition() const { return this->Position; }
  void SetPosition(const char* position) { this->Position = position; }
  const char* GetBegin() const { return this->Begin; }
  const char* GetEnd() const { return this->End; }
  char GetComment() const { return this->Comment; }
  vtkIdType GetBytesLeft() const { return this->End - this->Position; }

  /// Skips white space and comments; false at the end of the text.
  bool SkipSpace();
  /// Skips the rest of the line and its end.
  void SkipLine();

  ///@{
  /**
   * Reads the next number, std::int64_t, float or double. @a what describes it in error messages,
   * e.g. "the number of vertices".
   */
  template <typename Number>
  bool Read(Number& value, const char* what);
  bool ReadInteger(std::int64_t& value, const char* what) { return this->Read(value, what); }
  template <typename Real>
  bool ReadReal(Real& value, const char* what)
  {
    return this->Read(value, what);
  }
  ///@}
  /// Reads a word between white space, without copying it.
  bool ReadWord(std::string_view& word, const char* what);
  /// Reads an integer in [first, last]; else fails with @a kind.
  bool ReadInteger(
    std::int64_t& value, std::int64_t first, std::int64_t last, ErrorKind kind, const char* what);
  /// Reads the number of records that follow, each of at least @a bytes bytes and at most 2^31 - 1
  /// of them.
  bool ReadCount(std::int64_t& value, int bytes, const char* what);

  ///@{
  /// Sets the error if there is none yet: "name:line: expected WHAT, found ..."; returns false.
  bool FailAt(const char* position, ErrorKind kind, const std::string& expected);
  bool FailAt(
    const char* position, ErrorKind kind, const std::string& expected, const std::string& found);
  ///@}
  /// Appends text to the error, if there is one.
  void AddToError(const std::string& more);
  const ScanError& GetError() const { return this->Error; }
  bool HasFailed() const { return static_cast<bool>(this->Error); }

  /// Number of the line that contains @a position, from 1.
  vtkIdType GetLine(const char* position) const;

private:
  std::string Name;
  const char* Begin;
  const char* End;
  const char* Position;
  char Comment;
  ScanError Error;
};

/// Skips a UTF-8 byte order mark at the beginning of a text.
const char* SkipByteOrderMark(const char* begin, const char* end);

/// First line end in [text, end), or end.
const char* FindLineEnd(const char* text, const char* end);

/**
 * The end of the text in a file: before trailing bytes 0 and 0x1A, possibly mixed with blanks and
 * line ends, which old editors and tapes append. Several zeros directly after a number or a name
 * are not an end; they indicate a lost part of the file.
 */
const char* FindTextEnd(const char* begin, const char* end);
}

#endif
