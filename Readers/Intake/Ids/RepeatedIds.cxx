// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Ids/RepeatedIds.h"

#include <algorithm>
#include <vector>

namespace camaron
{
//------------------------------------------------------------------------------
bool HasRepeatedIdsAnywhere(const std::int32_t* ids, vtkIdType size)
{
  constexpr vtkIdType Few = 8; // for which comparing all pairs is fastest
  if (size <= Few)
  {
    for (vtkIdType i = 1; i < size; ++i)
    {
      for (vtkIdType j = 0; j < i; ++j)
      {
        if (ids[i] == ids[j])
        {
          return true;
        }
      }
    }
    return false;
  }
  thread_local std::vector<std::int32_t> scratch;
  scratch.assign(ids, ids + size);
  std::sort(scratch.begin(), scratch.end());
  return std::adjacent_find(scratch.begin(), scratch.end()) != scratch.end();
}
}
