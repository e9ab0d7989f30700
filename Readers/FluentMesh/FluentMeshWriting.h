// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FluentMeshWriting.h
 * @brief Writes mesh files of Ansys Fluent. See Readers/FluentMesh/README.md.
 */
#ifndef camaron_FluentMeshWriting_h
#define camaron_FluentMeshWriting_h

#include "Intake/CellMesh/CellConversion.h"

#include <string> // for paths

class vtkDataSet;

namespace camaron
{
enum class FluentEncoding
{
  Ascii = 0,
  Single = 1, ///< binary, little endian
  Double = 2  ///< binary, little endian
};

/**
 * Writes the cells of the highest dimension of a vtkUnstructuredGrid or vtkPolyData.
 * @return false with the error in @a error, or without one if aborted; the file is then unchanged
 */
bool WriteFluentMesh(const std::string& path, vtkDataSet* mesh, FluentEncoding encoding,
  UnsupportedCells others, Warnings& warnings, ScanError& error,
  const Progress& progress = Progress());
}

#endif
