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
/// Whether the file begins like a TS file of Camarón or a TSurf of GOCAD. Reports no errors.
bool IsTS(const std::string& path);

/**
 * Reads a piece of a file into @a grid, which is emptied first. The result does not depend on the
 * number of threads.
 * @param chunk bytes of text per task
 * @return false with the error in @a error, or without one if aborted; the grid is then empty
 */
bool ReadTS(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress = Progress(),
  vtkIdType chunk = TextLines::DefaultChunk);
}

#endif
