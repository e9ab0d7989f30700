// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::SubdividedFacets
 * @brief The faces of cells of higher order as small triangles, with new points between the nodes,
 * and points inside of the cells.
 *
 * At level l, each edge is divided into 2^l parts, and faces accordingly. Two cells share the
 * triangles of their face. New points are numbered after those of the mesh; their positions, and
 * values of arrays, are combinations of those of nodes, as the cell interpolates them.
 */
#ifndef camaron_SubdividedFacets_h
#define camaron_SubdividedFacets_h

#include "vtkType.h" // for vtkIdType

#include <array>   // for edges
#include <cstdint> // for the places
#include <memory>  // for the result
#include <vector>  // for the tables

class vtkUnstructuredGrid;

namespace camaron
{
class MeshTopology;

/// Whether a grid, which may be null, has cells whose faces can be curved.
bool HasHigherOrderCells(vtkUnstructuredGrid* grid);

class SubdividedFacets
{
public:
  static constexpr int MaxLevel = 4;
  /// A lower level is used where it would need more new points, or divide the inside of cells into
  /// more tetrahedra (CellTetrahedra.h).
  static constexpr vtkIdType MaxParts = 30000000;

  enum class Extent
  {
    Boundary, ///< faces with one cell
    Faces,    ///< all faces
    Cells     ///< all faces, and points inside of the cells
  };

  /**
   * nullptr if the mesh has no cells to divide. At level 1, and without points inside of cells,
   * those with a node in the middle of each edge are drawn through these nodes (CurvedFacets.h).
   * Level 0 draws all cells by their vertices.
   */
  static std::shared_ptr<const SubdividedFacets> Make(
    const MeshTopology& topology, int level, Extent extent);

  /// That asked for, or a lower one.
  int GetLevel() const { return this->Level; }
  /// Whether cells of higher order are drawn by their vertices.
  bool AreStraight() const { return this->Level == 0; }
  bool Has(vtkIdType cell) const { return !this->First.empty() && this->First[cell] >= 0; }

  /// Triangles of a facet of a 3D cell, or of a 2D cell itself (local 0): three points each, and
  /// the bits of edges that belong to the facet, as in PolygonTriangles.
  struct Triangles
  {
    const vtkIdType* Points;
    const unsigned char* Edges;
    vtkIdType Count;
    bool AreReversed; ///< the facet is seen from its other side
  };
  Triangles Get(vtkIdType cell, vtkIdType local) const;

  /**
   * The points inside of a 3D cell: in layers from its faces to its center, each with a point for
   * every point of the faces, in the order of their numbers. The center follows the last layer.
   * First is -1 without them.
   */
  struct Inside
  {
    vtkIdType First;
    int Layers;
  };
  Inside GetInside(vtkIdType cell) const
  {
    return { this->Insides.empty() ? -1 : this->Insides[cell], this->Layers };
  }

  /// For every divided edge, the ends of a part at its middle, then of the edge.
  const std::vector<std::array<vtkIdType, 4>>& GetMiddleParts() const { return this->MiddleParts; }

  vtkIdType GetNumberOfNewPoints() const { return static_cast<vtkIdType>(this->NewPoints.size()); }
  /// The nodes of a cell of which a new point is a combination, by its number among the new points.
  struct Stencil
  {
    vtkIdType Cell;
    const int* Nodes; ///< of the cell
    const double* Weights;
    int Size;
  };
  Stencil GetStencil(vtkIdType newPoint) const;

private:
  class Builder;

  struct Facet
  {
    vtkIdType First = 0, Count = 0; ///< triangles
    bool IsReversed = false;
  };
  struct NewPoint
  {
    vtkIdType Cell;
    int Mixture;
  };
  int Level = 0, Layers = 0;
  std::vector<std::int64_t> First; ///< of every cell, its first facet, or -1
  std::vector<Facet> Facets;
  std::vector<vtkIdType> Points;
  std::vector<unsigned char> Edges;
  std::vector<std::array<vtkIdType, 4>> MiddleParts;
  std::vector<vtkIdType> Insides;
  std::vector<NewPoint> NewPoints;
  std::vector<int> MixtureEnds, MixtureNodes; ///< which many cells share
  std::vector<double> MixtureWeights;
};
}

#endif
