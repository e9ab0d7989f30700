// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointSetHulls.h
 * @brief Adds faces to convex point sets.
 */
#ifndef camaron_PointSetHulls_h
#define camaron_PointSetHulls_h

#include "vtkSmartPointer.h" // for the result

class vtkUnstructuredGrid;

namespace camaron
{
/**
 * Returns the grid itself, or if it has cells of type VTK_CONVEX_POINT_SET, a grid where these
 * cells list the faces of their convex hull (ConvexHull) and have the given type: the same or
 * VTK_POLYHEDRON. A cell with nonfinite coordinates has no hull; it stays a VTK_CONVEX_POINT_SET
 * with one face of all its points.
 */
vtkSmartPointer<vtkUnstructuredGrid> WithHulls(vtkUnstructuredGrid* grid, int type);
}

#endif
