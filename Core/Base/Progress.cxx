// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Progress.h"

#include "Base/Parallel.h"

namespace camaron
{
//------------------------------------------------------------------------------
bool Progress::For(vtkIdType size, FunctionRef<void(vtkIdType, vtkIdType)> function) const
{
  // Few slices, so that waiting for threads at the end of each is cheap.
  const vtkIdType slices = this->Shared && size >= 64 ? 10 : 1;
  for (vtkIdType slice = 0; slice < slices; ++slice)
  {
    const vtkIdType first = size * slice / slices;
    const vtkIdType count = size * (slice + 1) / slices - first;
    ParallelFor(count, count > 1 ? 0 : 1, // 0 lets VTK choose
      [&](vtkIdType begin, vtkIdType end) { function(first + begin, first + end); });
    if (!this->Report(static_cast<double>(slice + 1) / slices))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool Progress::ForBlocks(
  vtkIdType size, vtkIdType block, FunctionRef<void(vtkIdType, vtkIdType)> function) const
{
  return this->For((size + block - 1) / block, [&](vtkIdType first, vtkIdType last)
    { function(first * block, last * block < size ? last * block : size); });
}
}
