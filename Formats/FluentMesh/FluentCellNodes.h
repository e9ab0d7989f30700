// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FluentCellNodes.h
 * @brief Nodes of cells of standard types, found face by face.
 *
 * Each function adds a face to what is known of a cell: its nodes, of which there is room for as
 * many as the type has, and a state, which is 0 before the first face. All take ids of nodes other
 * than 0. They are false if the faces are not those of such a cell, or do not run as neighbours do.
 */
#ifndef camaron_FluentCellNodes_h
#define camaron_FluentCellNodes_h

#include <cstdint> // for ids

namespace camaron
{
using FluentCellState = unsigned char;
/// The state of a cell that has all its faces; its nodes are in VTK's order.
constexpr FluentCellState FluentCellComplete = 0xff;

/// Adds an edge, which has the cell on its left, to one of @a size edges, 3 or 4. The first is that
/// from node 0 to node 1.
bool AddToRing(
  std::int32_t* nodes, int size, FluentCellState& state, std::int32_t from, std::int32_t to);
/// Adds a face whose normal points inside.
bool AddToTetrahedron(std::int32_t* nodes, FluentCellState& state, const std::int32_t* face);
/// Adds a face whose normal points inside. The first is the bottom.
bool AddToHexahedron(std::int32_t* nodes, FluentCellState& state, const std::int32_t* face);
}

#endif
