// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TextTable.h
 * @brief Reads rows of numbers, such as coordinates, from text.
 */
#ifndef camaron_TextTable_h
#define camaron_TextTable_h

#include "Scan/TextRows.h"

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
