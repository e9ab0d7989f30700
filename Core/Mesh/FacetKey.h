// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FacetKey
 * @brief What tells a facet from others: its smallest point, and of up to four points the other ones, of more a hash.
 *
 * Does not depend on the point at which a facet begins, nor on its direction.
 */
#ifndef camaron_FacetKey_h
#define camaron_FacetKey_h

#include "vtkType.h" // for vtkIdType

#include <algorithm> // for std::min
#include <cstdint>   // for the parts
#include <vector>    // for scratch

namespace camaron
{
struct FacetKey
{
  ///@{
  /// Values of the last part where it is not the fourth point.
  static constexpr std::uint32_t HashedBit = 0x80000000u;
  static constexpr std::uint32_t ThreePoints = 0x7fffffffu;
  static constexpr std::uint32_t TwoPoints = 0x7ffffffeu;
  static constexpr std::uint32_t OnePoint = 0x7ffffffdu;
  ///@}
  /// Of a mesh; larger ids would be such values.
  static constexpr vtkIdType MaxPoints = (vtkIdType(1) << 31) - 16;

  std::uint32_t Smallest;
  std::uint32_t Parts[3];
  std::uint32_t Down; ///< 1 or 0, see RunsDown

  /// Equal keys of this kind may have different points.
  bool IsHashed() const { return (this->Parts[2] & HashedBit) != 0; }
  std::uint64_t GetHash() const
  {
    return Mix(Mix(1, Join(this->Smallest, this->Parts[0])), Join(this->Parts[1], this->Parts[2]));
  }
  bool operator==(const FacetKey& other) const
  {
    return this->Smallest == other.Smallest && this->Parts[0] == other.Parts[0] &&
      this->Parts[1] == other.Parts[1] && this->Parts[2] == other.Parts[2];
  }

  static std::uint64_t Mix(std::uint64_t hash, std::uint64_t value)
  {
    hash = (hash ^ value) * 0x9e3779b97f4a7c15ull;
    return hash ^ (hash >> 29);
  }

private:
  static std::uint64_t Join(std::uint32_t a, std::uint32_t b)
  {
    return static_cast<std::uint64_t>(a) << 32 | b;
  }
};

/// Where a ring of values, at(0) to at(size - 1), begins if it is read so that it is the first of all in the dictionary.
template <typename At>
vtkIdType FindLeastRotation(vtkIdType size, At&& at)
{
  const auto get = [&](vtkIdType i) { return at(i < size ? i : i - size); };
  vtkIdType a = 0, b = 1, common = 0; // candidates, and how many values they have in common
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

/// RingRunsDown of a ring that comes to its smallest value more than once: whether it comes later in the dictionary than
/// the other way round.
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
 * True when a ring of more than two values, at(0) to at(size - 1), runs from its smallest one towards the larger of
 * that one's neighbours; so two rings with the same values have equal signs when they run the same way.
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
  if (isRepeated)
  {
    return RepeatingRingRunsDown(size, at);
  }
  const vtkIdType next = smallest + 1 < size ? smallest + 1 : 0;
  const vtkIdType previous = smallest > 0 ? smallest - 1 : size - 1;
  return at(next) > at(previous);
}

/// The same of the points of a polygon or an edge.
inline bool RunsDown(const vtkIdType* points, vtkIdType size)
{
  return size == 2 ? points[0] > points[1]
                   : RingRunsDown(size, [=](vtkIdType i) { return points[i]; });
}

/// Of at least one point.
inline vtkIdType GetSmallest(const vtkIdType* points, vtkIdType size)
{
  if (size == 3)
  {
    return std::min(points[0], std::min(points[1], points[2]));
  }
  vtkIdType smallest = points[0];
  for (vtkIdType i = 1; i < size; ++i)
  {
    smallest = std::min(smallest, points[i]);
  }
  return smallest;
}

/// Turns a point list into sorted distinct points.
template <typename Points>
void SortDistinct(Points& points)
{
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

///@{
/**
 * The key of at least one point, in whatever order; the list is overwritten. The second one is quick for triangles. It
 * writes the key where it stays: a processor waits for copies in wider pieces than it has just written.
 */
FacetKey MakeKeyOfAny(const vtkIdType* points, vtkIdType size, std::vector<vtkIdType>& sorted);
inline void MakeKey(
  const vtkIdType* points, vtkIdType size, std::vector<vtkIdType>& scratch, FacetKey& key)
{
  if (size == 3)
  {
    // An odd number of inversions means that the triangle runs from its smallest point to the largest one.
    const vtkIdType a = points[0], b = points[1], c = points[2];
    const vtkIdType low = std::min(a, std::min(b, c)), high = std::max(a, std::max(b, c));
    const vtkIdType middle = a + b + c - low - high;
    const auto part = [](vtkIdType id) { return static_cast<std::uint32_t>(id); };
    const bool down = (a > b) ^ (b > c) ^ (a > c);
    if (low != middle && middle != high)
    {
      key.Smallest = part(low);
      key.Parts[0] = part(middle);
      key.Parts[1] = part(high);
      key.Parts[2] = FacetKey::ThreePoints;
      key.Down = down;
      return;
    }
  }
  key = MakeKeyOfAny(points, size, scratch);
}
///@}
}

#endif
