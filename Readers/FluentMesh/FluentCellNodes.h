// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FluentCellNodes.h
 * @brief Nodes of cells of standard types, found face by face.
 *
 * Each function adds a face to what is known of a cell: its nodes, of which there is room for as
 * many as the type has, and a state, which is 0 before the first face. All take ids of nodes other
 * than 0. They are false if the faces are not those of such a cell, or do not run as neighbors do.
 */
#ifndef camaron_FluentCellNodes_h
#define camaron_FluentCellNodes_h

#include <cstdint> // for ids

namespace camaron
{
using FluentCellState = std::uint32_t;
/// The state of a cell that has all its faces; its nodes are in VTK's
/// order.
constexpr FluentCellState FluentCellComplete = 0xff;

/// Adds an edge, which has the cell on its left, to one of @a size edges, 3 or 4. The first is that
/// from node 0 to node 1.
bool AddToRing(
  std::int32_t* nodes, int size, FluentCellState& state, std::int32_t from, std::int32_t to);
/// Adds a face whose normal points inside. The first is the bottom.
bool AddToHexahedron(std::int32_t* nodes, FluentCellState& state, const std::int32_t* face);

/**
 * A tetrahedron from sums: each face lacks one of the nodes, so that the sum of the ids of its
 * nodes says which one as soon as the sum of all is known. There is nothing to look for, and
 * nothing to decide but at the end, which is what makes it fast: a mesh has two faces per
 * tetrahedron, in any order, and a processor guesses wrongly what follows from that.
 *
 * Until the end the nodes are the sums of the faces, modulo 2^31, with the sign of what is checked.
 * As sums of wrong faces may look right, the state is a checksum of the nodes of all faces, with
 * the number of faces in its low bits. A face that runs the other way has the negative checksum.
 */
namespace FluentTetrahedron
{
constexpr std::uint32_t SumMask = 0x7fffffff;
constexpr int CountBits = 3;
constexpr FluentCellState CountMask = (1 << CountBits) - 1;
/// Tell faces that lack different nodes apart; any odd numbers would do.
constexpr std::uint32_t Factors[4] = { 0x9e3779b1, 0x85ebca77, 0xc2b2ae3d, 0x27d4eb2f };

/// A number that looks random.
inline std::uint32_t Mix(std::uint32_t node)
{
  return static_cast<std::uint32_t>(node * HashFactor >> 32);
}
/// Changes its sign with the direction of three nodes, whichever is the first; of mixed numbers.
inline std::uint32_t GetCheck(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
  return (a - b) * (b - c) * (c - a);
}

/// What a tetrahedron needs to know of a face, whose normal points inside.
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

/// Adds a face; false if there are four.
inline bool Add(std::int32_t* nodes, FluentCellState& state, const Face& face)
{
  const FluentCellState count = state & CountMask;
  if (count > 3)
  {
    return false;
  }
  nodes[count] = static_cast<std::int32_t>(face.Sum);
  state += (face.Check * Factors[count] << CountBits) + 1;
  return true;
}

/// Finds the nodes when all faces were added; false if these were not those of a tetrahedron, or
/// run otherwise than neighbors do. The nodes may be any then. Among millions some checksum is
/// that of both directions, in which case the first face decides.
inline bool Finish(std::int32_t* nodes, FluentCellState state)
{
  constexpr std::uint32_t Third = 0x2aaaaaab; // 3 * Third = 1 modulo 2^31
  const auto s0 = static_cast<std::uint32_t>(nodes[0]), s1 = static_cast<std::uint32_t>(nodes[1]),
             s2 = static_cast<std::uint32_t>(nodes[2]), s3 = static_cast<std::uint32_t>(nodes[3]);
  const std::uint32_t sum = (s0 + s1 + s2 + s3) * Third;
  // As in VTK's list of the faces: the first lacks node 2, then 0, 1 and 3.
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
