// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::JudgedValues
 * @brief Values of a criterion in which cells that its acceptable range is not for are inside of
 * it.
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
  /// @a values of the cells of @a grid themselves where the range is for all of them, or there is
  /// none.
  vtkDataArray* Update(vtkDataArray* values, vtkUnstructuredGrid* grid);

private:
  vtkSmartPointer<vtkDataArray> Values, Judged;
  vtkMTimeType Time = 0;
};
}

#endif
