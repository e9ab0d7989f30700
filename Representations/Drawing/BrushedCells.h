// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::BrushedCells
 * @brief Which cells of a mesh brushes select: the same as ParaView's selections by thresholds.
 */
#ifndef camaron_BrushedCells_h
#define camaron_BrushedCells_h

#include "InspectionStyle.h"

#include "vtkSmartPointer.h"      // for the result
#include "vtkType.h"              // for vtkMTimeType
#include "vtkUnsignedCharArray.h" // for the result

#include <vector> // for the brushes

class vtkUnstructuredGrid;

namespace camaron
{
class BrushedCells
{
public:
  /// Returns 1 for the cells that @a brushes select, one after another, and 0 for all others.
  vtkDataArray* Update(const std::vector<Brush>& brushes, vtkUnstructuredGrid* grid);

private:
  std::vector<Brush> Brushes;
  vtkMTimeType Time = 0; ///< of the arrays
  vtkSmartPointer<vtkUnsignedCharArray> Cells;
};
}

#endif
