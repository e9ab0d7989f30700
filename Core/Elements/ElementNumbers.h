// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ElementNumbers
 * @brief The numbers that MakeFaces and MakeEdges give to the elements of a mesh, found by cells
 * and points.
 *
 * Elements that only ghost cells have count for nothing. Of a mesh that was put together from
 * pieces, one after the other and with points of their own, elements have the numbers that they
 * have in their piece.
 */
#ifndef camaron_ElementNumbers_h
#define camaron_ElementNumbers_h

#include "Elements/EdgeFinder.h"
#include "Mesh/MeshTopology.h"

#include <memory> // for the edges
#include <vector> // for numbers

namespace camaron
{
class ElementNumbers
{
public:
  static constexpr vtkIdType None = -1;

  /**
   * @param mesh a vtkUnstructuredGrid or vtkPolyData
   * @param ghosts vtkGhostType of the cells, or null
   * @param firstCells of the pieces, ascending from 0; empty: the mesh is one
   */
  ElementNumbers(
    vtkDataSet* mesh, const unsigned char* ghosts, const std::vector<vtkIdType>& firstCells = {});

  /// Number of the face of @a cell with three of its points, in whatever order; None if there is
  /// none.
  vtkIdType GetFace(vtkIdType cell, const vtkIdType points[3]) const;
  /// Number of the edge between two points; None if there is none.
  vtkIdType GetEdge(vtkIdType a, vtkIdType b) const;

private:
  struct Piece
  {
    vtkIdType FirstCell;
    vtkIdType FirstPoint;
    bool HasVolume;
  };

  std::size_t FindPiece(vtkIdType cell) const;
  bool IsGhost(vtkIdType cell) const;
  void MakePieces(const std::vector<vtkIdType>& firstCells);
  void NumberFaces() const;
  void NumberPolygons() const;
  void NumberEdges() const;

  MeshTopology Topology;
  const unsigned char* Ghosts;
  std::vector<Piece> Pieces;
  // Made when first asked for.
  mutable std::vector<Index> Faces;
  mutable std::vector<Index> Polygons; // of 2D cells that are faces
  mutable std::vector<Index> Edges;
  mutable std::unique_ptr<EdgeFinder> Finder;
};
}

#endif
