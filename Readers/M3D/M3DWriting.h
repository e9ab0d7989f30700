// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file M3DWriting.h
 * @brief Writes M3D, M2D and MVM files.
 */
#ifndef camaron_M3DWriting_h
#define camaron_M3DWriting_h

#include "CellMesh/CellConversion.h"
#include "M3DElements.h"

#include <string> // for paths

class vtkDataSet;

namespace camaron
{
/// The dialect that the extension of a path stands for; M3D for all others.
M3DDialect GetM3DDialect(const std::string& path);

/// How an M3D file is written.
struct M3DWriteOptions
{
  M3DDialect Dialect = M3DDialect::M3D;
  int Digits = 9; ///< of coordinates; 9 keep every float, 17 every double
  UnsupportedCells Others = UnsupportedCells::Refuse;
};

/**
 * Writes a vtkUnstructuredGrid or vtkPolyData. The material of elements is that of the cell array
 * or the field data "Material" of three components, else what mesh generators write. All nodes have
 * code 1.
 * @return false with the error in @a error, or without one if stopped; the file is as before then
 */
bool WriteM3D(const std::string& path, vtkDataSet* mesh, const M3DWriteOptions& options,
  Warnings& warnings, ScanError& error, const Progress& progress = Progress());
}

#endif
