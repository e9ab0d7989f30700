// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceShape.h
 * @brief How far a face of a cell is from a flat, convex polygon.
 *
 * Of cells with NeedsFaces, and NeedsCorners for the concavity. A face needs an area.
 */
#ifndef camaron_FaceShape_h
#define camaron_FaceShape_h

#include "Cell/CellGeometry.h"

namespace camaron
{
/// Length of the vector area divided by the area of the fan about the centre, at most 1.
double GetFaceFlatness(const CellGeometry& cell, int face);
/// Largest distance of a point from the plane of the face, divided by the largest one from its centre.
double GetFaceWarpage(const CellGeometry& cell, int face);
/// By how much the largest angle exceeds 180 degrees, in radian; null if no angle is defined.
double GetFaceConcavity(const CellGeometry& cell, int face);
}

#endif
