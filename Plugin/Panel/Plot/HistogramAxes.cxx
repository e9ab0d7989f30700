// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HistogramPainter.h"

#include "NumberText.h"
#include "PlotColors.h"
#include "PlotText.h"

#include <QCoreApplication>
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
constexpr double TextGap = 4;  // between a handle and its number

struct AxesPainter
{
  Q_DECLARE_TR_FUNCTIONS(pqHistogramPlot)

public:
  QPainter* Painter;
  const HistogramScene& Scene;
  const PlotColors& Colors;

  void PaintCountAxis()
  {
    const QRectF& columns = this->Scene.Columns;
    for (const Tick& tick : this->Scene.CountTicks)
    {
      const double y = tick.Value > 0 ? this->Scene.ToY(tick.Value) : columns.bottom();
      this->PaintText(QRectF(columns.left() - LabelGap, y, 0, 0), Qt::AlignRight | Qt::AlignVCenter,
        tick.Label, this->Colors.Text);
    }
  }

  void PaintPercentAxis()
  {
    if (!this->Scene.Cumulative || this->Scene.Data.Edges.empty())
    {
      return;
    }
    const QRectF& columns = this->Scene.Columns;
    const double height = this->Scene.Metrics.height();
    const bool isHigh = columns.height() > 4 * height;
    for (const int percent : { 0, 25, 50, 75, 100 })
    {
      if (percent % 50 == 0 || isHigh)
      {
        const double y = this->Scene.PercentToY(percent);
        this->PaintText(QRectF(columns.right() + LabelGap, y, 0, 0),
          Qt::AlignLeft | Qt::AlignVCenter, FormatPercent(percent, 100), this->Colors.Curve);
      }
    }
  }

  void PaintValueAxis()
  {
    const QRectF& plot = this->Scene.Plot;
    this->PaintLine(plot.left(), plot.bottom(), plot.right(), plot.bottom() + LineWidth);
    if (this->Scene.Data.Edges.empty())
    {
      this->PaintText(plot, Qt::AlignCenter | Qt::TextWordWrap,
        this->Scene.Data.Logarithmic ? tr("No positive values") : tr("No finite values"),
        this->Colors.Axis);
      return;
    }
    for (const Tick& tick : this->Scene.ValueTicks)
    {
      const double x = this->Scene.Align(this->Scene.ToX(tick.Value));
      const double length = tick.Label.isEmpty() ? MinorTickLength : TickLength;
      this->PaintLine(x, plot.bottom(), x + LineWidth, plot.bottom() + length);
      if (!tick.Label.isEmpty())
      {
        // Labels at the ends stay near the plot, so that those of other columns have space.
        const double width = std::ceil(this->Scene.Metrics.horizontalAdvance(tick.Label));
        const double left = std::clamp(x - width / 2, plot.left() - LabelGap,
          std::max(plot.right() + LabelGap - width, plot.left() - LabelGap));
        this->PaintText(
          QRectF(left, plot.bottom() + TickLength, width + 1, this->Scene.Metrics.height()),
          Qt::AlignLeft | Qt::AlignTop, tick.Label, this->Colors.Text);
      }
    }
  }

  void PaintColumnLabels()
  {
    const HistogramData& data = this->Scene.Data;
    const double height = this->Scene.Metrics.height();
    for (int column = 0; column < data.GetNumberOfColumns(); ++column)
    {
      const QRectF slot = this->Scene.GetSlot(column);
      if (data.IsBin(column) || slot.isNull())
      {
        continue;
      }
      this->PaintLine(slot.left(), slot.bottom(), slot.right(), slot.bottom() + LineWidth);
      this->PaintText(QRectF(slot.left() - 1, slot.bottom() + TickLength, slot.width() + 2, height),
        Qt::AlignHCenter | Qt::AlignTop,
        GetColumnLabel(data.GetType(column), this->Scene.HasBriefLabels), this->Colors.Text);
    }
  }

  void PaintTitles()
  {
    const HistogramData& data = this->Scene.Data;
    const QRectF& title = this->Scene.Title;
    this->PaintText(title, Qt::AlignCenter,
      this->Scene.Metrics.elidedText(AddUnit(data.Name, data.Unit), Qt::ElideRight, title.width()),
      this->Colors.Text);

    const QRectF& box = this->Scene.CountTitle;
    this->Painter->save();
    this->Painter->translate(box.left(), box.bottom());
    constexpr double quarter = -90;
    this->Painter->rotate(quarter);
    this->PaintText(QRectF(0, 0, box.height(), box.width()), Qt::AlignCenter,
      this->Scene.Metrics.elidedText(GetElements(data), Qt::ElideRight, box.height()),
      this->Colors.Axis);
    this->Painter->restore();
  }

  void PaintLegend()
  {
    const int groups = static_cast<int>(this->Scene.Data.Groups.size());
    for (const LegendEntry& entry : this->Scene.Legend)
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
          groups > 1                  ? this->Colors.GetGroupColor(entry.Index)
            : this->Scene.HasLimits() ? this->Colors.Good
                                      : this->Colors.Bar);
      }
      this->PaintText(
        entry.TextBox, Qt::AlignLeft | Qt::AlignVCenter, entry.Text, this->Colors.Text);
    }
  }

  void PaintHandles()
  {
    if (this->Scene.Data.Edges.empty())
    {
      return;
    }
    const auto [low, high] = this->Scene.Data.GetAxisRange();
    constexpr double fraction = 1e-3; // of the axis
    const double tolerance = fraction * (high - low);
    constexpr int leastDigits = 6;
    QRectF occupied;
    // The active one last, above the other; its number first, because there may be space for one.
    const bool isHighActive = this->Scene.Marks.ActiveHandle == LimitHandle::High;
    const LimitHandle first = isHighActive ? LimitHandle::High : LimitHandle::Low;
    const LimitHandle other = isHighActive ? LimitHandle::Low : LimitHandle::High;
    this->PaintHandle(other);
    this->PaintHandle(first);
    for (const LimitHandle handle : { first, other })
    {
      const double limit = this->Scene.GetLimit(handle);
      if (std::isfinite(limit))
      {
        const QString text = FormatLimit(
          limit, this->Scene.Data.Unit, GetNumberOfDigits(limit, tolerance, leastDigits));
        const QRectF box =
          this->GetTextBox(handle, std::ceil(this->Scene.Metrics.horizontalAdvance(text)) + 1);
        if (handle == first ||
          !(box.intersects(occupied) || box.intersects(this->Scene.GetGrip(first))))
        {
          this->PaintText(box, Qt::AlignCenter, text, this->Colors.Text);
        }
        occupied = box;
      }
    }
  }

  void PaintHandle(LimitHandle handle)
  {
    const QRectF& plot = this->Scene.Plot;
    const double value = this->Scene.GetLimit(handle), x = this->Scene.GetHandleX(handle);
    const bool isActive = handle == this->Scene.Marks.ActiveHandle;
    const bool isFinite = std::isfinite(value);
    const QColor color = isActive ? this->Colors.Brush : this->Colors.Text;
    const double line = isActive ? 2 : 1;
    const double raw = this->Scene.ToX(value);
    this->Painter->save();
    if (isFinite && raw >= plot.left() - 1 && raw <= plot.right() + 1)
    {
      this->Painter->fillRect(QRectF(x - line / 2, plot.top(), line, plot.height()), color);
    }
    // A flag with its tip at the line, on the side that is not acceptable.
    const QRectF grip = this->Scene.GetGrip(handle);
    const double outer = handle == LimitHandle::Low ? grip.left() : grip.right();
    const double inner = handle == LimitHandle::Low ? grip.right() : grip.left();
    const double shoulder = grip.top() + grip.height() * 0.55;
    const QPolygonF shape({ { inner, grip.top() + 1 }, { outer, grip.top() + 1 },
      { outer, shoulder }, { inner, grip.bottom() } });
    this->Painter->setRenderHint(QPainter::Antialiasing);
    this->Painter->setPen(QPen(isFinite ? color
        : isActive                      ? this->Colors.Brush
                                        : this->Colors.Axis,
      1));
    this->Painter->setBrush(isFinite ? color : this->Colors.Background);
    this->Painter->drawPolygon(shape);
    this->Painter->restore();
  }

  // Beside the grip, or on the other side of the line if it would reach above the labels of an
  // axis.
  QRectF GetTextBox(LimitHandle handle, double width) const
  {
    const QRectF grip = this->Scene.GetGrip(handle);
    const QRectF& plot = this->Scene.Plot;
    const double before = grip.left() - TextGap - width, after = grip.right() + TextGap;
    const bool fitsBefore = before >= plot.left(), fitsAfter = after + width <= plot.right();
    const bool isBefore = handle == LimitHandle::Low ? fitsBefore : !fitsAfter;
    const QRectF& strip = this->Scene.HandleStrip;
    return QRectF(isBefore ? before : after, strip.top(), width, strip.height());
  }

  void PaintLine(double left, double top, double right, double bottom)
  {
    this->Painter->fillRect(QRectF(QPointF(left, top), QPointF(right, bottom)), this->Colors.Axis);
  }

  void PaintText(const QRectF& box, int flags, const QString& text, const QColor& color)
  {
    this->Painter->setPen(color);
    this->Painter->drawText(box, flags | Qt::TextDontClip, text);
  }
};
}

//------------------------------------------------------------------------------
void PaintGrid(QPainter* painter, const HistogramScene& scene, const PlotColors& colors)
{
  for (const Tick& tick : scene.CountTicks)
  {
    if (!tick.Label.isEmpty() && tick.Value > 0)
    {
      const double y = scene.ToY(tick.Value);
      painter->fillRect(
        QRectF(scene.Columns.left(), y, scene.Columns.width(), LineWidth), colors.Grid);
    }
  }
}

//------------------------------------------------------------------------------
void PaintAxes(QPainter* painter, const HistogramScene& scene, const PlotColors& colors)
{
  AxesPainter axes{ painter, scene, colors };
  axes.PaintCountAxis();
  axes.PaintPercentAxis();
  axes.PaintValueAxis();
  axes.PaintColumnLabels();
  axes.PaintTitles();
  axes.PaintLegend();
  axes.PaintHandles();
}
}
