// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file KernelCells.h
 * @brief Creates the kernels of cells, or of a closed surface, as cells.
 *
 * The kernel of a cell is the set of points from which the whole cell is visible; see CellKernel.
 */
#ifndef camaron_KernelCells_h
#define camaron_KernelCells_h

#include "Cell/CellGeometry.h"

#include <functional> // for progress
#include <vector>     // for polygons

class vtkDataArray;
class vtkDataSet;
class vtkUnstructuredGrid;

namespace camaron
{
/**
 * Fills @a kernels, which must be empty, with the kernels of the 2D and 3D cells of @a mesh,
 * except ghosts and cells without a kernel: VTK_POLYGON and VTK_POLYHEDRON in the order of the
 * cells, each with its own points in double precision. The kernel of a convex cell is the cell
 * itself.
 *
 * Cell arrays: those of the mesh, "SourceCell" (id of the cell, the global one if the mesh has
 * them) and "KernelRatio". Field array "CellsWithoutKernel": ids of the chosen cells without a
 * kernel, because they are not star-shaped, not closed, or without volume or area.
 *
 * Memory: twice that of the result.
 *
 * @param chosen one value per cell, 0 to skip the cell; or nullptr for all cells
 * @param goesOn called about 100 times with the completed fraction; return false to stop
 * @return false if stopped; the grid is empty then
 */
bool MakeKernelCells(vtkDataSet* mesh, const EvaluationOptions& options, vtkDataArray* chosen,
  const std::function<bool(double)>& goesOn, vtkUnstructuredGrid* kernels);

/// Polygons with the coordinates of every vertex.
struct SurfacePolygons
{
  std::vector<vtkIdType> Sizes; ///< number of vertices of every polygon
  std::vector<double> Corners;  ///< x, y, z of all vertices
};

/// The 2D cells of a mesh except ghosts; higher-order cells by their vertices, without strips.
SurfacePolygons TakePolygons(vtkDataSet* mesh);

enum class SurfaceKernel
{
  Found,
  Empty,     ///< no point sees the whole surface
  NotClosed, ///< the polygons do not bound a volume
  NotFinite, ///< a coordinate is NaN or infinite
  Stopped
};

/**
 * Fills @a kernel, which must be empty, with the kernel of the volume enclosed by the polygons:
 * one VTK_POLYHEDRON with the cell array "KernelRatio". Vertices with the same coordinates are
 * merged. The result does not depend on the order of the polygons and their first vertices. Time
 * is O(n log n) for n polygons, and linear for an empty kernel.
 */
SurfaceKernel MakeSurfaceKernel(const SurfacePolygons& polygons, const EvaluationOptions& options,
  const std::function<bool(double)>& goesOn, vtkUnstructuredGrid* kernel);
}

#endif
