// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Units.h
 * @brief Units of values, and where VTK keeps that of an array.
 */
#ifndef camaron_Units_h
#define camaron_Units_h

class vtkDataArray;

namespace camaron
{
enum class Unit
{
  None,
  Angle, ///< degree or radian, as the user chooses
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

/// From radian.
constexpr double GetAngleFactor(AngleUnit unit)
{
  return unit == AngleUnit::Degrees ? 180 / 3.141592653589793238462643383279502884 : 1;
}

/// "deg", "rad", "sr" or "" (lengths, areas and volumes are in the units of the mesh).
const char* GetUnitLabel(enum Unit unit, AngleUnit angles);

/// Sets the unit of an array (vtkDataArray::UNITS_LABEL); none for an empty label, which VTK's
/// legacy format writes but cannot read.
void SetUnitLabel(vtkDataArray* array, const char* label);
}

#endif
