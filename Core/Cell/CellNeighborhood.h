// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellNeighborhood
 * @brief A cell, its facets, and the neighboring cells, as a finite volume method uses them.
 *
 * The facets of a polyhedron are its faces. Those of a polygon are its edges, whose vector area
 * lies in the plane of the polygon and has the length of the edge. All coordinates are relative to
 * the first point of the cell. Holds scratch memory: use one object per thread.
 */
#ifndef camaron_CellNeighborhood_h
#define camaron_CellNeighborhood_h

#include "Base/Buffer.h"
#include "Cell/CellGeometry.h"
#include "Cell/FaceRing.h"
#include "Mesh/MeshTopology.h"

#include <vector> // for the facets

namespace camaron
{
class FacetLinks;
struct PieceLinks;

/// Centroid and volume or area of every cell of a mesh.
struct CellCenters
{
  LargeVector<Vector> Centroids; ///< absolute coordinates; NaN if undefined
  LargeVector<double> Sizes;     ///< NaN if the cell is not closed

  /// Initially, all values are undefined.
  explicit CellCenters(vtkIdType numberOfCells);
  /// Sets the values of a cell from its geometry, which requires CellNeighborhood::BaseNeeds.
  void Set(vtkIdType cell, const CellGeometry& geometry);
};

/// Whether the mesh has cells of this dimension.
bool HasCellsOfDimension(const MeshView& mesh, int dimension);

///@{
/**
 * GetCellCenter returns centroid and size of a cell as in CellCenters; GetCellVector returns the
 * unit normal of its vector area, which is zero unless the cell is a polygon with an area.
 * @a scratch is overwritten.
 */
void GetCellCenter(const MeshView& mesh, vtkIdType cell, const EvaluationOptions& options,
  CellGeometry& scratch, Vector& centroid, double& size);
Vector GetCellVector(
  const MeshView& mesh, vtkIdType cell, const EvaluationOptions& options, CellGeometry& scratch);
///@}

/// Number of cells at a facet that has cells in other pieces, too (see FacetLinks), without
/// duplicates.
Index CountCellsOfAllPieces(Index facet, const FacetTable& table, const FacetLinks& links,
  const EvaluationOptions& options, std::vector<Index>& scratch);

class CellNeighborhood
{
public:
  enum class Side
  {
    Cell,       ///< one other cell
    Boundary,   ///< no other cell
    Missing,    ///< the other cell is in another piece
    NonManifold ///< several other cells, or the cell itself
  };
  struct Facet
  {
    Vector Area;         ///< vector area, out of the cell
    double Size = 0;     ///< magnitude of Area
    bool IsZero = false; ///< collapsed
    Vector Center;
    Vector Way; ///< from the centroid of the cell to Center
    double WayLength = 0;
    double AreaByWay = 0; ///< scalar product of Area and Way
    Side Other = Side::Boundary;
    Vector OtherCentroid; ///< like OtherSize, the value of an earlier facet unless Other is Cell
    Vector Line;          ///< from the centroid of the cell to OtherCentroid; zero if there is no
                          ///< other cell
    double LineLength = 0;
    double AreaByLine = 0; ///< scalar product of Area and Line
    double OtherSize = 0;
    int Number = 0; ///< index of the face or edge in the topology of the cell
    int Use = 0;    ///< index among the facets of the cell in the facet table
  };

  CellNeighborhood(
    const MeshTopology& topology, const CellCenters& centers, const EvaluationOptions& options);

  /// Parts of the geometry that are always required.
  static constexpr unsigned BaseNeeds = NeedsFaces | NeedsCentroid;

  /// Loads a cell; returns false if its facets cannot be distinguished.
  bool Load(vtkIdType cell, const CellGeometry& geometry);

  const CellGeometry& GetGeometry() const { return *this->Geometry; }
  const Vector& GetCentroid() const { return this->Geometry->GetCentroid(); }
  /// Volume or area.
  double GetSize() const { return this->Size; }
  const std::vector<Facet>& GetFacets() const { return this->Facets; }

  /// Calls @a visit(const Vector&) for the points of a facet.
  template <typename Visit>
  void ForEachPoint(const Facet& facet, Visit&& visit) const
  {
    const FaceRing ring(*this->Geometry, this->IsPolygon ? 0 : facet.Number);
    if (this->IsPolygon)
    {
      visit(ring.GetBegin(facet.Number));
      visit(ring.GetEnd(facet.Number));
      return;
    }
    for (int i = 0; i < ring.GetSize(); ++i)
    {
      visit(ring.GetBegin(i));
    }
  }

private:
  void Finish(Facet& facet) const;
  void FindUsesOfRing();
  void FindOther(
    vtkIdType cell, CellFacet use, const FacetTable& table, const FacetLinks* links, Facet& facet);
  bool FindLinked(
    vtkIdType cell, CellFacet use, const FacetTable& table, const FacetLinks& links, Facet& facet);

  const CellCenters& Centers;
  const EvaluationOptions& Options;
  const PieceLinks* Links;
  const FacetTable* Faces = nullptr; ///< of 3D cells; nullptr if there are none
  const FacetTable* Edges = nullptr; ///< of 2D cells; nullptr if there are none
  const CellGeometry* Geometry = nullptr;
  bool IsPolygon = false;
  double Size = 0;
  std::vector<Facet> Facets;
  std::vector<Index> FacetCells; // scratch memory
  std::vector<int> UsesOfRing; // for the remaining edges of a polygon, their index among all edges
};
}

#endif
