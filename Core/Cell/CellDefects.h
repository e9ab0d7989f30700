// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellDefects.h
 * @brief What may be wrong with a cell, and how it is found.
 */
#ifndef camaron_CellDefects_h
#define camaron_CellDefects_h

#include "Cell/CellGeometry.h"

namespace camaron
{
enum CellStatusBits : unsigned
{
  WrongNumberOfPoints = 0x1,
  IntersectingEdges = 0x2,
  IntersectingFaces = 0x4,
  NoncontiguousEdges = 0x8, ///< a face that comes to a point twice
  Nonconvex = 0x10,
  FacesAreOrientedIncorrectly = 0x20,
  NonPlanarFaces = 0x40,
  DegenerateFaces = 0x80,
  CoincidentPoints = 0x100,
  NotWatertight = 0x1000,     ///< an edge of one face
  NonManifoldEdge = 0x2000,   ///< an edge of more than two faces
  NonManifoldVertex = 0x4000, ///< faces around a point that do not form one ring
  InvertedOrZeroVolume = 0x8000,
  ZeroLengthEdge = 0x10000,
  NotStarShaped = 0x20000,
  NonFinitePoint = 0x40000,
  OpenCell = 0x80000 ///< face vectors that do not add up to zero
};

class CellGeometry;

/// Whether two edges of a face meet that are not next to each other.
bool HasIntersectingEdges(const CellGeometry& cell);
/**
 * Whether a face goes through another one: whether an edge, or a line from a corner into the face,
 * goes through a face of which its ends are no points, or touches it. A face that is star-shaped
 * about its center is the triangles about that one, any other those of PolygonTriangulator. Of an
 * open cell an end that lies on an edge of the face does not count, nor a point of the face that
 * lies on the edge. With NeedsEdges, NeedsFaces and NeedsVolume.
 */
bool HasIntersectingFaces(const CellGeometry& cell);

class CellTopology;

/// Whether the faces at some point are more than one group that hangs together over edges at that
/// point. After FindEdges.
bool HasPinchedPoints(const CellTopology& topology);

/// Length of the vector area divided by the area of the fan about the center, at most 1.
double GetFaceFlatness(const CellGeometry& cell, int face);
/// Largest distance of a point from the plane of the face, divided by the largest one from its
/// center.
double GetFaceWarpage(const CellGeometry& cell, int face);
/// By how much the largest angle exceeds 180 degrees, in radian; null if no angle is defined.
double GetFaceConcavity(const CellGeometry& cell, int face);
}

#endif
