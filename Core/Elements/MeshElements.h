// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshElements.h
 * @brief Extracts the faces, edges and vertices of a mesh as data sets.
 *
 * Each function fills an empty vtkPolyData with the points of the mesh, their data, and the named
 * arrays of ElementArray.h. If the mesh has ghost cells, elements that only belong to duplicates
 * are omitted, and "vtkGhostType" marks those that belong to another piece, which are those whose
 * cell with the smallest id is a duplicate (DUPLICATECELL). Each returns ElementContext::GoesOn;
 * if that is false, the elements are incomplete.
 */
#ifndef camaron_MeshElements_h
#define camaron_MeshElements_h

#include "Elements/ElementArray.h"
#include "Ranks/Reducer.h"

#include "vtkType.h" // for ids

#include <array>   // for keys
#include <cstdint> // for keys
#include <string>  // for names of arrays
#include <vector>  // for lists of arrays

class vtkPolyData;

namespace camaron
{
/**
 * What the elements of the undivided mesh are sorted by: for a face, the global id of its first
 * cell, and its number in that cell; for an edge or vertex, the global ids of its points.
 */
using ElementKey = std::array<std::int64_t, 2>;

/// Elements of one piece.
struct KeyedElements
{
  int Block = 0; ///< elements of different blocks differ; they are numbered block by block
  std::vector<ElementKey> Keys; ///< one per element
  const unsigned char* Ghosts =
    nullptr; ///< DUPLICATECELL if it belongs to another piece; or nullptr
};

/// Keys of edges and vertices; empty if their points have no global ids.
std::vector<ElementKey> MakeKeys(vtkPolyData* elements);

/**
 * Collective. The number of every element in the undivided mesh, by piece. Ghosts have the number
 * of the element that they duplicate. Empty if keys do not tell the elements apart: two elements
 * have the same, or some are negative or too large.
 */
std::vector<std::vector<vtkIdType>> NumberElements(
  const std::vector<KeyedElements>& pieces, Reducer& reducer);

/**
 * Every face of the 3D cells once; face i is facet i of MeshTopology::GetFaces, with the
 * orientation of its first cell. Without 3D cells, the faces are the 2D cells.
 *
 * @param keys returns a key for each face; nullptr if they are not needed
 */
bool MakeFaces(const ElementContext& context, const std::vector<std::string>& arrays,
  vtkPolyData* faces, std::vector<ElementKey>* keys = nullptr);

/// Every edge of the 2D and 3D cells once, in the order of MeshTopology::GetEdges.
bool MakeEdges(
  const ElementContext& context, const std::vector<std::string>& arrays, vtkPolyData* edges);

/// A VTK_VERTEX for every point of the mesh, in the order of the points.
bool MakeVertices(
  const ElementContext& context, const std::vector<std::string>& arrays, vtkPolyData* vertices);

/**
 * Adds "VertexWorst<Criterion>" to @a vertices of MakeVertices, for every criterion with a bad end
 * in the cell data of the mesh: the worst value of the cells at the point, NaN if none of them has
 * a value.
 */
bool AddWorstOfCells(const ElementContext& context, vtkPolyData* vertices);
}

#endif
