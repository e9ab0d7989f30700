// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file UnitLabel.h
 * @brief The unit of an array, where VTK keeps it.
 */
#ifndef camaron_UnitLabel_h
#define camaron_UnitLabel_h

#include "vtkDataArray.h"
#include "vtkInformation.h"

namespace camaron
{
/// None for an empty label, which VTK's legacy format writes but cannot read.
inline void SetUnitLabel(vtkDataArray* array, const char* label)
{
  if (label[0])
  {
    array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), label);
  }
}
}

#endif
