// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DuplicateCells.h
 * @brief Cells that are in a mesh more than once.
 */
#ifndef camaron_DuplicateCells_h
#define camaron_DuplicateCells_h

#include "Mesh/FacetTable.h"
#include "Mesh/MeshView.h"

#include <vector> // for the groups

namespace camaron
{
/**
 * Groups of two or more cells of the same dimension that have the same set of point ids; each
 * ascending. Finds them in parallel, in n log(n) time however many cells are alike.
 * @param leastDimension of the cells that are looked at
 * @param among only these cells; all if none are given
 */
std::vector<std::vector<Index>> FindDuplicateCells(
  const MeshView& mesh, int leastDimension = 2, const std::vector<Index>* among = nullptr);
}

#endif
