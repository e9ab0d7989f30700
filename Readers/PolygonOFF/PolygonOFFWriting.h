// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonOFFWriting.h
 * @brief Writes OFF files as text or binary.
 *
 * See Readers/PolygonOFF/README.md for the format.
 */
#ifndef camaron_PolygonOFFWriting_h
#define camaron_PolygonOFFWriting_h

#include "Intake/CellMesh/CellConversion.h"

#include <string> // for paths

class vtkDataSet;

namespace camaron
{
enum class OFFEncoding
{
  ASCII = 0,
  Binary = 1 ///< big endian, float
};

/// Options of the writer. By default a file has coordinates and faces only, which all programs
/// read.
struct OFFOptions
{
  OFFEncoding Encoding = OFFEncoding::ASCII;
  int Digits = 0; ///< significant digits of real numbers in text; 0 for the fewest that are exact
  bool WriteNormals = false;
  bool WriteTexture = false;
  std::string VertexColors; ///< point array; empty for none
  std::string FaceColors;   ///< cell array; empty for none
  UnsupportedCells Others = UnsupportedCells::Refuse;
  SurfaceFaces Surface = SurfaceFaces::Boundary;
};

/**
 * Writes a vtkUnstructuredGrid or vtkPolyData. Lines and vertices become faces with two vertices
 * and one; if the cells are exactly one vertex per point, in order, the file has no faces.
 * @return false with the error in @a error, or without one if aborted; the file is then unchanged
 */
bool WritePolygonOFF(const std::string& path, vtkDataSet* mesh, const OFFOptions& options,
  Warnings& warnings, ScanError& error, const Progress& progress = Progress());
}

#endif
