// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LinkedPieces.h
 * @brief Finds the cells of other pieces at the facets of each piece of a mesh.
 *
 * Facets of two pieces are the same when they have the same points, see PieceBorders. Each process
 * computes what others need to know of its own cells, so it is the same, to the last bit, as in an
 * undivided mesh. Copies of cells (DUPLICATECELL) take no part.
 *
 * Facets whose points lie within the box of another piece are compared by a hash of 128 bits; every
 * process compares its share of the hashes. Memory, messages and time are proportional to these
 * facets.
 */
#ifndef camaron_LinkedPieces_h
#define camaron_LinkedPieces_h

#include "Cell/CellGeometry.h"
#include "Mesh/FacetLinks.h"
#include "Mesh/MeshTopology.h"
#include "Ranks/Reducer.h"

#include "vtkDataSetAttributes.h" // for kinds of ghosts

#include <vector> // for the pieces

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

/// Collective. Of every piece the cells of others at its facets.
std::vector<PieceLinks> LinkPieces(const std::vector<LinkedPiece>& pieces, Reducer& reducer);
}

#endif
