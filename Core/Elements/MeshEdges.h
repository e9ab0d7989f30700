// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshEdges.h
 * @brief The edges and vertices of a mesh as data sets of their own.
 */
#ifndef camaron_MeshEdges_h
#define camaron_MeshEdges_h

#include "Criteria/CellGeometry.h"
#include "Mesh/MeshTopology.h"

class vtkDataSet;
class vtkPolyData;

namespace camaron
{
/**
 * Fills @a edges, which must be empty, with every edge of the 2D and 3D cells once, in the order of
 * MeshTopology::GetEdges. Points and their data are those of the mesh.
 *
 * Cell arrays: "EdgeLength", "EdgeCellCount", "EdgeFaceCount" (faces of 3D cells, and 2D cells),
 * "IsBoundary" (of a face with one 3D cell, or of one 2D cell), and, if the mesh has 2D cells,
 * "EdgeDihedralAngle" (interior angle of its two polygons, 180 degrees is flat; null if there are not
 * two) and "InconsistentEdge" (1 if both run along it in the same direction). If the mesh has ghost
 * cells, "vtkGhostType" marks the edges that belong to another piece.
 */
void MakeEdges(vtkDataSet* mesh, const MeshTopology& topology, const EvaluationOptions& options,
  vtkPolyData* edges);

/**
 * Fills @a vertices, which must be empty, with a VTK_VERTEX for every point of the mesh, in their order.
 *
 * Cell arrays: "VertexCellCount", "VertexFaceCount", "VertexEdgeCount", "IsBoundary", "UnusedPoint" (1 if
 * no cell has the point). If the mesh has ghost points, "vtkGhostType" marks them.
 */
void MakeVertices(vtkDataSet* mesh, const MeshTopology& topology, const EvaluationOptions& options,
  vtkPolyData* vertices);
}

#endif
