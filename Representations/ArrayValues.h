// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ArrayValues.h
 * @brief One value for each row of an array, for the graphics card.
 */
#ifndef camaron_ArrayValues_h
#define camaron_ArrayValues_h

#include <vector> // for the values

class vtkDataArray;

namespace camaron
{
/// A component of an array, or the lengths of its tuples where @a component is negative; of one component itself.
std::vector<float> GetArrayValues(vtkDataArray* array, int component = -1);
}

#endif
