// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshElements.h
 * @brief The faces, edges and vertices of a mesh as data sets of their own.
 *
 * Each fills an empty vtkPolyData, which gets the points of the mesh with their data and those of
 * the arrays of ElementArray.h that are named. If the mesh has ghost cells, elements that only
 * copies of cells have are left out, and "vtkGhostType" marks those that belong to another piece:
 * whose cell of the smallest id is a copy (DUPLICATECELL). Each returns ElementContext::GoesOn; if
 * that is false, the elements are not complete.
 */
#ifndef camaron_MeshElements_h
#define camaron_MeshElements_h

#include "Elements/ElementArray.h"

#include <string> // for names of arrays
#include <vector> // for lists of arrays

class vtkPolyData;

namespace camaron
{
/**
 * Every face of the 3D cells once; face i is facet i of MeshTopology::GetFaces, and runs as its
 * first cell has it. A mesh without 3D cells has its 2D cells for faces.
 */
bool MakeFaces(
  const ElementContext& context, const std::vector<std::string>& arrays, vtkPolyData* faces);

/// Every edge of the 2D and 3D cells once, in the order of MeshTopology::GetEdges.
bool MakeEdges(
  const ElementContext& context, const std::vector<std::string>& arrays, vtkPolyData* edges);

/// A VTK_VERTEX for every point of the mesh, in their order.
bool MakeVertices(
  const ElementContext& context, const std::vector<std::string>& arrays, vtkPolyData* vertices);

/**
 * Adds to @a vertices of MakeVertices "VertexWorst<Criterion>" for every criterion of which the
 * mesh has a cell array and which has a better end: the worst value of the cells with the point,
 * null if none of them has a value.
 */
bool AddWorstOfCells(const ElementContext& context, vtkPolyData* vertices);
}

#endif
