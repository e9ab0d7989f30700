// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentCellNodes.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Sets a node that is 0 as long as it is not known.
bool Agree(std::int32_t& known, std::int32_t node)
{
  known = known == 0 ? node : known;
  return known == node;
}

//------------------------------------------------------------------------------
bool AreDistinct(const std::int32_t* nodes, int count)
{
  bool good = true;
  for (int i = 0; i < count; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      good &= nodes[i] != nodes[j];
    }
  }
  return good;
}
}

//------------------------------------------------------------------------------
bool AddToRing(
  std::int32_t* nodes, int size, FluentCellState& state, std::int32_t from, std::int32_t to)
{
  int edge = 0;
  bool good = true;
  if (state == 0)
  {
    std::fill(nodes, nodes + size, 0);
    nodes[0] = from;
    nodes[1] = to;
  }
  else if (from == nodes[1])
  {
    edge = 1;
    good = Agree(nodes[2], to);
  }
  else if (to == nodes[0])
  {
    edge = size - 1;
    good = Agree(nodes[edge], from);
  }
  else
  {
    edge = 2;
    good = size == 4 && Agree(nodes[2], from) && Agree(nodes[3], to);
  }
  const auto bit = static_cast<FluentCellState>(1 << edge);
  good = good && !(state & bit);
  state |= bit;
  if (state == (1 << size) - 1)
  {
    good = good && AreDistinct(nodes, size);
    state = FluentCellComplete;
  }
  return good;
}

//------------------------------------------------------------------------------
// Until it is complete, nodes 0 to 2 are the first face, and the state is the number of faces and
// which of these nodes the second and the third face lack.
bool AddToTetrahedron(std::int32_t* nodes, FluentCellState& state, const std::int32_t* face)
{
  if (state == 0)
  {
    std::copy(face, face + 3, nodes);
    nodes[3] = 0;
    state = 1;
    return AreDistinct(face, 3);
  }
  unsigned int found = 0;
  std::int32_t fourth = 0;
  for (int i = 0; i < 3; ++i)
  {
    const std::int32_t id = face[i];
    const unsigned int which =
      (id == nodes[0] ? 1u : 0u) | (id == nodes[1] ? 2u : 0u) | (id == nodes[2] ? 4u : 0u);
    found |= which;
    fourth = which ? fourth : id;
  }
  const int lacking = found == 6 ? 0 : found == 5 ? 1 : found == 3 ? 2 : 3;
  if (lacking == 3 || fourth == 0 || !Agree(nodes[3], fourth))
  {
    return false;
  }
  constexpr int Last = 3;
  const int count = state & 3, second = state >> 2 & 3, third = state >> 4;
  if (count < Last)
  {
    state = static_cast<FluentCellState>(
      (count + 1) | (count == 1 ? lacking << 2 : second << 2 | lacking << 4));
    return true;
  }
  // As in VTK's list of the faces, the first lacks node 2, the others lack 0, 1 and 3, or in the
  // mirror image 0, 3 and 1.
  const std::int32_t base[3] = { nodes[0], nodes[1], nodes[2] };
  const bool isMirrored = second != (third + 1) % 3;
  nodes[2] = fourth;
  nodes[0] = base[second];
  nodes[isMirrored ? 3 : 1] = base[third];
  nodes[isMirrored ? 1 : 3] = base[lacking];
  state = FluentCellComplete;
  return second != third && lacking != second && lacking != third;
}

//------------------------------------------------------------------------------
// The first face is the bottom, nodes 0 to 3; bits of the state are the sides at its edges, the
// bottom and the top.
bool AddToHexahedron(std::int32_t* nodes, FluentCellState& state, const std::int32_t* face)
{
  constexpr FluentCellState Sides = 0x0f, Bottom = 0x10, Top = 0x20;
  std::int32_t* const high = nodes + 4;
  if (state == 0)
  {
    std::copy(face, face + 4, nodes);
    std::fill(high, high + 4, 0);
    state = Bottom;
    return true;
  }
  int low[4]; // which nodes of the bottom these are, or -1
  int first = -1;
  for (int i = 0; i < 4; ++i)
  {
    const std::int32_t id = face[i];
    low[i] = id == nodes[0] ? 0 : id == nodes[1] ? 1 : id == nodes[2] ? 2 : id == nodes[3] ? 3 : -1;
  }
  for (int i = 0; i < 4; ++i)
  {
    first =
      low[i] >= 0 && low[i] == ((low[(i + 1) & 3] + 1) & 3) && low[(i + 1) & 3] >= 0 ? i : first;
  }
  bool good = true;
  if (first >= 0)
  {
    // A side runs along its edge of the bottom the other way.
    const int a = low[(first + 1) & 3], b = low[first];
    const std::int32_t overA = face[(first + 2) & 3], overB = face[(first + 3) & 3];
    const auto bit = static_cast<FluentCellState>(1 << a);
    good = low[(first + 2) & 3] < 0 && low[(first + 3) & 3] < 0 && !(state & bit);
    if (!(state & Sides) && (state & Top))
    {
      std::int32_t* const start = std::find(high, high + 4, overA);
      std::rotate(high, start == high + 4 ? high : start, high + 4);
      std::rotate(high, high + (4 - a), high + 4);
    }
    good = good && Agree(high[a], overA) && Agree(high[b], overB);
    state |= bit;
  }
  else
  {
    const std::int32_t top[4] = { face[0], face[3], face[2], face[1] };
    int turn = 0;
    for (int i = 0; i < 4; ++i)
    {
      for (int j = 0; j < 4; ++j)
      {
        turn = high[i] == top[j] ? (j - i) & 3 : turn;
      }
    }
    good = !(state & Top);
    for (int i = 0; i < 4; ++i)
    {
      good = good && low[i] < 0 && Agree(high[i], top[(i + turn) & 3]);
    }
    state |= Top;
  }
  if (state == (Sides | Bottom | Top))
  {
    good = good && AreDistinct(nodes, 8);
    state = FluentCellComplete;
  }
  return good;
}
}
