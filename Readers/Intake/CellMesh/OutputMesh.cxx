// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/CellMesh/OutputMesh.h"

#include "Base/Parallel.h"

#include "vtkCellType.h"

#include <atomic>

namespace camaron
{
//------------------------------------------------------------------------------
bool OutputMesh::IsCloud() const
{
  std::atomic<bool> isCloud{ this->NumberOfCells == this->NumberOfPoints };
  ParallelFor(this->NumberOfCells, LightGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end && isCloud; ++cell)
      {
        if (this->GetCellType(cell) != VTK_VERTEX || this->GetCellPoints(cell)[0] != cell)
        {
          isCloud = false;
        }
      }
    });
  return isCloud;
}

//------------------------------------------------------------------------------
vtkIdType OutputMesh::Count(unsigned char type) const
{
  return ParallelScan(
    this->NumberOfCells, LightGrain,
    [this, type](vtkIdType begin, vtkIdType end)
    {
      vtkIdType count = 0;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        count += this->GetCellType(cell) == type ? 1 : 0;
      }
      return count;
    },
    [](vtkIdType, vtkIdType, vtkIdType) {});
}
}
