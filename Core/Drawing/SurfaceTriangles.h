// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceTriangles.h
 * @brief Cuts the polygons of a surface into triangles.
 */
#ifndef camaron_SurfaceTriangles_h
#define camaron_SurfaceTriangles_h

class vtkPolyData;

namespace camaron
{
/// As PolygonTriangulator cuts them. Triangles have the data of their polygon; those that come to a
/// point twice, as polygons do that come to a corner again, are left out.
void CutIntoTriangles(vtkPolyData* surface);
}

#endif
