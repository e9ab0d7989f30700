// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What mouse and keyboard do with the plot.
#include "pqHistogramPlot.h"

#include "PlotText.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

using camaron::HistogramBrush;
using camaron::HistogramScene;
using camaron::LimitHandle;

namespace
{
// Pixels by which the mouse must move for a drag of a handle or a zoom.
constexpr double DragDistance = 3;

// Ratio of the ranges before and after a step of the wheel, and the same for a key.
constexpr double WheelFactor = 1.25, KeyFactor = 1.5;

// Angle of a step of the wheel; see QWheelEvent::angleDelta.
constexpr double AngleOfStep = 120;
}

//------------------------------------------------------------------------------
bool pqHistogramPlot::event(QEvent* event)
{
  if (event->type() == QEvent::ToolTip)
  {
    auto* help = static_cast<QHelpEvent*>(event);
    QRect area;
    const QString text = camaron::GetToolTip(this->placedScene(), help->pos(), area);
    if (text.isEmpty() || this->isDragging())
    {
      QToolTip::hideText();
      event->ignore();
    }
    else
    {
      QToolTip::showText(help->globalPos(), text, this, area);
    }
    return true;
  }
  if (event->type() == QEvent::ShortcutOverride)
  {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const bool isZoom = key == Qt::Key_Plus || key == Qt::Key_Minus || key == Qt::Key_0;
    const bool canEscape = this->isDragging() || this->hasSelection();
    if (isZoom || (key == Qt::Key_Escape && canEscape))
    { // ParaView has shortcuts with these keys
      event->accept();
      return true;
    }
  }
  return Superclass::event(event);
}

//------------------------------------------------------------------------------
void pqHistogramPlot::mousePressEvent(QMouseEvent* event)
{
  if (event->button() != Qt::LeftButton)
  {
    event->ignore(); // such as for a context menu
    return;
  }
  const HistogramScene& scene = this->placedScene();
  if (scene.Data.IsEmpty())
  {
    return;
  }
  this->PressedAt = event->position();
  this->Modifiers = event->modifiers() & (Qt::ShiftModifier | Qt::ControlModifier);
  this->BrushBefore = scene.Brush;
  this->LowBefore = scene.Low;
  this->HighBefore = scene.High;
  this->Scene.Marks.FirstCurrent = this->Scene.Marks.LastCurrent = -1;
  const LimitHandle handle = scene.FindHandle(this->PressedAt);
  if (handle != LimitHandle::None)
  {
    this->Gesture = Gestures::Limit;
    this->GrabOffset = this->PressedAt.x() - scene.GetHandleX(handle);
  }
  else if (scene.IsAtAxis(this->PressedAt))
  {
    this->Gesture = Gestures::Zoom;
  }
  else
  {
    this->Gesture = Gestures::Brush;
    this->Anchor = scene.FindColumn(this->PressedAt, true);
    this->PressedOnBar = scene.FindBar(this->PressedAt) >= 0;
    this->Newer = HistogramBrush();
    this->dragBrush(this->PressedAt);
  }
  this->mark(-1, handle);
}

//------------------------------------------------------------------------------
void pqHistogramPlot::mouseMoveEvent(QMouseEvent* event)
{
  switch (this->Gesture)
  {
    case Gestures::None:
      if (event->buttons() == Qt::NoButton)
      {
        this->hover(event->position());
      }
      break;
    case Gestures::Brush:
      this->dragBrush(event->position());
      break;
    case Gestures::Limit:
      this->dragLimit(event->position().x(), event->modifiers());
      break;
    case Gestures::Zoom:
      this->Scene.Marks.Zoom = std::make_pair(this->PressedAt.x(), event->position().x());
      this->update();
      break;
  }
}

//------------------------------------------------------------------------------
void pqHistogramPlot::mouseReleaseEvent(QMouseEvent* event)
{
  if (event->button() != Qt::LeftButton || !this->isDragging())
  {
    return;
  }
  const Gestures gesture = std::exchange(this->Gesture, Gestures::None);
  this->Scene.Marks.Zoom.reset();
  this->update();
  if (gesture == Gestures::Brush)
  {
    Q_EMIT this->brushEnded();
    this->releaseBrush();
  }
  else if (gesture == Gestures::Zoom)
  {
    this->releaseZoom(event->position().x());
  }
  else if (this->Scene.Low != this->LowBefore || this->Scene.High != this->HighBefore)
  {
    Q_EMIT this->acceptableChanged(this->Scene.Low, this->Scene.High);
  }
  this->hover(event->position());
}

//------------------------------------------------------------------------------
void pqHistogramPlot::mouseDoubleClickEvent(QMouseEvent* event)
{
  const HistogramScene& scene = this->placedScene();
  if (event->button() == Qt::LeftButton && scene.FindBar(event->position()) < 0 &&
    scene.FindHandle(event->position()) == LimitHandle::None)
  {
    Q_EMIT this->rangeReset();
  }
}

//------------------------------------------------------------------------------
void pqHistogramPlot::leaveEvent(QEvent* event)
{
  if (!this->isDragging())
  {
    this->endDrag();
  }
  Superclass::leaveEvent(event);
}

//------------------------------------------------------------------------------
void pqHistogramPlot::hideEvent(QHideEvent* event)
{
  if (this->isDragging())
  {
    this->cancelDrag();
  }
  Superclass::hideEvent(event);
}

//------------------------------------------------------------------------------
void pqHistogramPlot::wheelEvent(QWheelEvent* event)
{
  // Else it scrolls the panel, also when the plot passes below the mouse.
  const bool isMeant = this->hasFocus() || (event->modifiers() & Qt::ControlModifier);
  event->setAccepted(isMeant && this->placedScene().IsAtAxis(event->position()));
  if (event->isAccepted())
  {
    this->zoomAround(
      event->position().x(), std::pow(WheelFactor, event->angleDelta().y() / AngleOfStep));
  }
}

//------------------------------------------------------------------------------
void pqHistogramPlot::hover(const QPointF& position)
{
  const HistogramScene& scene = this->placedScene();
  const LimitHandle handle = scene.FindHandle(position);
  const int column = handle == LimitHandle::None ? scene.FindBar(position) : -1;
  this->mark(column, handle);
  this->setCursor(handle != LimitHandle::None ? Qt::SizeHorCursor
      : column >= 0                           ? Qt::PointingHandCursor
      : scene.IsAtAxis(position)              ? Qt::CrossCursor
                                              : Qt::ArrowCursor);
}

//------------------------------------------------------------------------------
void pqHistogramPlot::mark(int column, LimitHandle handle)
{
  camaron::HistogramMarks& marks = this->Scene.Marks;
  if (column != marks.HoveredColumn || handle != marks.ActiveHandle)
  {
    marks.HoveredColumn = column;
    marks.ActiveHandle = handle;
    this->update();
  }
}

//------------------------------------------------------------------------------
void pqHistogramPlot::dragBrush(const QPointF& position)
{
  const int column = this->placedScene().FindColumn(position, true);
  HistogramBrush newer;
  if (this->PressedOnBar || column != this->Anchor || !this->Newer.IsEmpty())
  {
    newer = HistogramBrush(this->Scene.Data, this->Anchor, column);
  }
  if (newer != this->Newer)
  {
    this->Newer = newer;
    this->showBrush(this->BrushBefore.Combined(newer, camaron::ToCombination(this->Modifiers)));
  }
}

//------------------------------------------------------------------------------
void pqHistogramPlot::showBrush(const HistogramBrush& brush)
{
  this->Scene.Brush = brush;
  this->update();
  Q_EMIT this->brushDragging(this->brushLow(), this->brushHigh(), this->brushedCount());
}

//------------------------------------------------------------------------------
void pqHistogramPlot::dragLimit(double x, Qt::KeyboardModifiers modifiers)
{
  const bool isFirst = this->Scene.Low == this->LowBefore && this->Scene.High == this->HighBefore;
  if (isFirst && std::abs(x - this->PressedAt.x()) < DragDistance)
  {
    return;
  }
  const bool snap = !(modifiers & Qt::ControlModifier);
  const LimitHandle handle = this->Scene.Marks.ActiveHandle;
  const double limit = this->placedScene().GetLimitAt(handle, x - this->GrabOffset, snap);
  if (limit != this->Scene.GetLimit(handle))
  {
    (handle == LimitHandle::Low ? this->Scene.Low : this->Scene.High) = limit;
    this->update();
    Q_EMIT this->acceptableDragging(this->Scene.Low, this->Scene.High);
  }
}

//------------------------------------------------------------------------------
void pqHistogramPlot::releaseBrush()
{
  this->Scene.Brush = this->BrushBefore;
  if (this->Newer.GetCount(this->Scene.Data) > 0)
  {
    this->brush(this->Newer, this->Modifiers);
  }
  else if (this->Modifiers == Qt::NoModifier)
  {
    this->brush(HistogramBrush(), Qt::NoModifier);
  }
}

//------------------------------------------------------------------------------
void pqHistogramPlot::releaseZoom(double x)
{
  const HistogramScene& scene = this->placedScene();
  const double from = std::clamp(this->PressedAt.x(), scene.Plot.left(), scene.Plot.right());
  const double to = std::clamp(x, scene.Plot.left(), scene.Plot.right());
  if (std::abs(to - from) >= DragDistance)
  {
    this->zoomTo(scene.ToValue(std::min(from, to)), scene.ToValue(std::max(from, to)));
  }
}

//------------------------------------------------------------------------------
void pqHistogramPlot::cancelDrag()
{
  if (this->Gesture == Gestures::Brush)
  {
    this->showBrush(this->BrushBefore);
  }
  else if (this->Gesture == Gestures::Limit)
  {
    this->Scene.Low = this->LowBefore;
    this->Scene.High = this->HighBefore;
    Q_EMIT this->acceptableDragging(this->LowBefore, this->HighBefore);
  }
  this->endDrag();
}

//------------------------------------------------------------------------------
void pqHistogramPlot::endDrag()
{
  if (std::exchange(this->Gesture, Gestures::None) == Gestures::Brush)
  {
    Q_EMIT this->brushEnded();
  }
  this->Scene.Marks.Zoom.reset();
  this->mark(-1, LimitHandle::None);
  this->update();
}

//------------------------------------------------------------------------------
void pqHistogramPlot::brush(const HistogramBrush& newer, Qt::KeyboardModifiers modifiers)
{
  const camaron::HistogramData& data = this->Scene.Data;
  this->Scene.Brush = this->Scene.Brush.Combined(newer, camaron::ToCombination(modifiers));
  this->Scene.Data.Selected = {}; // whole bars are selected now
  this->update();
  Q_EMIT this->brushed(
    newer.GetRanges(data), newer.GetSpecials(data), newer.GetCount(data), modifiers);
}

//------------------------------------------------------------------------------
// Shows the bins that exist in the new range until the owner sets others.
void pqHistogramPlot::zoomTo(double low, double high)
{
  constexpr double least = 1e-12; // relative width; less cannot be divided into bins
  const bool isUsable = std::isfinite(low) && std::isfinite(high) &&
    high - low > least * std::max(std::abs(low), std::abs(high)) &&
    !(this->Scene.Data.Logarithmic && low <= 0);
  if (isUsable && !this->Scene.Data.Edges.empty())
  {
    this->Scene.VisibleRange = std::make_pair(low, high);
    this->placeAgain();
    Q_EMIT this->rangeRequested(low, high);
  }
}

//------------------------------------------------------------------------------
void pqHistogramPlot::zoomAround(double x, double factor)
{
  const HistogramScene& scene = this->placedScene();
  this->zoomTo(scene.ToValue(x - (x - scene.Plot.left()) / factor),
    scene.ToValue(x + (scene.Plot.right() - x) / factor));
}

//------------------------------------------------------------------------------
void pqHistogramPlot::keyPressEvent(QKeyEvent* event)
{
  if (!this->pressKey(event->key(), event->modifiers()))
  {
    Superclass::keyPressEvent(event);
  }
}

//------------------------------------------------------------------------------
bool pqHistogramPlot::pressKey(int key, Qt::KeyboardModifiers modifiers)
{
  const HistogramScene& scene = this->placedScene();
  const QRectF current = scene.GetSlot(scene.Marks.LastCurrent);
  const double x = (current.isNull() ? scene.Plot : current).center().x();
  if (this->isDragging() && key != Qt::Key_Escape)
  {
    return false;
  }
  if (modifiers & Qt::AltModifier)
  {
    const bool isArrow =
      key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
    if (isArrow && !scene.Data.Edges.empty())
    {
      this->moveLimit(key);
    }
    return isArrow;
  }
  switch (key)
  {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Home:
    case Qt::Key_End:
      this->moveCurrent(key, modifiers & Qt::ShiftModifier);
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
      if (scene.Marks.LastCurrent < 0)
      {
        return false;
      }
      this->brush(HistogramBrush(scene.Data, scene.Marks.FirstCurrent, scene.Marks.LastCurrent),
        modifiers & (Qt::ShiftModifier | Qt::ControlModifier));
      return true;
    case Qt::Key_Escape:
      if (this->isDragging())
      {
        this->cancelDrag();
        return true;
      }
      if (this->hasSelection())
      {
        this->brush(HistogramBrush(), Qt::NoModifier);
        return true;
      }
      return false;
    case Qt::Key_Plus:
    case Qt::Key_Equal: // the same key without Shift on many keyboards
      this->zoomAround(x, KeyFactor);
      return true;
    case Qt::Key_Minus:
      this->zoomAround(x, 1 / KeyFactor);
      return true;
    case Qt::Key_0:
      Q_EMIT this->rangeReset();
      return true;
    default:
      return false;
  }
}

//------------------------------------------------------------------------------
// To the next round number, or to infinity at the end of the axis: the lower limit by Left and
// Right, the upper one by Down and Up.
void pqHistogramPlot::moveLimit(int key)
{
  const bool isLow = key == Qt::Key_Left || key == Qt::Key_Right;
  const bool isUp = key == Qt::Key_Right || key == Qt::Key_Up;
  const std::vector<double> round = camaron::GetRoundLimits(this->Scene.Data);
  double low = this->Scene.Low, high = this->Scene.High;
  double& limit = isLow ? low : high;
  if (isUp)
  {
    const auto above = std::upper_bound(round.begin(), round.end(), limit);
    limit = above != round.end() ? *above : isLow ? limit : camaron::Infinity;
  }
  else
  {
    const auto from = std::lower_bound(round.begin(), round.end(), limit);
    limit = from != round.begin() ? *(from - 1) : isLow ? -camaron::Infinity : limit;
  }
  if (low <= high && (low != this->Scene.Low || high != this->Scene.High))
  {
    this->showAcceptable(low, high);
    Q_EMIT this->acceptableChanged(low, high);
  }
}

//------------------------------------------------------------------------------
void pqHistogramPlot::moveCurrent(int key, bool extend)
{
  const HistogramScene& scene = this->placedScene();
  camaron::HistogramMarks& marks = this->Scene.Marks;
  const bool isForward = key == Qt::Key_Right || key == Qt::Key_Home;
  const int step = isForward ? 1 : -1, last = scene.Data.GetNumberOfColumns() - 1;
  const bool isFromEnd =
    key == Qt::Key_Home || key == Qt::Key_End || scene.GetSlot(marks.LastCurrent).isNull();
  int column = !isFromEnd ? marks.LastCurrent + step : isForward ? 0 : last;
  while (column >= 0 && column <= last && scene.GetSlot(column).isNull())
  {
    column += step;
  }
  const bool isBeyond = column < 0 || column > last;
  if (scene.Data.IsEmpty() || (isBeyond && isFromEnd))
  {
    return; // no column is shown
  }
  marks.LastCurrent = isBeyond ? marks.LastCurrent : column;
  if (!extend || marks.FirstCurrent < 0)
  {
    marks.FirstCurrent = marks.LastCurrent;
  }
  // What the mouse would show.
  const QRect area = scene.GetSlot(marks.LastCurrent).toAlignedRect();
  this->setAccessibleDescription(camaron::DescribeColumn(scene.Data, marks.LastCurrent).join(", "));
  QToolTip::showText(this->mapToGlobal(area.bottomLeft()),
    camaron::GetColumnToolTip(scene.Data, marks.LastCurrent), this);
  this->update();
}
