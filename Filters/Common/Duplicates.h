// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Duplicates.h
 * @brief Merges duplicates of points, so that cells at the borders of pieces share points again,
 * and hides those of ghost cells.
 *
 * Readers that append several pieces of a file leave a duplicate of each border point per piece,
 * and the ghost cells of each piece.
 */
#ifndef camaron_Duplicates_h
#define camaron_Duplicates_h

#include "vtkDataSet.h"      // for the result
#include "vtkSmartPointer.h" // for the result

#include <vector> // for points

namespace camaron
{
/// For every point of an unstructured grid or vtkPolyData the first point with the same global id
/// and position, where NaN equals NaN. Empty if there are no duplicates or no global ids.
std::vector<vtkIdType> FindFirstCopies(vtkDataSet* mesh);

/**
 * A mesh with the same points and cells, in which all cells use the first duplicate of their points
 * and the others are marked with DUPLICATEPOINT. Returns @a mesh itself if @a firsts, from
 * FindFirstCopies, is empty. Point ids of cells must be valid.
 */
vtkSmartPointer<vtkDataSet> ShareCopiesOfPoints(
  vtkDataSet* mesh, const std::vector<vtkIdType>& firsts);

/**
 * Returns an unstructured grid or vtkPolyData in which a ghost cell is hidden (HIDDENCELL) if the
 * mesh also contains its original or an earlier duplicate of it. Returns @a mesh itself if there is
 * nothing to hide.
 *
 * Cells are the same if they have the same points and, if there are global ids, the same global id.
 * Merge duplicate points before. Point ids of cells must be valid.
 */
vtkSmartPointer<vtkDataSet> HideRepeatedGhosts(vtkDataSet* mesh);
}

#endif
