// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file M3DReading.h
 * @brief Reads M3D, M2D and MVM files, meshes of mixed elements.
 *
 * See Readers/M3D/README.md for the formats.
 */
#ifndef camaron_M3DReading_h
#define camaron_M3DReading_h

#include "Intake/Pieces/PieceRequest.h"
#include "Intake/Rows/TextRows.h"

#include <string> // for paths

class vtkUnstructuredGrid;

namespace camaron
{
/// Whether the file begins like an M3D, M2D or MVM file. Reports no errors.
bool IsM3D(const std::string& path);

struct M3DOptions
{
  /// Whether to move nodes with code 2 by their projection.
  bool AddProjection = true;
};

/**
 * Reads a piece of a file into @a grid, which is emptied first. The result does not depend on the
 * number of threads.
 * @param chunk bytes of text per task; shorter text than two chunks is read serially
 * @return false with the error in @a error, or without one if aborted; the grid is then empty
 */
bool ReadM3D(const std::string& path, const PieceRequest& request, const M3DOptions& options,
  vtkUnstructuredGrid* grid, Warnings& warnings, ScanError& error,
  const Progress& progress = Progress(), vtkIdType chunk = TextLines::DefaultChunk);
}

#endif
