// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PLYHeader.h
 * @brief The header of a PLY file: which elements it has, and which properties these have.
 */
#ifndef camaron_PLYHeader_h
#define camaron_PLYHeader_h

#include "PLYTypes.h"
#include "Scan/TextScanner.h"

#include <initializer_list> // for names
#include <map>              // for arrays of several components
#include <string>           // for names
#include <vector>           // for elements and properties

namespace camaron
{
struct PLYProperty
{
  std::string Name;
  PLYType Type;
  bool IsList = false;
  PLYType CountType = PLYType::UInt8; ///< of the length of a list
  bool IsColor = false;               ///< integers count from 0 to 255, whatever the type
};

struct PLYElement
{
  std::string Name;
  vtkIdType Count = 0;
  std::vector<PLYProperty> Properties;

  /// The first property that is, or is no, list of one of these names; -1 if there is none.
  int Find(std::initializer_list<const char*> names, bool isList) const;
};

enum class PLYEncoding
{
  Text,
  LittleEndian,
  BigEndian
};

struct PLYHeader
{
  PLYEncoding Encoding = PLYEncoding::Text;
  std::vector<PLYElement> Elements;
  /// Arrays of several components and how many they have, as our writer notes them in comments
  /// "components NAME NUMBER".
  std::map<std::string, int> Components;
  /// Whether our writer noted in a comment that values of faces of cells are none.
  bool FacesOfCellsAreBlank = false;
  const char* Body = nullptr; ///< where the values begin
  std::vector<std::string> Oddities;
};

/// What our writer says in a comment of faces that only bound cells.
constexpr char BlankFacesOfCells[] = "faces_of_cells_have_no_values";

/// A name of the file for messages.
std::string Quote(const std::string& name);

/// Reads a header; false with the error in the scanner, which is at the start of the file.
bool ReadPLYHeader(TextScanner& scanner, PLYHeader& header);
/// Whether a text begins like a PLY file.
bool IsPLYStart(const char* begin, const char* end);
}

#endif
