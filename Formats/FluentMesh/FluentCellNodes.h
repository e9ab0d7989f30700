// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FluentCellNodes.h
 * @brief Nodes of cells of standard types, found face by face.
 *
 * Each function adds a face to what is known of a cell: its nodes, of which there is room for as
 * many as the type has, and a state, which is 0 before the first face. All take ids of nodes other
 * than 0. They are false if the faces are not those of such a cell, or do not run as neighbours do.
 */
#ifndef camaron_FluentCellNodes_h
#define camaron_FluentCellNodes_h

#include <cstdint> // for ids

namespace camaron
{
using FluentCellState = std::uint32_t;
/// The state of a cell, other than a tetrahedron, that has all its faces; its nodes are in VTK's
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
 * Until the end the nodes are the sums (modulo 2^31) of the faces that lack them, with a bit for
 * the direction of the face. As sums of wrong faces may look right, the state is a checksum of the
 * nodes of all faces, with the number of faces in its low bits.
 */
namespace FluentTetrahedron
{
constexpr std::uint32_t SumMask = 0x7fffffff;
constexpr int CountBits = 3;
constexpr FluentCellState CountMask = (1 << CountBits) - 1;
/// Which node a face lacks, in the order in which faces come, as in VTK's list of the faces.
constexpr unsigned char Lacking[4] = { 2, 0, 1, 3 };
/// Tell faces that lack different nodes apart; any odd numbers would do.
constexpr std::uint32_t Factors[4] = { 0x9e3779b1, 0x85ebca77, 0xc2b2ae3d, 0x27d4eb2f };

/// A number that looks random; sums of these are the same only for the same nodes.
inline std::uint32_t Mix(std::uint32_t node)
{
  const std::uint64_t x = node * std::uint64_t(0x9e3779b97f4a7c15);
  return static_cast<std::uint32_t>((x ^ x >> 29) * std::uint64_t(0xbf58476d1ce4e5b9) >> 32);
}

/// What a tetrahedron needs to know of a face.
struct Face
{
  Face() = default;
  explicit Face(const std::int32_t* nodes)
  {
    const auto a = static_cast<std::uint32_t>(nodes[0]), b = static_cast<std::uint32_t>(nodes[1]),
               c = static_cast<std::uint32_t>(nodes[2]);
    const bool isOdd = ((a > b) != (b > c)) != (a > c);
    this->Sum = ((a + b + c) & SumMask) | (isOdd ? ~SumMask : 0u);
    this->Check = Mix(a) + Mix(b) + Mix(c);
  }
  std::uint32_t Sum = 0, Check = 0;
};

/// Adds a face; the normal points inside on side 0. False if there are four.
inline bool Add(std::int32_t* nodes, FluentCellState& state, const Face& face, int side)
{
  const std::uint32_t count = state & CountMask;
  if (count > 3)
  {
    return false;
  }
  nodes[Lacking[count]] =
    static_cast<std::int32_t>(face.Sum ^ static_cast<std::uint32_t>(side) << 31);
  state += (face.Check * Factors[count] << CountBits) + 1;
  return true;
}

/// Finds the nodes when all faces were added; false if these were not those of a tetrahedron, run
/// otherwise than neighbours do, or have nodes other than those from 1 to @a maxNode.
bool Finish(std::int32_t* nodes, FluentCellState state, std::int64_t maxNode);
}
}

#endif
