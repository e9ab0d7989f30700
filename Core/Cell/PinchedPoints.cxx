// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cell/PinchedPoints.h"

#include "Mesh/CellTopology.h"
#include "Base/DisjointSets.h"

#include <array>
#include <vector>

namespace camaron
{
//------------------------------------------------------------------------------
// Corners of faces hang together where they lie at the same end of an edge.
bool HasPinchedPoints(const CellTopology& topology)
{
  const std::size_t size = topology.FacePoints.size();
  DisjointSets groups(size);
  std::vector<std::array<int, 2>> firstCorners(topology.Edges.size(), { -1, -1 }); // at both ends
  const auto join = [&](int edge, int corner)
  {
    int& first = firstCorners[edge][topology.FacePoints[corner] == topology.Edges[edge].Points[0] ? 0 : 1];
    first = first < 0 ? corner : first;
    groups.Join(first, corner);
  };
  for (std::size_t corner = 0; corner < size; ++corner)
  {
    groups.Insert(static_cast<vtkIdType>(corner));
  }
  for (int face = 0; face < topology.GetNumberOfFaces(); ++face)
  {
    const int begin = topology.FaceOffsets[face], end = topology.FaceOffsets[face + 1];
    for (int corner = begin; corner < end; ++corner)
    {
      join(topology.FaceEdges[corner], corner);
      join(topology.FaceEdges[corner], corner + 1 < end ? corner + 1 : begin);
    }
  }
  std::vector<vtkIdType> groupsOfPoints(topology.NumberOfPoints, -1);
  for (std::size_t corner = 0; corner < size; ++corner)
  {
    const vtkIdType group = groups.Find(static_cast<vtkIdType>(corner));
    vtkIdType& known = groupsOfPoints[topology.FacePoints[corner]];
    if (known >= 0 && known != group)
    {
      return true;
    }
    known = group;
  }
  return false;
}
}
