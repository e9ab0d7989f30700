// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::MeshTopology
 * @brief Faces, edges and neighbors of a mesh, built once and shared by everybody who sees it.
 *
 * Made from a vtkUnstructuredGrid (any mixture of linear types and polyhedra, higher-order types by
 * their corners, any mixture of dimensions) or a vtkPolyData. Every table is built, in parallel and
 * in time and memory proportional to the mesh, when it is first asked for; it is then found again
 * by every MeshTopology of a mesh with the same connectivity arrays (shallow copies included) and
 * released with these arrays.
 *
 * All methods are safe to call from several threads.
 */
#ifndef camaron_MeshTopology_h
#define camaron_MeshTopology_h

#include "Mesh/FacetTable.h"
#include "Mesh/MeshView.h"

#include <array>  // for edges
#include <memory> // for std::shared_ptr
#include <vector> // for tables

class vtkUnstructuredGrid;

namespace camaron
{
/// For every point the cells that use it, ascending.
struct PointCells
{
  std::vector<vtkIdType> Offsets; ///< one more than points
  std::vector<Index> Cells;
};

/// Unique edges of all cells; each with the smaller point id first, sorted.
using EdgeList = std::vector<std::array<Index, 2>>;

/// What two neighboring cells have in common.
enum class Adjacency
{
  Facet, ///< a face of 3D cells, an edge of 2D cells
  Edge,
  Vertex
};

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
  /// The one or the other: the facets of cells of dimension 3 or 2.
  const FacetTable& GetFacets(int dimension) const
  {
    return dimension == 3 ? this->GetFaces() : this->GetSurfaceEdges();
  }
  /// Edges of all 2D and 3D cells.
  const EdgeList& GetEdges() const;
  const PointCells& GetPointCells() const;
  /// See FindCellRegions.
  const std::vector<Index>& GetCellRegions() const;
  /// See CountPointRegions.
  const std::vector<Index>& GetPointRegionCounts() const;

  /**
   * Points of a face as its owner runs around it (outward for a healthy cell); @a points is
   * overwritten.
   */
  void GetFacePoints(Index face, std::vector<vtkIdType>& points) const;

  /**
   * The other cells of the mesh next to @a cell, ascending; @a neighbors is overwritten. Builds the
   * tables that the kind of adjacency needs.
   */
  void GetNeighbors(vtkIdType cell, Adjacency adjacency, std::vector<Index>& neighbors) const;

  /**
   * For readers whose file lists the faces of a mesh: hands them over, so that they need not be
   * found again. Cheap: the table itself is built only when somebody asks for it.
   * @param grid the reader's output, whose connectivity must not change afterwards
   * @param cellFaces for every face of every 3D cell, in the order of GetFaces, the number that the
   *   file gives it: two entries with the same number have the same points. Different numbers may
   *   still have the same points.
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
}

#endif
