// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PLYHeader.h
 * @brief The header of a PLY file: its elements and their properties.
 */
#ifndef camaron_PLYHeader_h
#define camaron_PLYHeader_h

#include "Intake/Rows/TableRows.h"
#include "Scan/TextScanner.h"

#include <initializer_list> // for names
#include <map>              // for arrays of several components
#include <string>           // for names
#include <string_view>      // for names of encodings
#include <vector>           // for elements and properties

namespace camaron
{
/// The encoding of a file, in the order of the writer's property.
enum class PLYEncoding
{
  Text = 0,
  LittleEndian = 1,
  BigEndian = 2
};

constexpr std::string_view PLYEncodingNames[] = { "ascii", "binary_little_endian",
  "binary_big_endian" };

struct PLYElement : Table
{
  bool HasByteColors = false; ///< colors range from 0 to 255, whatever the type

  /// The first property with one of these names that is, or is not, a list; -1 if there is none.
  int Find(std::initializer_list<const char*> names, bool isList) const;
};

struct PLYHeader
{
  PLYEncoding Encoding = PLYEncoding::Text;
  std::vector<PLYElement> Elements;
  /// Arrays with several components and their numbers, as recorded by our writer in comments
  /// "components NAME NUMBER".
  std::map<std::string, int> Components;
  /// Whether our writer recorded in a comment that faces of cells have no values.
  bool FacesOfCellsAreBlank = false;
  const char* Body = nullptr; ///< start of the values
  std::vector<std::string> Oddities;
};

/// Comment of our writer for faces that only bound cells.
constexpr char BlankFacesOfCells[] = "faces_of_cells_have_no_values";

/// Reads a header; false with the error in the scanner, which is at the start of the file.
bool ReadPLYHeader(TextScanner& scanner, PLYHeader& header);
/// Whether a text begins like a PLY file.
bool IsPLYStart(const char* begin, const char* end);
}

#endif
