// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqHistogramPlot.h"

#include "HistogramPainter.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

using camaron::CumulativeCounts;
using camaron::HistogramBrush;
using camaron::HistogramData;

namespace
{
//------------------------------------------------------------------------------
QString SpellCounts(const HistogramData& data)
{
  QStringList counts;
  for (int bin = 0; bin < data.GetNumberOfBins(); ++bin)
  {
    counts << QString::number(data.GetCount(data.GetColumnOfBin(bin)));
  }
  return counts.join(' ');
}
}

//------------------------------------------------------------------------------
pqHistogramPlot::pqHistogramPlot(QWidget* parent)
  : Superclass(parent)
{
  this->Scene.EmptyText = tr("No data");
  this->setFocusPolicy(Qt::StrongFocus);
  this->setMouseTracking(true);
  this->setAttribute(Qt::WA_OpaquePaintEvent);
  this->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  this->setAccessibleName(tr("Histogram"));
  this->setWhatsThis(
    tr("<p>Number of elements per range of values. Click a bar, or drag over several, to select "
       "their elements. Shift adds to the selection, Ctrl subtracts from it, Ctrl+Shift keeps the "
       "elements that are in both. Click on empty space, or press Esc, to clear it.</p>"
       "<p>Drag the flags above the plot to change the acceptable range.</p>"
       "<p>Drag along the axis or turn the wheel over it to zoom; double-click the axis to "
       "reset.</p>"
       "<p>Keys: Left, Right, Home and End move between the bars, with Shift over several; Return "
       "selects. Alt+Left and Alt+Right move the lower limit, Alt+Down and Alt+Up the upper one. "
       "+ and - zoom, 0 resets.</p>"));
}

//------------------------------------------------------------------------------
void pqHistogramPlot::setData(const HistogramData& data)
{
  const bool haveSameBins =
    this->Scene.Data.Edges == data.Edges && this->Scene.Data.Logarithmic == data.Logarithmic;
  this->Scene.Data = data.IsValid() ? data : HistogramData();
  this->Scene.VisibleRange.reset();
  if (!haveSameBins)
  {
    this->Scene.Brush = HistogramBrush();
    this->endDrag();
    this->Scene.Marks = {};
  }
  this->setAccessibleName(
    data.Name.isEmpty() ? tr("Histogram") : tr("Histogram of %1").arg(data.Name));
  this->placeAgain();
}

//------------------------------------------------------------------------------
void pqHistogramPlot::setCurve(const CumulativeCounts& curve)
{
  this->Scene.Curve = curve;
  this->placeAgain();
}

//------------------------------------------------------------------------------
void pqHistogramPlot::setOutline(const HistogramData& outline)
{
  this->Scene.Outline = outline.IsValid() ? outline : HistogramData();
  this->placeAgain();
}

//------------------------------------------------------------------------------
void pqHistogramPlot::setEmptyText(const QString& text)
{
  this->Scene.EmptyText = text;
  this->update();
}

//------------------------------------------------------------------------------
void pqHistogramPlot::showAcceptable(double low, double high)
{
  low = std::isnan(low) ? -camaron::Infinity : low;
  high = std::isnan(high) ? camaron::Infinity : high;
  this->Scene.Low = std::min(low, high);
  this->Scene.High = std::max(low, high);
  this->update();
}

//------------------------------------------------------------------------------
void pqHistogramPlot::showSelected(
  const HistogramData::Group& selected, const std::vector<HistogramData::Group>& groups)
{
  this->Scene.Brush = HistogramBrush();
  const bool isValid =
    selected.Counts.size() == static_cast<std::size_t>(this->Scene.Data.GetNumberOfColumns());
  this->Scene.Data.Selected = isValid ? selected : HistogramData::Group();
  this->Scene.Data.SelectedGroups = isValid ? groups : std::vector<HistogramData::Group>();
  this->update();
}

//------------------------------------------------------------------------------
void pqHistogramPlot::setLogarithmicCounts(bool logarithmic)
{
  this->Scene.LogarithmicCounts = logarithmic;
  this->placeAgain();
}

//------------------------------------------------------------------------------
void pqHistogramPlot::setCumulative(bool cumulative)
{
  this->Scene.Cumulative = cumulative;
  this->placeAgain();
}

//------------------------------------------------------------------------------
double pqHistogramPlot::brushLow() const
{
  const HistogramBrush::Ranges ranges = this->brushedRanges();
  return ranges.isEmpty() ? std::numeric_limits<double>::quiet_NaN() : ranges.front().first;
}

//------------------------------------------------------------------------------
double pqHistogramPlot::brushHigh() const
{
  const HistogramBrush::Ranges ranges = this->brushedRanges();
  return ranges.isEmpty() ? std::numeric_limits<double>::quiet_NaN() : ranges.back().second;
}

//------------------------------------------------------------------------------
QString pqHistogramPlot::binCounts() const
{
  return SpellCounts(this->data());
}

//------------------------------------------------------------------------------
QString pqHistogramPlot::outlineCounts() const
{
  return SpellCounts(this->Scene.Outline);
}

//------------------------------------------------------------------------------
QString pqHistogramPlot::groupCounts() const
{
  QStringList counts;
  for (const auto& group : this->data().Groups)
  {
    const qint64 count = std::accumulate(group.Counts.begin(), group.Counts.end(), qint64(0));
    counts << QString("%1 %2").arg(group.Label).arg(count);
  }
  return counts.join(", ");
}

//------------------------------------------------------------------------------
QPoint pqHistogramPlot::positionOf(double value, bool isLimit)
{
  const camaron::HistogramScene& scene = this->placedScene();
  const QRectF& area = isLimit ? scene.HandleStrip : scene.Plot;
  return QPointF(scene.ToX(value), area.center().y()).toPoint();
}

//------------------------------------------------------------------------------
camaron::HistogramScene& pqHistogramPlot::placedScene()
{
  const QSizeF size = this->size();
  const double ratio = this->devicePixelRatioF();
  if (!this->IsPlaced || this->Scene.Size != size || this->Scene.PixelRatio != ratio)
  {
    this->Scene.Place(size, this->font(), ratio);
    this->IsPlaced = true;
  }
  return this->Scene;
}

//------------------------------------------------------------------------------
void pqHistogramPlot::placeAgain()
{
  this->IsPlaced = false;
  this->update();
}

//------------------------------------------------------------------------------
void pqHistogramPlot::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  camaron::PaintHistogram(&painter, this->placedScene(), this->palette());
  if (this->hasFocus())
  {
    // The style's own frame may be filled, which would change the colors of the bars.
    painter.setPen(this->palette().color(QPalette::Highlight));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(this->rect().adjusted(0, 0, -1, -1));
  }
}

//------------------------------------------------------------------------------
void pqHistogramPlot::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
  {
    this->placeAgain();
  }
  Superclass::changeEvent(event);
}
