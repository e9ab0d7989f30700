// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonPLYReading.h
 * @brief Reads PLY files with all their properties.
 *
 * A PLY file (polygon file format, Stanford) declares elements and their properties in a header;
 * their values follow as text, or as binary in either byte order. See
 * Readers/PolygonPLY/README.md.
 *
 * Output: a vtkUnstructuredGrid. Coordinates are float, or double if the file has double or 32-bit
 * integers, in the unit of the file, which the format does not state. Faces become VTK_TRIANGLE,
 * VTK_QUAD or VTK_POLYGON, strips VTK_TRIANGLE, edges VTK_LINE; a file with vertices only gives one
 * VTK_VERTEX each. Cells given by faces become tetrahedra, pyramids, wedges or hexahedra if they
 * match, else VTK_POLYHEDRON. Normals, texture coordinates, and colors ("RGB", "RGBA") become
 * arrays with several components, every other property an array of its name and type.
 *
 * Lists other than those of vertices and faces become arrays if their lengths are similar; others
 * are left out with a warning.
 */
#ifndef camaron_PolygonPLYReading_h
#define camaron_PolygonPLYReading_h

#include "Intake/Pieces/PieceRequest.h"
#include "Intake/Rows/TextLines.h"

#include <string> // for paths

class vtkUnstructuredGrid;

namespace camaron
{
/// Whether the file begins like a PLY file. Reads a few bytes and reports no errors.
bool IsPolygonPLY(const std::string& path);

/**
 * Reads a piece of a file into @a grid, which is emptied first. The result does not depend on the
 * number of threads.
 * @param chunk bytes of text per task; shorter text than two chunks is read serially
 * @return false with the error in @a error, or without one if aborted; the grid is then empty
 */
bool ReadPolygonPLY(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress = Progress(),
  vtkIdType chunk = TextLines::DefaultChunk);
}

#endif
