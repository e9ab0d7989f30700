// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NullMask.h
 * @brief Why values of criteria are null, as an array.
 */
#ifndef camaron_NullMask_h
#define camaron_NullMask_h

#include "vtkSmartPointer.h"

class vtkDataSet;
class vtkDoubleArray;
class vtkUnsignedCharArray;

namespace camaron
{
/// A new array "(name)_Null" with the camaron::NullReason of each value of the cells of a mesh.
vtkSmartPointer<vtkUnsignedCharArray> MakeNullMask(vtkDoubleArray* values, vtkDataSet* mesh);
}

#endif
