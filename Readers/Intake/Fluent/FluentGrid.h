// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FluentGrid.h
 * @brief Creates VTK cells from the faces of a Fluent file.
 */
#ifndef camaron_FluentGrid_h
#define camaron_FluentGrid_h

#include "Intake/Fluent/FluentInteriorZones.h"
#include "Intake/Fluent/FluentMesh.h"

class vtkUnstructuredGrid;

namespace camaron
{
/**
 * Sets the cells of @a grid to those of a piece.
 *
 * Faces declare the cell on each side, which determines the orientation of cells: an inverted cell
 * remains inverted. Cells of a declared type become that of VTK, with split faces instead of their
 * parts where neighbors were refined; if they have other faces, they become polyhedra (polygons).
 * Cells declared as polyhedra remain so, whatever their shape; cells of unknown type are
 * recognized. Cells without faces, and 2D cells whose edges do not form a closed ring, become
 * VTK_EMPTY_CELL.
 *
 * The faces of meshes with polyhedra are passed on to MeshTopology. The grid does not depend on the
 * number of threads.
 *
 * @param isFirstPiece whether this one warns about faces of the whole mesh
 * @return false with the error in @a error, or without one if aborted
 */
bool BuildFluentCells(FluentMesh& mesh, bool isFirstPiece, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress);

/**
 * Creates the same cells without storing faces, if all are of declared types other than polyhedra,
 * and adds the faces to @a zones if these are several.
 * @return false, with @a grid unchanged, for other cells, if faces do not match the declared type
 * of their cell or are oriented inconsistently, if the file is invalid, or if aborted
 */
bool StreamFluentStandardCells(const FluentMesh& mesh, FluentInteriorZones& zones,
  vtkUnstructuredGrid* grid, const Progress& progress);
}

#endif
