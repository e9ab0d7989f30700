// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GridBuilder.h
 * @brief Makes a vtkUnstructuredGrid of a mesh given by its faces.
 */
#ifndef camaron_GridBuilder_h
#define camaron_GridBuilder_h

#include "FaceMesh/FaceMesh.h"

class vtkUnstructuredGrid;

namespace camaron
{
/**
 * Fills @a grid, which must be empty, with a piece of @a mesh. Its points have the precision of the
 * source.
 *
 * Cells become VTK_TETRA, VTK_PYRAMID, VTK_WEDGE or VTK_HEXAHEDRON where PrimitiveMatcher
 * recognizes them, VTK_EMPTY_CELL where they have no faces, else VTK_POLYHEDRON with faces turned
 * as CellShell does. Cells that it cannot turn take a face as it is if they are the first to have
 * it, reversed if they are the second, and so on. Faces that no cell has follow as VTK_TRIANGLE,
 * VTK_QUAD or VTK_POLYGON (VTK_LINE and VTK_VERTEX for fewer points; none for no points). Without
 * faces and cells every point becomes a VTK_VERTEX.
 *
 * Arrays are exactly sized, with 32 bit indices where these suffice. For meshes with polyhedra the
 * faces are handed over to MeshTopology. Points of a piece of a mesh have "GlobalPointIds" and
 * cells "GlobalCellIds", positions in the whole mesh, and "vtkGhostType" if ghosts were asked for.
 *
 * The grid does not depend on the number of threads, and the pieces of a mesh make up the whole.
 *
 * The mesh is used up: nothing is left of it in the end.
 *
 * @return false with the error in @a error, or without one if stopped; the grid is empty then.
 */
bool BuildGrid(FaceMesh& mesh, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress);
}

#endif
