// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file M3DWriting.h
 * @brief Writes M3D, M2D and MVM files.
 */
#ifndef camaron_M3DWriting_h
#define camaron_M3DWriting_h

#include "Intake/CellMesh/CellConversion.h"
#include "M3DElements.h"

#include <string> // for paths

class vtkDataSet;

namespace camaron
{
/// The dialect of the extension of a path; M3D for unknown extensions.
M3DDialect GetM3DDialect(const std::string& path);

/// Options of the writer.
struct M3DWriteOptions
{
  M3DDialect Dialect = M3DDialect::M3D;
  int Digits = 0; ///< of coordinates; 0 for 9, as generators write, or 17 if 9 are not exact
  UnsupportedCells Others = UnsupportedCells::Refuse;
};

/**
 * Writes a vtkUnstructuredGrid or vtkPolyData. The material of elements is taken from the cell
 * array or the field data "Material" with three components, else the default of mesh generators is
 * written. All nodes get code 1.
 * @return false with the error in @a error, or without one if aborted; the file is then unchanged
 */
bool WriteM3D(const std::string& path, vtkDataSet* mesh, const M3DWriteOptions& options,
  Warnings& warnings, ScanError& error, const Progress& progress = Progress());
}

#endif
