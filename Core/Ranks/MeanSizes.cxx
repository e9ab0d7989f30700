// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/MeanSizes.h"

#include "Base/Parallel.h"
#include "Ranks/ExactTotals.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
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
