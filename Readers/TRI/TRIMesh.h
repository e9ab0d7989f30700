// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TRIMesh.h
 * @brief Content of text and binary files of triangles, and its conversion to a grid.
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
  vtkSmartPointer<vtkDataArray> Components; ///< of cells of the piece, or nullptr
  vtkSmartPointer<vtkDataArray> Scalars;    ///< of points of the piece, or nullptr

  /// Moves everything into an empty grid and adds warnings.
  /// @param hasMore whether there is data after the end of the mesh
  void Finish(const PieceRequest& request, bool hasMore, vtkUnstructuredGrid* grid,
    Warnings& warnings, const Progress& progress);
};

/**
 * Number of scalars per vertex, or 0 if the counts do not match @a found numbers. The documentation
 * of Cart3D includes the pressure coefficient in the count, but some programs do not.
 */
std::int64_t FindScalarSize(std::int64_t scalars, std::int64_t vertices, std::int64_t found);
}

#endif
