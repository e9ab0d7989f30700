// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WedgeOrder.h
 * @brief The order of the nodes of wedges in files and in VTK.
 *
 * Files list a prism as an extrusion: the normal of the triangle (0,1,2), by the right-hand rule,
 * points to the triangle (3,4,5). VTK's linear wedge is inverted in some versions, but its
 * quadratic wedge is not; these functions query VTK.
 */
#ifndef camaron_WedgeOrder_h
#define camaron_WedgeOrder_h

namespace camaron
{
constexpr int MaxWedgeNodes = 15;

/// Whether VTK's order of nodes of a wedge type is that of an extrusion.
bool IsExtrusion(unsigned char wedgeType);

/**
 * Maps the nodes of VTK_WEDGE (6) or VTK_QUADRATIC_WEDGE (15, its edges in VTK's order) to those
 * of an extrusion: vtk[i] = extrusion[order[i]]. The permutation is its own inverse: extrusion[i]
 * = vtk[order[i]].
 */
const int* GetExtrusionOrder(unsigned char wedgeType);
}

#endif
