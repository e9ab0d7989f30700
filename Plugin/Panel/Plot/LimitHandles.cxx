// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LimitHandles.h"

#include "NumberText.h"
#include "PlotColors.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
// Lengths in pixels.
constexpr double GripWidth = 8, GripHeight = 12;
constexpr double Reach = 3;                // around grips and lines, for the mouse
constexpr double NarrowestGraspedBar = 10; // of bars beside which a line can be grasped, too
constexpr double InfiniteBeyond = 10;      // outside the axis
constexpr double TextGap = 4;              // between a handle and its number
}

//------------------------------------------------------------------------------
LimitHandles::LimitHandles(const HistogramContent& content, const HistogramLayout& layout)
  : Content(content)
  , Layout(layout)
{
}

//------------------------------------------------------------------------------
double LimitHandles::GetValue(Handle handle) const
{
  return handle == Handle::Low ? this->Content.Low : this->Content.High;
}

//------------------------------------------------------------------------------
double LimitHandles::GetX(Handle handle) const
{
  return this->Layout.Align(this->Layout.LimitToX(this->GetValue(handle), handle == Handle::Low));
}

//------------------------------------------------------------------------------
QRectF LimitHandles::GetGrip(Handle handle) const
{
  const double x = this->GetX(handle);
  const double left = handle == Handle::Low ? x - GripWidth : x;
  return QRectF(left, this->Layout.Plot.top() - GripHeight, GripWidth, GripHeight);
}

//------------------------------------------------------------------------------
LimitHandles::Handle LimitHandles::Find(const QPointF& position) const
{
  if (this->Content.Data.IsEmpty() || this->Content.Data.Edges.empty())
  {
    return Handle::None;
  }
  const Handle handles[] = { Handle::Low, Handle::High };
  // Exactly on a grip first, because the surroundings of two grips may overlap.
  for (const double reach : { 0.0, Reach })
  {
    for (const Handle handle : handles)
    {
      if (this->GetGrip(handle).adjusted(-reach, -reach, reach, 0).contains(position))
      {
        return handle;
      }
    }
  }
  const QRectF& plot = this->Layout.Plot;
  const int bins = this->Content.Data.GetNumberOfBins();
  if (position.y() > plot.bottom() || position.y() < plot.top() ||
    plot.width() / bins < NarrowestGraspedBar)
  {
    return Handle::None;
  }
  for (const Handle handle : handles)
  {
    if (std::isfinite(this->GetValue(handle)) &&
      std::abs(position.x() - this->GetX(handle)) <= Reach)
    {
      return handle;
    }
  }
  return Handle::None;
}

//------------------------------------------------------------------------------
double LimitHandles::GetLimit(Handle handle, double x, bool snap) const
{
  const QRectF& plot = this->Layout.Plot;
  const bool isLow = handle == Handle::Low;
  if (isLow ? x < plot.left() - InfiniteBeyond : x > plot.right() + InfiniteBeyond)
  {
    return isLow ? -Infinity : Infinity;
  }
  const double inside = std::clamp(x, plot.left(), plot.right());
  const double limit = snap ? this->GetRoundLimitAt(inside, isLow) : this->GetNumberAt(inside);
  return isLow ? std::min(limit, this->Content.High) : std::max(limit, this->Content.Low);
}

//------------------------------------------------------------------------------
double LimitHandles::GetRoundLimitAt(double x, bool isLow) const
{
  double limit = this->GetNumberAt(x);
  double least = Infinity;
  for (const double round : GetRoundLimits(this->Content.Data))
  {
    const double distance = std::abs(this->Layout.LimitToX(round, isLow) - x);
    if (distance < least)
    {
      least = distance;
      limit = round;
    }
  }
  return limit;
}

//------------------------------------------------------------------------------
double LimitHandles::GetNumberAt(double x) const
{
  constexpr double half = 0.5; // of a pixel
  const double value = this->Layout.ToValue(x);
  if (this->Content.Data.HasIntegerBins())
  {
    return std::round(value);
  }
  const double tolerance = std::abs(this->Layout.ToValue(x + half) - value);
  return QString::number(value, 'g', GetNumberOfDigits(value, tolerance, 1)).toDouble();
}

//------------------------------------------------------------------------------
QString LimitHandles::GetText(Handle handle) const
{
  constexpr int least = 6;
  constexpr double fraction = 1e-3; // of the axis
  const auto [low, high] = this->Content.Data.GetAxisRange();
  const double value = this->GetValue(handle);
  return FormatLimit(
    value, this->Content.Data.Unit, GetNumberOfDigits(value, fraction * (high - low), least));
}

//------------------------------------------------------------------------------
// Beside the grip, or on the other side of the line if it would reach above the labels of an axis.
QRectF LimitHandles::GetTextBox(Handle handle, double width) const
{
  const QRectF grip = this->GetGrip(handle);
  const QRectF& strip = this->Layout.HandleStrip;
  const bool isLow = handle == Handle::Low;
  const double before = grip.left() - TextGap - width, after = grip.right() + TextGap;
  const QRectF& plot = this->Layout.Plot;
  const bool fitsBefore = before >= plot.left(), fitsAfter = after + width <= plot.right();
  const double left = isLow ? (fitsBefore ? before : after) : (fitsAfter ? after : before);
  return QRectF(left, strip.top(), width, strip.height());
}

//------------------------------------------------------------------------------
void LimitHandles::Paint(QPainter* painter, const PlotColors& colors, Handle active) const
{
  if (this->Content.Data.Edges.empty())
  {
    return;
  }
  const QFontMetricsF metrics(this->Layout.Font);
  QRectF occupied;
  // The active one last, above the other; its number first, because there may be space for one.
  const Handle other = active == Handle::High ? Handle::Low : Handle::High;
  const Handle first = other == Handle::Low ? Handle::High : Handle::Low;
  this->PaintHandle(painter, colors, other, false);
  this->PaintHandle(painter, colors, first, active == first);
  for (const Handle handle : { first, other })
  {
    if (!std::isfinite(this->GetValue(handle)))
    {
      continue;
    }
    const QString text = this->GetText(handle);
    const QRectF box = this->GetTextBox(handle, std::ceil(metrics.horizontalAdvance(text)) + 1);
    const QRectF otherGrip = this->GetGrip(handle == Handle::Low ? Handle::High : Handle::Low);
    if (handle == first || !(box.intersects(occupied) || box.intersects(otherGrip)))
    {
      painter->setPen(colors.Text);
      painter->drawText(box, Qt::AlignCenter | Qt::TextDontClip, text);
    }
    occupied = box;
  }
}

//------------------------------------------------------------------------------
void LimitHandles::PaintHandle(
  QPainter* painter, const PlotColors& colors, Handle handle, bool isActive) const
{
  const QRectF& plot = this->Layout.Plot;
  const double value = this->GetValue(handle), x = this->GetX(handle);
  const bool isFinite = std::isfinite(value);
  const QColor color = isActive ? colors.Brush : colors.Text;
  const double line = isActive ? 2 : 1;
  const double raw = this->Layout.ToX(value);
  painter->save();
  if (isFinite && raw >= plot.left() - 1 && raw <= plot.right() + 1)
  {
    painter->fillRect(QRectF(x - line / 2, plot.top(), line, plot.height()), color);
  }
  // A flag with its tip at the line, on the side that is not acceptable.
  const QRectF grip = this->GetGrip(handle);
  const double outer = handle == Handle::Low ? grip.left() : grip.right();
  const double inner = handle == Handle::Low ? grip.right() : grip.left();
  const double shoulder = grip.top() + grip.height() * 0.55;
  const QPolygonF shape({ { inner, grip.top() + 1 }, { outer, grip.top() + 1 }, { outer, shoulder },
    { inner, grip.bottom() } });
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(QPen(isFinite ? color : isActive ? colors.Brush : colors.Axis, 1));
  painter->setBrush(isFinite ? color : colors.Background);
  painter->drawPolygon(shape);
  painter->restore();
}
}
