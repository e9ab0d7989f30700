// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurvedEdges.h
 * @brief Lengths of the edges of cells of higher order.
 */
#ifndef camaron_CurvedEdges_h
#define camaron_CurvedEdges_h

#include "Mesh/MeshTopology.h"

namespace camaron
{
/// Whether there may be edges that are not straight.
bool MayHaveCurvedEdges(const MeshView& mesh);

/// Replaces the lengths of edges that are not straight, as the first cell that has them maps them.
/// They are the same in every piece of a mesh.
void MeasureCurvedEdges(const MeshView& mesh, const EdgeFinder& finder, double* lengths);
}

#endif
