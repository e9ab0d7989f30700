// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WedgeOrder.h
 * @brief The order of the nodes of wedges in files and in VTK.
 *
 * Files list a prism as an extrusion: the triangle (0,1,2), seen by the right-hand rule, points to
 * the triangle (3,4,5). VTK's linear wedge is the other way round in some versions, and its
 * quadratic wedge is not; VTK is asked which.
 */
#ifndef camaron_WedgeOrder_h
#define camaron_WedgeOrder_h

namespace camaron
{
constexpr int MaxWedgeNodes = 15;

/// Whether VTK's nodes of a type of wedges are in the order of an extrusion.
bool IsExtrusion(unsigned char wedgeType);

/**
 * Where VTK's nodes of a VTK_WEDGE (6) or VTK_QUADRATIC_WEDGE (15, its edges in VTK's order) are in
 * an extrusion: vtk[i] = extrusion[order[i]]. It is its own inverse: extrusion[i] = vtk[order[i]].
 */
const int* GetExtrusionOrder(unsigned char wedgeType);
}

#endif
