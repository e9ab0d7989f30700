// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VisfReading.h
 * @brief Reads Visf mesh files of every known dialect.
 *
 * Visf is the format of the original Camarón: vertices, polygons as lists of vertices, polyhedra as
 * lists of polygons. All dialects are read: ASCII, binary in both byte orders, and the headers of
 * all versions. See Readers/Visf/README.md.
 *
 * Output: a vtkUnstructuredGrid with float coordinates in the unit of the file, which the format
 * does not state. Polyhedra become tetrahedra, pyramids, wedges or hexahedra where they match, else
 * VTK_POLYHEDRON with faces that point outward. Polygons of no polyhedron follow as 2D cells. A
 * file with vertices only gives one VTK_VERTEX each. Lists of faces do not distinguish inside from
 * outside, so every cell with a volume has a positive one.
 *
 * The whole file is read; lists of neighbors are checked and then dropped, as they follow from the
 * polygons.
 */
#ifndef camaron_VisfReading_h
#define camaron_VisfReading_h

#include "Intake/FaceMesh/FaceMesh.h"

#include <string> // for paths

class vtkUnstructuredGrid;

namespace camaron
{
/// Whether the file begins like a Visf file. Reads a few bytes and reports no errors.
bool IsVisf(const std::string& path);

/**
 * Reads a piece of a file into @a grid, which is emptied first; see BuildGrid for the cells. The
 * result does not depend on the number of threads.
 * @param chunk bytes of text per task; shorter text than two chunks is read serially
 * @return false with the error in @a error, or without one if aborted; the grid is then empty
 */
bool ReadVisf(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress = Progress(),
  vtkIdType chunk = TextLines::DefaultChunk);
}

#endif
