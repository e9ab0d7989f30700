// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HistogramLayout.h"

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

QStringList GetLegendLabels(const HistogramContent& content)
{
  QStringList labels;
  const bool hasOutline = !content.Outline.IsEmpty();
  if (content.Data.Groups.size() > 1 || hasOutline)
  {
    for (const HistogramData::Group& group : content.Data.Groups)
    {
      labels << group.Label;
    }
  }
  if (hasOutline)
  {
    labels << content.Outline.Groups.front().Label;
  }
  return labels;
}
}

//------------------------------------------------------------------------------
PlotLegend::PlotLegend(const QStringList& labels, const QPointF& topLeft, double width,
  const QFontMetricsF& metrics, int mostLines)
{
  const double height = std::ceil(metrics.height());
  const double swatch = std::round(metrics.ascent() * 0.75);
  const int size = static_cast<int>(labels.size());
  double x = 0;
  int line = 0;
  for (int i = 0; i < size; ++i)
  {
    const QString text = metrics.elidedText(labels[i], Qt::ElideRight, width * LongestLabel);
    const double textWidth = std::ceil(metrics.horizontalAdvance(text));
    // Where this is the last line, the number of the other entries must fit behind this one.
    const bool isLast = i == size - 1;
    const double rest =
      isLast || line + 1 < mostLines ? 0 : OuterGap + metrics.horizontalAdvance(GetRest(size));
    if (x > 0 && x + swatch + InnerGap + textWidth + rest > width)
    {
      if (line + 1 == mostLines)
      {
        const QString others = GetRest(size - i);
        this->Entries.push_back({ -1, others, QRectF(),
          QRectF(topLeft.x() + x, topLeft.y() + line * height, width - x, height) });
        break;
      }
      x = 0;
      ++line;
    }
    const double top = topLeft.y() + line * height;
    this->Entries.push_back(
      { i, text, QRectF(topLeft.x() + x, top + std::round((height - swatch) / 2), swatch, swatch),
        QRectF(topLeft.x() + x + swatch + InnerGap, top, textWidth + 1, height) });
    x += swatch + InnerGap + textWidth + OuterGap;
  }
  this->Height = this->Entries.empty() ? 0 : (line + 1) * height;
}

//------------------------------------------------------------------------------
HistogramLayout::HistogramLayout(
  const HistogramContent& content, const QSizeF& size, const QFont& font, double pixelRatio)
  : Font(MakeFont(font))
  , Size(size)
  , PixelRatio(pixelRatio)
  , HasBriefLabels(size.width() < NarrowPlot)
  , HasAxis(!content.Data.Edges.empty() && !content.Data.IsEmpty())
  , HasIntegerBins(content.Data.HasIntegerBins())
{
  const QFontMetricsF metrics(this->Font);
  const double line = std::ceil(metrics.height());
  this->Legend = PlotLegend(GetLegendLabels(content), QPointF(Margin, Margin),
    size.width() - 2 * Margin, metrics, MostLegendLines);

  const double stripTop =
    Margin + (this->Legend.GetHeight() > 0 ? this->Legend.GetHeight() + Margin : 0);
  const double top = stripTop + std::max(line, ShortestHandles) + 1;
  const double titleHeight = content.Data.Name.isEmpty() ? 0 : line;
  const double bottom =
    std::max(size.height() - Margin - titleHeight - line - TickLength, top + line);
  this->Plot = QRectF(QPointF(0, top), QPointF(size.width(), bottom));
  this->MakeCountScale(content);
  this->CountTicks =
    GetCountTicks(this->Counts, static_cast<int>(this->Plot.height() / (1.8 * line)));

  const double countLabels = GetWidestLabel(metrics, this->CountTicks);
  this->CountTitle = QRectF(Margin - 1, top, line, this->Plot.height());
  const double left = this->CountTitle.right() + 2 + countLabels + Gap;
  const double percentLabels =
    content.Cumulative ? GetWidth(metrics, FormatPercent(1, 1)) + Gap : 0;
  const double right = size.width() - Margin - std::max(percentLabels, HandleWidth);
  this->PlaceColumns(content, left, right);

  this->HandleStrip = QRectF(this->Plot.left() - HandleWidth, stripTop,
    this->Plot.width() + 2 * HandleWidth, top - stripTop);
  this->ValueAxis = QRectF(this->Plot.left(), bottom, this->Plot.width(), TickLength + line);
  this->Title = QRectF(left, bottom + TickLength + line, right - left, titleHeight);
  const auto [low, high] =
    content.VisibleRange ? *content.VisibleRange : content.Data.GetAxisRange();
  this->Values = Scale(low, high, content.Data.Logarithmic);
  this->MakeTicks(content.Data.Edges.empty());

  // Bins and constant data need the scale of values.
  const HistogramData& data = content.Data;
  for (int bin = 0; bin < data.GetNumberOfBins(); ++bin)
  {
    double from = this->Align(this->ToX(data.Edges[bin]));
    double to = this->Align(this->ToX(data.Edges[bin + 1]));
    if (data.IsConstant())
    {
      const double half = std::min(WidestConstant, this->Plot.width() / 3) / 2;
      to = this->Align(from + half);
      from = this->Align(from - half);
    }
    if (to < this->Plot.left() || from > this->Plot.right())
    {
      continue;
    }
    from = std::clamp(from, this->Plot.left(), this->Plot.right());
    to = std::clamp(to, this->Plot.left(), this->Plot.right());
    this->Slots[data.GetColumnOfBin(bin)] = QRectF(QPointF(from, top), QPointF(to, bottom));
  }
}

//------------------------------------------------------------------------------
void HistogramLayout::PlaceColumns(const HistogramContent& content, double left, double right)
{
  const QFontMetricsF metrics(this->Font);
  const HistogramData& data = content.Data;
  const double top = this->Plot.top(), bottom = this->Plot.bottom();
  this->Columns = QRectF(QPointF(this->Align(left), top), QPointF(this->Align(right), bottom));
  this->Slots.assign(data.GetNumberOfColumns(), QRectF());
  const auto getWidth = [&](HistogramData::Column type) -> double
  {
    if (data.GetCount(type) == 0)
    {
      return 0;
    }
    return std::max(GetWidth(metrics, GetColumnLabel(type, this->HasBriefLabels)), NarrowestColumn);
  };
  left = this->Columns.left();
  right = this->Columns.right();
  for (const auto type : { HistogramData::Column::Undefined, HistogramData::Column::Infinite,
         HistogramData::Column::Overflow })
  {
    if (const double width = getWidth(type))
    {
      this->Slots[data.GetColumn(type)] =
        QRectF(QPointF(this->Align(right - width), top), QPointF(this->Align(right), bottom));
      right -= width + Gap;
    }
  }
  if (right < this->Columns.right() || content.Cumulative)
  {
    right -= HandleWidth - Gap / 2; // for the handle at the end
  }
  if (const double width = getWidth(HistogramData::Column::Underflow))
  {
    this->Slots[data.GetColumn(HistogramData::Column::Underflow)] =
      QRectF(QPointF(this->Align(left + Gap / 2), top),
        QPointF(this->Align(left + Gap / 2 + width), bottom));
    left += width + Gap + HandleWidth;
  }
  right = std::max(right, left + 1);
  this->Plot = QRectF(QPointF(this->Align(left), top), QPointF(this->Align(right), bottom));
}

//------------------------------------------------------------------------------
void HistogramLayout::MakeCountScale(const HistogramContent& content)
{
  const HistogramData& data = content.Data;
  const qint64 outlineTotal = content.Outline.GetTotal();
  this->OutlineFactor = outlineTotal == 0
    ? 0
    : static_cast<double>(data.GetTotal()) / static_cast<double>(outlineTotal);
  double most = std::max(static_cast<double>(data.GetLargestCount()),
    static_cast<double>(content.Outline.GetLargestCount()) * this->OutlineFactor);
  // The other columns may be much higher, for example after zooming, and are cut off then.
  const bool haveBins = most > 0;
  for (int column = 0; !haveBins && column < data.GetNumberOfColumns(); ++column)
  {
    most = std::max(most, static_cast<double>(data.GetCount(column)));
  }
  most = std::max(most, 1.0);
  this->Counts = content.LogarithmicCounts
    ? Scale(LogarithmicBase, most * LogarithmicHeadroom, true)
    : Scale(0, most * LinearHeadroom);
}

//------------------------------------------------------------------------------
void HistogramLayout::MakeTicks(bool isEmpty)
{
  const QFontMetricsF metrics(this->Font);
  const double width = this->Plot.width();
  if (isEmpty)
  {
    return;
  }
  // The width of the labels depends on the ticks.
  constexpr int most = 12;
  for (int number = most; number >= 2; --number)
  {
    this->ValueTicks = GetTicks(this->Values, number);
    const auto labels = std::count_if(this->ValueTicks.begin(), this->ValueTicks.end(),
      [](const Tick& tick) { return !tick.Label.isEmpty(); });
    if (static_cast<double>(labels) * (GetWidestLabel(metrics, this->ValueTicks) + LeastLabelGap) <=
      width)
    {
      return;
    }
  }
}

//------------------------------------------------------------------------------
double HistogramLayout::ToX(double value) const
{
  return this->Plot.left() + this->Values.ToFraction(value) * this->Plot.width();
}

//------------------------------------------------------------------------------
double HistogramLayout::ToValue(double x) const
{
  return this->Values.FromFraction((x - this->Plot.left()) / this->Plot.width());
}

//------------------------------------------------------------------------------
double HistogramLayout::ToY(double count) const
{
  const double fraction = std::clamp(this->Counts.ToFraction(count), 0.0, 1.0);
  const double height = this->Align(fraction * this->Plot.height());
  return this->Plot.bottom() - (count > 0 ? std::max(height, LowestBar) : 0);
}

//------------------------------------------------------------------------------
double HistogramLayout::PercentToY(double percent) const
{
  return this->Plot.bottom() - std::clamp(percent / 100, 0.0, 1.0) * this->Plot.height();
}

//------------------------------------------------------------------------------
bool HistogramLayout::IsCutOff(double count) const
{
  return count > this->Counts.GetHigh();
}

//------------------------------------------------------------------------------
double HistogramLayout::LimitToX(double limit, bool isLow) const
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
bool HistogramLayout::IsAtAxis(const QPointF& position) const
{
  return this->HasAxis && position.x() >= this->Plot.left() && position.x() <= this->Plot.right() &&
    position.y() >= this->Plot.bottom() && position.y() <= this->Size.height();
}

//------------------------------------------------------------------------------
QRectF HistogramLayout::GetSlot(int column) const
{
  return column >= 0 && column < static_cast<int>(this->Slots.size()) ? this->Slots[column]
                                                                      : QRectF();
}

//------------------------------------------------------------------------------
std::vector<int> HistogramLayout::GetShownColumns() const
{
  std::vector<int> shown;
  for (std::size_t i = 0; i < this->Slots.size(); ++i)
  {
    if (!this->Slots[i].isNull())
    {
      shown.push_back(static_cast<int>(i));
    }
  }
  return shown;
}

//------------------------------------------------------------------------------
int HistogramLayout::FindColumn(const QPointF& position, bool nearest) const
{
  if (!nearest && (position.y() < this->Plot.top() || position.y() > this->Plot.bottom()))
  {
    return -1;
  }
  int found = -1;
  double least = nearest ? std::numeric_limits<double>::max() : 0;
  for (std::size_t i = 0; i < this->Slots.size(); ++i)
  {
    const QRectF& slot = this->Slots[i];
    if (slot.isNull())
    {
      continue;
    }
    if (position.x() >= slot.left() && position.x() < slot.right())
    {
      return static_cast<int>(i);
    }
    const double distance = std::max(slot.left() - position.x(), position.x() - slot.right());
    if (distance < least)
    {
      found = static_cast<int>(i);
      least = distance;
    }
  }
  return found;
}

//------------------------------------------------------------------------------
double HistogramLayout::Align(double position) const
{
  return std::round(position * this->PixelRatio) / this->PixelRatio;
}
}
