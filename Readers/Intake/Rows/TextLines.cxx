// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Rows/TextLines.h"

#include <algorithm>

namespace camaron
{
//------------------------------------------------------------------------------
TextLines::TextLines(const TextScanner& scanner, const Progress& progress, vtkIdType chunkSize)
  : Comment(scanner.GetComment())
{
  const char* const end = scanner.GetEnd();
  for (const char* text = scanner.GetPosition(); text < end;)
  {
    this->Chunks.push_back({ text, 0 });
    text = end - text > chunkSize ? FindLineFeed(text + chunkSize, end) : end;
    text += text < end;
  }
  this->Chunks.push_back({ end, 0 });

  std::vector<vtkIdType> counts(this->Chunks.size(), 0);
  progress.For(static_cast<vtkIdType>(this->Chunks.size()) - 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType c = first; c < last; ++c)
      {
        counts[c + 1] = this->CountLines(this->Chunks[c].Begin, this->Chunks[c + 1].Begin);
      }
    });
  for (std::size_t c = 1; c < this->Chunks.size(); ++c)
  {
    this->Chunks[c].FirstLine = this->Chunks[c - 1].FirstLine + counts[c];
  }
}

//------------------------------------------------------------------------------
vtkIdType TextLines::CountLines(const char* begin, const char* end) const
{
  vtkIdType lines = 0;
  for (const char* text = begin; this->NextLine(text, end); ++lines)
  {
    text = FindLineFeed(text, end);
  }
  return lines;
}

//------------------------------------------------------------------------------
vtkIdType TextLines::GetChunk(const char* position) const
{
  const auto next = std::upper_bound(this->Chunks.begin(), this->Chunks.end() - 1, position,
    [](const char* p, const Chunk& chunk) { return p < chunk.Begin; });
  return std::max<vtkIdType>(0, next - this->Chunks.begin() - 1);
}

//------------------------------------------------------------------------------
TextLines::Section TextLines::Find(const char* begin, vtkIdType count) const
{
  const Chunk& chunk = this->Chunks[this->GetChunk(begin)];
  bool isBehindText = false;
  for (const char* before = begin; before > chunk.Begin && before[-1] != '\n'; --before)
  {
    // After a lone CR, which ends a line for a scanner but not here, lines would be counted twice.
    if (before[-1] == '\r')
    {
      return {};
    }
    isBehindText = isBehindText || !IsSpace(before[-1]);
  }
  if (isBehindText)
  {
    // After a number, for example: lines begin with the next one, unless more text follows in this
    // line.
    const char* const next = FindLineFeed(begin, this->Chunks.back().Begin);
    const bool isBlank = next < this->Chunks.back().Begin && this->IsBlank(begin, next);
    return isBlank ? this->Find(next + 1, count) : Section();
  }
  const vtkIdType first = chunk.FirstLine + this->CountLines(chunk.Begin, begin);
  if (this->Chunks.back().FirstLine - first < count)
  {
    return {};
  }
  // The last chunk that starts no later than the line after the section.
  const auto next = std::upper_bound(this->Chunks.begin(), this->Chunks.end(), first + count,
    [](vtkIdType line, const Chunk& c) { return line < c.FirstLine; });
  const Chunk& last = *(next - 1);
  const char* const end = this->Chunks.back().Begin;
  const char* text = std::max(begin, last.Begin);
  vtkIdType line = std::max(first, last.FirstLine);
  for (; line < first + count && this->NextLine(text, end); ++line)
  {
    text = FindLineFeed(text, end);
    text += text < end;
  }
  return { begin, text, first, count };
}

//------------------------------------------------------------------------------
vtkIdType TextLines::GetNumberOfPieces(const Section& section) const
{
  return section.End > section.Begin
    ? this->GetChunk(section.End - 1) - this->GetChunk(section.Begin) + 1
    : 0;
}

//------------------------------------------------------------------------------
bool TextLines::IsBlank(const char* text, const char* end) const
{
  for (; text < end && (this->Comment == '\0' || *text != this->Comment); ++text)
  {
    if (!IsSpace(*text) || (*text == '\r' && text + 1 < end))
    {
      return false;
    }
  }
  return HasOneEnd(text, end);
}

//------------------------------------------------------------------------------
bool TextLines::HasOneEnd(const char* text, const char* end)
{
  const void* found = text < end ? std::memchr(text, '\r', end - text) : nullptr;
  return !found || static_cast<const char*>(found) == end - 1;
}
}
