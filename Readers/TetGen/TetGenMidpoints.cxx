// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TetGenMidpoints.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
constexpr int Edges[6][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };

int GetNumberOfEdges(int corners)
{
  return corners == 4 ? 6 : 3;
}

//------------------------------------------------------------------------------
double GetDistance(const double* a, const double* b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}
}

//------------------------------------------------------------------------------
TetGenMidpointOrder GetUsualMidpointOrder(int corners)
{
  return corners == 4 ? TetGenMidpointOrder{ 2, 3, 5, 1, 4, 0 }
                      : TetGenMidpointOrder{ 2, 0, 1, 0, 0, 0 };
}

//------------------------------------------------------------------------------
bool FindMidpointOrder(int corners, const double (*x)[3], TetGenMidpointOrder& order)
{
  const int edges = GetNumberOfEdges(corners);
  const TetGenMidpointOrder usual = GetUsualMidpointOrder(corners);
  order = usual;
  double distances[6][6]; // from the middle of an edge to a node
  double lengths[6];
  for (int edge = 0; edge < edges; ++edge)
  {
    const double* const a = x[Edges[edge][0]];
    const double* const b = x[Edges[edge][1]];
    const double middle[3] = { (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2 };
    lengths[edge] = GetDistance(a, b);
    for (int node = 0; node < edges; ++node)
    {
      distances[edge][node] = GetDistance(middle, x[corners + node]);
    }
  }
  // Curved edges need not pass exactly through their middle, but close to it. In flat cells the
  // middles of two edges may coincide; then the usual order is as good as any.
  constexpr double Near = 0.25, Rounding = 1e-6; // of the length of the edge
  TetGenMidpointOrder nearest = usual;
  bool isUsual = true, isGood = true;
  unsigned int used = 0;
  for (int edge = 0; edge < edges; ++edge)
  {
    const double* const begin = distances[edge];
    const int best = static_cast<int>(std::min_element(begin, begin + edges) - begin);
    const double limit = Near * lengths[edge];
    isUsual = isUsual && begin[usual[edge]] <= begin[best] + Rounding * lengths[edge] &&
      begin[usual[edge]] <= limit;
    isGood = isGood && begin[best] <= limit && (used >> best & 1) == 0;
    used |= 1u << best;
    nearest[edge] = best;
  }
  if (!isUsual && isGood)
  {
    order = nearest;
  }
  return isUsual || isGood;
}

//------------------------------------------------------------------------------
void OrderMidpoints(CellMesh& mesh, int corners, const TetGenMidpointOrder& order)
{
  const int edges = GetNumberOfEdges(corners);
  constexpr vtkIdType Grain = 65536;
  ParallelFor(mesh.NumberOfCells, Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        std::int32_t* const nodes = mesh.Connectivity.data() + cell * (corners + edges) + corners;
        std::int32_t file[6];
        std::copy(nodes, nodes + edges, file);
        for (int edge = 0; edge < edges; ++edge)
        {
          nodes[edge] = file[order[edge]];
        }
      }
    });
}
}
