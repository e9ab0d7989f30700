// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::SharedFaces
 * @brief The polygons and polyhedra of a mesh as formats with shared faces store them.
 *
 * Polyhedra are lists of polygons. A face of two 3D cells is written once, as the first of them has
 * it; CellShell turns it for the other when it is read. Where that would not bring back the mesh,
 * as the cells are not closed and run around the face in the same direction, each has a polygon of
 * its own.
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
/// Lists as many formats store them, n id1 ... idn, with the word at which every chunk begins.
struct WordLists
{
  vtkIdType Count = 0;
  Buffer<std::int32_t> Words;
  std::vector<vtkIdType> Starts;
  vtkIdType GetNumberOfChunks() const { return static_cast<vtkIdType>(this->Starts.size()) - 1; }
};

/// What a cell is to a format.
enum class FaceRole : unsigned char
{
  Polyhedron,
  Polygon,
  Strip,  ///< a polygon per triangle
  Pieces, ///< polygons of one or two points: of points and lines
  None
};

class SharedFaces
{
public:
  using RoleTable = std::array<FaceRole, 256>; ///< by type of cells

  /// 3D cells and cells without points as polyhedra, 2D cells as polygons, points and lines as
  /// their pieces.
  static RoleTable GetUsualRoles();

  SharedFaces(vtkDataSet* mesh, const RoleTable& roles);
  SharedFaces(const SharedFaces&) = delete;
  void operator=(const SharedFaces&) = delete;

  /// Lists every polygon; cells are in the order of the mesh. Throws std::length_error for too
  /// many.
  void Build();

  const MeshView& GetMesh() const { return this->Mesh; }
  FaceRole GetRole(vtkIdType cell) const { return this->Roles[this->Mesh.GetCellType(cell)]; }

  WordLists Polygons;
  WordLists Polyhedra;
  /// The first cell that has a polygon: the cell that it is, or of which it is a face.
  Buffer<std::int32_t> CellOfPolygon;

private:
  bool IsClosed(vtkIdType cell) const;
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
  // A use of a facet by a cell, as the cell and its local number.
  using Use = std::pair<vtkIdType, Index>;
  // Of a use that does not share the first polygon of its facet.
  struct ExtraUse
  {
    Use Start; // the use whose polygon it has; it may be its own
    std::int32_t Polygon;
  };
  std::map<Use, ExtraUse> ExtraUses;
};
}

#endif
