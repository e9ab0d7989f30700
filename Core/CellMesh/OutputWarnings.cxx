// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellMesh/OutputWarnings.h"

#include "Mesh/MeshView.h"
#include "Parallel.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace camaron
{
//------------------------------------------------------------------------------
void WarnOfArrays(
  vtkDataSet* mesh, const char* format, Warnings& warnings, const std::vector<std::string>& written)
{
  std::string arrays;
  for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(mesh->GetPointData()),
         static_cast<vtkDataSetAttributes*>(mesh->GetCellData()) })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = data->GetAbstractArray(i);
      const std::string name = array->GetName() ? array->GetName() : "without name";
      const vtkAbstractArray* globalIds = data->GetGlobalIds();
      if (array != globalIds && name != vtkDataSetAttributes::GhostArrayName() &&
        std::find(written.begin(), written.end(), name) == written.end())
      {
        arrays += (arrays.empty() ? "" : ", ") + name;
      }
    }
  }
  if (!arrays.empty())
  {
    warnings.Add(std::string(format) +
      (written.empty() ? " holds no arrays; not written: "
                       : " cannot hold some arrays; not written: ") +
      arrays);
  }
}

//------------------------------------------------------------------------------
void WarnOfRounding(vtkDataSet* mesh, Warnings& warnings)
{
  const MeshView view(mesh);
  if (view.HasFloatPoints())
  {
    return;
  }
  constexpr vtkIdType ChunkSize = 1 << 16;
  Tally rounded;
  std::mutex mutex;
  ParallelFor(view.GetNumberOfPoints(), ChunkSize,
    [&](vtkIdType begin, vtkIdType end)
    {
      const auto isExact = [](double v) { return std::isnan(v) || static_cast<float>(v) == v; };
      Tally found;
      for (vtkIdType id = begin; id < end; ++id)
      {
        double x[3];
        view.GetPoint(id, x);
        if (!isExact(x[0]) || !isExact(x[1]) || !isExact(x[2]))
        {
          found.Add(id);
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      rounded.Merge(found);
    });
  warnings.Add(rounded, "point", "points", "rounded to single precision");
}
}
