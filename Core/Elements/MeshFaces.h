// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshFaces.h
 * @brief The faces of a mesh as a data set of their own.
 */
#ifndef camaron_MeshFaces_h
#define camaron_MeshFaces_h

#include "Criteria/CellGeometry.h"
#include "Mesh/MeshTopology.h"

class vtkDataSet;
class vtkPolyData;

namespace camaron
{
/**
 * Fills @a faces, which must be empty, with every face of the 3D cells of @a mesh once; face i is facet i
 * of MeshTopology::GetFaces, and runs as its first cell has it. A mesh without 3D cells has its 2D cells
 * for faces. Points and their data are those of the mesh.
 *
 * Cell arrays: "OwnerCell" and "NeighborCell" (ids of the cells, global ones if the mesh has them; -1 for
 * none), "FaceCellCount", "IsBoundary" (1 with one cell). With @a measures also "NonOrthogonality",
 * "BoundaryNonOrthogonality", "FaceSkewness", "FaceWeight", "VolumeRatio" and "FacePyramidVolume", null
 * (NaN) where there is no value. If the mesh has ghost cells, "vtkGhostType" marks the faces that belong
 * to another piece: those whose cell of the smallest id is a ghost.
 */
void MakeFaces(vtkDataSet* mesh, const MeshTopology& topology, const EvaluationOptions& options,
  bool measures, vtkPolyData* faces);
}

#endif
