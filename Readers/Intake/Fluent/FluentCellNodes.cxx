// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentCellNodes.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Sets a node if it is 0, which means unknown; false if it is another one.
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
// The first face is the bottom, nodes 0 to 3; the bits of the state are the sides at its edges, the
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
  int low[4]; // index of each node in the bottom, or -1
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
    // A side runs along its edge of the bottom in the opposite direction.
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
