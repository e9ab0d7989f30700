// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TRIWriting.h
 * @brief Writes TRI files of Camarón and of Cart3D.
 */
#ifndef camaron_TRIWriting_h
#define camaron_TRIWriting_h

#include "Intake/CellMesh/CellConversion.h"

#include <string> // for paths

class vtkDataSet;

namespace camaron
{
enum class TRIDialect
{
  Camaron = 0, ///< ids count from 0
  Cart3D = 1   ///< ids count from 1, and components of triangles
};

/// Options of the writer.
struct TRIOptions
{
  TRIDialect Dialect = TRIDialect::Camaron;
  UnsupportedCells Others = UnsupportedCells::Refuse;
  SurfaceFaces Surface = SurfaceFaces::Boundary;
};

/**
 * Writes a vtkUnstructuredGrid or vtkPolyData. Coordinates have the fewest digits that read back as
 * the same number of their type. Cart3D files contain the components of triangles if the mesh has
 * the cell array "Component".
 * @return false with the error in @a error, or without one if aborted; the file is then unchanged
 */
bool WriteTRI(const std::string& path, vtkDataSet* mesh, const TRIOptions& options,
  Warnings& warnings, ScanError& error, const Progress& progress = Progress());
}

#endif
