// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/FacetTable.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// The entries of a sorted list of (facet, cell) pairs that belong to one facet.
template <typename ExtraCell>
auto FindExtraCells(const std::vector<ExtraCell>& cells, Index facet)
{
  return std::equal_range(cells.begin(), cells.end(), ExtraCell{ facet, 0 },
    [](const ExtraCell& a, const ExtraCell& b) { return a.Facet < b.Facet; });
}
}

//------------------------------------------------------------------------------
void FacetTable::GetCells(Index facet, std::vector<Index>& cells) const
{
  const CellPair pair = this->FacetCells[facet];
  cells.assign(1, pair.First);
  if (pair.Second >= 0)
  {
    cells.push_back(pair.Second);
  }
  const auto extra = FindExtraCells(this->ExtraCells, facet);
  for (auto it = extra.first; it != extra.second; ++it)
  {
    cells.push_back(it->Cell);
  }
}

//------------------------------------------------------------------------------
Index FacetTable::GetNumberOfCells(Index facet) const
{
  if (this->FacetCells[facet].Second < 0)
  {
    return 1;
  }
  const auto extra = FindExtraCells(this->ExtraCells, facet);
  return 2 + static_cast<Index>(extra.second - extra.first);
}

//------------------------------------------------------------------------------
Index FacetTable::GetOwnerLocalFacet(Index facet) const
{
  const Range facets = this->GetCellFacets(this->FacetCells[facet].First);
  Index local = 0;
  while (facets[local].Facet() != facet)
  {
    ++local;
  }
  return local;
}
}
