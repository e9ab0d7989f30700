// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ScanError.h
 * @brief Errors and warnings of reading or writing a mesh file.
 */
#ifndef camaron_ScanError_h
#define camaron_ScanError_h

#include "vtkType.h" // for vtkIdType

#include <string>      // for messages
#include <string_view> // for words
#include <vector>      // for warnings

namespace camaron
{
enum class ErrorKind
{
  None,
  Open,          ///< the file cannot be opened or read
  Changed,       ///< the file was changed while it was read
  NotThisFormat, ///< the file has another format
  Truncated,     ///< the file ends before its declared contents
  Syntax,        ///< a number or keyword is missing where one is required
  Count,         ///< a count is negative, too large or impossible
  Index,         ///< an id of a point, face or cell is out of range
  Unsupported,   ///< the file is valid but contains something that is not supported
  Companion,     ///< a second file that belongs to this one is missing
  Write,         ///< the file cannot be written
  DiskFull,      ///< the disk is full
  Memory         ///< not enough memory for the contents of the file
};

/// An error as a value. The message states file, position, expected and found text.
struct ScanError
{
  ErrorKind Kind = ErrorKind::None;
  std::string Message;
  explicit operator bool() const { return this->Kind != ErrorKind::None; }
};

/// The closest error code of VTK (vtkErrorCode).
unsigned long GetVTKErrorCode(ErrorKind kind);

/// A character as shown in messages: itself, or '?' unless it is printable ASCII.
inline char ToPrintable(char c)
{
  return c >= ' ' && c < '\x7f' ? c : '?';
}

/// A word of a file as quoted in messages: up to its first white space, shortened and printable.
std::string QuoteWord(std::string_view word);

/// Number of occurrences and the first one; merging does not depend on the order.
struct Tally
{
  vtkIdType Count = 0;
  vtkIdType First = -1;
  void Add(vtkIdType where)
  {
    this->First = this->Count == 0 || where < this->First ? where : this->First;
    ++this->Count;
  }
  void Merge(const Tally& other)
  {
    if (other.Count > 0)
    {
      this->First = this->Count == 0 || other.First < this->First ? other.First : this->First;
      this->Count += other.Count;
    }
  }
};

/// Note for messages that count items by position, although files may use other ids.
constexpr const char* FromZero = " (counted from 0)";

/// A warning about unusual but usable input: a sentence, or, with a tally, the words of one.
struct Warning
{
  std::string What; ///< the sentence; with a tally what was found, such as "not closed"
  Tally Found = {};
  std::string One = {}, Many = {}; ///< singular and plural of the items
  std::string Note = {};           ///< after the first one

  /// "12 polygons with fewer than 3 vertices, the first is polygon 7", and the note.
  std::string GetSentence() const;
};

/// The warnings of a file: one per kind.
class Warnings
{
public:
  void Add(std::string sentence) { this->All.push_back({ std::move(sentence) }); }
  /// Nothing if the tally is empty.
  void Add(
    const Tally& tally, const char* one, const char* many, const char* what, const char* note = "");
  void Add(Warning warning) { this->All.push_back(std::move(warning)); }

  const std::vector<Warning>& Get() const { return this->All; }
  std::vector<std::string> GetSentences() const;

private:
  std::vector<Warning> All;
};
}

#endif
