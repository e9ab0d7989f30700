// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cell/Shapes.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Every point has three edges.
bool HasThreeEdgesPerPoint(const CellTopology& topology)
{
  int valences[MaxSimpleNodes] = {};
  for (const CellTopology::Edge& edge : topology.Edges)
  {
    ++valences[edge.Points[0]];
    ++valences[edge.Points[1]];
  }
  return std::all_of(
    valences, valences + topology.NumberOfPoints, [](int valence) { return valence == 3; });
}

//------------------------------------------------------------------------------
bool AreDistinct(const int* points, int size)
{
  for (int i = 1; i < size; ++i)
  {
    if (std::find(points, points + i, points[i]) != points + i)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
int FindFace(const CellTopology& topology, int size)
{
  int face = 0;
  while (topology.GetFaceSize(face) != size)
  {
    ++face;
  }
  return face;
}

//------------------------------------------------------------------------------
bool Contains(const int* points, int size, int point)
{
  return std::find(points, points + size, point) != points + size;
}
}

//------------------------------------------------------------------------------
unsigned FindSimpleShape(const CellTopology& topology)
{
  const int points = topology.NumberOfPoints, faces = topology.GetNumberOfFaces();
  if (points > MaxSimpleNodes || !topology.IsManifold)
  {
    return 0;
  }
  int triangles = 0, quads = 0;
  for (int f = 0; f < faces; ++f)
  {
    const int size = topology.GetFaceSize(f);
    triangles += size == 3;
    quads += size == 4;
    if (size > 4 || !AreDistinct(topology.GetFace(f), size))
    {
      return 0;
    }
  }
  if (points == 4 && triangles == 4 && quads == 0)
  {
    return Tetrahedra;
  }
  if (points == 5 && triangles == 4 && quads == 1)
  {
    return Pyramids;
  }
  const auto edges = static_cast<int>(topology.Edges.size());
  const unsigned shape = points == 6 && triangles == 2 && quads == 3 && edges == 9 ? Wedges
    : points == 8 && triangles == 0 && quads == 6 && edges == 12                   ? Hexahedra
                                                                                   : 0u;
  if (shape == 0 || !HasThreeEdgesPerPoint(topology))
  {
    return 0;
  }
  // Two shells can have the same numbers of points, edges and faces.
  int nodes[MaxSimpleNodes];
  return GetSimpleNodes(topology, shape, nodes) == points && AreDistinct(nodes, points) ? shape
                                                                                        : 0u;
}

//------------------------------------------------------------------------------
int GetSimpleNodes(const CellTopology& topology, unsigned shape, int nodes[MaxSimpleNodes])
{
  const int base = shape & (Pyramids | Hexahedra) ? 4 : 3;
  const int* face = topology.GetFace(FindFace(topology, base));
  nodes[0] = face[0]; // of faces as VTK gives them, the nodes of its pyramid
  std::reverse_copy(face + 1, face + base, nodes + 1);
  int size = base;
  if (shape & (Tetrahedra | Pyramids))
  {
    nodes[size] = 0;
    while (Contains(nodes, base, nodes[size]))
    {
      ++nodes[size];
    }
    return size + 1;
  }
  for (int i = 0; i < base; ++i)
  {
    for (const CellTopology::Edge& edge : topology.Edges)
    {
      for (const int end : { 0, 1 })
      {
        if (edge.Points[end] == nodes[i] && !Contains(nodes, base, edge.Points[1 - end]))
        {
          nodes[size++] = edge.Points[1 - end];
        }
      }
    }
  }
  return size;
}
}
