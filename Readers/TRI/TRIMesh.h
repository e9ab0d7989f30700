// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TRIMesh.h
 * @brief What text and binary files of triangles hold, and the grid that it becomes.
 */
#ifndef camaron_TRIMesh_h
#define camaron_TRIMesh_h

#include "CellMesh/CellMeshPiece.h"

#include "vtkDataArray.h"    // for arrays
#include "vtkSmartPointer.h" // for arrays

class vtkUnstructuredGrid;

namespace camaron
{
struct TRIMesh
{
  CellMesh Cells;
  CellMeshPiece Piece;
  vtkSmartPointer<vtkDataArray> Points;     ///< of the piece
  vtkSmartPointer<vtkDataArray> Components; ///< of cells of the piece, or none
  vtkSmartPointer<vtkDataArray> Scalars;    ///< of points of the piece, or none

  /// Moves everything into an empty grid, and warns of what is odd, @a hasMore data after the end
  /// included.
  void Finish(const PieceRequest& request, bool hasMore, vtkUnstructuredGrid* grid,
    Warnings& warnings, const Progress& progress);
};

/**
 * How many scalars each vertex has, 0 if @a found numbers are none that the counts allow: the
 * documentation of Cart3D counts the pressure coefficient among them, but some programs do not.
 */
std::int64_t FindScalarSize(std::int64_t scalars, std::int64_t vertices, std::int64_t found);
}

#endif
