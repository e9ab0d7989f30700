// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InspectionValues.h
 * @brief One number of each cell or point in graphics memory, as its difference from an origin.
 */
#ifndef camaron_InspectionValues_h
#define camaron_InspectionValues_h

#include "TextureBuffer.h"

#include "vtkSmartPointer.h" // for the array
#include "vtkType.h"         // for vtkMTimeType

#include <vector> // for the values

class vtkDataArray;

namespace camaron
{
struct ArrayValues
{
  /// What was taken from all values: floats cannot tell 101325.00 from 101325.01 well. 0 where it
  /// would not help.
  double Origin = 0;
  std::vector<float> Values;

  float FromOrigin(double value) const { return static_cast<float>(value - this->Origin); }
};

/// A component of an array, or the lengths of its tuples where @a component is negative; of one
/// component itself.
ArrayValues GetArrayValues(vtkDataArray* array, int component = -1);

class InspectionValues
{
public:
  static constexpr int Magnitude = -1;

  /// Uploads a component of @a array or the length of its rows, unless it is there already; null:
  /// nothing.
  void Update(vtkDataArray* array, int component = Magnitude);
  bool IsEmpty() const { return !this->Array; }
  const TextureBuffer& GetTable() const { return this->Values; }
  double GetOrigin() const { return this->Origin; }
  void Release();

private:
  vtkSmartPointer<vtkDataArray> Array;
  vtkMTimeType Time = 0;
  int Component = Magnitude;
  double Origin = 0;
  TextureBuffer Values{ TextureBuffer::Row::Float };
};
}

#endif
