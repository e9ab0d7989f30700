// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentMeshFile
 * @brief Finds the sections of a Fluent file in text or binary.
 *
 * A file is a sequence of sections `(index ...)`. Those that describe the mesh are collected, all
 * others are skipped: text by matching parentheses outside of quotes, including lists of settings
 * without an index; binary sections (index 2000 to 3999) up to their end mark, as bytes in them may
 * look like parentheses.
 */
#ifndef camaron_FluentMeshFile_h
#define camaron_FluentMeshFile_h

#include "Intake/Fluent/FluentFile.h"

#include <string> // for names

namespace camaron
{
class FluentMeshFile : public FluentFile
{
public:
  FluentMeshFile(std::string name, const char* begin, const char* end);

  /// Whether these may be the first bytes of a Fluent file; among files with its extensions, only
  /// these begin with '('.
  static bool IsFluent(const char* begin, const char* end);

  /// Finds all sections; false with the error, or if aborted.
  bool Scan(const Progress& progress);

private:
  /// "name:line", or with the byte instead of the line after binary sections.
  std::string Locate(const char* place) const override;
  /// Skips white space; whether '(' follows.
  bool IsAtList();
  const char* ParseFirst(std::int64_t& value);
  bool SkipRest(int depth, const FluentSection& section);
  bool SkipBinary(const FluentSection& section, int index);
  bool ReadHeader(FluentSection& section);
  bool ReadSection();
  bool ReadMeshSection(FluentSection& section, int index);
  bool ReadTextBody(FluentSection& section);
  bool ReadBinaryBody(FluentSection& section, int index);
  const char* FindEndOfData(FluentSection& section);
  const char* FindLists(FluentSection& section);
  const char* FindEndMark(const char* place, int index, bool hasData) const;
  bool ReadDimension();
  void ReadConfiguration();
  void ReadZone();
  void Keep(FluentSection&& section);
  bool CheckRange(const FluentSection& section);

  const char* Position = nullptr;
  const char* FirstBinary = nullptr;
  bool TrustsQuotes = true;
  bool HasMeshSection = false;
};
}

#endif
