// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Units.h
 * @brief Units of values, and the unit label of VTK arrays.
 */
#ifndef camaron_Units_h
#define camaron_Units_h

class vtkDataArray;

namespace camaron
{
enum class Unit
{
  None,
  Angle, ///< degrees or radians, as chosen by the user
  SolidAngle,
  Length,
  Area,
  Volume
};

enum class AngleUnit
{
  Degrees,
  Radians
};

/// Factor to convert from radians.
constexpr double GetAngleFactor(AngleUnit unit)
{
  return unit == AngleUnit::Degrees ? 180 / 3.141592653589793238462643383279502884 : 1;
}

/// "deg", "rad", "sr" or "" (lengths, areas and volumes are in the units of the mesh).
const char* GetUnitLabel(enum Unit unit, AngleUnit angles);

/// Sets the unit label of an array (vtkDataArray::UNITS_LABEL). An empty label is not set, because
/// VTK's legacy format writes but cannot read it.
void SetUnitLabel(vtkDataArray* array, const char* label);
}

#endif
