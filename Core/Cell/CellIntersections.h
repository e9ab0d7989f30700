// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellIntersections.h
 * @brief Whether a cell cuts through itself.
 */
#ifndef camaron_CellIntersections_h
#define camaron_CellIntersections_h

namespace camaron
{
class CellGeometry;

/// Whether two edges of a face meet that are not next to each other.
bool HasIntersectingEdges(const CellGeometry& cell);
/**
 * Whether a face goes through another one: whether an edge, or a line from a corner into the face, goes through a face of which
 * its ends are no points, or touches it. A face that is star-shaped about its center is the triangles about that one, any other
 * those of PolygonTriangulator. Of an open cell an end that lies on an edge of the face does not count, nor a point of the
 * face that lies on the edge. With NeedsEdges, NeedsFaces and NeedsVolume.
 */
bool HasIntersectingFaces(const CellGeometry& cell);
}

#endif
