// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetGenMidpoints.h
 * @brief The order of the midside nodes of quadratic cells.
 *
 * TetGen 1.5 lists those of edges 23 03 01 12 13 02 of a tetrahedron; Triangle and TetGen list
 * those opposite vertices 0 1 2 of a triangle. Other programs may use other orders.
 */
#ifndef camaron_TetGenMidpoints_h
#define camaron_TetGenMidpoints_h

#include "Intake/CellMesh/CellMesh.h"

#include <array> // for orders

namespace camaron
{
/// For each edge in VTK's order, the number of its node among the midside nodes of the file.
using TetGenMidpointOrder = std::array<int, 6>;

/// The order of TetGen and Triangle, for cells with 4 or 3 vertices.
TetGenMidpointOrder GetUsualMidpointOrder(int corners);

/**
 * Finds the order in which every node is nearest to the middle of its edge; the usual one is
 * preferred.
 * @param x nodes of a cell in the order of the file
 * @return false if there is none; the order is then the usual one
 */
bool FindMidpointOrder(int corners, const double (*x)[3], TetGenMidpointOrder& order);

/// Reorders the midside nodes of all cells to VTK's order.
void OrderMidpoints(CellMesh& mesh, int corners, const TetGenMidpointOrder& order);
}

#endif
