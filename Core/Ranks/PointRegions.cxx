// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/PointRegions.h"

#include "Ranks/CompletedPieces.h"

#include "vtkUnsignedCharArray.h"

namespace camaron
{
//------------------------------------------------------------------------------
std::vector<PointRegions> FindPointRegions(
  const std::vector<LinkedPiece>& pieces, Reducer& reducer)
{
  Completion completion;
  completion.BorderOnly = true;
  const auto borders = CompletePieces(pieces, completion, reducer);
  std::vector<PointRegions> regions;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    regions.push_back({ pieces[p].Topology->GetPointRegionCounts() });
    std::vector<Index>& counts = regions.back().Counts;
    const MeshTopology border(borders[p]);
    const MeshView& mesh = border.GetMesh();
    vtkUnsignedCharArray* ghosts = borders[p]->GetCellGhostArray();
    for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
    {
      // All cells around the points of an added cell are there.
      const bool isAdded = (ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0;
      const IndexRange points = mesh.GetCellPoints(cell);
      for (vtkIdType i = 0; i < points.Size && isAdded; ++i)
      {
        if (points[i] < static_cast<vtkIdType>(counts.size()))
        {
          counts[points[i]] = border.GetPointRegionCounts()[points[i]];
        }
      }
    }
  }
  return regions;
}
}
