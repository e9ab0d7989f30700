// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellMesh/OutputMesh.h"

#include "Base/Parallel.h"

namespace camaron
{
//------------------------------------------------------------------------------
vtkIdType OutputMesh::Count(unsigned char type) const
{
  constexpr vtkIdType ChunkSize = 1 << 16;
  return ParallelScan(
    this->NumberOfCells, ChunkSize,
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
