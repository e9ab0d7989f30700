// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonPLYReading.h
 * @brief Reads PLY files with all that they hold.
 *
 * See Readers/PolygonPLY/README.md for the format, and what becomes of it. Lists other than those
 * of vertices and faces are left out with a warning.
 */
#ifndef camaron_PolygonPLYReading_h
#define camaron_PolygonPLYReading_h

#include "Scan/PieceRequest.h"
#include "Scan/TextLines.h"

#include <string> // for paths

class vtkUnstructuredGrid;

namespace camaron
{
/// Whether the file begins like a PLY file. Reads a few bytes, reports nothing.
bool IsPLY(const std::string& path);

/**
 * Reads a piece of a file into @a grid, which is emptied first. Any number of threads gives the
 * same grid.
 * @param chunk bytes of text read as one piece of work; text of fewer than two is read in one go
 * @return false with the error in @a error, or without one if stopped; the grid is empty then
 */
bool ReadPLY(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress = Progress(),
  vtkIdType chunk = TextLines::DefaultChunk);
}

#endif
