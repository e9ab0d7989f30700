// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonPLYReading.h
 * @brief Reads PLY files with all their properties.
 *
 * See Readers/PolygonPLY/README.md for the format and the resulting arrays. Lists other than those
 * of vertices and faces become arrays if their lengths are similar; others are left out with a
 * warning.
 */
#ifndef camaron_PolygonPLYReading_h
#define camaron_PolygonPLYReading_h

#include "Scan/PieceRequest.h"
#include "Scan/TextLines.h"

#include <string> // for paths

class vtkUnstructuredGrid;

namespace camaron
{
/// Whether the file begins like a PLY file. Reads a few bytes and reports no errors.
bool IsPLY(const std::string& path);

/**
 * Reads a piece of a file into @a grid, which is emptied first. The result does not depend on the
 * number of threads.
 * @param chunk bytes of text per task; shorter text than two chunks is read serially
 * @return false with the error in @a error, or without one if aborted; the grid is then empty
 */
bool ReadPLY(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress = Progress(),
  vtkIdType chunk = TextLines::DefaultChunk);
}

#endif
