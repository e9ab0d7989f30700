// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DuplicatePoints.h
 * @brief Lets cells share points again that a mesh has several times.
 */
#ifndef camaron_DuplicatePoints_h
#define camaron_DuplicatePoints_h

#include "vtkDataSet.h"      // for the result
#include "vtkSmartPointer.h" // for the result

#include <vector> // for points

namespace camaron
{
/**
 * Of every point of an unstructured grid or vtkPolyData the first one of the same global id and
 * place, as a reader leaves them that puts several pieces of a file together; nothing if they are
 * all different, or without global ids.
 */
std::vector<vtkIdType> FindFirstCopies(vtkDataSet* mesh);

/**
 * A mesh with the same points and cells in which all cells have the first copies of their points,
 * and the other ones are marked as copies; @a mesh itself if @a firsts is empty. Point ids of cells
 * must be valid.
 */
vtkSmartPointer<vtkDataSet> ShareCopiesOfPoints(
  vtkDataSet* mesh, const std::vector<vtkIdType>& firsts);
}

#endif
