// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/FacetKey.h"

namespace camaron
{
namespace
{
constexpr vtkIdType MaxUnsorted = 12; // points of a facet that are compared pair by pair

//------------------------------------------------------------------------------
bool HasRepeatedPoints(const vtkIdType* points, vtkIdType size)
{
  bool isRepeated = false;
  for (vtkIdType i = 1; i < size; ++i)
  {
    for (vtkIdType j = 0; j < i; ++j)
    {
      isRepeated |= points[i] == points[j];
    }
  }
  return isRepeated;
}

//------------------------------------------------------------------------------
std::uint32_t Part(vtkIdType id)
{
  return static_cast<std::uint32_t>(id);
}

void Order(vtkIdType& low, vtkIdType& high)
{
  const vtkIdType smaller = std::min(low, high);
  high = std::max(low, high);
  low = smaller;
}

//------------------------------------------------------------------------------
// Of more than four different points, in whatever order.
FacetKey MakeHashedKey(const vtkIdType* points, vtkIdType size, bool down)
{
  std::uint64_t sum = 0;
  for (vtkIdType i = 0; i < size; ++i)
  {
    sum += FacetKey::Mix(1, static_cast<std::uint64_t>(points[i]));
  }
  const std::uint64_t hash = FacetKey::Mix(sum, static_cast<std::uint64_t>(size));
  return { Part(GetSmallest(points, size)),
    { static_cast<std::uint32_t>(hash), static_cast<std::uint32_t>(hash >> 32),
      FacetKey::HashedBit | static_cast<std::uint32_t>(FacetKey::Mix(hash, 1) >> 33) },
    down };
}
}

//------------------------------------------------------------------------------
// Sorting is for the rare facets that come to a point twice. Of others its branches would be as hard to foresee as
// the numbering of the points.
FacetKey MakeKeyOfAny(const vtkIdType* points, vtkIdType size, std::vector<vtkIdType>& sorted)
{
  const bool down = RunsDown(points, size);
  if (size > 4 && size <= MaxUnsorted && !HasRepeatedPoints(points, size))
  {
    return MakeHashedKey(points, size, down);
  }
  if (size == 4)
  {
    vtkIdType a = points[0], b = points[1], c = points[2], d = points[3];
    Order(a, b), Order(c, d), Order(a, c), Order(b, d), Order(b, c);
    if (a != b && b != c && c != d)
    {
      return { Part(a), { Part(b), Part(c), Part(d) }, down };
    }
  }
  sorted.assign(points, points + size);
  SortDistinct(sorted);
  const std::uint32_t smallest = Part(sorted[0]);
  switch (sorted.size())
  {
    case 1:
      return { smallest, { 0, 0, FacetKey::OnePoint }, down };
    case 2:
      return { smallest, { Part(sorted[1]), 0, FacetKey::TwoPoints }, down };
    case 3:
      return { smallest, { Part(sorted[1]), Part(sorted[2]), FacetKey::ThreePoints }, down };
    case 4:
      return { smallest, { Part(sorted[1]), Part(sorted[2]), Part(sorted[3]) }, down };
    default:
      return MakeHashedKey(sorted.data(), static_cast<vtkIdType>(sorted.size()), down);
  }
}
}
