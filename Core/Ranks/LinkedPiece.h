// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LinkedPiece.h
 * @brief A data set of this process, as a part of a mesh that others have parts of, too.
 *
 * Pieces are what the processes have of a mesh, partitions of one process, and blocks if they are to be connected.
 */
#ifndef camaron_LinkedPiece_h
#define camaron_LinkedPiece_h

#include "Cell/CellGeometry.h"
#include "Mesh/MeshTopology.h"

#include "vtkDataSetAttributes.h" // for kinds of ghosts

class vtkDataSet;

namespace camaron
{
struct LinkedPiece
{
  const MeshTopology* Topology = nullptr;
  EvaluationOptions Options;
  int Block = 0;                       ///< pieces of one block, in all processes, are linked
  int Order = 0;                       ///< cells of a block are counted by this, then by process
  const vtkIdType* PointIds = nullptr; ///< global ids, or none
  const vtkIdType* CellIds = nullptr;  ///< global ids, or none
  vtkDataSet* Data = nullptr;          ///< what Topology is of, or none where it is not asked for

  /// Whether a cell is a copy of one that belongs to another piece.
  bool IsCopy(vtkIdType cell) const { return this->Options.IsCopy(cell); }
};
}

#endif
