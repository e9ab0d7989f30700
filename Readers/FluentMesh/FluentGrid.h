// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FluentGrid.h
 * @brief Makes cells of VTK of the faces of a Fluent file.
 */
#ifndef camaron_FluentGrid_h
#define camaron_FluentGrid_h

#include "FluentCellFaces.h"

class vtkUnstructuredGrid;

namespace camaron
{
/**
 * Sets the cells of @a grid to those of a piece.
 *
 * Faces say which cell is on which of their sides, so cells are oriented by them: an inverted cell
 * stays inverted. Cells of a declared type become that of VTK. If they have more faces, because
 * neighbors were refined, split faces are put together again; if that does not help, they are
 * polyhedra (polygons). Cells declared as polyhedra are such whatever they look like; cells of
 * unknown type are recognized. Cells without faces, and 2D cells whose edges make no ring, are
 * VTK_EMPTY_CELL.
 *
 * The faces of meshes with polyhedra are handed over to MeshTopology. The grid does not depend on
 * the number of threads.
 *
 * @return false with the error in @a error, or without one if stopped
 */
bool BuildFluentCells(const FluentMesh& mesh, vtkUnstructuredGrid* grid, Warnings& warnings,
  ScanError& error, const Progress& progress);
}

#endif
