// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FluentMesh.h
 * @brief The piece of the mesh of a Fluent file from which cells are created.
 */
#ifndef camaron_FluentMesh_h
#define camaron_FluentMesh_h

#include "Intake/CellMesh/CellMeshPiece.h"
#include "Intake/Fluent/FluentCells.h"
#include "Intake/Fluent/FluentFaces.h"

#include <map>    // for split faces
#include <vector> // for members

namespace camaron
{
struct FluentMesh
{
  FluentFaces Faces;
  FluentCells Cells;
  CellMeshPiece Piece; ///< its cells are the leaves
  int Dimension = 3;
  std::vector<std::int32_t> Leaves; ///< of the piece, unless it is whole
  /// Positions of faces that were split where neighbors have been refined, by those of their parts.
  std::map<vtkIdType, vtkIdType> SplitFaces;

  /// Index in the piece of the cell with an id of the file; -1 if it is not in the piece.
  vtkIdType FindCell(std::int64_t id) const
  {
    const vtkIdType leaf = this->Cells.FindLeaf(id);
    return leaf >= 0 ? this->Piece.FindCell(leaf) : -1;
  }
  /// The leaf of a cell of the piece.
  vtkIdType GetLeaf(vtkIdType cell) const
  {
    return this->Piece.IsWhole() ? cell : this->Leaves[static_cast<std::size_t>(cell)];
  }
  FluentShape GetShape(vtkIdType cell) const
  {
    return GetFluentShape(this->Cells.GetElement(this->GetLeaf(cell)), this->Dimension);
  }
};
}

#endif
