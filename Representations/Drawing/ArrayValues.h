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
struct ArrayValues
{
  /// What was taken from all values: floats cannot tell 101325.00 from 101325.01 well. 0 where it would not help.
  double Origin = 0;
  std::vector<float> Values;

  float FromOrigin(double value) const { return static_cast<float>(value - this->Origin); }
};

/// A component of an array, or the lengths of its tuples where @a component is negative; of one component itself.
ArrayValues GetArrayValues(vtkDataArray* array, int component = -1);
}

#endif
