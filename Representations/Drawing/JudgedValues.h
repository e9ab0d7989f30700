// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::JudgedValues
 * @brief Values of a criterion, with others for cells to which its acceptable range does not apply,
 * so that these cells are never emphasized, or have a color of their own.
 */
#ifndef camaron_JudgedValues_h
#define camaron_JudgedValues_h

#include "vtkDataArray.h"    // for the values
#include "vtkSmartPointer.h" // for the values
#include "vtkType.h"         // for vtkMTimeType

#include <optional> // for values

class vtkUnstructuredGrid;

namespace camaron
{
class JudgedValues
{
public:
  /**
   * Returns @a values of the cells of @a grid with @a others for cells to which the range does not
   * apply, or, without that, a value inside of the range. Undefined values remain. Returns @a
   * values itself if the range applies to all cells or does not exist.
   */
  vtkDataArray* Update(
    vtkDataArray* values, vtkUnstructuredGrid* grid, std::optional<double> others = {});

private:
  vtkSmartPointer<vtkDataArray> Values, Judged;
  double Others = 0;
  vtkMTimeType Time = 0;
};
}

#endif
