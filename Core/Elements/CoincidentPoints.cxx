// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Elements/CoincidentPoints.h"

#include "Base/Parallel.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// A point in a bucket, which contains all points of a cube of space.
struct Entry
{
  std::uint64_t Bucket;
  vtkIdType Id;
  vtkIdType Point;
  bool operator<(const Entry& other) const
  {
    return std::tie(this->Bucket, this->Id, this->Point) <
      std::tie(other.Bucket, other.Id, other.Point);
  }
};

//------------------------------------------------------------------------------
// Finds points by position.
class PointBuckets
{
public:
  PointBuckets(const MeshView& mesh, const PointGrid& grid, const PointNumbers& numbers,
    const std::vector<unsigned char>& isLeftOut)
    : Mesh(mesh)
    , Grid(grid)
    , Entries(static_cast<std::size_t>(mesh.GetNumberOfPoints()))
  {
    ParallelForEach(mesh.GetNumberOfPoints(), MediumGrain,
      [&](vtkIdType point)
      {
        const Vector place = mesh.GetPoint(point);
        const bool counts =
          std::isfinite(PointGrid::GetSize(place)) && (isLeftOut.empty() || !isLeftOut[point]);
        this->Entries[point] = { counts ? grid.GetHash(place) : 0, numbers(point),
          counts ? point : -1 };
      });
    WithThreads([this] { vtkSMPTools::Sort(this->Entries.begin(), this->Entries.end()); });
  }

  /// The lowest id within reach of a point, or -1 if there is only the point itself.
  vtkIdType FindLowest(vtkIdType point) const
  {
    const Vector place = this->Mesh.GetPoint(point);
    if (!std::isfinite(PointGrid::GetSize(place)))
    {
      return -1;
    }
    vtkIdType lowest = -1;
    bool hasOther = false;
    this->Grid.ForNear(
      place, [&](std::uint64_t bucket) { this->Search(bucket, point, place, lowest, hasOther); });
    return hasOther ? lowest : -1;
  }

private:
  // A bucket is in the order of ids: its lowest is the first within reach; a second one shows that
  // there is another point.
  void Search(std::uint64_t bucket, vtkIdType point, const Vector& place, vtkIdType& lowest,
    bool& hasOther) const
  {
    auto entry = std::lower_bound(this->Entries.begin(), this->Entries.end(), bucket,
      [](const Entry& known, std::uint64_t wanted) { return known.Bucket < wanted; });
    bool isFirst = true;
    for (; entry != this->Entries.end() && entry->Bucket == bucket; ++entry)
    {
      if (entry->Point < 0 || !this->Grid.AreNear(place, this->Mesh.GetPoint(entry->Point)))
      {
        continue;
      }
      hasOther = hasOther || entry->Point != point;
      if (isFirst)
      {
        lowest = lowest < 0 ? entry->Id : std::min(lowest, entry->Id);
        isFirst = false;
      }
      if (hasOther)
      {
        return;
      }
    }
  }

  const MeshView& Mesh;
  const PointGrid& Grid;
  std::vector<Entry> Entries;
};
}

//------------------------------------------------------------------------------
vtkIdType PointNumbers::operator()(vtkIdType point) const
{
  return this->Array ? static_cast<vtkIdType>(this->Array->GetComponent(point, 0))
    : this->Ids      ? this->Ids[point]
                     : this->First + point;
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> FindCoincidentPoints(const MeshView& mesh, double tolerance,
  const PointNumbers& numbers, const std::vector<unsigned char>& isLeftOut)
{
  double largest = 0;
  for (vtkIdType point = 0; point < mesh.GetNumberOfPoints(); ++point)
  {
    const double size = PointGrid::GetSize(mesh.GetPoint(point));
    largest = std::isfinite(size) ? std::max(largest, size) : largest;
  }
  const PointGrid grid(tolerance, mesh.HasFloatPoints(), largest);
  return FindCoincidentPoints(mesh, grid, numbers, isLeftOut);
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> FindCoincidentPoints(const MeshView& mesh, const PointGrid& grid,
  const PointNumbers& numbers, const std::vector<unsigned char>& isLeftOut)
{
  const PointBuckets buckets(mesh, grid, numbers, isLeftOut);
  std::vector<vtkIdType> lowest(static_cast<std::size_t>(mesh.GetNumberOfPoints()));
  ParallelForEach(mesh.GetNumberOfPoints(), MediumGrain,
    [&](vtkIdType point) { lowest[point] = buckets.FindLowest(point); });
  return lowest;
}
}
