// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TRIMesh.h
 * @brief Content of text and binary files of triangles, and its conversion to a grid.
 */
#ifndef camaron_TRIMesh_h
#define camaron_TRIMesh_h

#include "Intake/CellMesh/CellMeshPiece.h"
#include "Scan/MappedFile.h"

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

///@{
/// Binary files of Cart3D, which consist of unformatted Fortran records: whether a file begins with
/// a record of two or three counts, and reading a piece; false with the error in @a error, or
/// without one if aborted.
bool IsBinaryTRI(const MappedFile& file);
bool ReadBinaryTRI(const MappedFile& file, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress);
///@}
}

#endif
