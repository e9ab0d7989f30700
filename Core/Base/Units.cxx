// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Units.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"

namespace camaron
{
//------------------------------------------------------------------------------
const char* GetUnitLabel(enum Unit unit, AngleUnit angles)
{
  switch (unit)
  {
    case Unit::Angle:
      return angles == AngleUnit::Degrees ? "deg" : "rad";
    case Unit::SolidAngle:
      return "sr";
    default:
      return "";
  }
}

//------------------------------------------------------------------------------
void SetUnitLabel(vtkDataArray* array, const char* label)
{
  if (label[0])
  {
    array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), label);
  }
}
}
