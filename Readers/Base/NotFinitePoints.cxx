// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "NotFinitePoints.h"

#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <cmath>

namespace camaron
{
//------------------------------------------------------------------------------
Tally FindNotFinitePoints(vtkPointSet* mesh)
{
  auto* const globalIds =
    vtkIdTypeArray::SafeDownCast(mesh->GetPointData()->GetArray("GlobalPointIds"));
  Tally tally;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
    {
      tally.Add(globalIds ? globalIds->GetValue(i) : i);
    }
  }
  return tally;
}
}
