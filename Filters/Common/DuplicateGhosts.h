// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DuplicateGhosts.h
 * @brief Leaves one of several copies that a mesh has of a cell.
 */
#ifndef camaron_DuplicateGhosts_h
#define camaron_DuplicateGhosts_h

#include "vtkDataSet.h"      // for the result
#include "vtkSmartPointer.h" // for the result

namespace camaron
{
/**
 * An unstructured grid or vtkPolyData in which ghost cells are hidden (HIDDENCELL) whose original,
 * or another copy of it before them, the mesh has as well: as a reader leaves them that puts
 * several pieces of a file together, which have ghost cells of each other. @a mesh itself if there
 * are none. The same cell has the same points, which copies of points must share, and the same
 * global id if cells have any. Point ids of cells must be valid.
 */
vtkSmartPointer<vtkDataSet> HideRepeatedGhosts(vtkDataSet* mesh);
}

#endif
