// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/Strategy.h"

#include "Cell/CellNeighborhood.h"
#include "Mesh/CellFacets.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Marks the 3D cells with a face that no other cell shares, or the 2D cells with such an edge; or
// the points of these faces or edges.
void MarkBoundary(const DistributedMesh& pieces, std::size_t piece, int dimension, bool marksCells,
  std::vector<unsigned char>& marks)
{
  const MeshTopology& topology = pieces.GetTopology(piece);
  if (!HasCellsOfDimension(topology.GetMesh(), dimension))
  {
    return;
  }
  const EvaluationOptions& options = pieces.GetOptions(piece);
  const FacetTable& table = topology.GetFacets(dimension);
  CellFacets facets(topology.GetMesh());
  for (Index cell = 0; cell < table.GetNumberOfCells(); ++cell)
  {
    const FacetTable::Range uses = table.GetCellFacets(cell);
    const auto isBoundary = [&](CellFacet use)
    {
      return table.IsBoundary(use.Facet()) &&
        !(options.Links && options.Links->GetFacets(dimension).Has(use.Facet()));
    };
    if ((options.Ghosts && options.Ghosts[cell]) ||
      std::none_of(uses.begin(), uses.end(), isBoundary))
    {
      continue;
    }
    if (marksCells)
    {
      marks[cell] = 1;
      continue;
    }
    facets.ForEach(cell,
      [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
      {
        for (vtkIdType i = 0; i < size && isBoundary(uses[static_cast<Index>(local)]); ++i)
        {
          marks[points[i]] = 1;
        }
      });
  }
}
}

//------------------------------------------------------------------------------
std::string SelectBoundary(const SelectionTask& task, SelectionMarks& marks)
{
  const DistributedMesh& pieces = task.GetLinkedPieces();
  for (std::size_t piece = 0; piece < marks.size(); ++piece)
  {
    for (const int dimension : { 2, 3 })
    {
      MarkBoundary(pieces, piece, dimension, task.HasCells(), marks[piece]);
    }
  }
  task.MarkCopies(marks);
  return "";
}
}
