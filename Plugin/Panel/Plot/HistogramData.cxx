// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HistogramData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace camaron
{
//------------------------------------------------------------------------------
int HistogramData::GetNumberOfBins() const
{
  return this->Edges.empty() ? 0 : static_cast<int>(this->Edges.size()) - 1;
}

//------------------------------------------------------------------------------
bool HistogramData::IsConstant() const
{
  return this->Edges.size() == 2 && this->Edges[0] == this->Edges[1];
}

//------------------------------------------------------------------------------
bool HistogramData::HasIntegerBins() const
{
  // See camaron::Bins::OfIntegers: the edges are at halves.
  return this->Edges.size() >= 2 &&
    std::adjacent_find(this->Edges.begin(), this->Edges.end(),
      [](double low, double high) { return high - low != 1; }) == this->Edges.end() &&
    this->Edges[0] - std::floor(this->Edges[0]) == 0.5;
}

//------------------------------------------------------------------------------
bool HistogramData::HasWholeNumbers() const
{
  return this->HasIntegerBins() ||
    (this->IsConstant() && this->Edges[0] == std::floor(this->Edges[0]));
}

//------------------------------------------------------------------------------
HistogramData::Column HistogramData::GetType(int column) const
{
  const int bins = this->GetNumberOfBins();
  if (column < 1)
  {
    return Column::Underflow;
  }
  return column <= bins ? Column::Bin
                        : static_cast<Column>(column - bins + static_cast<int>(Column::Bin));
}

//------------------------------------------------------------------------------
int HistogramData::GetColumn(Column type) const
{
  return type == Column::Underflow
    ? 0
    : this->GetNumberOfBins() + static_cast<int>(type) - static_cast<int>(Column::Bin);
}

//------------------------------------------------------------------------------
qint64 HistogramData::GetNotJudged(int column) const
{
  const std::vector<qint64> none;
  const std::vector<qint64>& judged = this->Groups.size() == 1 ? this->Groups.front().Judged : none;
  const bool isAnyJudged =
    std::any_of(judged.begin(), judged.end(), [](qint64 count) { return count > 0; });
  return isAnyJudged && this->IsBin(column)
    ? this->Groups.front().Counts[column] - judged[column - 1]
    : 0;
}

//------------------------------------------------------------------------------
qint64 HistogramData::GetCount(int column) const
{
  return std::accumulate(this->Groups.begin(), this->Groups.end(), qint64(0),
    [=](qint64 sum, const Group& group) { return sum + group.Counts[column]; });
}

//------------------------------------------------------------------------------
qint64 HistogramData::GetTotal() const
{
  qint64 total = 0;
  for (const Group& group : this->Groups)
  {
    total = std::accumulate(group.Counts.begin(), group.Counts.end(), total);
  }
  return total;
}

//------------------------------------------------------------------------------
qint64 HistogramData::GetLargestCount() const
{
  qint64 largest = 0;
  for (int bin = 0; bin < this->GetNumberOfBins(); ++bin)
  {
    largest = std::max(largest, this->GetCount(this->GetColumnOfBin(bin)));
  }
  return largest;
}

//------------------------------------------------------------------------------
qint64 HistogramData::GetNumberOfValues() const
{
  return this->GetTotal() - this->GetCount(Column::Undefined);
}

//------------------------------------------------------------------------------
std::pair<double, double> HistogramData::GetAxisRange() const
{
  if (this->Edges.empty())
  {
    return this->Logarithmic ? std::make_pair(1.0, 10.0) : std::make_pair(0.0, 1.0);
  }
  const double low = this->Edges.front(), high = this->Edges.back();
  if (low != high)
  {
    return { low, high };
  }
  constexpr double factor = 2, smallest = 1e-300; // half of this is still a normal number
  if (this->Logarithmic)
  {
    const double positive = std::max(low, smallest);
    return { positive / factor, std::min(positive * factor, std::numeric_limits<double>::max()) };
  }
  const double margin = std::abs(low) < smallest ? 1 : std::abs(low) / factor;
  return { low - margin, low + margin };
}

//------------------------------------------------------------------------------
bool HistogramData::IsValid() const
{
  const auto isWrong = [](double low, double high) { return !(low < high); };
  const bool areFinite = std::all_of(
    this->Edges.begin(), this->Edges.end(), [](double edge) { return std::isfinite(edge); });
  const bool areSorted = this->IsConstant() ||
    std::adjacent_find(this->Edges.begin(), this->Edges.end(), isWrong) == this->Edges.end();
  const bool haveCounts =
    std::all_of(this->Groups.begin(), this->Groups.end(), [this](const Group& group)
      { return group.Counts.size() == static_cast<std::size_t>(this->GetNumberOfColumns()); });
  return areFinite && areSorted && haveCounts && this->Edges.size() != 1 &&
    !(this->Logarithmic && !this->Edges.empty() && this->Edges.front() <= 0);
}
}
