// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GatheredMesh.h
 * @brief Makes one mesh of pieces that several processes had.
 */
#ifndef camaron_GatheredMesh_h
#define camaron_GatheredMesh_h

#include "vtkSmartPointer.h"

#include <vector> // for pieces

class vtkDataSet;
class vtkUnstructuredGrid;

namespace camaron
{
/**
 * Whether a mesh has ghost or hidden cells, or several points of the same global id and place, as it may after
 * pieces were put together.
 */
bool HasSeams(vtkDataSet* mesh);

/**
 * Puts pieces together: their cells one after the other without ghost and hidden ones, and their points
 * without those that only such cells use. If all pieces have global ids of points, points of the same
 * id and place are merged, and if there are any, all are sorted by id. Arrays that all pieces have are kept;
 * a merged point has the values of the first. Field data is that of all pieces, by name of the first.
 * @param pieces of types vtkUnstructuredGrid and vtkPolyData
 */
vtkSmartPointer<vtkUnstructuredGrid> MergePieces(const std::vector<vtkDataSet*>& pieces);
}

#endif
