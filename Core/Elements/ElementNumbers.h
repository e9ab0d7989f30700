// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ElementNumbers
 * @brief Finds the numbers that MakeFaces and MakeEdges give to elements, by cells and points.
 *
 * Elements that only belong to ghost cells are ignored. If a mesh is the concatenation of pieces,
 * each with its own points, elements have the numbers of their piece.
 */
#ifndef camaron_ElementNumbers_h
#define camaron_ElementNumbers_h

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
   * @param ghosts vtkGhostType of the cells, or nullptr
   * @param firstCells first cell of each piece, ascending from 0; empty for a single piece
   */
  ElementNumbers(
    vtkDataSet* mesh, const unsigned char* ghosts, const std::vector<vtkIdType>& firstCells = {});

  /// Number of the face of @a cell with these three points in any order, or None.
  vtkIdType GetFace(vtkIdType cell, const vtkIdType points[3]) const;
  /// Number of the edge between two points, or None.
  vtkIdType GetEdge(vtkIdType a, vtkIdType b) const;

private:
  struct Piece
  {
    vtkIdType FirstCell;
    vtkIdType FirstPoint;
    bool HasVolume;
  };

  bool IsGhost(vtkIdType cell) const;
  void MakePieces(const std::vector<vtkIdType>& firstCells);
  void NumberFaces() const;
  void NumberPolygons() const;
  void NumberEdges() const;

  MeshTopology Topology;
  const unsigned char* Ghosts;
  std::vector<Piece> Pieces;
  // Built on first use.
  mutable std::vector<Index> Faces;
  mutable std::vector<Index> Polygons; // of 2D cells that are faces
  mutable std::vector<Index> Edges;
  mutable std::unique_ptr<EdgeFinder> Finder;
};
}

#endif
