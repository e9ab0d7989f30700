// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Needs.h
 * @brief Declares what a criterion reads, so that nothing else is computed.
 */
#ifndef camaron_Needs_h
#define camaron_Needs_h

namespace camaron
{
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
