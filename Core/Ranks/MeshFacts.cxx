// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/MeshFacts.h"
#include "Base/Parallel.h"
#include "Ranks/CompletedPieces.h"
#include "Ranks/ExactTotals.h"
#include "Ranks/KeyRanks.h"
#include "Ranks/LinkedComponents.h"
#include "Ranks/LinkedPieces.h"
#include "vtkUnsignedCharArray.h"
#include <algorithm>
#include <cmath>
#include <map>

namespace camaron
{
//------------------------------------------------------------------------------
void MeshFacts::Find(unsigned needs, std::vector<LinkedPiece>& pieces, Reducer& reducer,
  const std::function<void()>& goOn)
{
  const auto provide = [&](unsigned need, auto member, auto& facts, auto&& find, auto&& ofPiece)
  {
    if (!(needs & need) || (!pieces.empty() && pieces[0].Options.*member))
    {
      return;
    }
    goOn();
    facts = find(pieces, reducer);
    for (std::size_t piece = 0; piece < pieces.size(); ++piece)
    {
      pieces[piece].Options.*member = ofPiece(facts, piece);
    }
  };
  const auto same = [](const auto& facts, std::size_t) { return &facts; };
  const auto own = [](const auto& facts, std::size_t piece) { return &facts[piece]; };
  using Options = EvaluationOptions;
  provide(NeedsMeanSizes, &Options::Means, this->Means, GetMeanSizes, same);
  provide(NeedsSurfaceSides, &Options::Sides, this->Sides, FindSurfaceSides, own);
  provide(NeedsRegions, &Options::Regions, this->Regions, FindMeshRegions, own);
  provide(NeedsPointRegions, &Options::PointGroups, this->PointGroups, FindPointRegions, own);
}

namespace
{
using Ids = std::vector<std::int64_t>;

//------------------------------------------------------------------------------
// Connected components within the pieces of this rank, except those that only contain duplicates.
class PieceRegions
{
public:
  PieceRegions(const std::vector<LinkedPiece>& pieces, const CellIds& ids)
  {
    for (std::size_t p = 0; p < pieces.size(); ++p)
    {
      const std::vector<Index>& regions = pieces[p].Topology->GetCellRegions();
      std::vector<Index> components(regions.size(), CopiesOnly); // of the regions of this piece
      for (std::size_t cell = 0; cell < regions.size(); ++cell)
      {
        if (regions[cell] >= 0 && !pieces[p].IsCopy(static_cast<vtkIdType>(cell)))
        {
          const std::int64_t id = ids.Get(p, cell);
          Index& component = components[regions[cell]];
          if (component < 0)
          {
            component = static_cast<Index>(this->FirstCells.size());
            this->FirstCells.push_back(id);
          }
          this->FirstCells[component] = std::min(this->FirstCells[component], id);
        }
      }
      this->OfCells.emplace_back();
      for (const Index region : regions)
      {
        this->OfCells[p].push_back(region < 0 ? NoRegion : components[region]);
      }
    }
  }

  static constexpr Index NoRegion = -1;
  static constexpr Index CopiesOnly = -2;
  std::vector<std::vector<Index>> OfCells; // components
  Ids FirstCells;                          // of the components
};
}

//------------------------------------------------------------------------------
std::vector<MeshRegions> FindMeshRegions(const std::vector<LinkedPiece>& pieces, Reducer& reducer)
{
  const PieceRegions regions(pieces, CellIds(pieces, reducer));
  const LinkedComponents linked(
    pieces, regions.OfCells, static_cast<Index>(regions.FirstCells.size()), reducer);
  const Ids firstCells = linked.Combine(regions.FirstCells,
    [](std::int64_t& first, std::int64_t other) { first = std::min(first, other); });
  // The number of a region is the position of its first cell among those of all regions.
  std::map<std::int64_t, std::int64_t> numbers; // of first cells
  for (std::size_t i = 0; i < firstCells.size(); ++i)
  {
    numbers[firstCells[i]] += linked.IsFirst(i); // each region counts once
  }
  std::vector<KeyCounts> keys;
  for (const auto& [cell, count] : numbers)
  {
    keys.push_back({ cell, { { count, 0 } } });
  }
  const std::vector<KeyRank> ranks = RankKeys(keys, reducer);
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    numbers[keys[i].Key] = ranks[i].Before[0];
  }
  Ids ofComponents;
  for (const std::int64_t cell : firstCells)
  {
    ofComponents.push_back(numbers[cell]);
  }
  std::vector<MeshRegions> result;
  for (const std::vector<Index>& components : regions.OfCells)
  {
    result.emplace_back();
    for (const Index component : components)
    {
      result.back().OfCells.push_back(component >= 0 ? ofComponents[component]
          : component == PieceRegions::CopiesOnly    ? MeshRegions::Unknown
                                                     : MeshRegions::None);
    }
  }
  return result;
}

//------------------------------------------------------------------------------
std::vector<PointRegions> FindPointRegions(const std::vector<LinkedPiece>& pieces, Reducer& reducer)
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
      // All cells around the points of an added cell are present.
      const bool isAdded = (ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0;
      for (const vtkIdType point : mesh.GetCellPoints(cell))
      {
        if (isAdded && point < static_cast<vtkIdType>(counts.size()))
        {
          counts[point] = border.GetPointRegionCounts()[point];
        }
      }
    }
  }
  return regions;
}

namespace
{
constexpr vtkIdType MaxParts = 64; // number of parts that are summed in parallel

// Sums of the cells of a part.
struct Sums
{
  ExactSum Sum[MeanSizes::NumberOfKinds];
  std::int64_t Count[MeanSizes::NumberOfKinds] = {};

  void Add(MeanSizes::Kind kind, double size)
  {
    if (std::isfinite(size))
    {
      this->Sum[kind].Add(size);
      ++this->Count[kind];
    }
  }
};

//------------------------------------------------------------------------------
void AddCells(const LinkedPiece& piece, vtkIdType begin, vtkIdType end, Sums& sums)
{
  for (ExactSum& sum : sums.Sum)
  {
    sum.Reserve(end - begin);
  }
  CellGeometry cell;
  for (vtkIdType id = begin; id < end; ++id)
  {
    if (piece.Options.Ghosts && piece.Options.Ghosts[id])
    {
      continue;
    }
    cell.Load(piece.Topology->GetMesh(), id, piece.Options);
    cell.Normalize();
    const bool isPolygon = (cell.GetShapes() & Polygons) != 0;
    const int dimension = isPolygon ? 2 : 3;
    if (!cell.IsFinite() || !(cell.GetShapes() & PolygonsAndPolyhedra))
    {
      continue;
    }
    cell.Compute(NeedsFaces | NeedsVolume);
    sums.Add(isPolygon ? MeanSizes::PolygonArea : MeanSizes::PolyhedronVolume,
      cell.ToMesh(isPolygon ? cell.GetPolygonArea() : cell.GetVolume(), dimension));
    MeanSizes::Kind kind;
    double size;
    if (GetVerdictSize(cell, kind, size))
    {
      sums.Add(kind, cell.ToMesh(size, dimension));
    }
  }
}
}

//------------------------------------------------------------------------------
MeanSizes GetMeanSizes(const std::vector<LinkedPiece>& pieces, Reducer& reducer)
{
  ExactTotals totals(MeanSizes::NumberOfKinds);
  for (const LinkedPiece& piece : pieces)
  {
    const vtkIdType size = piece.Topology->GetMesh().GetNumberOfCells();
    const vtkIdType numberOfParts = std::min(MaxParts, size / HeavyGrain + 1);
    std::vector<Sums> parts(static_cast<std::size_t>(numberOfParts));
    ParallelForEach(numberOfParts, 1,
      [&](vtkIdType part)
      {
        AddCells(
          piece, size * part / numberOfParts, size * (part + 1) / numberOfParts, parts[part]);
      });
    for (Sums& part : parts)
    {
      totals.AddEach(part.Sum);
      for (int kind = 0; kind < MeanSizes::NumberOfKinds; ++kind)
      {
        totals.Count(kind) += part.Count[kind];
      }
    }
  }
  totals.Reduce(reducer);
  MeanSizes means;
  for (int kind = 0; kind < MeanSizes::NumberOfKinds; ++kind)
  {
    const std::int64_t count = totals.Count(kind);
    means.Of[kind] = count > 0 ? totals.Divide(kind, count) : Null(NullReason::Degenerate);
  }
  return means;
}
}
