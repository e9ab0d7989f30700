// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellRegions.h
 * @brief Connected components of a mesh, and of the cells around every point.
 */
#ifndef camaron_CellRegions_h
#define camaron_CellRegions_h

#include "Mesh/MeshTopology.h"

#include <vector> // for the tables

namespace camaron
{
/**
 * For every cell, the index of its region. A region is a set of 2D or 3D cells connected over
 * facets. Regions are numbered from 0 in the order of their first cells; other cells have -1.
 */
std::vector<Index> FindCellRegions(const MeshTopology& topology);

/**
 * For every point, the number of groups of cells around it that are connected over facets with
 * that point; more than 1 where the mesh is pinched. Takes the larger number of the 2D and the 3D
 * cells, because a solid may include its boundary as 2D cells. 0 for points that are vertices of
 * neither.
 */
std::vector<Index> CountPointRegions(const MeshTopology& topology);
}

#endif
