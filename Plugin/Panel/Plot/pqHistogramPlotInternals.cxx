// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqHistogramPlotInternals.h"

#include "PlotText.h"

#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>

using camaron::HistogramBrush;
using camaron::HistogramData;
using camaron::HistogramLayout;
using camaron::LimitHandles;

namespace
{
// Pixels by which the mouse must move for a drag of a handle or a zoom.
constexpr double DragDistance = 3;

// Ratio of the ranges before and after a step of the wheel.
constexpr double WheelFactor = 1.25;

// The same for a key.
constexpr double ZoomFactor = 1.5;
}

//------------------------------------------------------------------------------
pqHistogramPlot::pqInternals::pqInternals(pqHistogramPlot* plot)
  : Plot(plot)
{
}

//------------------------------------------------------------------------------
const HistogramLayout& pqHistogramPlot::pqInternals::GetLayout()
{
  const QSizeF size = this->Plot->size();
  const double ratio = this->Plot->devicePixelRatioF();
  if (!this->IsLayoutValid || this->Layout.Size != size || this->Layout.PixelRatio != ratio)
  {
    this->Layout = HistogramLayout(this->Content, size, this->Plot->font(), ratio);
    this->IsLayoutValid = true;
  }
  return this->Layout;
}

//------------------------------------------------------------------------------
void pqHistogramPlot::pqInternals::Invalidate()
{
  this->IsLayoutValid = false;
  this->Plot->update();
}

//------------------------------------------------------------------------------
void pqHistogramPlot::pqInternals::EmitBrush(
  const HistogramBrush& brush, Qt::KeyboardModifiers modifiers)
{
  const HistogramData& data = this->Content.Data;
  this->Plot->update();
  Q_EMIT this->Plot->brushed(
    brush.GetRanges(data), brush.GetSpecials(data), brush.GetCount(data), modifiers);
}

//------------------------------------------------------------------------------
void pqHistogramPlot::pqInternals::Brush(
  const HistogramBrush& newer, Qt::KeyboardModifiers modifiers)
{
  this->Content.Brush = this->Content.Brush.Combined(newer, camaron::ToCombination(modifiers));
  this->Content.Data.Selected = {}; // whole bars are selected now
  this->EmitBrush(newer, modifiers);
}

//------------------------------------------------------------------------------
void pqHistogramPlot::pqInternals::Clear()
{
  this->Content.Brush = HistogramBrush();
  this->EmitBrush(HistogramBrush(), Qt::NoModifier);
}

//------------------------------------------------------------------------------
void pqHistogramPlot::pqInternals::SetLimits(double low, double high)
{
  if (low != this->Content.Low || high != this->Content.High)
  {
    this->Content.Low = low;
    this->Content.High = high;
    this->Plot->update();
    Q_EMIT this->Plot->acceptableChanged(low, high);
  }
}

//------------------------------------------------------------------------------
// Shows the bins that exist in the new range until the owner sets others.
void pqHistogramPlot::pqInternals::Request(double low, double high)
{
  constexpr double least = 1e-12; // relative width; less cannot be divided into bins
  const bool isUsable = std::isfinite(low) && std::isfinite(high) &&
    high - low > least * std::max(std::abs(low), std::abs(high)) &&
    !(this->Content.Data.Logarithmic && low <= 0);
  if (isUsable && !this->Content.Data.Edges.empty())
  {
    this->Content.VisibleRange = std::make_pair(low, high);
    this->Invalidate();
    Q_EMIT this->Plot->rangeRequested(low, high);
  }
}

//------------------------------------------------------------------------------
void pqHistogramPlot::pqInternals::Press(const QPointF& position, Qt::KeyboardModifiers modifiers)
{
  const HistogramLayout& layout = this->GetLayout();
  if (this->Content.Data.IsEmpty())
  {
    return;
  }
  this->PressedAt = position;
  this->Modifiers = modifiers;
  const LimitHandles handles(this->Content, layout);
  this->Handle = handles.Find(position);
  this->Marks.FirstCurrent = this->Marks.LastCurrent = -1;
  if (this->Handle != LimitHandles::Handle::None)
  {
    this->Gesture = Gestures::Limit;
    this->GrabOffset = position.x() - handles.GetX(this->Handle);
    this->LowBefore = this->Content.Low;
    this->HighBefore = this->Content.High;
  }
  else if (this->GetLayout().IsAtAxis(position))
  {
    this->Gesture = Gestures::Zoom;
  }
  else
  {
    this->Gesture = Gestures::Brush;
    this->BrushBefore = this->Content.Brush;
    this->Anchor = layout.FindColumn(position, true);
    this->PressedOnBar =
      layout.FindColumn(position, false) >= 0 && this->Content.Data.GetCount(this->Anchor) > 0;
    this->Newer = HistogramBrush();
    this->DragBrush(position);
  }
  this->ShowHover(-1, this->Handle);
}

//------------------------------------------------------------------------------
void pqHistogramPlot::pqInternals::Drag(const QPointF& position, Qt::KeyboardModifiers modifiers)
{
  switch (this->Gesture)
  {
    case Gestures::Brush:
      this->DragBrush(position);
      break;
    case Gestures::Limit:
      this->DragLimit(position, modifiers);
      break;
    case Gestures::Zoom:
      this->Marks.Zoom = std::make_pair(this->PressedAt.x(), position.x());
      this->Plot->update();
      break;
    default:
      break;
  }
}

//------------------------------------------------------------------------------
void pqHistogramPlot::pqInternals::DragBrush(const QPointF& position)
{
  const int column = this->GetLayout().FindColumn(position, true);
  HistogramBrush newer;
  if (this->PressedOnBar || column != this->Anchor || !this->Newer.IsEmpty())
  {
    newer = HistogramBrush(this->Content.Data, this->Anchor, column);
  }
  if (newer != this->Newer)
  {
    this->Newer = newer;
    this->Content.Brush =
      this->BrushBefore.Combined(newer, camaron::ToCombination(this->Modifiers));
    this->Plot->update();
    this->EmitBrushDragging();
  }
}

//------------------------------------------------------------------------------
void pqHistogramPlot::pqInternals::EmitBrushDragging()
{
  Q_EMIT this->Plot->brushDragging(
    this->Plot->brushLow(), this->Plot->brushHigh(), this->Plot->brushedCount());
}

//------------------------------------------------------------------------------
void pqHistogramPlot::pqInternals::DragLimit(
  const QPointF& position, Qt::KeyboardModifiers modifiers)
{
  const bool isFirst =
    this->Content.Low == this->LowBefore && this->Content.High == this->HighBefore;
  if (isFirst && std::abs(position.x() - this->PressedAt.x()) < DragDistance)
  {
    return;
  }
  const LimitHandles handles(this->Content, this->GetLayout());
  const bool snap = !(modifiers & Qt::ControlModifier);
  const double limit = handles.GetLimit(this->Handle, position.x() - this->GrabOffset, snap);
  double& present =
    this->Handle == LimitHandles::Handle::Low ? this->Content.Low : this->Content.High;
  if (limit != present)
  {
    present = limit;
    this->Plot->update();
    Q_EMIT this->Plot->acceptableDragging(this->Content.Low, this->Content.High);
  }
}

//------------------------------------------------------------------------------
void pqHistogramPlot::pqInternals::Release(const QPointF& position)
{
  const Gestures gesture = this->Gesture;
  this->Gesture = Gestures::None;
  this->Marks.Zoom.reset();
  switch (gesture)
  {
    case Gestures::Brush:
      Q_EMIT this->Plot->brushEnded();
      this->ReleaseBrush();
      break;
    case Gestures::Limit:
      if (this->Content.Low != this->LowBefore || this->Content.High != this->HighBefore)
      {
        Q_EMIT this->Plot->acceptableChanged(this->Content.Low, this->Content.High);
      }
      break;
    case Gestures::Zoom:
      this->ReleaseZoom(position);
      break;
    default:
      break;
  }
  this->Hover(position);
}

//------------------------------------------------------------------------------
void pqHistogramPlot::pqInternals::ReleaseBrush()
{
  this->Content.Brush = this->BrushBefore;
  const bool isReplaced = camaron::ToCombination(this->Modifiers) == camaron::Combination::Replace;
  if (this->Newer.GetCount(this->Content.Data) > 0)
  {
    this->Brush(this->Newer, this->Modifiers);
  }
  else if (isReplaced)
  {
    this->Clear();
  }
  this->Plot->update();
}

//------------------------------------------------------------------------------
void pqHistogramPlot::pqInternals::ReleaseZoom(const QPointF& position)
{
  this->Plot->update();
  const QRectF& plot = this->GetLayout().Plot;
  const double from = std::clamp(this->PressedAt.x(), plot.left(), plot.right());
  const double to = std::clamp(position.x(), plot.left(), plot.right());
  if (std::abs(to - from) >= DragDistance)
  {
    this->Request(
      this->Layout.ToValue(std::min(from, to)), this->Layout.ToValue(std::max(from, to)));
  }
}

//------------------------------------------------------------------------------
void pqHistogramPlot::pqInternals::Cancel()
{
  if (this->Gesture == Gestures::Brush)
  {
    this->Content.Brush = this->BrushBefore;
    this->EmitBrushDragging();
  }
  else if (this->Gesture == Gestures::Limit)
  {
    this->Content.Low = this->LowBefore;
    this->Content.High = this->HighBefore;
    Q_EMIT this->Plot->acceptableDragging(this->LowBefore, this->HighBefore);
  }
  this->Forget();
}

//------------------------------------------------------------------------------
void pqHistogramPlot::pqInternals::Forget()
{
  if (std::exchange(this->Gesture, Gestures::None) == Gestures::Brush)
  {
    Q_EMIT this->Plot->brushEnded();
  }
  this->Marks.Zoom.reset();
  this->Marks.HoveredColumn = -1;
  this->Marks.ActiveHandle = LimitHandles::Handle::None;
  this->Plot->update();
}

//------------------------------------------------------------------------------
void pqHistogramPlot::pqInternals::Hover(const QPointF& position)
{
  const HistogramLayout& layout = this->GetLayout();
  const LimitHandles::Handle handle = LimitHandles(this->Content, layout).Find(position);
  int column = layout.FindColumn(position, false);
  if (handle != LimitHandles::Handle::None || this->Content.Data.IsEmpty() ||
    (column >= 0 && this->Content.Data.GetCount(column) == 0))
  {
    column = -1;
  }
  this->ShowHover(column, handle);
  this->Plot->setCursor(handle != LimitHandles::Handle::None ? Qt::SizeHorCursor
      : column >= 0                                          ? Qt::PointingHandCursor
      : this->GetLayout().IsAtAxis(position)                 ? Qt::CrossCursor
                                                             : Qt::ArrowCursor);
}

//------------------------------------------------------------------------------
void pqHistogramPlot::pqInternals::ShowHover(int column, LimitHandles::Handle handle)
{
  if (column != this->Marks.HoveredColumn || handle != this->Marks.ActiveHandle)
  {
    this->Marks.HoveredColumn = column;
    this->Marks.ActiveHandle = handle;
    this->Plot->update();
  }
}

//------------------------------------------------------------------------------
void pqHistogramPlot::pqInternals::DoubleClick(const QPointF& position)
{
  const HistogramLayout& layout = this->GetLayout();
  const int column = layout.FindColumn(position, false);
  const bool isOnBar = column >= 0 && this->Content.Data.GetCount(column) > 0;
  const bool isOnHandle =
    LimitHandles(this->Content, layout).Find(position) != LimitHandles::Handle::None;
  if (!isOnBar && !isOnHandle)
  {
    Q_EMIT this->Plot->rangeReset();
  }
}

//------------------------------------------------------------------------------
bool pqHistogramPlot::pqInternals::Wheel(const QPointF& position, double steps)
{
  if (!this->GetLayout().IsAtAxis(position))
  {
    return false;
  }
  this->ZoomAround(position.x(), std::pow(WheelFactor, steps));
  return true;
}

//------------------------------------------------------------------------------
void pqHistogramPlot::pqInternals::ZoomAround(double x, double factor)
{
  const HistogramLayout& layout = this->GetLayout();
  const QRectF& plot = layout.Plot;
  this->Request(layout.ToValue(x - (x - plot.left()) / factor),
    layout.ToValue(x + (plot.right() - x) / factor));
}

//------------------------------------------------------------------------------
bool pqHistogramPlot::pqInternals::Key(int key, Qt::KeyboardModifiers modifiers)
{
  const QRectF& plot = this->GetLayout().Plot;
  const QRectF current = this->Layout.GetSlot(this->Marks.LastCurrent);
  const double x = current.isNull() ? plot.center().x() : current.center().x();
  if (this->IsDragging() && key != Qt::Key_Escape)
  {
    return false;
  }
  if (modifiers & Qt::AltModifier)
  {
    const bool isArrow =
      key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
    if (isArrow && !this->Content.Data.Edges.empty())
    {
      this->MoveLimit(key);
    }
    return isArrow;
  }
  switch (key)
  {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Home:
    case Qt::Key_End:
      this->MoveCurrent(key, modifiers & Qt::ShiftModifier);
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
      if (this->Marks.LastCurrent < 0)
      {
        return false;
      }
      this->Brush(camaron::HistogramBrush(
                    this->Content.Data, this->Marks.FirstCurrent, this->Marks.LastCurrent),
        modifiers & (Qt::ShiftModifier | Qt::ControlModifier));
      return true;
    case Qt::Key_Escape:
      if (this->IsDragging())
      {
        this->Cancel();
        return true;
      }
      if (!this->HasSelection())
      {
        return false;
      }
      this->Clear();
      return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal: // the same key without Shift on many keyboards
      this->ZoomAround(x, ZoomFactor);
      return true;
    case Qt::Key_Minus:
      this->ZoomAround(x, 1 / ZoomFactor);
      return true;
    case Qt::Key_0:
      Q_EMIT this->Plot->rangeReset();
      return true;
    default:
      return false;
  }
}

//------------------------------------------------------------------------------
// To the next round number, or to infinity at the end of the axis: the lower limit by Left and
// Right, the upper one by Down and Up.
void pqHistogramPlot::pqInternals::MoveLimit(int key)
{
  const bool isLow = key == Qt::Key_Left || key == Qt::Key_Right;
  const bool isUp = key == Qt::Key_Right || key == Qt::Key_Up;
  const std::vector<double> round = camaron::GetRoundLimits(this->Content.Data);
  double low = this->Content.Low, high = this->Content.High;
  double& limit = isLow ? low : high;
  const auto above = std::upper_bound(round.begin(), round.end(), limit);
  const auto from = std::lower_bound(round.begin(), round.end(), limit);
  if (isUp)
  {
    limit = above != round.end() ? *above : isLow ? limit : camaron::Infinity;
  }
  else
  {
    limit = from != round.begin() ? *(from - 1) : isLow ? -camaron::Infinity : limit;
  }
  if (low <= high)
  {
    this->SetLimits(low, high);
  }
}

//------------------------------------------------------------------------------
void pqHistogramPlot::pqInternals::MoveCurrent(int key, bool extend)
{
  const std::vector<int> shown = this->GetLayout().GetShownColumns();
  if (shown.empty() || this->Content.Data.IsEmpty())
  {
    return;
  }
  const bool isForward = key == Qt::Key_Right || key == Qt::Key_Home;
  auto found = std::find(shown.begin(), shown.end(), this->Marks.LastCurrent);
  if (key == Qt::Key_Home || key == Qt::Key_End || found == shown.end())
  {
    found = isForward ? shown.begin() : shown.end() - 1;
  }
  else if (isForward ? found + 1 != shown.end() : found != shown.begin())
  {
    found += isForward ? 1 : -1;
  }
  this->Marks.LastCurrent = *found;
  if (!extend || this->Marks.FirstCurrent < 0)
  {
    this->Marks.FirstCurrent = this->Marks.LastCurrent;
  }
  // What the mouse would show.
  const QRect area = this->Layout.GetSlot(*found).toAlignedRect();
  this->Plot->setAccessibleDescription(
    camaron::DescribeColumn(this->Content.Data, *found).join(", "));
  QToolTip::showText(this->Plot->mapToGlobal(area.bottomLeft()),
    camaron::GetColumnToolTip(this->Content.Data, *found), this->Plot);
  this->Plot->update();
}
