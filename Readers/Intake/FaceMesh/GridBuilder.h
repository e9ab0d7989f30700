// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GridBuilder.h
 * @brief Creates a vtkUnstructuredGrid from a mesh given by its faces.
 */
#ifndef camaron_GridBuilder_h
#define camaron_GridBuilder_h

#include "Intake/FaceMesh/FaceMesh.h"

class vtkUnstructuredGrid;

namespace camaron
{
/**
 * Fills @a grid, which must be empty, with a piece of @a mesh. Its points have the precision of
 * the source.
 *
 * If a mesh has sides, they define the orientation of cells; without coordinates, its
 * points are left to the caller, and it must be requested as a whole. Cells become the declared
 * type if their faces match it, else VTK_POLYHEDRON; 2D cells become VTK_TRIANGLE, VTK_QUAD and
 * VTK_POLYGON, or VTK_EMPTY_CELL if their edges form no closed ring.
 *
 * Cells of other meshes become VTK_TETRA, VTK_PYRAMID, VTK_WEDGE or VTK_HEXAHEDRON if
 * PrimitiveMatcher recognizes them, VTK_EMPTY_CELL if they have no faces, else VTK_POLYHEDRON with
 * faces oriented by CellShell. If a cell cannot be oriented, its faces alternate: unchanged if it
 * is the first cell of the face, reversed if it is the second, and so on. Faces without a cell
 * follow as VTK_TRIANGLE, VTK_QUAD or VTK_POLYGON (VTK_LINE and VTK_VERTEX for fewer points;
 * omitted without points). Without faces and cells, every point becomes a VTK_VERTEX.
 *
 * Arrays are exactly sized, with 32-bit indices if these suffice. For meshes with polyhedra, the
 * faces are passed to MeshTopology. Points of a piece have "GlobalPointIds" and cells
 * "GlobalCellIds", which are positions in the whole mesh, and "vtkGhostType" if ghosts were
 * requested.
 *
 * The grid does not depend on the number of threads, and the pieces of a mesh add up to the whole.
 *
 * The contents of @a mesh are consumed.
 *
 * @return false with the error in @a error, which does not name the file, or without one if
 * stopped; the grid is empty then
 */
bool BuildGrid(FaceMesh& mesh, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress);
}

#endif
