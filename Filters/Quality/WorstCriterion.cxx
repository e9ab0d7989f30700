// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WorstCriterion.h"

#include "AcceptableRanges.h"

#include "Base/Parallel.h"

#include "vtkDataSet.h"
#include "vtkMath.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <mutex>
#include <numeric>
#include <optional>
#include <tuple>

namespace camaron
{
namespace
{
constexpr unsigned AnyPolygon = Polygons | Triangles | Quadrilaterals;

constexpr std::size_t NumberOfBins = 256; // for distances from the ideal, 0 to 1

/// Numbers of values of a criterion. They are integers, so sums do not depend on the order of
/// cells.
enum Count : std::size_t
{
  Finite,
  Judged,
  Outside,
  FirstBin,
  NumberOfCounts = FirstBin + NumberOfBins
};
using Counts = std::array<std::int64_t, NumberOfCounts>;

//------------------------------------------------------------------------------
std::size_t GetMedianBin(const Counts& counts)
{
  const auto bins = counts.begin() + FirstBin;
  const std::int64_t total = std::accumulate(bins, counts.end(), std::int64_t(0));
  std::int64_t before = 0;
  std::size_t bin = 0;
  while (bin + 1 < NumberOfBins && 2 * (before + bins[bin]) < total)
  {
    before += bins[bin++];
  }
  return bin;
}

/// Relative distance of values from the ideal: 0 at the ideal, 1 at the bad end of the range.
class IdealDistance
{
public:
  //----------------------------------------------------------------------------
  IdealDistance(const Criterion& criterion, AngleUnit angles)
  {
    const bool isInRadians = criterion.Unit == Unit::Angle && angles == AngleUnit::Radians;
    const double scale = isInRadians ? vtkMath::RadiansFromDegrees(1.0) : 1;
    const double badEnd = criterion.Range[criterion.Better == Better::Bigger ? 0 : 1] * scale;
    this->Ideal = criterion.Ideal * scale;
    this->Width = std::abs(badEnd - this->Ideal);
    this->Size = std::max(std::abs(criterion.Ideal), 1.0) * scale;
    this->IsKnown =
      criterion.Better != Better::Neither && std::isfinite(criterion.Ideal) && this->Width > 0;
  }

  bool GetIsKnown() const { return this->IsKnown; }

  //----------------------------------------------------------------------------
  std::size_t GetBin(double value) const
  {
    const double distance = std::abs(value - this->Ideal);
    const double share = std::isinf(distance) ? 1.0
      : std::isinf(this->Width)               ? distance / (distance + this->Size)
                                              : std::min(distance / this->Width, 1.0);
    return std::min(static_cast<std::size_t>(share * NumberOfBins), NumberOfBins - 1);
  }

private:
  double Ideal;
  double Width; // from the ideal to the bad end
  double Size;  // scale where the range has no bad end
  bool IsKnown;
};

//------------------------------------------------------------------------------
void Add(const ValueBlock& block, const unsigned char* ghosts, const ValueRange& range,
  const IdealDistance& distance, Counts& counts)
{
  const unsigned char ghostMask = GetGhostMask(ElementKind::Cells);
  std::mutex mutex;
  ParallelFor(block.Size, LightGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      Counts own{};
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const double value = block.Values[cell];
        if (std::isnan(value) || (ghosts && (ghosts[cell] & ghostMask)))
        {
          continue;
        }
        own[Finite] += std::isfinite(value);
        const bool isJudged = block.IsJudged(cell);
        own[Judged] += isJudged;
        own[Outside] += isJudged && (value < range.Low || value > range.High);
        if (distance.GetIsKnown())
        {
          ++own[FirstBin + distance.GetBin(value)];
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      std::transform(own.begin(), own.end(), counts.begin(), counts.begin(), std::plus<>());
    });
}
}

//------------------------------------------------------------------------------
const Criterion* FindWorstCriterion(const std::vector<const Criterion*>& criteria,
  const std::map<std::string, std::vector<vtkSmartPointer<vtkDoubleArray>>>& arrays,
  const std::vector<DataSetLeaf>& leaves, const AcceptableRanges& ranges, AngleUnit angles,
  Reducer& reducer)
{
  std::vector<Counts> counts(criteria.size(), Counts{});
  std::vector<std::optional<AcceptableRange>> acceptable;
  std::vector<std::vector<std::uint16_t>> shapes(leaves.size());
  for (std::size_t i = 0; i < criteria.size(); ++i)
  {
    const IdealDistance distance(*criteria[i], angles);
    acceptable.push_back(ranges.Find(criteria[i]->Name, criteria[i]->UnitLabel(angles)));
    const std::vector<vtkSmartPointer<vtkDoubleArray>>& values = arrays.at(criteria[i]->Name);
    for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf)
    {
      vtkUnsignedCharArray* const ghosts = leaves[leaf].Data->GetCellGhostArray();
      ValueBlock block;
      block.Values = values[leaf]->GetPointer(0);
      block.Size = values[leaf]->GetNumberOfValues();
      if (acceptable[i] && !(acceptable[i]->Shapes & AnyCell))
      {
        if (shapes[leaf].empty())
        {
          shapes[leaf] = FindCellShapes(leaves[leaf].Data);
        }
        block.Shapes = shapes[leaf].data();
        block.JudgedShapes = acceptable[i]->Shapes;
      }
      Add(block, ghosts ? ghosts->GetPointer(0) : nullptr,
        acceptable[i].value_or(AcceptableRange()), distance, counts[i]);
    }
  }
  reducer.Sum(counts.data()->data(), counts.size() * NumberOfCounts);

  bool hasSolids = false;
  for (std::size_t i = 0; i < criteria.size(); ++i)
  {
    hasSolids |= counts[i][Finite] > 0 && (criteria[i]->AppliesTo & (AnyPolygon | AnyCell)) == 0;
  }
  const auto rank = [&](std::size_t i)
  {
    const Criterion& criterion = *criteria[i];
    const bool hasDistance = IdealDistance(criterion, angles).GetIsKnown();
    return std::make_tuple(ranges.IsHint(criterion) ? 0 : counts[i][Outside], counts[i][Outside],
      hasDistance && acceptable[i] && counts[i][Judged] > 0 && GetMedianBin(counts[i]) > 0,
      hasDistance, hasDistance ? GetMedianBin(counts[i]) : 0, criterion.Better != Better::Neither);
  };
  const std::size_t none = criteria.size();
  std::size_t worst = none;
  for (std::size_t i = 0; i < criteria.size(); ++i)
  {
    const bool isCandidate =
      counts[i][Finite] > 0 && !(hasSolids && (criteria[i]->AppliesTo & ~AnyPolygon) == 0);
    if (isCandidate && (worst == none || rank(i) > rank(worst)))
    {
      worst = i;
    }
  }
  return worst == none ? nullptr : criteria[worst];
}
}
