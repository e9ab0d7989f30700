// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlotToolTip.h"

#include "HistogramLayout.h"
#include "LimitHandles.h"
#include "NumberText.h"
#include "PlotText.h"

#include <QCoreApplication>
#include <QStringList>

#include <cmath>

namespace camaron
{
namespace
{
struct ToolTipText
{
  Q_DECLARE_TR_FUNCTIONS(pqHistogramPlot)
};

// The first line in bold type; no line is broken.
QString ToRichText(const QStringList& lines)
{
  QStringList escaped;
  for (const QString& line : lines)
  {
    escaped << line.toHtmlEscaped();
  }
  escaped.front() = "<b>" + escaped.front() + "</b>";
  return "<p style='white-space:pre'>" + escaped.join("<br>") + "</p>";
}

QStringList DescribeHandle(const HistogramContent& content, LimitHandles::Handle handle)
{
  const bool isLow = handle == LimitHandles::Handle::Low;
  const double limit = isLow ? content.Low : content.High;
  const QString text =
    std::isinf(limit) ? ToolTipText::tr("none") : FormatLimit(limit, content.Data.Unit);
  return { (isLow ? ToolTipText::tr("Lower limit of the acceptable range: %1")
                  : ToolTipText::tr("Upper limit of the acceptable range: %1"))
             .arg(text),
    ToolTipText::tr("Drag to change it; with Ctrl it does not snap to round numbers"),
    isLow ? ToolTipText::tr("Keys: Alt+Left, Alt+Right")
          : ToolTipText::tr("Keys: Alt+Down, Alt+Up") };
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
  lines << ToolTipText::tr("%1: %2 (%3)")
             .arg(GetElements(data), GroupedInteger(count),
               FormatPercent(static_cast<double>(count), total));
  const qint64 selected = data.Selected.Counts.empty() ? 0 : data.GetCount(column, data.Selected);
  if (selected > 0)
  {
    lines << ToolTipText::tr("selected: %1").arg(GroupedInteger(selected));
  }
  int groups = 0;
  for (const HistogramData::Group& group : data.Groups)
  {
    const qint64 part = data.GetCount(column, group);
    if (data.Groups.size() > 1 && part > 0)
    {
      if (++groups > mostGroups)
      {
        lines << QStringLiteral("…");
        break;
      }
      lines << ToolTipText::tr("%1: %2").arg(group.Label, GroupedInteger(part));
    }
  }
  if (data.GetType(column) == HistogramData::Column::Bin)
  {
    qint64 upTo = 0;
    for (int i = 0; i <= column; ++i)
    {
      upTo += data.GetCount(i);
    }
    lines << ToolTipText::tr("Cumulative: %1")
               .arg(FormatPercent(
                 static_cast<double>(upTo), static_cast<double>(data.GetNumberOfValues())));
  }
  return lines;
}

//------------------------------------------------------------------------------
QString GetColumnToolTip(const HistogramData& data, int column)
{
  return ToRichText(DescribeColumn(data, column));
}

//------------------------------------------------------------------------------
QString GetToolTip(const HistogramContent& content, const HistogramLayout& layout,
  const QPointF& position, QRect& area)
{
  const LimitHandles::Handle handle = LimitHandles(content, layout).Find(position);
  if (handle != LimitHandles::Handle::None)
  {
    return ToRichText(DescribeHandle(content, handle));
  }
  const int column = layout.FindColumn(position, false);
  if (column >= 0 && !content.Data.IsEmpty())
  {
    area = layout.GetSlot(column).toAlignedRect();
    return ToRichText(DescribeColumn(content.Data, column)
      << ToolTipText::tr("Click to select; Shift adds, Ctrl subtracts, Ctrl+Shift intersects"));
  }
  if (layout.IsAtAxis(position))
  {
    return ToolTipText::tr("Drag or turn the wheel to zoom; double-click to reset").toHtmlEscaped();
  }
  return {};
}
}
