// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "NotFinitePoints.h"

#include "Base/Parallel.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <cmath>
#include <mutex>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
struct FindNotFinite
{
  template <typename Array>
  void operator()(Array* coordinates, const vtkIdType* ids, Tally& tally) const
  {
    std::mutex mutex;
    const auto points = vtk::DataArrayTupleRange<3>(coordinates);
    ParallelFor(points.size(), LightGrain,
      [&](vtkIdType begin, vtkIdType end)
      {
        Tally local;
        for (vtkIdType i = begin; i < end; ++i)
        {
          const auto x = points[i];
          if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
          {
            local.Add(ids ? ids[i] : i);
          }
        }
        const std::lock_guard<std::mutex> lock(mutex);
        tally.Merge(local);
      });
  }
};
}

//------------------------------------------------------------------------------
Tally FindNotFinitePoints(vtkPointSet* mesh)
{
  Tally tally;
  if (mesh->GetNumberOfPoints() == 0)
  {
    return tally;
  }
  vtkDataArray* const coordinates = mesh->GetPoints()->GetData();
  auto* const globalIds =
    vtkIdTypeArray::SafeDownCast(mesh->GetPointData()->GetArray("GlobalPointIds"));
  const vtkIdType* const ids = globalIds ? globalIds->GetPointer(0) : nullptr;
  const FindNotFinite find;
  if (!vtkArrayDispatch::DispatchByArray<vtkTypeList::Create<vtkAOSDataArrayTemplate<float>,
        vtkAOSDataArrayTemplate<double>>>::Execute(coordinates, find, ids, tally))
  {
    find(coordinates, ids, tally);
  }
  return tally;
}
}
