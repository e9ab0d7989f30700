// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonPLYWriting.h
 * @brief Writes PLY files with all arrays.
 */
#ifndef camaron_PolygonPLYWriting_h
#define camaron_PolygonPLYWriting_h

#include "Intake/CellMesh/CellConversion.h"
#include "PLYColumns.h"

#include <string> // for paths

class vtkDataSet;

namespace camaron
{
/// Options of the writer.
struct PLYWriteOptions
{
  PLYEncoding Encoding = PLYEncoding::LittleEndian;
  bool FloatCoordinates = false; ///< even if the mesh has double
  bool Cells = false;            ///< 3D cells as elements `cell`, not only their faces
  UnsupportedCells Others = UnsupportedCells::Refuse;
  SurfaceFaces Surface = SurfaceFaces::Boundary;
};

/**
 * Writes a vtkUnstructuredGrid or vtkPolyData with the arrays of its points and cells.
 * @return false with the error in @a error, or without one if aborted; the file is then unchanged
 */
bool WritePLY(const std::string& path, vtkDataSet* mesh, const PLYWriteOptions& options,
  Warnings& warnings, ScanError& error, const Progress& progress = Progress());
}

#endif
