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
/// Shapes that a criterion is defined for, as bits; it is undefined (NaN) for all other cells.
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

/// One of Tetrahedra, Pyramids, Wedges and Hexahedra, or 0. The orientation of the faces does not
/// matter.
unsigned FindSimpleShape(const CellTopology& topology);

constexpr int MaxSimpleNodes = 8;

/**
 * Points of a cell of a simple shape in the usual order: a base whose normal points into the cell,
 * then the apex or the opposite ends of the edges from the base. The faces must be oriented
 * outward.
 * @return the number of points
 */
int GetSimpleNodes(const CellTopology& topology, unsigned shape, int nodes[MaxSimpleNodes]);

/// Parts of CellGeometry, or of the whole mesh, that a criterion reads.
enum Needs : unsigned
{
  NeedsPoints = 0u,
  NeedsEdges = 1u,   ///< distinct edges and their lengths
  NeedsFaces = 2u,   ///< vector areas, areas, centers
  NeedsVolume = 4u,  ///< orientation and volume of a polyhedron
  NeedsCorners = 8u, ///< interior angles of the faces
  NeedsDihedral = 16u,
  NeedsSolidAngle = 32u,
  NeedsAngles = NeedsCorners | NeedsDihedral | NeedsSolidAngle, ///< any angles
  NeedsCentroid = 64u,       ///< requires NeedsVolume for a polyhedron
  NeedsMeanSizes = 128u,     ///< mean sizes of all cells of the mesh
  NeedsSurfaceSides = 256u,  ///< which side of a closed surface is outside
  NeedsRegions = 512u,       ///< connected components of the mesh
  NeedsPointRegions = 1024u, ///< connected groups of cells at points
  NeedsStarShape = 2048u     ///< CellStatus reports cells that are not star-shaped as well
};
}

#endif
