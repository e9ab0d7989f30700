// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GridPoints.h
 * @brief The points of a grid, and where points and cells of a piece are in the whole mesh.
 */
#ifndef camaron_GridPoints_h
#define camaron_GridPoints_h

#include "FaceMesh/FaceMeshPiece.h"

class vtkUnstructuredGrid;

namespace camaron
{
/// Sets the points of @a grid; from then on @a mesh has those of the grid. False if they cannot be
/// read any more, or if stopped.
bool TakePoints(
  FaceMesh& mesh, const FaceMeshPiece& piece, vtkUnstructuredGrid* grid, const Progress& progress);

/// Adds global ids to a piece of a mesh, and which points and cells are ghosts.
void AddPieceIds(
  const FaceMeshPiece& piece, const PieceRequest& request, vtkUnstructuredGrid* grid);
}

#endif
