// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointRanges.h"

#include "Base/Parallel.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationInformationVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Computes bounds from the cached ranges of coordinates, instead of from the coordinates.
class RangedPoints : public vtkPoints
{
public:
  static RangedPoints* New();
  vtkTypeMacro(RangedPoints, vtkPoints);
  void ComputeBounds() override
  {
    if (this->GetMTime() > this->ComputeTime)
    {
      for (int c = 0; c < 3; ++c)
      {
        this->Data->GetRange(this->Bounds + 2 * c, c);
      }
      this->ComputeTime.Modified();
    }
  }
};

vtkStandardNewMacro(RangedPoints);

//------------------------------------------------------------------------------
struct Ranges
{
  // Of the coordinates and of their squared norm.
  double Least[4], Greatest[4];
  bool AreFinite = true;

  Ranges()
  {
    std::fill_n(this->Least, 4, std::numeric_limits<double>::infinity());
    std::fill_n(this->Greatest, 4, -std::numeric_limits<double>::infinity());
  }

  template <typename Real>
  void Add(const Real* points, vtkIdType size)
  {
    for (vtkIdType i = 0; i < size; ++i)
    {
      const double x = points[3 * i], y = points[3 * i + 1], z = points[3 * i + 2];
      const double values[4] = { x, y, z, x * x + y * y + z * z };
      for (int c = 0; c < 4; ++c)
      {
        this->Least[c] = std::min(this->Least[c], values[c]);
        this->Greatest[c] = std::max(this->Greatest[c], values[c]);
      }
      this->AreFinite &= values[3] <= std::numeric_limits<double>::max(); // false for NaN
    }
  }

  void Add(const Ranges& other)
  {
    for (int c = 0; c < 4; ++c)
    {
      this->Least[c] = std::min(this->Least[c], other.Least[c]);
      this->Greatest[c] = std::max(this->Greatest[c], other.Greatest[c]);
    }
    this->AreFinite &= other.AreFinite;
  }
};

//------------------------------------------------------------------------------
template <typename Real>
Ranges FindRanges(const Real* points, vtkIdType size)
{
  Ranges ranges;
  std::mutex mutex;
  ParallelFor(size, LightGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      Ranges local;
      local.Add(points + 3 * begin, end - begin);
      const std::lock_guard<std::mutex> lock(mutex);
      ranges.Add(local);
    });
  return ranges;
}

//------------------------------------------------------------------------------
void Keep(const Ranges& ranges, vtkDataArray* points)
{
  vtkInformation* known = points->GetInformation();
  for (auto* key : { vtkAbstractArray::PER_COMPONENT(), vtkAbstractArray::PER_FINITE_COMPONENT() })
  {
    vtkNew<vtkInformationVector> coordinates;
    coordinates->SetNumberOfInformationObjects(3);
    for (int c = 0; c < 3; ++c)
    {
      const double range[2] = { ranges.Least[c], ranges.Greatest[c] };
      coordinates->GetInformationObject(c)->Set(vtkDataArray::COMPONENT_RANGE(), range, 2);
    }
    known->Set(key, coordinates);
  }
  const double norms[2] = { std::sqrt(ranges.Least[3]), std::sqrt(ranges.Greatest[3]) };
  known->Set(vtkDataArray::L2_NORM_RANGE(), norms, 2);
  known->Set(vtkDataArray::L2_NORM_FINITE_RANGE(), norms, 2);
}
}

//------------------------------------------------------------------------------
bool FindPointRanges(vtkPointSet* mesh)
{
  vtkDataArray* const data = mesh->GetPoints() ? mesh->GetPoints()->GetData() : nullptr;
  auto* const floats = vtkFloatArray::SafeDownCast(data);
  auto* const doubles = vtkDoubleArray::SafeDownCast(data);
  if ((!floats && !doubles) || data->GetNumberOfTuples() == 0)
  {
    return false;
  }
  const vtkIdType size = data->GetNumberOfTuples();
  const Ranges ranges =
    floats ? FindRanges(floats->GetPointer(0), size) : FindRanges(doubles->GetPointer(0), size);
  if (!ranges.AreFinite)
  {
    return false;
  }
  vtkNew<RangedPoints> points;
  points->SetData(data); // for VTK a change of the array, whose ranges it would forget
  mesh->SetPoints(points);
  Keep(ranges, data);
  return true;
}

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
