// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HistogramScene.h"

#include "NumberText.h"
#include "PlotText.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
// Lengths in pixels.
constexpr double Margin = 4;
constexpr double Gap = 6;              // between an axis and its labels, and between columns
constexpr double ShortestHandles = 13; // height of the strip for handles
constexpr double HandleWidth = 9;      // beside the plot
constexpr double NarrowestColumn = 18; // outside the bins
constexpr double LowestBar = 2;
constexpr double WidestConstant = 48; // of the bar of constant data
constexpr double LeastLabelGap = 12;  // between labels of values

// Below this width, labels of columns are symbols.
constexpr double NarrowPlot = 420;

// Of handles: the grips, and around them and their lines, for the mouse; the width of bars beside
// which a line can be grasped, too; and where a limit becomes infinite, outside the axis.
constexpr double GripWidth = 8, GripHeight = 12, Reach = 3, NarrowestGraspedBar = 10,
                 InfiniteBeyond = 10;

// Space above the highest bar, and below a count of 1 if the axis is logarithmic.
constexpr double LinearHeadroom = 1.06, LogarithmicHeadroom = 1.5, LogarithmicBase = 0.5;

constexpr int MostLegendLines = 2;

// In the legend, pixels between a swatch and its text, and between entries.
constexpr double InnerGap = 4, OuterGap = 12;

// No label takes more than this fraction of a line.
constexpr double LongestLabel = 0.6;

// Font of all texts, relative to that of the widget, and the smallest one.
constexpr double FontScale = 0.9, SmallestPoints = 7;

QFont MakeFont(QFont font)
{
  if (font.pointSizeF() > 0)
  {
    font.setPointSizeF(std::max(font.pointSizeF() * FontScale, SmallestPoints));
  }
  else
  {
    font.setPixelSize(static_cast<int>(std::lround(font.pixelSize() * FontScale)));
  }
  return font;
}

double GetWidth(const QFontMetricsF& metrics, const QString& text)
{
  return std::ceil(metrics.horizontalAdvance(text));
}

double GetWidestLabel(const QFontMetricsF& metrics, const std::vector<Tick>& ticks)
{
  double width = 0;
  for (const Tick& tick : ticks)
  {
    width = std::max(width, GetWidth(metrics, tick.Label));
  }
  return width;
}

QString GetRest(int number)
{
  return QCoreApplication::translate("pqHistogramPlot", "and %1 more").arg(number);
}

QStringList GetLegendLabels(const HistogramScene& scene)
{
  QStringList labels;
  const bool hasOutline = !scene.Outline.IsEmpty();
  if (scene.Data.Groups.size() > 1 || hasOutline)
  {
    for (const HistogramData::Group& group : scene.Data.Groups)
    {
      labels << group.Label;
    }
  }
  if (hasOutline)
  {
    labels << scene.Outline.Groups.front().Label;
  }
  return labels;
}
}

//------------------------------------------------------------------------------
void HistogramScene::Place(const QSizeF& size, const QFont& font, double pixelRatio)
{
  this->Font = MakeFont(font);
  this->Metrics = QFontMetricsF(this->Font);
  this->Size = size;
  this->PixelRatio = pixelRatio;
  this->HasBriefLabels = size.width() < NarrowPlot;
  this->HasIntegerBins = this->Data.HasIntegerBins();
  const double line = std::ceil(this->Metrics.height());
  this->PlaceLegend();

  const double stripTop =
    Margin + (this->Legend.empty() ? 0 : this->Legend.back().TextBox.bottom());
  const double top = stripTop + std::max(line, ShortestHandles) + 1;
  const double titleHeight = this->Data.Name.isEmpty() ? 0 : line;
  const double bottom =
    std::max(size.height() - Margin - titleHeight - line - TickLength, top + line);
  this->Plot = QRectF(QPointF(0, top), QPointF(size.width(), bottom));
  this->MakeCountScale();
  this->CountTicks =
    GetCountTicks(this->Counts, static_cast<int>(this->Plot.height() / (1.8 * line)));

  const double countLabels = GetWidestLabel(this->Metrics, this->CountTicks);
  this->CountTitle = QRectF(Margin - 1, top, line, this->Plot.height());
  const double left = this->CountTitle.right() + 2 + countLabels + Gap;
  const double percentLabels =
    this->Cumulative ? GetWidth(this->Metrics, FormatPercent(1, 1)) + Gap : 0;
  const double right = size.width() - Margin - std::max(percentLabels, HandleWidth);
  this->PlaceColumns(left, right);

  this->HandleStrip = QRectF(this->Plot.left() - HandleWidth, stripTop,
    this->Plot.width() + 2 * HandleWidth, top - stripTop);
  this->ValueAxis = QRectF(this->Plot.left(), bottom, this->Plot.width(), TickLength + line);
  this->Title = QRectF(left, bottom + TickLength + line, right - left, titleHeight);
  const auto [low, high] = this->VisibleRange ? *this->VisibleRange : this->Data.GetAxisRange();
  this->Values = Scale(low, high, this->Data.Logarithmic);
  this->MakeValueTicks();
  this->PlaceBins();
}

//------------------------------------------------------------------------------
// The last entry summarizes those that do not fit.
void HistogramScene::PlaceLegend()
{
  const QStringList labels = GetLegendLabels(*this);
  const double width = this->Size.width() - 2 * Margin;
  const double height = std::ceil(this->Metrics.height());
  const double swatch = std::round(this->Metrics.ascent() * 0.75);
  const int size = static_cast<int>(labels.size());
  double x = 0;
  int line = 0;
  this->Legend.clear();
  for (int i = 0; i < size; ++i)
  {
    const QString text = this->Metrics.elidedText(labels[i], Qt::ElideRight, width * LongestLabel);
    const double textWidth = GetWidth(this->Metrics, text);
    // Where this is the last line, the number of the other entries must fit behind this one.
    const bool isLastLine = line + 1 == MostLegendLines;
    const double rest =
      i < size - 1 && isLastLine ? OuterGap + this->Metrics.horizontalAdvance(GetRest(size)) : 0;
    if (x > 0 && x + swatch + InnerGap + textWidth + rest > width)
    {
      if (isLastLine)
      {
        this->Legend.push_back({ -1, GetRest(size - i), QRectF(),
          QRectF(Margin + x, Margin + line * height, width - x, height) });
        break;
      }
      x = 0;
      ++line;
    }
    const double top = Margin + line * height;
    this->Legend.push_back(
      { i, text, QRectF(Margin + x, top + std::round((height - swatch) / 2), swatch, swatch),
        QRectF(Margin + x + swatch + InnerGap, top, textWidth + 1, height) });
    x += swatch + InnerGap + textWidth + OuterGap;
  }
}

//------------------------------------------------------------------------------
QRectF HistogramScene::MakeSlot(double left, double right) const
{
  return QRectF(
    QPointF(this->Align(left), this->Plot.top()), QPointF(this->Align(right), this->Plot.bottom()));
}

//------------------------------------------------------------------------------
void HistogramScene::PlaceColumns(double left, double right)
{
  this->Columns = this->MakeSlot(left, right);
  this->Slots.assign(this->Data.GetNumberOfColumns(), QRectF());
  const auto getWidth = [&](HistogramData::Column type)
  {
    const QString label = GetColumnLabel(type, this->HasBriefLabels);
    return this->Data.GetCount(type) == 0
      ? 0
      : std::max(GetWidth(this->Metrics, label), NarrowestColumn);
  };
  left = this->Columns.left();
  right = this->Columns.right();
  for (const auto type : { HistogramData::Column::Undefined, HistogramData::Column::Infinite,
         HistogramData::Column::Overflow })
  {
    if (const double width = getWidth(type))
    {
      this->Slots[this->Data.GetColumn(type)] = this->MakeSlot(right - width, right);
      right -= width + Gap;
    }
  }
  if (right < this->Columns.right() || this->Cumulative)
  {
    right -= HandleWidth - Gap / 2; // for the handle at the end
  }
  if (const double width = getWidth(HistogramData::Column::Underflow))
  {
    this->Slots.front() = this->MakeSlot(left + Gap / 2, left + Gap / 2 + width);
    left += width + Gap + HandleWidth;
  }
  this->Plot = this->MakeSlot(left, std::max(right, left + 1));
}

//------------------------------------------------------------------------------
void HistogramScene::PlaceBins()
{
  for (int bin = 0; bin < this->Data.GetNumberOfBins(); ++bin)
  {
    double from = this->Align(this->ToX(this->Data.Edges[bin]));
    double to = this->Align(this->ToX(this->Data.Edges[bin + 1]));
    if (this->Data.IsConstant())
    {
      const double half = std::min(WidestConstant, this->Plot.width() / 3) / 2;
      to = from + half;
      from -= half;
    }
    if (to >= this->Plot.left() && from <= this->Plot.right())
    {
      this->Slots[this->Data.GetColumnOfBin(bin)] =
        this->MakeSlot(std::max(from, this->Plot.left()), std::min(to, this->Plot.right()));
    }
  }
}

//------------------------------------------------------------------------------
void HistogramScene::MakeCountScale()
{
  const qint64 total = this->Data.GetTotal(), outlineTotal = this->Outline.GetTotal();
  this->OutlineFactor =
    outlineTotal == 0 ? 0 : static_cast<double>(total) / static_cast<double>(outlineTotal);
  double most = std::max(static_cast<double>(this->Data.GetLargestCount()),
    static_cast<double>(this->Outline.GetLargestCount()) * this->OutlineFactor);
  // The other columns may be much higher, for example after zooming, and are cut off then.
  const bool haveBins = most > 0;
  for (int column = 0; !haveBins && column < this->Data.GetNumberOfColumns(); ++column)
  {
    most = std::max(most, static_cast<double>(this->Data.GetCount(column)));
  }
  most = std::max(most, 1.0);
  this->Counts = this->LogarithmicCounts ? Scale(LogarithmicBase, most * LogarithmicHeadroom, true)
                                         : Scale(0, most * LinearHeadroom);
}

//------------------------------------------------------------------------------
void HistogramScene::MakeValueTicks()
{
  this->ValueTicks.clear();
  // The width of the labels depends on the ticks.
  constexpr int most = 12;
  for (int number = most; number >= 2 && !this->Data.Edges.empty(); --number)
  {
    this->ValueTicks = GetTicks(this->Values, number, this->Data.HasWholeNumbers() ? 1 : 0);
    const auto labels = std::count_if(this->ValueTicks.begin(), this->ValueTicks.end(),
      [](const Tick& tick) { return !tick.Label.isEmpty(); });
    if (static_cast<double>(labels) *
        (GetWidestLabel(this->Metrics, this->ValueTicks) + LeastLabelGap) <=
      this->Plot.width())
    {
      break;
    }
  }
}

//------------------------------------------------------------------------------
double HistogramScene::ToX(double value) const
{
  return this->Plot.left() + this->Values.ToFraction(value) * this->Plot.width();
}

//------------------------------------------------------------------------------
double HistogramScene::ToValue(double x) const
{
  return this->Values.FromFraction((x - this->Plot.left()) / this->Plot.width());
}

//------------------------------------------------------------------------------
double HistogramScene::ToY(double count) const
{
  const double fraction = std::clamp(this->Counts.ToFraction(count), 0.0, 1.0);
  const double height = this->Align(fraction * this->Plot.height());
  return this->Plot.bottom() - (count > 0 ? std::max(height, LowestBar) : 0);
}

//------------------------------------------------------------------------------
double HistogramScene::PercentToY(double percent) const
{
  return this->Plot.bottom() - std::clamp(percent / 100, 0.0, 1.0) * this->Plot.height();
}

//------------------------------------------------------------------------------
bool HistogramScene::IsAtAxis(const QPointF& position) const
{
  return this->HasValues() && position.x() >= this->Plot.left() &&
    position.x() <= this->Plot.right() && position.y() >= this->Plot.bottom() &&
    position.y() <= this->Size.height();
}

//------------------------------------------------------------------------------
QRectF HistogramScene::GetSlot(int column) const
{
  return column >= 0 && column < static_cast<int>(this->Slots.size()) ? this->Slots[column]
                                                                      : QRectF();
}

//------------------------------------------------------------------------------
int HistogramScene::FindColumn(const QPointF& position, bool nearest) const
{
  const double x = position.x();
  const auto getDistance = [x](const QRectF& slot)
  {
    constexpr double inside = -1; // less than beside its end, where the next one begins
    return slot.isNull() ? Infinity
      : x < slot.left()  ? slot.left() - x
      : x < slot.right() ? inside
                         : x - slot.right();
  };
  const auto found = std::min_element(this->Slots.begin(), this->Slots.end(),
    [&](const QRectF& a, const QRectF& b) { return getDistance(a) < getDistance(b); });
  const double distance = found == this->Slots.end() ? Infinity : getDistance(*found);
  const bool isInside =
    distance < 0 && position.y() >= this->Plot.top() && position.y() <= this->Plot.bottom();
  return isInside || (nearest && distance < Infinity)
    ? static_cast<int>(found - this->Slots.begin())
    : -1;
}

//------------------------------------------------------------------------------
int HistogramScene::FindBar(const QPointF& position) const
{
  const int column = this->FindColumn(position, false);
  return column >= 0 && this->Data.GetCount(column) > 0 ? column : -1;
}

//------------------------------------------------------------------------------
double HistogramScene::LimitToX(double limit, bool isLow) const
{
  if (std::isinf(limit))
  {
    return limit < 0 ? this->Plot.left() : this->Plot.right();
  }
  if (this->HasIntegerBins)
  {
    limit = isLow ? std::ceil(limit) - 0.5 : std::floor(limit) + 0.5;
  }
  return std::clamp(this->ToX(limit), this->Plot.left(), this->Plot.right());
}

//------------------------------------------------------------------------------
double HistogramScene::GetHandleX(LimitHandle handle) const
{
  return this->Align(this->LimitToX(this->GetLimit(handle), handle == LimitHandle::Low));
}

//------------------------------------------------------------------------------
QRectF HistogramScene::GetGrip(LimitHandle handle) const
{
  const double x = this->GetHandleX(handle);
  const double left = handle == LimitHandle::Low ? x - GripWidth : x;
  return QRectF(left, this->Plot.top() - GripHeight, GripWidth, GripHeight);
}

//------------------------------------------------------------------------------
LimitHandle HistogramScene::FindHandle(const QPointF& position) const
{
  if (!this->HasValues())
  {
    return LimitHandle::None;
  }
  const LimitHandle handles[] = { LimitHandle::Low, LimitHandle::High };
  // Exactly on a grip first, because the surroundings of two grips may overlap.
  for (const double reach : { 0.0, Reach })
  {
    for (const LimitHandle handle : handles)
    {
      if (this->GetGrip(handle).adjusted(-reach, -reach, reach, 0).contains(position))
      {
        return handle;
      }
    }
  }
  const bool isInPlot = position.y() >= this->Plot.top() && position.y() <= this->Plot.bottom();
  const bool areWide = this->Plot.width() / this->Data.GetNumberOfBins() >= NarrowestGraspedBar;
  for (const LimitHandle handle : handles)
  {
    if (isInPlot && areWide && std::isfinite(this->GetLimit(handle)) &&
      std::abs(position.x() - this->GetHandleX(handle)) <= Reach)
    {
      return handle;
    }
  }
  return LimitHandle::None;
}

//------------------------------------------------------------------------------
double HistogramScene::GetLimitAt(LimitHandle handle, double x, bool snap) const
{
  const QRectF& plot = this->Plot;
  const bool isLow = handle == LimitHandle::Low;
  if (isLow ? x < plot.left() - InfiniteBeyond : x > plot.right() + InfiniteBeyond)
  {
    return isLow ? -Infinity : Infinity;
  }
  const double inside = std::clamp(x, plot.left(), plot.right());
  const double limit = snap ? this->GetRoundLimitAt(inside, isLow) : this->GetNumberAt(inside);
  return isLow ? std::min(limit, this->High) : std::max(limit, this->Low);
}

//------------------------------------------------------------------------------
double HistogramScene::GetRoundLimitAt(double x, bool isLow) const
{
  const std::vector<double> limits = GetRoundLimits(this->Data);
  const auto getDistance = [&](double limit) { return std::abs(this->LimitToX(limit, isLow) - x); };
  const auto nearest = std::min_element(limits.begin(), limits.end(),
    [&](double a, double b) { return getDistance(a) < getDistance(b); });
  return nearest == limits.end() ? this->GetNumberAt(x) : *nearest;
}

//------------------------------------------------------------------------------
double HistogramScene::GetNumberAt(double x) const
{
  constexpr double half = 0.5; // of a pixel
  const double value = this->ToValue(x);
  if (this->HasIntegerBins)
  {
    return std::round(value);
  }
  const double tolerance = std::abs(this->ToValue(x + half) - value);
  return QString::number(value, 'g', GetNumberOfDigits(value, tolerance, 1)).toDouble();
}

//------------------------------------------------------------------------------
double HistogramScene::Align(double position) const
{
  return std::round(position * this->PixelRatio) / this->PixelRatio;
}
}
