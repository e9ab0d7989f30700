// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceTriangles.h
 * @brief Triangulates the polygons of a surface.
 */
#ifndef camaron_SurfaceTriangles_h
#define camaron_SurfaceTriangles_h

class vtkPolyData;

namespace camaron
{
/// Uses PolygonTriangulator. Triangles have the data of their polygon; those with a repeated point,
/// from polygons that visit a point twice, are omitted.
void CutIntoTriangles(vtkPolyData* surface);
}

#endif
