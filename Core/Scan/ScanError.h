// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ScanError.h
 * @brief What went wrong, or looked odd, while a mesh file was read or written.
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
  Changed,       ///< the file became another while it was read
  NotThisFormat, ///< the content is that of another format
  Truncated,     ///< the file ends before what it promised
  Syntax,        ///< a number or keyword is missing where one is required
  Count,         ///< a count is negative, too large or impossible
  Index,         ///< an id of a point, face or cell is out of range
  Unsupported,   ///< the file is valid but holds something that is not handled
  Companion,     ///< a second file that belongs to this one is missing
  Write,         ///< the file cannot be written
  DiskFull,      ///< there is no room for the file
  Memory         ///< there is not enough memory for what the file holds
};

/// An error as a value; the message says file, place, what was expected and what was found.
struct ScanError
{
  ErrorKind Kind = ErrorKind::None;
  std::string Message;
  explicit operator bool() const { return this->Kind != ErrorKind::None; }
};

/// VTK's error code (vtkErrorCode) that comes nearest to the kind.
unsigned long GetVTKErrorCode(ErrorKind kind);

/// A character of a file as messages show it: itself, or '?' if it cannot be printed as ASCII.
inline char ToPrintable(char c)
{
  return c >= ' ' && c < '\x7f' ? c : '?';
}

/// A word of a file as messages quote it: up to its first white space, short and printable.
std::string QuoteWord(std::string_view word);

/// How often something was seen, and where first; merging does not depend on the order.
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

/// To be noted where files may have other ids than what is named by its place in the mesh.
constexpr const char* FromZero = " (counted from 0)";

/// Odd but usable input: one sentence per kind, with how many there are and the first of them.
class Warnings
{
public:
  void Add(std::string sentence) { this->Sentences.push_back(std::move(sentence)); }
  /// "12 polygons with fewer than 3 vertices, the first is polygon 7", and @a note; nothing if the
  /// tally is empty.
  void Add(
    const Tally& tally, const char* one, const char* many, const char* what, const char* note = "");

  const std::vector<std::string>& GetSentences() const { return this->Sentences; }

private:
  std::vector<std::string> Sentences;
};
}

#endif
