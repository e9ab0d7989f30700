// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HistogramPainter.h"

#include "PlotColors.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
// Lengths in pixels.
constexpr double BarGap = 1;
constexpr double NarrowestWithGap = 4; // bars of this width have a gap between them
constexpr double NarrowestBar = 2;     // so that a bar of a single element is visible
constexpr double BrushLine = 3;        // below brushed columns
constexpr double OutlineWidth = 1.3;
constexpr double LevelHeight = 3; // of the line of a group
constexpr double CurveWidth = 1.5;

constexpr double AllPercent = 100;

// Opacities, of 255.
constexpr int BrushAlpha = 46, HoverAlpha = 22, CurrentAlpha = 24, ZoomAlpha = 60,
              OutlineAlpha = 46, TotalAlpha = 50;

QRectF MakeBox(double left, double top, double right, double bottom)
{
  return QRectF(QPointF(left, top), QPointF(right, bottom));
}

struct BarsPainter
{
  QPainter* Painter;
  const HistogramScene& Scene;
  const PlotColors& Colors;

  void PaintShades()
  {
    if (this->Scene.HasLimits() && !this->Scene.Data.Edges.empty())
    {
      this->FillParts(this->Scene.Plot, this->Colors.GoodShade, this->Colors.BadShade, false);
    }
  }

  void PaintColumnMarks()
  {
    const HistogramMarks& marks = this->Scene.Marks;
    const int first = std::min(marks.FirstCurrent, marks.LastCurrent);
    const int last = std::max(marks.FirstCurrent, marks.LastCurrent);
    QRectF current;
    for (int column = 0; column < this->Scene.Data.GetNumberOfColumns(); ++column)
    {
      const QRectF slot = this->Scene.GetSlot(column);
      if (this->Scene.Brush.Contains(column))
      {
        this->Painter->fillRect(slot, WithAlpha(this->Colors.Brush, BrushAlpha));
      }
      if (column == marks.HoveredColumn)
      {
        this->Painter->fillRect(slot, WithAlpha(this->Colors.Text, HoverAlpha));
      }
      if (first >= 0 && column >= first && column <= last)
      {
        current = current.united(slot);
      }
    }
    if (!current.isNull())
    {
      constexpr double half = 0.5;
      this->Painter->setPen(QPen(this->Colors.Brush, 1));
      this->Painter->setBrush(WithAlpha(this->Colors.Brush, CurrentAlpha));
      this->Painter->drawRect(current.adjusted(-half, half, half, 0));
    }
  }

  void PaintOutline(const QPen& pen, const QBrush& brush)
  {
    const HistogramData& outline = this->Scene.Outline;
    if (outline.IsEmpty() || outline.Edges.empty() || outline.IsConstant())
    {
      return;
    }
    const HistogramScene& scene = this->Scene;
    QPainterPath path;
    path.moveTo(scene.ToX(outline.Edges.front()), scene.Plot.bottom());
    for (int bin = 0; bin < outline.GetNumberOfBins(); ++bin)
    {
      const qint64 count = outline.GetCount(outline.GetColumnOfBin(bin));
      const double y = scene.ToY(static_cast<double>(count) * scene.OutlineFactor);
      path.lineTo(scene.Align(scene.ToX(outline.Edges[bin])), y);
      path.lineTo(scene.Align(scene.ToX(outline.Edges[bin + 1])), y);
    }
    path.lineTo(scene.ToX(outline.Edges.back()), scene.Plot.bottom());
    this->Painter->save();
    this->Painter->setClipRect(scene.Plot);
    this->Painter->setPen(pen);
    this->Painter->setBrush(brush);
    this->Painter->drawPath(path);
    this->Painter->restore();
  }

  void PaintCurve()
  {
    const HistogramData& data = this->Scene.Data;
    const CumulativeCounts& curve = this->Scene.Curve;
    if (!this->Scene.Cumulative || data.Edges.empty())
    {
      return;
    }
    const double total = static_cast<double>(data.GetNumberOfValues());
    const QRectF& plot = this->Scene.Plot;
    constexpr double farthest = 1e4; // from the plot, within what the painter can draw
    const double first = plot.left() - farthest, last = plot.right() + farthest;
    double y = this->Scene.PercentToY(0);
    QPolygonF points({ { plot.left() - CurveWidth, y } });
    for (std::size_t i = 0; i < curve.Values.size(); ++i)
    {
      const double x = std::clamp(this->Scene.ToX(curve.Values[i]), first, last);
      if (i == 0)
      {
        points << QPointF(x, y);
      }
      y = this->Scene.PercentToY(AllPercent * static_cast<double>(curve.Counts[i]) / total);
      points << QPointF(x, y);
    }
    points << QPointF(std::max(plot.right(), points.back().x()), y);
    this->Painter->save();
    this->Painter->setRenderHint(QPainter::Antialiasing);
    constexpr double margin = 1; // for the width of the line
    this->Painter->setClipRect(plot.adjusted(0, -margin, 0, margin));
    this->Painter->setPen(QPen(this->Colors.Curve, CurveWidth));
    this->Painter->drawPolyline(points);
    this->Painter->restore();
  }

  void PaintBars()
  {
    const HistogramData& data = this->Scene.Data;
    const HistogramBrush& brush = this->Scene.Brush;
    for (int column = 0; column < data.GetNumberOfColumns(); ++column)
    {
      const QRectF slot = this->Scene.GetSlot(column);
      if (slot.isNull())
      {
        continue;
      }
      if (brush.Contains(column))
      {
        this->Painter->fillRect(
          QRectF(slot.left(), slot.bottom(), slot.width(), BrushLine), this->Colors.Brush);
      }
      const double count = static_cast<double>(data.GetCount(column));
      if (count == 0)
      {
        continue;
      }
      const bool isBin = data.IsBin(column);
      const bool hasParts = brush.IsEmpty() && !data.Selected.Counts.empty();
      const bool isFaded = hasParts || (!brush.IsEmpty() && !brush.Contains(column));
      const double gap = isBin && slot.width() >= NarrowestWithGap ? BarGap : 0;
      const double top = this->Scene.ToY(count);
      const QRectF bar(
        slot.left(), top, std::max(slot.width() - gap, NarrowestBar), slot.bottom() - top);
      if (data.Groups.size() > 1)
      {
        this->PaintGroups(column, bar, isFaded);
      }
      else
      {
        const double notJudged = static_cast<double>(data.GetNotJudged(column));
        if (notJudged > 0) // gray, above those that are judged
        {
          this->Fill(bar, this->Colors.Special, isFaded);
        }
        this->PaintPart(column, bar, count - notJudged, isFaded);
        if (hasParts)
        {
          this->PaintPart(column, bar, static_cast<double>(data.Selected.Counts[column]), false);
        }
      }
      if (this->Scene.IsCutOff(count))
      {
        this->PaintBreak(bar);
      }
    }
  }

  void PaintZoom()
  {
    if (this->Scene.Marks.Zoom)
    {
      const QRectF zone = this->Scene.Plot.united(this->Scene.ValueAxis);
      const auto [from, to] =
        std::minmax(this->Scene.Marks.Zoom->first, this->Scene.Marks.Zoom->second);
      this->Painter->fillRect(
        MakeBox(from, zone.top(), to, zone.bottom()), WithAlpha(this->Colors.Axis, ZoomAlpha));
    }
  }

  // As many elements of a bar, at its bottom.
  void PaintPart(int column, const QRectF& bar, double count, bool isFaded)
  {
    const HistogramData& data = this->Scene.Data;
    const bool isRange = data.IsBin(column) && !this->Scene.HasIntegerBins && !data.IsConstant();
    const QRectF part = MakeBox(bar.left(), this->Scene.ToY(count), bar.right(), bar.bottom());
    if (isRange && this->Scene.HasLimits())
    { // a limit may be within the bin
      this->FillParts(part, this->Colors.Good, this->Colors.Bad, isFaded);
    }
    else
    {
      this->Fill(part, isRange ? this->Colors.Bar : this->GetColorOfColumn(column), isFaded);
    }
  }

  // Between the limits of the acceptable range, and outside.
  void FillParts(const QRectF& box, const QColor& good, const QColor& bad, bool isFaded)
  {
    const double low = this->Scene.GetHandleX(LimitHandle::Low);
    const double high = this->Scene.GetHandleX(LimitHandle::High);
    const double ends[] = { box.left(), std::clamp(low, box.left(), box.right()),
      std::clamp(high, box.left(), box.right()), box.right() };
    for (int part = 0; part < 3; ++part)
    {
      if (ends[part + 1] > ends[part])
      {
        const double middle = this->Scene.ToValue((ends[part] + ends[part + 1]) / 2);
        const bool isGood = middle >= this->Scene.Low && middle <= this->Scene.High;
        this->Fill(MakeBox(ends[part], box.top(), ends[part + 1], box.bottom()),
          isGood ? good : bad, isFaded);
      }
    }
  }

  // Stacked, with what is selected of a group at the bottom of its part of the bar. Heights do not
  // add up on a logarithmic axis: there each group is a line at its own count, in front of a pale
  // bar of the total.
  void PaintGroups(int column, const QRectF& bar, bool isFaded)
  {
    const HistogramData& data = this->Scene.Data;
    const double total = static_cast<double>(data.GetCount(column));
    const std::size_t parts = this->Scene.Brush.IsEmpty() ? data.SelectedGroups.size() : 0;
    double upTo = 0, bottom = bar.bottom();
    if (this->Scene.LogarithmicCounts)
    {
      this->Painter->fillRect(bar, WithAlpha(this->Colors.Axis, TotalAlpha));
    }
    for (std::size_t group = 0; group < data.Groups.size(); ++group)
    {
      const QColor color = this->Colors.GetGroupColor(static_cast<int>(group));
      const double count = static_cast<double>(data.Groups[group].Counts[column]);
      const double selected =
        group < parts ? static_cast<double>(data.SelectedGroups[group].Counts[column]) : 0;
      if (this->Scene.LogarithmicCounts)
      {
        this->PaintLevel(bar, count, color, isFaded);
        this->PaintLevel(bar, selected, color, false);
        continue;
      }
      upTo += count;
      const double top = this->Scene.Align(bar.bottom() - bar.height() * (upTo / total));
      this->Fill(MakeBox(bar.left(), top, bar.right(), bottom), color, isFaded);
      if (selected > 0)
      {
        const double height = (bottom - top) * (selected / count);
        this->Fill(MakeBox(bar.left(), bottom - height, bar.right(), bottom), color, false);
      }
      bottom = top;
    }
  }

  void PaintLevel(const QRectF& bar, double count, const QColor& color, bool isFaded)
  {
    if (count > 0)
    {
      this->Fill(
        QRectF(bar.left(), this->Scene.ToY(count), bar.width(), LevelHeight), color, isFaded);
    }
  }

  // Two slanted lines that show that the bar is higher than the plot.
  void PaintBreak(const QRectF& bar)
  {
    constexpr double depth = 8, distance = 5, rise = 4, width = 2;
    this->Painter->save();
    this->Painter->setRenderHint(QPainter::Antialiasing);
    this->Painter->setClipRect(bar);
    this->Painter->setPen(QPen(this->Colors.Background, width));
    for (const double y : { bar.top() + depth, bar.top() + depth + distance })
    {
      this->Painter->drawLine(
        QPointF(bar.left(), y + rise / 2), QPointF(bar.right(), y - rise / 2));
    }
    this->Painter->restore();
  }

  void Fill(const QRectF& box, const QColor& color, bool isFaded)
  {
    this->Painter->fillRect(box, isFaded ? this->Colors.GetFaded(color) : color);
  }

  QColor GetColorOfColumn(int column) const
  {
    const HistogramData& data = this->Scene.Data;
    switch (data.GetType(column))
    {
      case HistogramData::Column::Bin:
        return this->Colors.GetJudged(data.Edges[column - 1] + (data.IsConstant() ? 0 : 0.5),
          this->Scene.Low, this->Scene.High);
      case HistogramData::Column::Underflow:
        return this->GetColorOfOutside(true);
      case HistogramData::Column::Overflow:
        return this->GetColorOfOutside(false);
      default:
        return this->Colors.Special;
    }
  }

  // Values below or above all bins are known to be good or bad if the limit on that side is absent
  // or within the axis, or if the curve knows how many are beyond the limit.
  QColor GetColorOfOutside(bool isBelow) const
  {
    const HistogramData& data = this->Scene.Data;
    const CumulativeCounts& curve = this->Scene.Curve;
    const double low = this->Scene.Low, high = this->Scene.High;
    if (!this->Scene.HasLimits() || data.Edges.empty())
    {
      return this->Colors.Bar;
    }
    const double first = data.Edges.front(), last = data.Edges.back();
    if (isBelow ? low >= first || high < first : high <= last || low > last)
    {
      return this->Colors.Bad;
    }
    if (isBelow ? std::isinf(low) : std::isinf(high))
    {
      return this->Colors.Good;
    }
    const double all = static_cast<double>(
      data.GetCount(isBelow ? HistogramData::Column::Underflow : HistogramData::Column::Overflow));
    const CumulativeCounts::Estimate beyond =
      curve
        .GetOutside(isBelow ? low : -Infinity, isBelow ? Infinity : high, data.GetNumberOfValues())
        .Count;
    if (curve.IsEmpty() || !beyond.Exact || data.GetCount(HistogramData::Column::Infinite) > 0)
    {
      return this->Colors.Bar;
    }
    return beyond.Value >= all ? this->Colors.Bad
      : beyond.Value == 0      ? this->Colors.Good
                               : this->Colors.Bar;
  }
};
}

//------------------------------------------------------------------------------
void PaintHistogram(QPainter* painter, const HistogramScene& scene, const QPalette& palette)
{
  const PlotColors colors(palette);
  const QRectF all(QPointF(0, 0), scene.Size);
  painter->fillRect(all, colors.Background);
  painter->setFont(scene.Font);
  if (scene.Data.IsEmpty())
  {
    constexpr double margin = 16;
    painter->setPen(colors.Axis);
    painter->drawText(all.adjusted(margin, margin, -margin, -margin),
      Qt::AlignCenter | Qt::TextWordWrap, scene.EmptyText);
    return;
  }
  BarsPainter bars{ painter, scene, colors };
  bars.PaintShades();
  bars.PaintColumnMarks();
  PaintGrid(painter, scene, colors);
  bars.PaintOutline(Qt::NoPen, WithAlpha(colors.Outline, OutlineAlpha));
  bars.PaintBars();
  bars.PaintOutline(QPen(colors.Outline, OutlineWidth), Qt::NoBrush);
  bars.PaintCurve();
  PaintAxes(painter, scene, colors);
  bars.PaintZoom();
}

//------------------------------------------------------------------------------
void PaintSmallHistogram(QPainter* painter, const QRect& rect, const HistogramData& data,
  double acceptableLow, double acceptableHigh, const QPalette& palette)
{
  const int bins = data.GetNumberOfBins();
  const PlotColors colors(palette);
  // Several bins share a column of pixels if there are more bins than pixels.
  const int columns = std::min(bins, rect.width());
  // The only bar of constant data is in the middle.
  const QRect plot =
    data.IsConstant() ? rect.adjusted(rect.width() / 3, 0, -(rect.width() / 3), 0) : rect;
  const qint64 most = data.GetLargestCount();
  if (most == 0)
  {
    return;
  }
  painter->fillRect(
    QRectF(rect.left(), rect.bottom(), rect.width(), 1), colors.GetFaded(colors.Axis));
  const double width = static_cast<double>(plot.width()) / columns;
  const double bottom = rect.top() + rect.height();
  const auto paintBars = [&](const auto& countInColumn, bool isFaded)
  {
    for (const QColor& color : { colors.Bar, colors.Good, colors.Bad })
    { // bad ones in front of others at the same pixels
      for (int bin = 0; bin < bins; ++bin)
      {
        const double middle = data.Edges[bin] / 2 + data.Edges[bin + 1] / 2;
        const qint64 count = countInColumn(data.GetColumnOfBin(bin));
        if (count > 0 && colors.GetJudged(middle, acceptableLow, acceptableHigh) == color)
        {
          constexpr double lowest = 2;
          const double share = static_cast<double>(count) / static_cast<double>(most);
          const double top = bottom - std::max(rect.height() * share, lowest);
          const double left = plot.left() + width * (((bin + 1) * columns - 1) / bins);
          painter->fillRect(
            MakeBox(left, top, left + width, bottom), isFaded ? colors.GetFaded(color) : color);
        }
      }
    }
  };
  const bool isOfSelection = !data.Selected.Counts.empty();
  paintBars([&](int column) { return data.GetCount(column); }, isOfSelection);
  if (isOfSelection)
  {
    paintBars([&](int column) { return data.Selected.Counts[column]; }, false);
  }
}
}
