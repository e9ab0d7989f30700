// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TextLines
 * @brief Finds and visits lines of a large text in parallel.
 *
 * Counts lines, except blank lines and comments, in chunks that end at line feeds. A line with a
 * given number can then be found without reading the text before it, and many lines can be visited
 * at once, each with its number. Results do not depend on chunks or threads.
 *
 * Meant for formats with one record per line. A reader first tries a section this way; if the file
 * has another layout (a visitor returns false), it reads the section again with a TextScanner,
 * which also creates the error messages.
 */
#ifndef camaron_TextLines_h
#define camaron_TextLines_h

#include "Base/Number.h"
#include "Base/Progress.h"
#include "Scan/TextScanner.h"

#include <atomic> // for the verdict of several threads
#include <vector> // for the chunks

namespace camaron
{
class TextLines
{
public:
  /// Bytes per chunk. Tests reduce it to read small files in parallel.
  inline static vtkIdType DefaultChunk = vtkIdType(1) << 18;

  /// Counts the lines from the scanner's position, which must be at the start of a line, to the
  /// end.
  TextLines(const TextScanner& scanner, const Progress& progress, vtkIdType chunk = DefaultChunk);

  /// Consecutive lines of the text.
  struct Section
  {
    const char* Begin = nullptr;
    const char* End = nullptr;
    vtkIdType FirstLine = 0; ///< index among all counted lines
    vtkIdType NumberOfLines = 0;
    explicit operator bool() const { return this->Begin != nullptr; }
  };

  /**
   * The next @a count lines from @a begin, which is at the start of a line or behind the last word
   * of one; an empty section if there are fewer, or if a lone CR ended the line before.
   */
  Section Find(const char* begin, vtkIdType count) const;

  /// Number of parts in which a section is visited.
  vtkIdType GetNumberOfPieces(const Section& section) const;

  /**
   * Calls @a visit(piece, line, text, end) for every line of a section. @a line counts from 0, and
   * [text, end) is the line from its first non-blank character to its line feed. A part is visited
   * in order by one thread. Returns false if any visit did.
   */
  template <typename Visit>
  bool ForEach(const Section& section, const Progress& progress, Visit&& visit) const
  {
    return this->ForEachToEnd(section, progress,
      [&](vtkIdType piece, vtkIdType line, const char* text, const char* end)
      {
        const char* const lineEnd = FindLineFeed(text, end);
        return visit(piece, line, text, lineEnd) ? lineEnd : nullptr;
      });
  }

  /**
   * The same for a visitor that finds the end of the line itself, so that it need not be searched:
   * it receives the end of the text, and returns the end of the line like GetEndOfLine, or nullptr
   * on failure.
   */
  template <typename Visit>
  bool ForEachToEnd(const Section& section, const Progress& progress, Visit&& visit) const
  {
    const vtkIdType firstChunk = this->GetChunk(section.Begin);
    std::atomic<bool> good{ true };
    progress.For(this->GetNumberOfPieces(section),
      [&](vtkIdType beginPiece, vtkIdType endPiece)
      {
        for (vtkIdType piece = beginPiece; piece < endPiece && good; ++piece)
        {
          const Chunk& chunk = this->Chunks[firstChunk + piece];
          const Chunk& next = this->Chunks[firstChunk + piece + 1];
          const char* text = piece == 0 ? section.Begin : chunk.Begin;
          const char* end = next.Begin < section.End ? next.Begin : section.End;
          vtkIdType line = piece == 0 ? 0 : chunk.FirstLine - section.FirstLine;
          const vtkIdType lastLine = next.FirstLine - section.FirstLine < section.NumberOfLines
            ? next.FirstLine - section.FirstLine
            : section.NumberOfLines;
          bool pieceIsGood = true;
          while (pieceIsGood && this->NextLine(text, end))
          {
            // There may be fewer lines than counted if the file was changed since.
            const char* const lineEnd =
              line >= 0 && line < lastLine ? visit(piece, line, text, end) : nullptr;
            pieceIsGood = lineEnd != nullptr;
            text = lineEnd;
            ++line;
          }
          if (!pieceIsGood || line < lastLine)
          {
            good = false;
          }
        }
      });
    return good && !progress.IsStopped();
  }

  /**
   * Whether the rest of a line is white space or a comment; false for a lone CR, which starts a
   * new line.
   */
  bool IsBlank(const char* text, const char* end) const;
  /// Whether the rest of the line has no lone CR.
  static bool HasOneEnd(const char* text, const char* end);

  /// Moves @a text to the next counted line; false at the end.
  bool NextLine(const char*& text, const char* end) const
  {
    while (text < end)
    {
      if (IsSpace(*text))
      {
        ++text;
      }
      else if (*text == this->Comment && this->Comment != '\0')
      {
        text = FindLineEnd(text, end);
      }
      else
      {
        return true;
      }
    }
    return false;
  }

  /// The line feed after @a text, or @a end; nullptr if a lone CR comes before it.
  static const char* GetEndOfLine(const char* text, const char* end)
  {
    if (text < end && *text == '\n')
    {
      return text;
    }
    const char* const lineEnd = FindLineFeed(text, end);
    return HasOneEnd(text, lineEnd) ? lineEnd : nullptr;
  }
  /// The same, but also nullptr if the rest of the line is not blank.
  const char* GetEndOfBlankLine(const char* text, const char* end) const
  {
    const char* const lineEnd = GetEndOfLine(text, end);
    return lineEnd && (lineEnd == text || this->IsBlank(text, lineEnd)) ? lineEnd : nullptr;
  }

private:
  struct Chunk
  {
    const char* Begin;
    vtkIdType FirstLine;
  };

  static const char* FindLineFeed(const char* text, const char* end)
  {
    const void* found = text < end ? std::memchr(text, '\n', end - text) : nullptr;
    return found ? static_cast<const char*>(found) : end;
  }
  vtkIdType CountLines(const char* begin, const char* end) const;
  vtkIdType GetChunk(const char* position) const;

  char Comment;
  std::vector<Chunk> Chunks; ///< and one more, for the end
};
}

#endif
