// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellDefects.h
 * @brief Defects of a cell, as bits of CellStatus, and their detection.
 *
 * The bits up to 0x100 are those of VTK's Validate Cells (VTK 9.6).
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
  NoncontiguousEdges = 0x8,
  Nonconvex = 0x10,
  FacesAreOrientedIncorrectly = 0x20,
  NonPlanarFaces = 0x40,
  DegenerateFaces = 0x80,
  CoincidentPoints = 0x100,
  NotWatertight = 0x1000,
  NonManifoldEdge = 0x2000,
  NonManifoldVertex = 0x4000, // the faces at a point do not form one ring
  InvertedOrZeroVolume = 0x8000,
  ZeroLengthEdge = 0x10000,
  NotStarShaped = 0x20000,
  NonFinitePoint = 0x40000,
  OpenCell = 0x80000,
  FoldedMap = 0x100000,
  ZeroJacobian = 0x200000
};

/// A bit of CellStatus.
struct CellDefect
{
  unsigned Bit;
  const char* Name;        ///< such as "OpenCell"
  const char* Description; ///< as in the description of the criterion CellStatus
  bool IsInvalid;          ///< makes a cell unusable for any purpose, so IsValid is 0
};

/// All bits in ascending order. Warped faces are usable, and inward faces can be reversed.
#define CAMARON_DEFECT(bit, ...) { bit, #bit, __VA_ARGS__ }
constexpr CellDefect CellDefects[] = {
  CAMARON_DEFECT(WrongNumberOfPoints, "too few points", true),
  CAMARON_DEFECT(IntersectingEdges, "intersecting edges", true),
  CAMARON_DEFECT(IntersectingFaces, "intersecting faces", true),
  CAMARON_DEFECT(NoncontiguousEdges, "face with a repeated point", true),
  CAMARON_DEFECT(Nonconvex, "not convex", false),
  CAMARON_DEFECT(FacesAreOrientedIncorrectly, "faces not oriented outward", false),
  CAMARON_DEFECT(NonPlanarFaces, "nonplanar faces", false),
  CAMARON_DEFECT(DegenerateFaces, "degenerate faces", true),
  CAMARON_DEFECT(CoincidentPoints, "coincident points", true),
  CAMARON_DEFECT(NotWatertight, "open edge or no face", true),
  CAMARON_DEFECT(NonManifoldEdge, "edge with more than two faces", true),
  CAMARON_DEFECT(NonManifoldVertex, "pinched vertex", true),
  CAMARON_DEFECT(InvertedOrZeroVolume, "inverted or zero volume", true),
  CAMARON_DEFECT(ZeroLengthEdge, "zero-length edge", true),
  CAMARON_DEFECT(NotStarShaped, "not star-shaped", false),
  CAMARON_DEFECT(NonFinitePoint, "nonfinite coordinates", true),
  CAMARON_DEFECT(OpenCell, "face vectors that do not cancel", true),
  CAMARON_DEFECT(FoldedMap, "folded", true),
  CAMARON_DEFECT(ZeroJacobian, "zero Jacobian determinant", false),
};
#undef CAMARON_DEFECT

/// Whether two non-adjacent edges of a face intersect.
bool HasIntersectingEdges(const CellGeometry& cell);
/**
 * Whether faces intersect: an edge, or a line from a vertex into its face, touches or crosses
 * another face that does not contain its end points. A face that is star-shaped about its center
 * is represented by the triangles about its center, any other face by those of
 * PolygonTriangulator. In an open cell, ends of lines on an edge of the face are ignored, and so
 * are points of the face on the line. Requires NeedsEdges, NeedsFaces and NeedsVolume.
 */
bool HasIntersectingFaces(const CellGeometry& cell);

/// Whether the faces at any point form more than one group connected over edges at that point.
/// Requires FindEdges.
bool HasPinchedPoints(const CellTopology& topology);

/// Magnitude of the vector area divided by the area of the triangles about the center, at most 1.
double GetFaceFlatness(const CellGeometry& cell, int face);
/// Maximum distance of a point from the mean plane of the face, divided by the maximum distance
/// from its center.
double GetFaceWarpage(const CellGeometry& cell, int face);
/// How far the maximum interior angle exceeds 180 degrees, in radians; NaN if no angle is defined.
double GetFaceConcavity(const CellGeometry& cell, int face);
}

#endif
