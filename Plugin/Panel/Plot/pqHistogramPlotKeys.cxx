// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What the keyboard does in a histogram plot.
#include "PlotToolTip.h"
#include "pqHistogramPlotInternals.h"

#include <QToolTip>

#include <algorithm>
#include <limits>

namespace
{
// Ratio of the ranges before and after zooming.
constexpr double ZoomFactor = 1.5;
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
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const bool isLow = key == Qt::Key_Left || key == Qt::Key_Right;
  const bool isUp = key == Qt::Key_Right || key == Qt::Key_Up;
  const std::vector<double> round = camaron::GetRoundLimits(this->Content.Data);
  double low = this->Content.Low, high = this->Content.High;
  double& limit = isLow ? low : high;
  const auto above = std::upper_bound(round.begin(), round.end(), limit);
  const auto from = std::lower_bound(round.begin(), round.end(), limit);
  if (isUp)
  {
    limit = above != round.end() ? *above : isLow ? limit : infinity;
  }
  else
  {
    limit = from != round.begin() ? *(from - 1) : isLow ? -infinity : limit;
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
