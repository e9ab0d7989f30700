// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonOFFReading.h
 * @brief Reads OFF files of Geomview and of other programs that use the format.
 *
 * All keywords [ST][C][N][4][n]OFF are supported, in text and binary files, and deviations of
 * common programs. See Readers/PolygonOFF/README.md.
 *
 * Output: a vtkUnstructuredGrid. Points are double for text and float for binary files, in the unit
 * of the file, which the format does not state. Faces keep their order and orientation and become
 * VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON, or, with fewer vertices, VTK_LINE or VTK_VERTEX. A file
 * without faces gives one VTK_VERTEX per point. Normals become the point normals "Normals", texture
 * coordinates "TCoords", colors of vertices or faces unsigned char arrays "RGBA", indices into a
 * color map int arrays "ColorIndex" (-1 for none).
 */
#ifndef camaron_PolygonOFFReading_h
#define camaron_PolygonOFFReading_h

#include "Intake/Pieces/PieceRequest.h"
#include "Intake/Rows/TextLines.h"

#include <string> // for paths

class vtkUnstructuredGrid;

namespace camaron
{
/// Whether the file begins like an OFF file. Reports no errors.
bool IsPolygonOFF(const std::string& path);

/**
 * Reads a piece of a file into @a grid, which is emptied first. The result does not depend on the
 * number of threads.
 * @param chunk bytes of text per task; shorter text than two chunks is read serially
 * @return false with the error in @a error, or without one if aborted; the grid is then empty
 */
bool ReadPolygonOFF(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress = Progress(),
  vtkIdType chunk = TextLines::DefaultChunk);
}

#endif
