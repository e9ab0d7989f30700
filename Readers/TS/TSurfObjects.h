// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TSurfObjects.h
 * @brief The objects in a GOCAD file: their extents, and the lines before their records.
 */
#ifndef camaron_TSurfObjects_h
#define camaron_TSurfObjects_h

#include "Intake/Pieces/PieceRequest.h"
#include "Intake/Rows/TextRows.h"

#include <string> // for names
#include <vector> // for objects

class vtkUnstructuredGrid;

namespace camaron
{
// What errors expect.
constexpr char VertexId[] = "the id of a vertex";
constexpr char Coordinate[] = "a coordinate of a vertex";

/// Type of a line of a TSurf.
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

/// Reads the keyword of a line.
TSurfLine ReadKeyword(TextRow& row);

struct TSurfProperty
{
  std::string Name;
  int Size = 1;
  double NoData = 0; ///< value that means "undefined"
  bool HasNoData = false;
};

/// A surface.
struct TSurfObject
{
  const char* Begin; ///< of the first line with a record
  const char* End;   ///< of the last one
  std::string Name;
  std::string ZPositive; ///< "Elevation", "Depth" or empty
  std::string AxisUnit;
  std::vector<TSurfProperty> Properties;
};

/**
 * Finds the TSurf objects of the text, whose lines end with LF or CRLF, and reads the lines before
 * their records. False with the error in @a scanner. Warns about objects of other types.
 */
bool FindObjects(TextScanner& scanner, std::vector<TSurfObject>& objects, Warnings& warnings);

/// Whether the text begins with a GOCAD object, and the type of that.
bool IsGOCAD(TextScanner scanner, std::string_view& type);
/// Whether this is the type of surfaces.
bool IsTSurf(std::string_view type);

/// Reads the TSurf objects of a file into a grid; see ReadTS.
bool ReadTSurf(const MappedFile& file, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress, vtkIdType chunk);
}

#endif
