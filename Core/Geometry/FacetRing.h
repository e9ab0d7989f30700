// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FacetRing.h
 * @brief Compares the directions of rings of points, regardless of where they begin.
 */
#ifndef camaron_FacetRing_h
#define camaron_FacetRing_h

#include "vtkType.h" // for vtkIdType

#include <algorithm> // for std::min

namespace camaron
{
/// The points of a facet in borrowed memory.
struct FacetPoints
{
  const vtkIdType* Points;
  vtkIdType Size;
  vtkIdType operator[](vtkIdType i) const { return this->Points[i]; }
};

/// The start of the lexicographically smallest rotation of a ring of values, at(0) to at(size - 1).
template <typename At>
vtkIdType FindLeastRotation(vtkIdType size, At&& at)
{
  const auto get = [&](vtkIdType i) { return at(i < size ? i : i - size); };
  vtkIdType a = 0, b = 1, common = 0; // candidates, and the number of equal values at their
                                      // beginning
  while (a < size && b < size && common < size)
  {
    const auto first = get(a + common), second = get(b + common);
    if (first == second)
    {
      ++common;
      continue;
    }
    (second < first ? a : b) += common + 1;
    b += a == b;
    common = 0;
  }
  return std::min(a, b);
}

/// RingRunsDown for a ring with repeated values: whether it is lexicographically larger than its
/// reverse.
template <typename At>
bool RepeatingRingRunsDown(vtkIdType size, At&& at)
{
  const auto back = [&](vtkIdType i) { return at(size - 1 - i); };
  vtkIdType forth = FindLeastRotation(size, at), other = FindLeastRotation(size, back);
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (at(forth) != back(other))
    {
      return at(forth) > back(other);
    }
    forth = forth + 1 < size ? forth + 1 : 0;
    other = other + 1 < size ? other + 1 : 0;
  }
  return false;
}

/**
 * Whether a ring of more than two values, at(0) to at(size - 1), goes from its smallest value to
 * the larger one of its neighbors; two rings with the same values therefore have the same result
 * if they have the same direction.
 */
template <typename At>
bool RingRunsDown(vtkIdType size, At&& at)
{
  vtkIdType smallest = 0;
  auto least = at(0);
  bool isRepeated = false;
  for (vtkIdType i = 1; i < size; ++i)
  {
    const auto value = at(i);
    const bool isSmaller = value < least;
    isRepeated = !isSmaller & (isRepeated | (value == least));
    smallest = isSmaller ? i : smallest;
    least = isSmaller ? value : least;
  }
  const vtkIdType next = smallest + 1 < size ? smallest + 1 : 0;
  const vtkIdType previous = smallest > 0 ? smallest - 1 : size - 1;
  if (isRepeated || at(next) == at(previous))
  {
    return RepeatingRingRunsDown(size, at);
  }
  return at(next) > at(previous);
}

/// Whether two rings of points are the same, in either direction and wherever they begin, also if
/// points are repeated.
template <typename Points>
bool AreSameRings(const Points& a, const Points& b)
{
  const vtkIdType size = a.Size;
  const auto forth = [&a](vtkIdType i) { return a[i]; };
  const auto areSame = [&](auto&& other)
  {
    const vtkIdType first = FindLeastRotation(size, forth), second = FindLeastRotation(size, other);
    bool result = true;
    for (vtkIdType i = 0; result && i < size; ++i)
    {
      result = forth((first + i) % size) == other((second + i) % size);
    }
    return result;
  };
  return b.Size == size &&
    (areSame([&b](vtkIdType i) { return b[i]; }) ||
      areSame([&b, size](vtkIdType i) { return b[size - 1 - i]; }));
}

/// RingRunsDown for the points of a polygon or an edge.
inline bool RunsDown(const vtkIdType* points, vtkIdType size)
{
  return size == 2 ? points[0] > points[1]
                   : RingRunsDown(size, [=](vtkIdType i) { return points[i]; });
}

/// Converts a list of points to sorted distinct points.
template <typename Points>
void SortDistinct(Points& points)
{
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
}
}

#endif
