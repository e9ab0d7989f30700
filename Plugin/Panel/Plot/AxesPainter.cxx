// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AxesPainter.h"

#include "NumberText.h"
#include "PlotText.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
// Lengths in pixels.
constexpr double LineWidth = 1;
constexpr double MinorTickLength = 2;
constexpr double LabelGap = 5; // between an axis and its labels

struct AxisText
{
  Q_DECLARE_TR_FUNCTIONS(pqHistogramPlot)
};
}

//------------------------------------------------------------------------------
AxesPainter::AxesPainter(QPainter* painter, const HistogramContent& content,
  const HistogramLayout& layout, const PlotColors& colors)
  : Painter(painter)
  , Content(content)
  , Layout(layout)
  , Colors(colors)
{
}

//------------------------------------------------------------------------------
void AxesPainter::PaintGrid()
{
  const QRectF& columns = this->Layout.Columns;
  for (const Tick& tick : this->Layout.CountTicks)
  {
    if (!tick.Label.isEmpty() && tick.Value > 0)
    {
      this->Painter->fillRect(
        QRectF(columns.left(), this->Layout.ToY(tick.Value), columns.width(), LineWidth),
        this->Colors.Grid);
    }
  }
}

//------------------------------------------------------------------------------
void AxesPainter::Paint()
{
  this->PaintCountAxis();
  if (this->Content.Cumulative && !this->Content.Data.Edges.empty())
  {
    this->PaintPercentAxis();
  }
  this->PaintValueAxis();
  this->PaintColumnLabels();
  this->PaintTitles();
  this->PaintLegend();
}

//------------------------------------------------------------------------------
void AxesPainter::PaintCountAxis()
{
  const QRectF& columns = this->Layout.Columns;
  const double height = QFontMetricsF(this->Layout.Font).height();
  for (const Tick& tick : this->Layout.CountTicks)
  {
    const double y = tick.Value > 0 ? this->Layout.ToY(tick.Value) : columns.bottom();
    this->PaintText(QRectF(0, y - height / 2, columns.left() - LabelGap, height),
      Qt::AlignRight | Qt::AlignVCenter, tick.Label, this->Colors.Text);
  }
}

//------------------------------------------------------------------------------
void AxesPainter::PaintPercentAxis()
{
  const QRectF& columns = this->Layout.Columns;
  const double height = QFontMetricsF(this->Layout.Font).height();
  const bool isHigh = columns.height() > 4 * height;
  for (const int percent : { 0, 25, 50, 75, 100 })
  {
    if (percent % 50 == 0 || isHigh)
    {
      const double y = this->Layout.PercentToY(percent);
      this->PaintText(QRectF(columns.right() + LabelGap, y - height / 2, columns.right(), height),
        Qt::AlignLeft | Qt::AlignVCenter, FormatPercent(percent, 100), this->Colors.Curve);
    }
  }
}

//------------------------------------------------------------------------------
void AxesPainter::PaintValueAxis()
{
  const QRectF& plot = this->Layout.Plot;
  this->PaintLine(plot.left(), plot.bottom(), plot.right(), plot.bottom() + LineWidth);
  if (this->Content.Data.Edges.empty())
  {
    this->PaintText(plot, Qt::AlignCenter | Qt::TextWordWrap,
      this->Content.Data.Logarithmic ? AxisText::tr("No positive values")
                                     : AxisText::tr("No finite values"),
      this->Colors.Axis);
    return;
  }
  const QFontMetricsF metrics(this->Layout.Font);
  for (const Tick& tick : this->Layout.ValueTicks)
  {
    const double x = this->Layout.Align(this->Layout.ToX(tick.Value));
    const double length = tick.Label.isEmpty() ? MinorTickLength : TickLength;
    this->PaintLine(x, plot.bottom(), x + LineWidth, plot.bottom() + length);
    if (!tick.Label.isEmpty())
    {
      // Labels at the ends stay near the plot, so that those of other columns have space.
      const double width = std::ceil(metrics.horizontalAdvance(tick.Label));
      const double left = std::clamp(x - width / 2, plot.left() - LabelGap,
        std::max(plot.right() + LabelGap - width, plot.left() - LabelGap));
      this->PaintText(QRectF(left, plot.bottom() + TickLength, width + 1, metrics.height()),
        Qt::AlignLeft | Qt::AlignTop, tick.Label, this->Colors.Text);
    }
  }
}

//------------------------------------------------------------------------------
void AxesPainter::PaintColumnLabels()
{
  const HistogramData& data = this->Content.Data;
  const double height = QFontMetricsF(this->Layout.Font).height();
  for (int column = 0; column < data.GetNumberOfColumns(); ++column)
  {
    const QRectF slot = this->Layout.GetSlot(column);
    if (data.IsBin(column) || slot.isNull())
    {
      continue;
    }
    this->PaintLine(slot.left(), slot.bottom(), slot.right(), slot.bottom() + LineWidth);
    this->PaintText(QRectF(slot.left() - 1, slot.bottom() + TickLength, slot.width() + 2, height),
      Qt::AlignHCenter | Qt::AlignTop,
      GetColumnLabel(data.GetType(column), this->Layout.HasBriefLabels), this->Colors.Text);
  }
}

//------------------------------------------------------------------------------
void AxesPainter::PaintTitles()
{
  const QFontMetricsF metrics(this->Layout.Font);
  const QRectF& title = this->Layout.Title;
  this->PaintText(title, Qt::AlignCenter,
    metrics.elidedText(GetTitle(this->Content.Data), Qt::ElideRight, title.width()),
    this->Colors.Text);

  const QRectF& box = this->Layout.CountTitle;
  this->Painter->save();
  this->Painter->translate(box.left(), box.bottom());
  constexpr double quarter = -90;
  this->Painter->rotate(quarter);
  this->PaintText(QRectF(0, 0, box.height(), box.width()), Qt::AlignCenter,
    metrics.elidedText(GetElements(this->Content.Data), Qt::ElideRight, box.height()),
    this->Colors.Axis);
  this->Painter->restore();
}

//------------------------------------------------------------------------------
void AxesPainter::PaintLegend()
{
  const int groups = static_cast<int>(this->Content.Data.Groups.size());
  for (const PlotLegend::Entry& entry : this->Layout.Legend.GetEntries())
  {
    if (entry.Index == groups)
    {
      this->Painter->setPen(QPen(this->Colors.Outline, LineWidth));
      this->Painter->setBrush(this->Colors.GetFaded(this->Colors.Outline));
      this->Painter->drawRect(entry.Swatch.adjusted(0, 0, -LineWidth, -LineWidth));
    }
    else if (entry.Index >= 0)
    {
      this->Painter->fillRect(entry.Swatch,
        groups > 1                    ? this->Colors.GetGroupColor(entry.Index)
          : this->Content.HasLimits() ? this->Colors.Good
                                      : this->Colors.Bar);
    }
    this->PaintText(entry.TextBox, Qt::AlignLeft | Qt::AlignVCenter, entry.Text, this->Colors.Text);
  }
}

//------------------------------------------------------------------------------
void AxesPainter::PaintLine(double left, double top, double right, double bottom)
{
  this->Painter->fillRect(QRectF(QPointF(left, top), QPointF(right, bottom)), this->Colors.Axis);
}

//------------------------------------------------------------------------------
void AxesPainter::PaintText(const QRectF& box, int flags, const QString& text, const QColor& color)
{
  this->Painter->setPen(color);
  this->Painter->drawText(box, flags | Qt::TextDontClip, text);
}
}
