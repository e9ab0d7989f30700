// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellGrid.h
 * @brief Creates a vtkUnstructuredGrid from a mesh given by its cells.
 */
#ifndef camaron_CellGrid_h
#define camaron_CellGrid_h

#include "Intake/CellMesh/CellMeshPiece.h"

class vtkDataArray;
class vtkUnstructuredGrid;

namespace camaron
{
/**
 * Fills @a grid, which must be empty, with @a mesh, which contains the cells of a piece, and takes
 * over its arrays. A piece that is not the whole mesh gets "GlobalPointIds" and "GlobalCellIds",
 * which are positions in the whole mesh, and "vtkGhostType" if ghosts were requested.
 * @param points coordinates of the points of the piece, in its order
 */
void FillGrid(
  CellMesh& mesh, const CellMeshPiece& piece, vtkDataArray* points, vtkUnstructuredGrid* grid);

/// Adds these arrays of a piece, unless it is the whole mesh.
void AddPieceIds(const CellMeshPiece& piece, vtkUnstructuredGrid* grid);
}

#endif
