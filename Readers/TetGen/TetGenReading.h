// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetGenReading.h
 * @brief Reads TetGen and Triangle files.
 *
 * A mesh consists of several text files with the same name: .node (points), .ele (tetrahedra or
 * triangles), .face (triangles), .edge (line segments), .neigh (neighbors), and .poly or .smesh
 * (facets, holes and regions of the domain). FileName may be any of them; the others are found next
 * to it. See Readers/TetGen/README.md.
 *
 * Output: a vtkUnstructuredGrid with double coordinates in the unit of the files, which the format
 * does not state:
 * - .ele, or .node with an .ele next to it: VTK_TETRA, VTK_TRIANGLE, or their quadratic versions;
 * .neigh adds the cell array "Neighbors";
 * - .node alone: one VTK_VERTEX per point;
 * - .face, .edge: VTK_TRIANGLE, VTK_LINE, or their quadratic versions;
 * - .poly, .smesh: polygons of the facets; segments as VTK_LINE in 2D.
 *
 * Point arrays are "attr_0", "attr_1", ... and "BoundaryMarker"; cell arrays "Region", "attr_1",
 * ..., "BoundaryMarker", "Tetrahedra" and "Facet". Ids that do not count from 0 become
 * "OriginalPointId" and "OriginalCellId". Field arrays are "Holes", "Regions", "FacetHoles" and
 * "FacetOfHole".
 */
#ifndef camaron_TetGenReading_h
#define camaron_TetGenReading_h

#include "Intake/Pieces/PieceRequest.h"
#include "Intake/Rows/TextLines.h"

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
