// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TSReading.h
 * @brief Reads TS files: tetrahedra of Camarón, and surfaces of GOCAD.
 *
 * See Readers/TS/README.md for the formats.
 */
#ifndef camaron_TSReading_h
#define camaron_TSReading_h

#include "Scan/PieceRequest.h"
#include "Scan/TextRows.h"

#include <string> // for paths

class vtkUnstructuredGrid;

namespace camaron
{
/// Whether the file begins like one of Camarón's TS files or a TSurf of GOCAD. Reports nothing.
bool IsTS(const std::string& path);

/**
 * Reads a piece of a file into @a grid, which is emptied first. Any number of threads gives the
 * same grid.
 * @param chunk bytes of text read as one piece of work
 * @return false with the error in @a error, or without one if stopped; the grid is empty then
 */
bool ReadTS(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress = Progress(),
  vtkIdType chunk = TextLines::DefaultChunk);
}

#endif
