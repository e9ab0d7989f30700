// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/TextScanner.h"

#include "Base/Number.h"

#include <algorithm>
#include <cctype>
#include <cstring>

namespace camaron
{
//------------------------------------------------------------------------------
const char* FindLineEnd(const char* text, const char* end)
{
  while (text < end && *text != '\n' && *text != '\r')
  {
    ++text;
  }
  return text;
}

//------------------------------------------------------------------------------
const char* FindTextEnd(const char* begin, const char* end)
{
  constexpr char EndOfFile = 0x1a; // in files of CP/M and MS-DOS
  const char* padding = end;
  const char* text = end;
  for (; text > begin && (text[-1] == '\0' || text[-1] == EndOfFile || IsSpace(text[-1])); --text)
  {
    padding = IsSpace(text[-1]) ? padding : text - 1;
  }
  const bool isBehindWord = text > begin && text == padding &&
    (std::isalnum(static_cast<unsigned char>(text[-1])) || std::strchr(".+-", text[-1]));
  const bool isLost = isBehindWord && end - padding > 1 && padding[0] == '\0' && padding[1] == '\0';
  return isLost ? end : padding;
}

//------------------------------------------------------------------------------
const char* SkipByteOrderMark(const char* begin, const char* end)
{
  constexpr char Mark[] = "\xef\xbb\xbf";
  constexpr std::ptrdiff_t Size = sizeof(Mark) - 1;
  return end - begin >= Size && std::memcmp(begin, Mark, Size) == 0 ? begin + Size : begin;
}

//------------------------------------------------------------------------------
TextScanner::TextScanner(std::string name, const char* begin, const char* end, char comment)
  : Name(std::move(name))
  , Begin(begin)
  , End(end)
  , Position(SkipByteOrderMark(begin, end))
  , Comment(comment)
{
}

//------------------------------------------------------------------------------
bool TextScanner::SkipSpace()
{
  while (this->Position < this->End)
  {
    if (this->Comment != '\0' && *this->Position == this->Comment)
    {
      this->Position = FindLineEnd(this->Position, this->End);
    }
    else if (!IsSpace(*this->Position))
    {
      return true;
    }
    else
    {
      ++this->Position;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void TextScanner::SkipLine()
{
  this->Position = FindLineEnd(this->Position, this->End);
  if (this->End - this->Position >= 2 && this->Position[0] == '\r' && this->Position[1] == '\n')
  {
    ++this->Position;
  }
  this->Position += this->Position < this->End;
}

//------------------------------------------------------------------------------
template <typename Number>
bool TextScanner::Read(Number& value, const char* what)
{
  if (this->HasFailed())
  {
    return false;
  }
  if (!this->SkipSpace())
  {
    return this->FailAt(this->End, ErrorKind::Truncated, what);
  }
  Number number;
  const char* next = ParseNumber(this->Position, this->End, number);
  if (!next || (next < this->End && !IsSpace(*next) && *next != this->Comment))
  {
    return this->FailAt(this->Position, ErrorKind::Syntax, what);
  }
  this->Position = next;
  value = number;
  return true;
}

template bool TextScanner::Read<std::int64_t>(std::int64_t&, const char*);
template bool TextScanner::Read<float>(float&, const char*);
template bool TextScanner::Read<double>(double&, const char*);

//------------------------------------------------------------------------------
bool TextScanner::ReadInteger(
  std::int64_t& value, std::int64_t first, std::int64_t last, ErrorKind kind, const char* what)
{
  std::int64_t number;
  if (!this->Read(number, what))
  {
    return false;
  }
  if (number < first || number > last)
  {
    const std::string found = std::to_string(number);
    const std::string range = last < first
      ? " (there are none)"
      : " from " + std::to_string(first) + " to " + std::to_string(last);
    return this->FailAt(this->Position, kind, what + range, found);
  }
  value = number;
  return true;
}

//------------------------------------------------------------------------------
bool TextScanner::ReadWord(std::string_view& word, const char* what)
{
  if (this->HasFailed())
  {
    return false;
  }
  if (!this->SkipSpace())
  {
    return this->FailAt(this->End, ErrorKind::Truncated, what);
  }
  const char* const begin = this->Position;
  while (this->Position < this->End && !IsSpace(*this->Position) &&
    (this->Comment == '\0' || *this->Position != this->Comment ||
      IsPartOfNumber(begin, this->Position, this->End)))
  {
    ++this->Position;
  }
  word = std::string_view(begin, static_cast<std::size_t>(this->Position - begin));
  return true;
}

//------------------------------------------------------------------------------
bool TextScanner::ReadCount(std::int64_t& value, int bytes, const char* what)
{
  std::int64_t count;
  if (!this->Read(count, what))
  {
    return false;
  }
  if (count < 0)
  {
    return this->FailAt(this->Position, ErrorKind::Count, what, std::to_string(count));
  }
  if (count > INT32_MAX)
  {
    return this->FailAt(this->Position, ErrorKind::Count, std::string(what) + " below 2147483648",
      std::to_string(count));
  }
  const std::int64_t possible = (this->GetBytesLeft() + 1) / bytes; // the last record may lack a
                                                                    // line end
  if (count > possible)
  {
    return this->FailAt(this->Position, ErrorKind::Truncated,
      "at least " + std::to_string(count * bytes) + " bytes after " + what + " (" +
        std::to_string(count) + ")",
      std::to_string(this->GetBytesLeft()));
  }
  value = count;
  return true;
}

//------------------------------------------------------------------------------
bool TextScanner::FailAt(const char* position, ErrorKind kind, const std::string& expected)
{
  const std::string_view rest(position, static_cast<std::size_t>(this->End - position));
  return this->FailAt(
    position, kind, expected, rest.empty() ? "the end of the file" : QuoteWord(rest));
}

//------------------------------------------------------------------------------
bool TextScanner::FailAt(
  const char* position, ErrorKind kind, const std::string& expected, const std::string& found)
{
  if (!this->HasFailed())
  {
    this->Error = { kind,
      this->Name + ":" + std::to_string(this->GetLine(position)) + ": expected " + expected +
        ", found " + found };
  }
  return false;
}

//------------------------------------------------------------------------------
void TextScanner::AddToError(const std::string& more)
{
  if (this->HasFailed())
  {
    this->Error.Message += more;
  }
}

//------------------------------------------------------------------------------
vtkIdType TextScanner::GetLine(const char* position) const
{
  vtkIdType line = 1;
  for (const char* p = this->Begin; p < position; ++p)
  {
    line += *p == '\n' || (*p == '\r' && !(p + 1 < this->End && p[1] == '\n'));
  }
  return line;
}
}
