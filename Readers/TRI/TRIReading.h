// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TRIReading.h
 * @brief Reads TRI files of Camarón and of Cart3D.
 *
 * A TRI file of Camarón is text: the number of vertices, their coordinates, the number of
 * triangles, and their vertices, counted from 0. Cart3D files may be binary; they begin with both
 * numbers and count vertices from 1. See Readers/TRI/README.md.
 *
 * Output: a vtkUnstructuredGrid with double coordinates (float if a binary file stores floats) in
 * the unit of the file, which the format does not state. Cells are VTK_TRIANGLE in the order and
 * orientation of the file; a file with vertices only gives one VTK_VERTEX each. Components of
 * Cart3D become the cell array "Component", scalars the point array "Scalars".
 */
#ifndef camaron_TRIReading_h
#define camaron_TRIReading_h

#include "Intake/Pieces/PieceRequest.h"
#include "Intake/Rows/TextRows.h"

#include <string> // for paths

class vtkUnstructuredGrid;

namespace camaron
{
/// Whether the file begins like a TRI file. Reports no errors.
bool IsTRI(const std::string& path);

/**
 * Reads a piece of a file into @a grid, which is emptied first. The result does not depend on the
 * number of threads.
 * @param chunk bytes of text per task; shorter text than two chunks is read serially
 * @return false with the error in @a error, or without one if aborted; the grid is then empty
 */
bool ReadTRI(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress = Progress(),
  vtkIdType chunk = TextLines::DefaultChunk);
}

#endif
