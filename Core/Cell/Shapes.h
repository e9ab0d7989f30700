// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Shapes.h
 * @brief Shapes of cells: recognizes tetrahedra, pyramids, wedges and hexahedra by their topology,
 * and orders their nodes.
 */
#ifndef camaron_Shapes_h
#define camaron_Shapes_h

#include "Mesh/CellTopology.h"

namespace camaron
{
/// What a cell may be, as bits: what a criterion is defined for; every other cell gets null.
enum Shapes : unsigned
{
  Polygons = 1u,
  Polyhedra = 2u,
  PolygonsAndPolyhedra = Polygons | Polyhedra,
  Triangles = 4u,
  Tetrahedra = 8u,
  AnyCell = 16u,
  Quadrilaterals = 32u,
  Pyramids = 64u,
  Wedges = 128u,
  Hexahedra = 256u,
  SimplePolygons = Triangles | Quadrilaterals,
  SimplePolyhedra = Tetrahedra | Pyramids | Wedges | Hexahedra,
  NoShapes = 0u
};

/// One of Tetrahedra, Pyramids, Wedges and Hexahedra, or 0; whatever the directions of the faces.
unsigned FindSimpleShape(const CellTopology& topology);

constexpr int MaxSimpleNodes = 8;

/**
 * Points of a cell of a simple shape in the order of textbooks: a base whose normal points into the
 * cell, then the apex, or the other ends of the edges from the base. The faces must run outward.
 * @return how many there are
 */
int GetSimpleNodes(const CellTopology& topology, unsigned shape, int nodes[MaxSimpleNodes]);
}

#endif
