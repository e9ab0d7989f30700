// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TSurfObjects.h
 * @brief The objects in a file of GOCAD: where each is, and what comes before its records.
 */
#ifndef camaron_TSurfObjects_h
#define camaron_TSurfObjects_h

#include "Scan/TextRows.h"

#include <string> // for names
#include <vector> // for objects

namespace camaron
{
/// What a line of a TSurf is.
enum class TSurfLine
{
  Other,
  Vertex,         ///< VRTX id x y z
  PropertyVertex, ///< PVRTX id x y z values
  Atom,           ///< ATOM id of another vertex
  PropertyAtom,   ///< PATOM id of another vertex, values
  Triangle,       ///< TRGL a b c
  Face            ///< TFACE
};

/// Moves @a text, the start of a line, behind its keyword if it is none of the others.
TSurfLine ReadKeyword(const char*& text, const char* end);

struct TSurfProperty
{
  std::string Name;
  int Size = 1;
  double NoData = 0; ///< stands for no value
  bool HasNoData = false;
};

/// A surface.
struct TSurfObject
{
  const char* Begin; ///< of the first line with a record
  const char* End;   ///< of the last one
  std::string Name;
  std::string ZPositive; ///< "Elevation", "Depth" or nothing
  std::string AxisUnit;
  std::vector<TSurfProperty> Properties;

  /// Of all properties together.
  std::int64_t GetNumberOfValues() const
  {
    std::int64_t number = 0;
    for (const TSurfProperty& property : this->Properties)
    {
      number += property.Size;
    }
    return number;
  }
};

/**
 * Finds the TSurf objects of the text, whose lines end with LF or CRLF, and reads what comes before
 * their records. False with the error in @a scanner. Objects of other types are warned of.
 */
bool FindObjects(TextScanner& scanner, std::vector<TSurfObject>& objects, Warnings& warnings);

/// Whether the text begins with an object of GOCAD, or with a TSurf.
bool IsGOCAD(TextScanner scanner);
bool IsTSurf(TextScanner scanner);
}

#endif
