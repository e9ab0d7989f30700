// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TSWriting.h
 * @brief Writes TS files: tetrahedra of Camarón, and surfaces of GOCAD.
 */
#ifndef camaron_TSWriting_h
#define camaron_TSWriting_h

#include "Intake/CellMesh/CellConversion.h"

#include <string> // for paths

class vtkDataSet;

namespace camaron
{
enum class TSDialect
{
  Camaron = 0, ///< tetrahedra
  GOCAD = 1    ///< triangles, with point arrays as properties
};

/// Options of the writer.
struct TSOptions
{
  TSDialect Dialect = TSDialect::Camaron;
  UnsupportedCells Others = UnsupportedCells::Refuse;
  SurfaceFaces Surface = SurfaceFaces::Boundary; ///< of 3D cells, in GOCAD files
};

/**
 * Writes a vtkUnstructuredGrid or vtkPolyData. Numbers have the fewest digits that read back as the
 * same number of their type.
 * @return false with the error in @a error, or without one if aborted; the file is then unchanged
 */
bool WriteTS(const std::string& path, vtkDataSet* mesh, const TSOptions& options,
  Warnings& warnings, ScanError& error, const Progress& progress = Progress());
}

#endif
