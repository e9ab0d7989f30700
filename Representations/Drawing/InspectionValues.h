// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InspectionValues.h
 * @brief One number per cell or point in graphics memory, relative to an origin.
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
  /// Subtracted from all values, because float can hardly distinguish 101325.00 from 101325.01. 0
  /// if subtracting would not help.
  double Origin = 0;
  std::vector<float> Values;

  float FromOrigin(double value) const { return static_cast<float>(value - this->Origin); }
};

/// The values of a component of an array; if @a component is negative, the magnitudes of its
/// tuples. One-component arrays are always used as they are.
ArrayValues GetArrayValues(vtkDataArray* array, int component = -1);

class InspectionValues
{
public:
  static constexpr int Magnitude = -1;

  /// Uploads a component of @a array, or its magnitudes, unless it is already uploaded. Null:
  /// releases the values.
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
