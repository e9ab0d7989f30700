// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DuplicateCells.h
 * @brief Cells that occur more than once in a mesh.
 */
#ifndef camaron_DuplicateCells_h
#define camaron_DuplicateCells_h

#include "Mesh/FacetTable.h"
#include "Mesh/MeshView.h"

#include <vector> // for the groups

namespace camaron
{
/**
 * Groups of two or more cells of the same dimension with the same set of point ids; the cells of a
 * group are in ascending order. Runs in parallel and in O(n log n) time for any number of
 * duplicates.
 * @param leastDimension ignore cells of lower dimension
 * @param among only consider these cells; all cells by default
 */
std::vector<std::vector<Index>> FindDuplicateCells(
  const MeshView& mesh, int leastDimension = 2, const std::vector<Index>* among = nullptr);
}

#endif
