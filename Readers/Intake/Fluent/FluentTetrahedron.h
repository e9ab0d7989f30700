// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FluentTetrahedron.h
 * @brief The nodes of a tetrahedron, derived face by face.
 */
#ifndef camaron_FluentTetrahedron_h
#define camaron_FluentTetrahedron_h

#include "Base/Hash.h"

#include <cstdint> // for ids

namespace camaron
{
/**
 * Finds the nodes of a tetrahedron from sums: each face lacks one of the nodes, so the sum of its
 * node ids identifies that node once the sum of all is known. There are no searches, and no
 * branches except at the end, which makes it fast: a mesh has two faces per tetrahedron, in any
 * order, which defeats branch prediction.
 *
 * Node ids must not be 0. Until the end the nodes are the sums of the faces, modulo 2^31, with the
 * sign of the checksum. As sums of wrong faces may look valid, the state, 0 before the first face,
 * is a checksum of the nodes of all faces, with the number of faces in its low bits. A face of the
 * opposite orientation has the negative checksum.
 */
namespace FluentTetrahedron
{
constexpr std::uint32_t SumMask = 0x7fffffff;
constexpr int CountBits = 3;
constexpr std::uint32_t CountMask = (1 << CountBits) - 1;
/// Distinguish faces that lack different nodes; any odd numbers will do.
constexpr std::uint32_t Factors[4] = { 0x9e3779b1, 0x85ebca77, 0xc2b2ae3d, 0x27d4eb2f };

/// Hash function.
inline std::uint32_t Mix(std::uint32_t node)
{
  return static_cast<std::uint32_t>(node * HashFactor >> 32);
}
/// Changes its sign with the orientation of three nodes, whichever is first; for hashed ids.
inline std::uint32_t GetCheck(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
  return (a - b) * (b - c) * (c - a);
}

/// The data of a face, whose normal points inward, that a tetrahedron needs.
struct Face
{
  std::uint32_t Sum, Check;

  static Face Of(std::int32_t a, std::int32_t b, std::int32_t c)
  {
    const auto x = static_cast<std::uint32_t>(a), y = static_cast<std::uint32_t>(b),
               z = static_cast<std::uint32_t>(c);
    const std::uint32_t check = GetCheck(Mix(x), Mix(y), Mix(z));
    return { ((x + y + z) & SumMask) | (check & ~SumMask), check };
  }
};

/// Adds a face; false if there are four already.
inline bool Add(std::int32_t* nodes, std::uint32_t& state, const Face& face)
{
  const std::uint32_t count = state & CountMask;
  if (count > 3)
  {
    return false;
  }
  nodes[count] = static_cast<std::int32_t>(face.Sum);
  state += (face.Check * Factors[count] << CountBits) + 1;
  return true;
}

/// Determines the nodes when all faces have been added; false if they do not form a tetrahedron or
/// are oriented inconsistently; the nodes are then undefined. Among millions of cells, a checksum
/// may match both orientations; then the first face decides.
inline bool Finish(std::int32_t* nodes, std::uint32_t state)
{
  constexpr std::uint32_t Third = 0x2aaaaaab; // 3 * Third = 1 modulo 2^31
  const auto s0 = static_cast<std::uint32_t>(nodes[0]), s1 = static_cast<std::uint32_t>(nodes[1]),
             s2 = static_cast<std::uint32_t>(nodes[2]), s3 = static_cast<std::uint32_t>(nodes[3]);
  const std::uint32_t sum = (s0 + s1 + s2 + s3) * Third;
  // In the order of VTK's faces: the first lacks node 2, then 0, 1 and 3.
  const std::uint32_t n0 = (sum - s1) & SumMask, n1 = (sum - s2) & SumMask,
                      n2 = (sum - s0) & SumMask, n3 = (sum - s3) & SumMask;
  const std::uint32_t m0 = Mix(n0), m1 = Mix(n1), m2 = Mix(n2), m3 = Mix(n3);
  const std::uint32_t first = GetCheck(m0, m1, m3);
  const std::uint32_t outside = Factors[0] * first + Factors[1] * GetCheck(m1, m2, m3) +
    Factors[2] * GetCheck(m2, m0, m3) + Factors[3] * GetCheck(m0, m2, m1);
  const bool isPositive = state == ((0u - outside) << CountBits | 4);
  const bool mayBeMirrored = state == (outside << CountBits | 4);
  const bool isMirrored = mayBeMirrored && !(isPositive && (s0 ^ first) > SumMask);
  const std::uint32_t other = (n1 ^ n3) & (0u - static_cast<std::uint32_t>(isMirrored));
  nodes[0] = static_cast<std::int32_t>(n0);
  nodes[1] = static_cast<std::int32_t>(n1 ^ other);
  nodes[2] = static_cast<std::int32_t>(n2);
  nodes[3] = static_cast<std::int32_t>(n3 ^ other);
  return isPositive || mayBeMirrored;
}
}
}

#endif
