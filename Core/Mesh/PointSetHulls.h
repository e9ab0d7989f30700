// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointSetHulls.h
 * @brief Gives convex point sets faces.
 */
#ifndef camaron_PointSetHulls_h
#define camaron_PointSetHulls_h

#include "vtkSmartPointer.h" // for the result

class vtkUnstructuredGrid;

namespace camaron
{
/**
 * The grid itself, or if it has cells of type VTK_CONVEX_POINT_SET one in which these list the
 * faces of their hull (ConvexHull) and are of the given type: the same, or VTK_POLYHEDRON. One with
 * coordinates that are not finite has no hull, but as VTK_CONVEX_POINT_SET a face of all its
 * points.
 */
vtkSmartPointer<vtkUnstructuredGrid> WithHulls(vtkUnstructuredGrid* grid, int type);
}

#endif
