// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::MeshTopology
 * @brief Faces, edges and neighbors of a mesh, computed once and shared by all users of the mesh.
 *
 * Accepts a vtkUnstructuredGrid (any mixture of linear cell types, polyhedra and dimensions;
 * higher-order cells by their vertices) or a vtkPolyData. Every table is built on first use, in
 * parallel, in time and memory proportional to the mesh. Every MeshTopology of a mesh with the
 * same connectivity arrays, including shallow copies, shares it; it is released with these arrays.
 *
 *     MeshTopology topology(grid);
 *     const FacetTable& faces = topology.GetFaces();
 *     const bool isBoundary = faces.IsBoundary(face);
 *
 * All methods are thread-safe.
 */
#ifndef camaron_MeshTopology_h
#define camaron_MeshTopology_h

#include "Mesh/FacetTable.h"
#include "Mesh/MeshView.h"

#include <algorithm> // for std::lower_bound
#include <array>     // for edges
#include <memory>    // for std::shared_ptr
#include <numeric>   // for the offsets
#include <vector>    // for tables

class vtkUnstructuredGrid;

namespace camaron
{
/// For every point, the cells that use it, ascending.
struct PointCells
{
  std::vector<vtkIdType> Offsets; ///< one entry more than points
  std::vector<Index> Cells;
};

/// Unique edges of all cells, sorted; the smaller point id of each edge comes first.
using EdgeList = std::vector<std::array<Index, 2>>;

class MeshTopology
{
public:
  explicit MeshTopology(vtkDataSet* mesh);
  ~MeshTopology();

  const MeshView& GetMesh() const { return this->Mesh; }

  /// Faces of the 3D cells.
  const FacetTable& GetFaces() const;
  /// Edges of the 2D cells, in the direction of the owner.
  const FacetTable& GetSurfaceEdges() const;
  /// The facets of cells of dimension 3 or 2: GetFaces or GetSurfaceEdges.
  const FacetTable& GetFacets(int dimension) const
  {
    return dimension == 3 ? this->GetFaces() : this->GetSurfaceEdges();
  }
  /// Edges of all 2D and 3D cells.
  const EdgeList& GetEdges() const;
  const PointCells& GetPointCells() const;
  /// For every cell, the index of its region. A region is a set of 2D or 3D cells connected over
  /// facets. Regions are numbered from 0 in the order of their first cells; other cells have -1.
  const std::vector<Index>& GetCellRegions() const;
  /**
   * For every point, the number of groups of cells around it that are connected over facets with
   * that point; more than 1 where the mesh is pinched. The larger number of the 2D and the 3D cells
   * counts, because a solid may include its boundary as 2D cells. 0 for points that are vertices of
   * neither.
   */
  const std::vector<Index>& GetPointRegionCounts() const;

  /**
   * Points of a face in the order of its owner, which is oriented outward for a valid cell;
   * @a points is overwritten.
   */
  void GetFacePoints(Index face, std::vector<vtkIdType>& points) const;

  /**
   * For readers of formats that list the faces of a mesh: provides the faces, so that they need
   * not be found again. Cheap: the table is built only on first use.
   * @param grid the reader's output, whose connectivity must not change afterwards
   * @param cellFaces for every face of every 3D cell, in the order of GetFaces, its number in the
   * file: entries with the same number have the same points; entries with different numbers may
   * have the same points, too.
   * @param numberOfFileFaces one more than the largest number
   */
  static void Provide(
    vtkUnstructuredGrid* grid, LargeVector<Index>&& cellFaces, Index numberOfFileFaces);

private:
  struct Tables;
  class Cache;
  MeshView Mesh;
  std::shared_ptr<Tables> Shared;
};

/// Finds the index of the edge between two points.
class EdgeFinder
{
public:
  /// Keeps a reference to the edges, which must be sorted.
  EdgeFinder(const EdgeList& edges, vtkIdType numberOfPoints)
    : Edges(edges)
    , FirstEdges(static_cast<std::size_t>(numberOfPoints) + 1, 0)
  {
    for (const auto& edge : edges)
    {
      ++this->FirstEdges[edge[0] + 1];
    }
    std::partial_sum(this->FirstEdges.begin(), this->FirstEdges.end(), this->FirstEdges.begin());
  }

  /// Index of the edge between two points, which must exist.
  vtkIdType Find(vtkIdType a, vtkIdType b) const
  {
    const vtkIdType low = std::min(a, b), high = std::max(a, b);
    const auto begin = this->Edges.begin();
    return std::lower_bound(begin + this->FirstEdges[low], begin + this->FirstEdges[low + 1], high,
             [](const std::array<Index, 2>& edge, vtkIdType point) { return edge[1] < point; }) -
      begin;
  }

private:
  const EdgeList& Edges;
  std::vector<vtkIdType> FirstEdges; // first edge of each smaller point
};
}

#endif
