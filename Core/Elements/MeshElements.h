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
#include "Elements/ElementIds.h"

#include <string> // for names of arrays
#include <vector> // for lists of arrays

class vtkPolyData;

namespace camaron
{
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
