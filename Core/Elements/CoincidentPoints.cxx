// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Elements/CoincidentPoints.h"

#include "Mesh/Vector.h"
#include "Parallel.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <tuple>

namespace camaron
{
namespace
{
constexpr vtkIdType Grain = 4096;
constexpr double RoundingUnits = 8; // quality criteria, section 1

//------------------------------------------------------------------------------
// A point in a bucket, all points of a cube of space.
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
// Looks points up by their places. Two cubes may share a bucket: distances are compared in any case.
class PointBuckets
{
public:
  PointBuckets(const MeshView& mesh, double tolerance, vtkDataArray* ids)
    : Mesh(mesh)
    , Tolerance(tolerance)
    , Rounding(RoundingUnits *
        (mesh.HasFloatPoints() ? std::numeric_limits<float>::epsilon()
                               : std::numeric_limits<double>::epsilon()))
    , Entries(static_cast<std::size_t>(mesh.GetNumberOfPoints()))
  {
    double largest = 0;
    for (vtkIdType point = 0; point < mesh.GetNumberOfPoints(); ++point)
    {
      const double size = GetSize(this->GetPoint(point));
      largest = std::isfinite(size) ? std::max(largest, size) : largest;
    }
    // Few points have neighbours of their cube within reach, and numbers of cubes are exact.
    constexpr double CubesPerReach = 8;
    this->Reach = std::max(tolerance, this->Rounding * largest);
    this->Cube = this->Reach > 0 ? CubesPerReach * this->Reach : 1;
    ParallelFor(mesh.GetNumberOfPoints(), Grain,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType point = begin; point < end; ++point)
        {
          const Vector place = this->GetPoint(point);
          const vtkIdType id = ids ? static_cast<vtkIdType>(ids->GetComponent(point, 0)) : point;
          const bool isFinite = std::isfinite(GetSize(place));
          this->Entries[point] = { isFinite ? this->GetBucket(place) : 0, id, isFinite ? point : -1 };
        }
      });
    WithThreads([this] { vtkSMPTools::Sort(this->Entries.begin(), this->Entries.end()); });
  }

  /// The lowest id within reach of a point, or -1 if there is only the point itself.
  vtkIdType FindLowest(vtkIdType point) const
  {
    const Vector place = this->GetPoint(point);
    if (!std::isfinite(GetSize(place)))
    {
      return -1;
    }
    vtkIdType lowest = -1;
    bool hasOther = false;
    const Vector reach = { this->Reach, this->Reach, this->Reach };
    const Vector low = this->GetCube(place - reach), high = this->GetCube(place + reach);
    for (double x = low.X; x <= high.X; ++x)
    {
      for (double y = low.Y; y <= high.Y; ++y)
      {
        for (double z = low.Z; z <= high.Z; ++z)
        {
          this->Search(Hash({ x, y, z }), point, place, lowest, hasOther);
        }
      }
    }
    return hasOther ? lowest : -1;
  }

private:
  static double GetSize(const Vector& v)
  {
    const double sum = std::abs(v.X) + std::abs(v.Y) + std::abs(v.Z); // NaN if one is
    return std::isfinite(sum) ? std::max({ std::abs(v.X), std::abs(v.Y), std::abs(v.Z) }) : sum;
  }
  Vector GetPoint(vtkIdType point) const
  {
    double x[3];
    this->Mesh.GetPoint(point, x);
    return { x[0], x[1], x[2] };
  }
  Vector GetCube(const Vector& place) const
  {
    return { std::floor(place.X / this->Cube), std::floor(place.Y / this->Cube),
      std::floor(place.Z / this->Cube) };
  }
  std::uint64_t GetBucket(const Vector& place) const { return Hash(this->GetCube(place)); }
  static std::uint64_t Hash(const Vector& cube)
  {
    std::uint64_t hash = 0;
    for (const double number : { cube.X, cube.Y, cube.Z })
    {
      // The multiplier of Knuth's linear congruential generator MMIX.
      hash = (hash ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(number))) *
        6364136223846793005ull;
      hash ^= hash >> 32;
    }
    return hash;
  }

  // A bucket is in the order of ids: its lowest is the first within reach, and one more tells that there is another.
  void Search(std::uint64_t bucket, vtkIdType point, const Vector& place, vtkIdType& lowest,
    bool& hasOther) const
  {
    auto entry = std::lower_bound(this->Entries.begin(), this->Entries.end(), bucket,
      [](const Entry& known, std::uint64_t wanted) { return known.Bucket < wanted; });
    bool isFirst = true;
    for (; entry != this->Entries.end() && entry->Bucket == bucket; ++entry)
    {
      if (entry->Point < 0)
      {
        continue;
      }
      const Vector other = this->GetPoint(entry->Point);
      const double reach = this->Tolerance > 0
        ? this->Tolerance
        : this->Rounding * std::max(GetSize(place), GetSize(other));
      if (Norm(other - place) > reach)
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
  double Tolerance, Rounding;
  double Reach = 0; // of any point
  double Cube = 1;
  std::vector<Entry> Entries;
};
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> FindCoincidentPoints(
  const MeshView& mesh, double tolerance, vtkDataArray* ids)
{
  const PointBuckets buckets(mesh, tolerance, ids);
  std::vector<vtkIdType> lowest(static_cast<std::size_t>(mesh.GetNumberOfPoints()));
  ParallelFor(mesh.GetNumberOfPoints(), Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType point = begin; point < end; ++point)
      {
        lowest[point] = buckets.FindLowest(point);
      }
    });
  return lowest;
}
}
