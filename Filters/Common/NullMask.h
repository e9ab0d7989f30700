// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NullMask.h
 * @brief An array with the reasons why values of a criterion are undefined.
 */
#ifndef camaron_NullMask_h
#define camaron_NullMask_h

#include "vtkSmartPointer.h"

class vtkDataSet;
class vtkDoubleArray;
class vtkUnsignedCharArray;

namespace camaron
{
/// Creates the array "<name>_Null" with the camaron::NullReason of each value; 0 if it is defined.
/// @a values are cell values of @a mesh.
vtkSmartPointer<vtkUnsignedCharArray> MakeNullMask(vtkDoubleArray* values, vtkDataSet* mesh);
}

#endif
