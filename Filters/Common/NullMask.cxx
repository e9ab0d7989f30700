// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "NullMask.h"

#include "Base/Buffer.h"
#include "Base/Parallel.h"
#include "Criteria/Criterion.h"
#include "Mesh/CellShape.h"

#include "vtkDoubleArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <string>

namespace camaron
{
namespace
{
constexpr vtkIdType Grain = 65536;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnsignedCharArray> MakeNullMask(vtkDoubleArray* values, vtkDataSet* mesh)
{
  auto* const grid =
    vtkUnstructuredGrid::SafeDownCast(mesh); // other data sets have no higher-order cells
  const auto mask = MakeLargeArray<vtkUnsignedCharArray>(values->GetNumberOfValues());
  mask->SetName((std::string(values->GetName()) + "_Null").c_str());
  const double* from = values->GetPointer(0);
  unsigned char* to = mask->GetPointer(0);
  ParallelFor(values->GetNumberOfValues(), Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        NullReason reason = GetNullReason(from[cell]);
        if (reason == NullReason::Value && grid &&
          GetCellShape(static_cast<unsigned char>(grid->GetCellType(cell))).IsHigherOrder)
        {
          reason = NullReason::HigherOrder;
        }
        to[cell] = static_cast<unsigned char>(reason);
      }
    });
  return mask;
}
}
