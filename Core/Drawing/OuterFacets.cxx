// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/OuterFacets.h"

#include "Base/Parallel.h"
#include "Mesh/FacetLinks.h"
#include "Mesh/MeshTopology.h"

namespace camaron
{
std::vector<std::uint64_t> FindOuterFacets(const MeshTopology& topology, const FacetLinks* links)
{
  constexpr vtkIdType grain = 1 << 14;
  const FacetTable& faces = topology.GetFaces();
  std::vector<std::uint64_t> bits(topology.GetMesh().GetNumberOfCells(), 0);
  ParallelFor(static_cast<vtkIdType>(bits.size()), grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        int local = 0;
        for (const CellFacet use : faces.GetCellFacets(cell))
        {
          const bool isOuter = faces.IsBoundary(use.Facet()) && !(links && links->Has(use.Facet()));
          bits[cell] |= isOuter ? GetFacetBit(local) : 0;
          ++local;
        }
      }
    });
  return bits;
}
}
