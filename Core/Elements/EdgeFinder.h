// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::EdgeFinder
 * @brief Finds the index of the edge between two points.
 */
#ifndef camaron_EdgeFinder_h
#define camaron_EdgeFinder_h

#include "Mesh/MeshTopology.h"

#include <algorithm> // for std::lower_bound
#include <numeric>   // for the offsets
#include <vector>    // for the offsets

namespace camaron
{
class EdgeFinder
{
public:
  /// Keeps a reference to the edges, which must be sorted.
  EdgeFinder(const EdgeList& edges, vtkIdType numberOfPoints)
    : Edges(edges)
    , FirstEdges(static_cast<std::size_t>(numberOfPoints) + 1, 0)
  {
    for (const auto& edge : edges)
    {
      ++this->FirstEdges[edge[0] + 1];
    }
    std::partial_sum(this->FirstEdges.begin(), this->FirstEdges.end(), this->FirstEdges.begin());
  }

  /// Index of the edge between two points, which must exist.
  vtkIdType Find(vtkIdType a, vtkIdType b) const
  {
    const vtkIdType low = std::min(a, b), high = std::max(a, b);
    const auto begin = this->Edges.begin();
    return std::lower_bound(begin + this->FirstEdges[low], begin + this->FirstEdges[low + 1], high,
             [](const std::array<Index, 2>& edge, vtkIdType point) { return edge[1] < point; }) -
      begin;
  }

private:
  const EdgeList& Edges;
  std::vector<vtkIdType> FirstEdges; // first edge of each smaller point
};
}

#endif
