// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TextTable.h
 * @brief Reads rows of numbers, such as coordinates, from text.
 */
#ifndef camaron_TextTable_h
#define camaron_TextTable_h

#include "Scan/TextLines.h"

namespace camaron
{
/**
 * Reads @a rows rows of @a columns real numbers each into @a values; the rest of the line after each
 * row is ignored. False with the error in the scanner, or if stopped.
 * @param lines of the text if it is large enough to read it in parallel, else nullptr
 * @param what a number is, for errors, e.g. "a coordinate of a vertex"
 */
template <typename Real>
bool ReadTable(TextScanner& scanner, const TextLines* lines, vtkIdType rows, int columns,
  Real* values, const char* what, const Progress& progress)
{
  const TextLines::Section section =
    lines ? lines->Find(scanner.GetPosition(), rows) : TextLines::Section();
  const char comment = scanner.GetComment();
  if (section &&
    lines->ForEach(section, progress,
      [&](vtkIdType, vtkIdType line, const char* text, const char* end)
      {
        Real* row = values + line * columns;
        for (int c = 0; c < columns; ++c)
        {
          while (text < end && IsSpace(*text))
          {
            ++text;
          }
          text = ParseReal(text, end, row[c]);
          if (!text || (text < end && !IsSpace(*text) && *text != comment))
          {
            return false;
          }
        }
        return TextLines::HasOneEnd(text, end);
      }))
  {
    scanner.SetPosition(section.End);
    return true;
  }
  // Not one row per line, or wrong: row by row.
  for (vtkIdType row = 0; row < rows && !progress.IsStopped(); ++row)
  {
    for (int c = 0; c < columns; ++c)
    {
      if (!scanner.ReadReal(values[row * columns + c], what))
      {
        return false;
      }
    }
    scanner.SkipLine();
  }
  return !progress.IsStopped();
}
}

#endif
