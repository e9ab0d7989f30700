// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetrahedronFaces.h
 * @brief Finds equal faces of tetrahedra, several times as fast as those of any cells.
 */
#ifndef camaron_TetrahedronFaces_h
#define camaron_TetrahedronFaces_h

#include "Mesh/FacetTable.h"
#include "Mesh/MeshView.h"
#include "Scan/Buffer.h"

namespace camaron
{
/**
 * Of a mesh of nothing but VTK_TETRA, leaves in @a uses, four for each cell, the first use of a face with the same
 * points: itself, or the complement of another one and whether it runs against it. False if a cell has a point twice;
 * then the uses are as they were.
 */
bool MatchTetrahedronFaces(const MeshView& mesh, LargeVector<CellFacet>& uses);
}

#endif
