// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file KernelCells.h
 * @brief The kernels of the cells of a mesh, or of a closed surface, as cells.
 *
 * The kernel of a cell is the set of points that see all of it; see CellKernel.
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
 * Fills @a kernels, which must be empty, with the kernels of the 2D and 3D cells of @a mesh that
 * have one and are no ghosts: VTK_POLYGON and VTK_POLYHEDRON, in the order of the cells, each with
 * points of its own, in double precision. The kernel of a convex cell is that cell.
 *
 * Cell arrays: those of the mesh, "SourceCell" (id of the cell, the global one if the mesh has
 * them) and "KernelRatio". Field array "CellsWithoutKernel": ids in the same sense of the cells
 * that were asked for and have none: cells that are not star-shaped, not closed, or without volume
 * or area.
 *
 * Memory: the result twice.
 *
 * @param chosen one value per cell, with 0 for those to leave out; or nullptr for all
 * @param goesOn called about 100 times with the fraction done; false stops
 * @return false when stopped; the grid is empty then
 */
bool MakeKernelCells(vtkDataSet* mesh, const EvaluationOptions& options, vtkDataArray* chosen,
  const std::function<bool(double)>& goesOn, vtkUnstructuredGrid* kernels);

/// Polygons, every corner with its coordinates.
struct SurfacePolygons
{
  std::vector<vtkIdType> Sizes; ///< corners of every polygon
  std::vector<double> Corners;  ///< x, y, z of one after the other
};

/// The 2D cells of a mesh but for ghosts; higher-order ones by their corners, no strips.
SurfacePolygons TakePolygons(vtkDataSet* mesh);

enum class SurfaceKernel
{
  Found,
  Empty,     ///< no point sees all of the surface
  NotClosed, ///< the polygons do not bound a volume
  NotFinite, ///< a coordinate is NaN or infinite
  Stopped
};

/**
 * Fills @a kernel, which must be empty, with the kernel of what the polygons enclose: one
 * VTK_POLYHEDRON with the cell array "KernelRatio". Corners with the same coordinates are one. The
 * result does not depend on the order of the polygons nor on where they start. The time is n log n
 * for n polygons; with an empty kernel it is linear.
 */
SurfaceKernel MakeSurfaceKernel(const SurfacePolygons& polygons, const EvaluationOptions& options,
  const std::function<bool(double)>& goesOn, vtkUnstructuredGrid* kernel);
}

#endif
