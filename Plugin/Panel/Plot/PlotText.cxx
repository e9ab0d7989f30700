// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlotText.h"

#include "NumberText.h"

#include <QCoreApplication>

namespace camaron
{
namespace
{
constexpr int DigitsOfOnlyValue = 16; // of the only value in a bar

struct Text
{
  Q_DECLARE_TR_FUNCTIONS(pqHistogramPlot)
};
}

//------------------------------------------------------------------------------
QString GetTitle(const HistogramData& data)
{
  return AddUnit(data.Name, data.Unit);
}

//------------------------------------------------------------------------------
QString GetElements(const HistogramData& data)
{
  return data.Elements.isEmpty() ? Text::tr("elements") : data.Elements;
}

//------------------------------------------------------------------------------
QString GetColumnName(const HistogramData& data, int column)
{
  const std::vector<double>& edges = data.Edges;
  const QString unit = GetUnitSuffix(data.Unit);
  switch (data.GetType(column))
  {
    case HistogramData::Column::Infinite:
      return Text::tr("Infinite");
    case HistogramData::Column::Undefined:
      return Text::tr("Undefined (NaN)");
    case HistogramData::Column::Underflow:
      return edges.empty() ? Text::tr("Not positive")
                           : Text::tr("Below %1").arg(FormatNumber(edges.front()) + unit);
    case HistogramData::Column::Overflow:
      return edges.empty() ? Text::tr("Above the range")
                           : Text::tr("Above %1").arg(FormatNumber(edges.back()) + unit);
    default:
      break;
  }
  const int bin = column - 1;
  if (data.IsConstant())
  {
    return FormatNumber(edges[0], DigitsOfOnlyValue) + unit;
  }
  if (data.HasIntegerBins())
  {
    return FormatNumber(edges[bin] + 0.5, DigitsOfOnlyValue) + unit;
  }
  const auto [low, high] = FormatNumbers(edges[bin], edges[bin + 1]);
  const bool isLast = column == data.GetNumberOfBins();
  return (isLast ? Text::tr("%1 ≤ value ≤ %2") : Text::tr("%1 ≤ value < %2"))
    .arg(low + unit, high + unit);
}

//------------------------------------------------------------------------------
QString GetColumnLabel(HistogramData::Column type, bool brief)
{
  switch (type)
  {
    case HistogramData::Column::Underflow:
      return brief ? "<" : Text::tr("below");
    case HistogramData::Column::Overflow:
      return brief ? ">" : Text::tr("above");
    case HistogramData::Column::Infinite:
      return brief ? QStringLiteral("∞") : Text::tr("infinite");
    case HistogramData::Column::Undefined:
      return brief ? "NaN" : Text::tr("undefined");
    default:
      return {};
  }
}
}
