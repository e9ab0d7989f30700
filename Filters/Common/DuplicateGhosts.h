// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DuplicateGhosts.h
 * @brief Hides duplicate ghost cells of a mesh.
 */
#ifndef camaron_DuplicateGhosts_h
#define camaron_DuplicateGhosts_h

#include "vtkDataSet.h"      // for the result
#include "vtkSmartPointer.h" // for the result

namespace camaron
{
/**
 * Returns an unstructured grid or vtkPolyData in which a ghost cell is hidden (HIDDENCELL) if the
 * mesh also contains its original or an earlier duplicate of it. Readers create such meshes when
 * they append several pieces of a file, each with its own ghost cells. Returns @a mesh itself if
 * there is nothing to hide.
 *
 * Cells are the same if they have the same points and, if there are global ids, the same global id.
 * Merge duplicate points before (DuplicatePoints.h). Point ids of cells must be valid.
 */
vtkSmartPointer<vtkDataSet> HideRepeatedGhosts(vtkDataSet* mesh);
}

#endif
