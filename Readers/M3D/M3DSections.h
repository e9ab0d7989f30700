// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file M3DSections.h
 * @brief Finds the sections of M3D and MVM files.
 */
#ifndef camaron_M3DSections_h
#define camaron_M3DSections_h

#include "M3DElements.h"
#include "Scan/TextScanner.h"

#include <string>      // for headings
#include <string_view> // for keywords

namespace camaron
{
/// Sections that are skipped.
struct OtherSections
{
  vtkIdType Count = 0;
  std::string First;

  void Add(const char* text, const char* end);
};

/**
 * Moves past the heading of the section that begins with a keyword (in lower case), skipping other
 * sections. False if none begins within @a size bytes.
 */
bool FindSection(
  TextScanner& scanner, std::string_view keyword, vtkIdType size, OtherSections& others);

/// Moves past the first heading, or fails.
bool ReadHeading(TextScanner& scanner, M3DDialect& dialect, OtherSections& others);
}

#endif
