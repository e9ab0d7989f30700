// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetGenReading.h
 * @brief Reads files of TetGen and Triangle.
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
/// Whether the file begins like one of TetGen or Triangle with its extension. Reports nothing.
bool IsTetGen(const std::string& path);

/**
 * Reads a piece of the mesh that a file and those beside it make up into @a grid, which is emptied
 * first. Any number of threads gives the same grid.
 * @param chunk bytes of text read as one piece of work; text of fewer than two is read in one go
 * @return false with the error in @a error, or without one if stopped; the grid is empty then
 */
bool ReadTetGen(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress = Progress(),
  vtkIdType chunk = TextLines::DefaultChunk);
}

#endif
