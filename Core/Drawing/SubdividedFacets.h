// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::SubdividedFacets
 * @brief The faces of curved cells as small triangles, with new points between the nodes.
 *
 * At level l, each edge of a curved cell is divided into 2^l parts, and its faces accordingly. Two
 * cells share the triangles of their face. New points are numbered after those of the mesh; their
 * positions, and values of arrays, are combinations of those of nodes. The faces of straight cells
 * are not divided.
 */
#ifndef camaron_SubdividedFacets_h
#define camaron_SubdividedFacets_h

#include "vtkType.h" // for vtkIdType

#include <cstdint> // for the places
#include <memory>  // for the result
#include <vector>  // for the tables

namespace camaron
{
class MeshTopology;

class SubdividedFacets
{
public:
  static constexpr int MaxLevel = 4;

  /**
   * nullptr if the mesh has no cells to divide: at level 1, those with a node in the middle of each
   * edge are drawn through these nodes (CurvedFacets.h). Level 0 draws all cells by their vertices.
   */
  static std::shared_ptr<const SubdividedFacets> Make(const MeshTopology& topology, int level);

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

  /// The new point at the center of a 3D cell, from which its faces are seen better than from a
  /// vertex.
  vtkIdType GetCenter(vtkIdType cell) const { return this->Centers[cell]; }

  vtkIdType GetNumberOfNewPoints() const
  {
    return static_cast<vtkIdType>(this->StencilEnds.size());
  }
  /// The nodes of which a new point is a combination, by its number among the new points.
  struct Stencil
  {
    const vtkIdType* Points;
    const double* Weights;
    vtkIdType Size;
  };
  Stencil GetStencil(vtkIdType newPoint) const;

private:
  class Builder;

  struct Facet
  {
    vtkIdType First = 0, Count = 0; ///< triangles
    bool IsReversed = false;
  };
  int Level = 0;
  std::vector<std::int64_t> First; ///< of every cell, its first facet, or -1
  std::vector<vtkIdType> Centers;  ///< of every cell
  std::vector<Facet> Facets;
  std::vector<vtkIdType> Points;
  std::vector<unsigned char> Edges;
  std::vector<vtkIdType> StencilEnds, StencilPoints;
  std::vector<double> StencilWeights;
};
}

#endif
