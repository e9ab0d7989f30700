// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GhostArrays.h
 * @brief Makes ghosts known whatever integers a file has for them.
 */
#ifndef camaron_GhostArrays_h
#define camaron_GhostArrays_h

#include "vtkSmartPointer.h" // for the result

class vtkDataSet;

namespace camaron
{
/**
 * The data set itself, or where its "vtkGhostType" of cells or points is not the
 * vtkUnsignedCharArray that VTK looks for but other integers, a shallow copy with one. What cannot
 * be ghosts stays as it is; see CheckGhosts.
 */
vtkSmartPointer<vtkDataSet> WithGhostBytes(vtkDataSet* data);

/**
 * Throws std::runtime_error if cells or points still have a "vtkGhostType" that VTK does not know
 * as such: one that is not integers from 0 to 255, one for each.
 */
void CheckGhosts(vtkDataSet* data);
}

#endif
