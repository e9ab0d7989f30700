// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetGenReading.h
 * @brief Reads TetGen and Triangle files.
 *
 * See Readers/TetGen/README.md for the format.
 */
#ifndef camaron_TetGenReading_h
#define camaron_TetGenReading_h

#include "Scan/PieceRequest.h"
#include "Scan/TextLines.h"

#include <string> // for paths

class vtkUnstructuredGrid;

namespace camaron
{
/// Whether the file begins like a TetGen or Triangle file with its extension. Reports no errors.
bool IsTetGen(const std::string& path);

/**
 * Reads a piece of the mesh in a file and its companion files into @a grid, which is emptied first.
 * The result does not depend on the number of threads.
 * @param chunk bytes of text per task; shorter text than two chunks is read serially
 * @return false with the error in @a error, or without one if aborted; the grid is then empty
 */
bool ReadTetGen(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress = Progress(),
  vtkIdType chunk = TextLines::DefaultChunk);
}

#endif
