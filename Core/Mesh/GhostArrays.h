// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GhostArrays.h
 * @brief Lets VTK recognize ghost arrays of any integer type.
 */
#ifndef camaron_GhostArrays_h
#define camaron_GhostArrays_h

#include "vtkSmartPointer.h" // for the result

class vtkDataSet;

namespace camaron
{
/**
 * Returns the data set itself, or if its "vtkGhostType" of cells or points is not the
 * vtkUnsignedCharArray that VTK expects but another integer array, a shallow copy with a converted
 * array. Arrays that cannot be converted are kept; see CheckGhosts.
 */
vtkSmartPointer<vtkDataSet> WithGhostBytes(vtkDataSet* data);

/**
 * @throw std::runtime_error if cells or points still have a "vtkGhostType" that VTK does not
 * recognize: it must contain one integer from 0 to 255 per cell or point.
 */
void CheckGhosts(vtkDataSet* data);
}

#endif
