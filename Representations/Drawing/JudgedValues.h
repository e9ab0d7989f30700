// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::JudgedValues
 * @brief Values of a criterion for Emphasis, where cells to which its acceptable range does not
 * apply are never emphasized.
 */
#ifndef camaron_JudgedValues_h
#define camaron_JudgedValues_h

#include "vtkDataArray.h"    // for the values
#include "vtkSmartPointer.h" // for the values
#include "vtkType.h"         // for vtkMTimeType

class vtkUnstructuredGrid;

namespace camaron
{
class JudgedValues
{
public:
  /**
   * Returns @a values of the cells of @a grid with a value inside the acceptable range for cells to
   * which the range does not apply; @a values itself if the range applies to all cells or does not
   * exist.
   */
  vtkDataArray* Update(vtkDataArray* values, vtkUnstructuredGrid* grid);

private:
  vtkSmartPointer<vtkDataArray> Values, Judged;
  vtkMTimeType Time = 0;
};
}

#endif
