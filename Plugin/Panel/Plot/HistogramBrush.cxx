// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HistogramBrush.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace camaron
{
namespace
{
constexpr double Largest = std::numeric_limits<double>::max();

// The finite values in a column as a closed range; none in those of infinite and undefined values.
std::optional<QPair<double, double>> GetRange(const HistogramData& data, int column)
{
  const std::vector<double>& edges = data.Edges;
  switch (data.GetType(column))
  {
    case HistogramData::Column::Underflow:
      // Without bins, the values are those that a logarithmic axis cannot show.
      return { { -Largest, edges.empty() ? 0 : std::nextafter(edges.front(), -Infinity) } };
    case HistogramData::Column::Bin:
    {
      const double high = edges[column];
      const bool isLast = column == data.GetNumberOfBins();
      return { { edges[column - 1], isLast ? high : std::nextafter(high, -Infinity) } };
    }
    case HistogramData::Column::Overflow:
      return { { edges.empty() ? 0 : std::nextafter(edges.back(), Infinity), Largest } };
    default:
      return std::nullopt;
  }
}
}

//------------------------------------------------------------------------------
Combination ToCombination(Qt::KeyboardModifiers modifiers)
{
  const bool shift = modifiers & Qt::ShiftModifier;
  const bool control = modifiers & Qt::ControlModifier;
  return shift && control ? Combination::Intersect
    : shift               ? Combination::Add
    : control             ? Combination::Subtract
                          : Combination::Replace;
}

//------------------------------------------------------------------------------
HistogramBrush::HistogramBrush(const HistogramData& data, int first, int last)
{
  std::tie(first, last) = std::minmax({ first, last });
  this->Columns.resize(data.GetNumberOfColumns());
  last = std::min(last, data.GetNumberOfColumns() - 1);
  for (int column = std::max(first, 0); column <= last; ++column)
  {
    // A drag passes over columns that are not shown because they are empty.
    this->Columns[column] = data.IsBin(column) || data.GetCount(column) > 0;
  }
}

//------------------------------------------------------------------------------
HistogramBrush HistogramBrush::Combined(const HistogramBrush& newer, Combination combination) const
{
  // Arrays of different sizes combine as if the shorter one continued with zeros.
  HistogramBrush result(newer);
  switch (combination)
  {
    case Combination::Replace:
      break;
    case Combination::Add:
      result.Columns |= this->Columns;
      break;
    case Combination::Subtract:
      result.Columns = this->Columns ^ (this->Columns & newer.Columns);
      break;
    case Combination::Intersect:
      result.Columns &= this->Columns;
      break;
  }
  return result;
}

//------------------------------------------------------------------------------
HistogramBrush::Ranges HistogramBrush::GetRanges(const HistogramData& data) const
{
  Ranges ranges;
  bool isAdjacent = false;
  for (int column = 0; column < data.GetNumberOfColumns(); ++column)
  {
    const auto range = this->Contains(column) ? GetRange(data, column) : std::nullopt;
    if (range && isAdjacent)
    {
      ranges.back().second = range->second;
    }
    else if (range)
    {
      ranges.push_back(*range);
    }
    isAdjacent = range.has_value();
  }
  return ranges;
}

//------------------------------------------------------------------------------
int HistogramBrush::GetSpecials(const HistogramData& data) const
{
  return (this->Contains(data.GetColumn(HistogramData::Column::Undefined)) ? Undefined : 0) |
    (this->Contains(data.GetColumn(HistogramData::Column::Infinite)) ? Infinite : 0);
}

//------------------------------------------------------------------------------
qint64 HistogramBrush::GetCount(const HistogramData& data) const
{
  qint64 count = 0;
  for (int column = 0; column < data.GetNumberOfColumns(); ++column)
  {
    count += this->Contains(column) ? data.GetCount(column) : 0;
  }
  return count;
}
}
