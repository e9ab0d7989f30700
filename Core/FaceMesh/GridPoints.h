// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GridPoints.h
 * @brief Sets the points of a grid, and the global ids of points and cells of a piece.
 */
#ifndef camaron_GridPoints_h
#define camaron_GridPoints_h

#include "FaceMesh/FaceMeshPiece.h"

class vtkUnstructuredGrid;

namespace camaron
{
/// Sets the points of @a grid; afterwards, @a mesh uses those of the grid. False if they cannot be
/// read any more, or if stopped.
bool TakePoints(
  FaceMesh& mesh, const FaceMeshPiece& piece, vtkUnstructuredGrid* grid, const Progress& progress);

/// Adds global ids and ghost arrays to a piece of a mesh.
void AddPieceIds(
  const FaceMeshPiece& piece, const PieceRequest& request, vtkUnstructuredGrid* grid);
}

#endif
