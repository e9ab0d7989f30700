// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TSReading.h
 * @brief Reads TS files: tetrahedra of Camarón, and surfaces of GOCAD.
 *
 * A TS file of Camarón is text: the numbers of vertices and tetrahedra, the coordinates of the
 * vertices, and the vertices of the tetrahedra, counted from 0. A TSurf of GOCAD is text with a
 * keyword on every line. See Readers/TS/README.md.
 *
 * Output: a vtkUnstructuredGrid with double coordinates in the unit of the file. Cells are
 * VTK_TETRA or VTK_TRIANGLE in the order and orientation of the file; a file with vertices only
 * gives one VTK_VERTEX each. A TSurf adds the cell arrays "Part" and "TFace", a point array for
 * each property, "OriginalPointId", and field data "PartName", "ZPositive" and "AxisUnit" with a
 * value per part.
 */
#ifndef camaron_TSReading_h
#define camaron_TSReading_h

#include "Intake/Pieces/PieceRequest.h"
#include "Intake/Rows/TextRows.h"

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
