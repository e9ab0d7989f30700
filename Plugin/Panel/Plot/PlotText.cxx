// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlotText.h"

#include "HistogramScene.h"
#include "NumberText.h"

#include <QCoreApplication>

#include <cmath>

namespace camaron
{
namespace
{
constexpr int DigitsOfOnlyValue = 16; // of the only value in a bar

struct Text
{
  Q_DECLARE_TR_FUNCTIONS(pqHistogramPlot)
};

// The first line in bold type; no line is broken.
QString ToRichText(QStringList lines)
{
  for (QString& line : lines)
  {
    line = line.toHtmlEscaped();
  }
  lines.front() = "<b>" + lines.front() + "</b>";
  return "<p style='white-space:pre'>" + lines.join("<br>") + "</p>";
}

QStringList DescribeHandle(const HistogramScene& scene, LimitHandle handle)
{
  const bool isLow = handle == LimitHandle::Low;
  const double limit = scene.GetLimit(handle);
  const QString text = std::isinf(limit) ? Text::tr("none") : FormatLimit(limit, scene.Data.Unit);
  return { (isLow ? Text::tr("Lower limit of the acceptable range: %1")
                  : Text::tr("Upper limit of the acceptable range: %1"))
             .arg(text),
    Text::tr("Drag to change it; with Ctrl it does not snap to round numbers"),
    isLow ? Text::tr("Keys: Alt+Left, Alt+Right") : Text::tr("Keys: Alt+Down, Alt+Up") };
}
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
                           : Text::tr("Below %1").arg(ShortNumber(edges.front()) + unit);
    case HistogramData::Column::Overflow:
      return edges.empty() ? Text::tr("Above the range")
                           : Text::tr("Above %1").arg(ShortNumber(edges.back()) + unit);
    default:
      break;
  }
  const int bin = column - 1;
  if (data.IsConstant())
  {
    return ShortNumber(edges[0], DigitsOfOnlyValue) + unit;
  }
  if (data.HasIntegerBins())
  {
    return ShortNumber(edges[bin] + 0.5, DigitsOfOnlyValue) + unit;
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

//------------------------------------------------------------------------------
QStringList DescribeColumn(const HistogramData& data, int column)
{
  constexpr int mostGroups = 8;
  const double total = static_cast<double>(data.GetTotal());
  const qint64 count = data.GetCount(column);
  QStringList lines;
  lines << GetColumnName(data, column);
  lines << Text::tr("%1: %2 (%3)")
             .arg(GetElements(data), GroupedInteger(count),
               FormatPercent(static_cast<double>(count), total));
  const qint64 selected = data.Selected.Counts.empty() ? 0 : data.Selected.Counts[column];
  if (selected > 0)
  {
    lines << Text::tr("selected: %1").arg(GroupedInteger(selected));
  }
  const qint64 notJudged = data.GetNotJudged(column);
  if (notJudged > 0)
  {
    lines << Text::tr("of shapes that the range is not for: %1").arg(GroupedInteger(notJudged));
  }
  QStringList groups;
  for (const HistogramData::Group& group : data.Groups)
  {
    if (group.Counts[column] > 0)
    {
      groups << Text::tr("%1: %2").arg(group.Label, GroupedInteger(group.Counts[column]));
    }
  }
  if (groups.size() > mostGroups)
  {
    groups.resize(mostGroups);
    groups << QStringLiteral("…");
  }
  lines << (data.Groups.size() > 1 ? groups : QStringList());
  if (data.IsBin(column))
  {
    double upTo = 0;
    for (int i = 0; i <= column; ++i)
    {
      upTo += static_cast<double>(data.GetCount(i));
    }
    lines << Text::tr("Cumulative: %1")
               .arg(FormatPercent(upTo, static_cast<double>(data.GetNumberOfValues())));
  }
  return lines;
}

//------------------------------------------------------------------------------
QString GetColumnToolTip(const HistogramData& data, int column)
{
  return ToRichText(DescribeColumn(data, column));
}

//------------------------------------------------------------------------------
QString GetToolTip(const HistogramScene& scene, const QPointF& position, QRect& area)
{
  const LimitHandle handle = scene.FindHandle(position);
  if (handle != LimitHandle::None)
  {
    return ToRichText(DescribeHandle(scene, handle));
  }
  const int column = scene.FindColumn(position, false);
  if (column >= 0 && !scene.Data.IsEmpty())
  {
    area = scene.GetSlot(column).toAlignedRect();
    return ToRichText(DescribeColumn(scene.Data, column)
      << Text::tr("Click to select; Shift adds, Ctrl subtracts, Ctrl+Shift intersects"));
  }
  if (scene.IsAtAxis(position))
  {
    return Text::tr("Drag or turn the wheel to zoom; double-click to reset").toHtmlEscaped();
  }
  return {};
}
}
