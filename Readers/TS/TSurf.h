// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TSurf.h
 * @brief Surfaces of GOCAD (TSurf), which share the extension of TS files.
 *
 * A file has one object per surface, from "GOCAD TSurf 1" to "END". Its first lines have a name, a
 * coordinate system and properties of vertices; then come the records: VRTX, PVRTX, ATOM, PATOM,
 * TRGL, and TFACE. See Readers/TS/README.md.
 */
#ifndef camaron_TSurf_h
#define camaron_TSurf_h

#include "Base/Progress.h"
#include "Intake/Pieces/PieceRequest.h"
#include "Intake/Write/OutputFile.h"
#include "Scan/MappedFile.h"
#include "Scan/TextScanner.h"

#include <string> // for names
#include <vector> // for objects

class vtkDataSet;
class vtkUnstructuredGrid;

namespace camaron
{
class OutputMesh;

constexpr char Coordinate[] = "a coordinate of a vertex"; ///< for errors

constexpr char PartArray[] = "Part";               ///< of cells, the object of a triangle
constexpr char FaceArray[] = "TFace";              ///< of cells, the face (TFACE) in the object
constexpr char PointIdArray[] = "OriginalPointId"; ///< of points, their ids in the file

struct TSurfProperty
{
  std::string Name;
  int Size = 1;
  double NoData = 0; ///< value that means "undefined"
  bool HasNoData = false;
};

/// The first lines of an object.
struct TSurfObject
{
  std::string Name;
  std::string ZPositive; ///< "Elevation", "Depth" or empty
  std::string AxisUnit;
  std::vector<TSurfProperty> Properties;
  const char* Begin = nullptr; ///< of the first line with a record
  const char* End = nullptr;   ///< of the last one
};

/// Field data with a text of each object.
struct TSurfText
{
  const char* Array;
  std::string TSurfObject::* Text;
};
constexpr TSurfText TSurfTexts[] = { { "PartName", &TSurfObject::Name },
  { "ZPositive", &TSurfObject::ZPositive }, { "AxisUnit", &TSurfObject::AxisUnit } };

/// The type of the GOCAD object with which a text begins; empty if it begins with none.
std::string_view GetGOCADType(TextScanner scanner);
/// Whether this is the type of surfaces.
bool IsTSurf(std::string_view type);
/// Whether a line with this keyword is a record.
bool IsRecord(std::string_view keyword);

/**
 * Finds the TSurf objects of the text, whose lines end with LF or CRLF, and reads their first
 * lines. False with the error in @a scanner. Warns about objects of other types.
 */
bool FindObjects(TextScanner& scanner, std::vector<TSurfObject>& objects, Warnings& warnings);

/// Reads the TSurf objects of a file into one grid; see ReadTS.
bool ReadTSurf(const MappedFile& file, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress, vtkIdType chunk);

/**
 * Writes triangles. Point arrays become properties. The array "Part" splits the mesh into several
 * objects if every part has points of its own, as after reading such a file. False with the error
 * in
 * @a file, or if stopped.
 * @param input the mesh from which @a mesh was converted
 */
bool WriteTSurf(OutputFile& file, vtkDataSet* input, const OutputMesh& mesh, Warnings& warnings,
  const Progress& progress);
}

#endif
