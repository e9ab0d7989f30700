// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FluentMesh.h
 * @brief The mesh of a Fluent file from which cells are created.
 */
#ifndef camaron_FluentMesh_h
#define camaron_FluentMesh_h

#include "Intake/Fluent/FluentPiece.h"

#include "vtkCellType.h" // for the types of cells

#include <utility> // for pairs
#include <vector>  // for faces

namespace camaron
{
/// Split faces and their parts, where neighbors have been refined.
struct FluentFaceTree
{
  /// Positions of a part and of the split face.
  struct Entry
  {
    vtkIdType Child, Parent;
  };
  std::vector<Entry> Entries;                           ///< sorted by part
  std::vector<std::pair<vtkIdType, vtkIdType>> Parents; ///< and their numbers of parts, sorted

  /// Sorts Entries.
  void Build();
  vtkIdType FindParent(vtkIdType child) const;
  vtkIdType GetNumberOfParts(vtkIdType parent) const;
};

/// Declared type of a cell; VTK_EMPTY_CELL if unknown.
struct FluentShape
{
  unsigned char Type = VTK_EMPTY_CELL;
  int Nodes = 0; ///< 0 if the type does not determine it
  int Faces = 0;
};

/// The shape of an element other than a polyhedron.
FluentShape GetFluentShape(FluentElement element);

struct FluentMesh
{
  FluentFaces& Faces;
  const FluentCells& Cells;
  const FluentPiece& Piece;
  const FluentFaceTree& Tree;
  int Dimension;

  /// Index in the piece of the cell with an id of the file; -1 if it is not in the piece.
  vtkIdType FindCell(std::int32_t id) const
  {
    const vtkIdType leaf = this->Cells.FindLeaf(id);
    return leaf >= 0 ? this->Piece.FindLeaf(leaf) : -1;
  }
  FluentShape GetShape(vtkIdType cell) const;
};
}

#endif
