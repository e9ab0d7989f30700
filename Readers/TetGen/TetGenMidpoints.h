// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetGenMidpoints.h
 * @brief The order of the nodes on edges of cells of second order.
 *
 * TetGen 1.5 lists those of edges 23 03 01 12 13 02 of a tetrahedron, Triangle and TetGen those
 * opposite of corners 0 1 2 of a triangle. Other programs may have other orders.
 */
#ifndef camaron_TetGenMidpoints_h
#define camaron_TetGenMidpoints_h

#include "CellMesh/CellMesh.h"

#include <array> // for orders

namespace camaron
{
/// For each edge in VTK's order, which node of the file, counted from the first after the corners.
using TetGenMidpointOrder = std::array<int, 6>;

/// The order of TetGen and Triangle, for 4 or 3 corners.
TetGenMidpointOrder GetUsualMidpointOrder(int corners);

/**
 * Finds the order in which every node lies nearest to the middle of its edge, preferring the usual
 * one.
 * @param x nodes of a cell in the order of the file
 * @return false if there is none; the order is the usual one then
 */
bool FindMidpointOrder(int corners, const double (*x)[3], TetGenMidpointOrder& order);

/// Puts the nodes of all cells into VTK's order.
void OrderMidpoints(CellMesh& mesh, int corners, const TetGenMidpointOrder& order);
}

#endif
