// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::SharedFaces
 * @brief The polygons and polyhedra of a mesh for formats with shared faces.
 *
 * Polyhedra are lists of polygons. A face between two 3D cells is written once, with the
 * orientation of its first cell; CellShell reverses it for the other cell when it is read. If this
 * would not restore the mesh, because the cells are not closed and traverse the face in the same
 * direction, or because they traverse its points in another order, each cell gets its own polygon.
 */
#ifndef camaron_SharedFaces_h
#define camaron_SharedFaces_h

#include "Base/Buffer.h"
#include "Mesh/CellFacets.h"
#include "Mesh/MeshTopology.h"

#include <array>   // for roles by type
#include <cstdint> // for the words
#include <map>     // for faces of their own
#include <utility> // for uses of faces
#include <vector>  // for the starts of chunks

namespace camaron
{
/// Lists in the layout of many formats, n id1 ... idn, with the word at which every chunk begins.
struct WordLists
{
  vtkIdType Count = 0;
  Buffer<std::int32_t> Words;
  std::vector<vtkIdType> Starts;
  vtkIdType GetNumberOfChunks() const { return static_cast<vtkIdType>(this->Starts.size()) - 1; }
};

/// How a format represents a cell.
enum class FaceRole : unsigned char
{
  Polyhedron,
  Polygon,
  Strip,  ///< a polygon per triangle
  Pieces, ///< polygons with one or two points, for points and lines
  None
};

class SharedFaces
{
public:
  using RoleTable = std::array<FaceRole, 256>; ///< by cell type

  /// 3D cells and cells without points become polyhedra, 2D cells polygons, points and lines their
  /// parts.
  static RoleTable GetUsualRoles();

  SharedFaces(vtkDataSet* mesh, const RoleTable& roles);
  SharedFaces(const SharedFaces&) = delete;
  void operator=(const SharedFaces&) = delete;

  /// Lists every polygon; cells are in the order of the mesh. @throw std::length_error for too many
  void Build();

  const MeshView& GetMesh() const { return this->Mesh; }
  FaceRole GetRole(vtkIdType cell) const { return this->Roles[this->Mesh.GetCellType(cell)]; }

  WordLists Polygons;
  WordLists Polyhedra;
  /// The first cell of a polygon: the cell that it represents, or of which it is a face.
  Buffer<std::int32_t> CellOfPolygon;

private:
  // The use of a facet by a cell, as the cell and its local index.
  using Use = std::pair<vtkIdType, Index>;

  bool IsClosed(vtkIdType cell) const;
  bool AreSameRing(const Use& use, const Use& other) const;
  void ShareFacet(Index facet);
  void FindExtraUses();
  struct Scratch
  {
    CellFacets Facets;
    std::vector<vtkIdType> Polygon;
  };
  template <typename Visit>
  void ForEachPolygon(Scratch& scratch, vtkIdType cell, Visit&& visit) const;
  std::int32_t GetPolygon(vtkIdType cell, Index local, Index facet) const;

  MeshTopology Topology;
  const MeshView& Mesh;
  const FacetTable& Faces;
  RoleTable Roles;
  std::vector<std::int32_t> PolygonOfFacet;
  // A use that does not share the first polygon of its facet.
  struct ExtraUse
  {
    Use Start; // the use whose polygon it shares, possibly itself
    std::int32_t Polygon;
  };
  std::map<Use, ExtraUse> ExtraUses;
};
}

#endif
