// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkMeshes.h
 * @brief Large meshes for benchmarks, made in memory.
 */
#ifndef camaron_BenchmarkMeshes_h
#define camaron_BenchmarkMeshes_h

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

namespace camaron
{
/// A ball of about @a numberOfCells jittered tetrahedra, six to a cube, with shuffled cells and
/// points.
vtkSmartPointer<vtkUnstructuredGrid> MakeTetrahedra(vtkIdType numberOfCells);
/// A jittered sheet of about @a numberOfCells triangles, or of as many polygons of three and four
/// points, with shuffled cells.
vtkSmartPointer<vtkUnstructuredGrid> MakeSurface(vtkIdType numberOfCells, bool isMixed = false);
/// A block of about @a numberOfCells truncated octahedra, the Voronoi cells of a body-centered
/// lattice (14 faces, 24 points), with jittered points, as VTK_POLYHEDRON.
vtkSmartPointer<vtkUnstructuredGrid> MakeTruncatedOctahedra(vtkIdType numberOfCells);
}

#endif
