// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqHistogramPlot.h"

#include "pqHistogramPlotInternals.h"

#include <QSignalBlocker>

#include <algorithm>
#include <cmath>
#include <limits>

using camaron::CumulativeCounts;
using camaron::HistogramBrush;
using camaron::HistogramData;

namespace
{
constexpr QSize Hint(360, 150), MinimumHint(240, 130);
}

//------------------------------------------------------------------------------
pqHistogramPlot::pqHistogramPlot(QWidget* parent)
  : Superclass(parent)
  , Internals(std::make_unique<pqInternals>(this))
{
  this->Internals->Content.EmptyText = tr("No data");
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
pqHistogramPlot::~pqHistogramPlot() = default;

//------------------------------------------------------------------------------
void pqHistogramPlot::setData(const HistogramData& data)
{
  camaron::HistogramContent& content = this->Internals->Content;
  const bool haveSameBins =
    content.Data.Edges == data.Edges && content.Data.Logarithmic == data.Logarithmic;
  content.Data = data.IsValid() ? data : HistogramData();
  content.VisibleRange.reset();
  if (!haveSameBins)
  {
    content.Brush = HistogramBrush();
    this->Internals->Forget();
    this->Internals->Marks = {};
  }
  this->setAccessibleName(
    data.Name.isEmpty() ? tr("Histogram") : tr("Histogram of %1").arg(data.Name));
  this->Internals->Invalidate();
}

//------------------------------------------------------------------------------
const HistogramData& pqHistogramPlot::data() const
{
  return this->Internals->Content.Data;
}

//------------------------------------------------------------------------------
void pqHistogramPlot::setCurve(const CumulativeCounts& curve)
{
  this->Internals->Content.Curve = curve.IsValid() ? curve : CumulativeCounts();
  this->Internals->Invalidate();
}

//------------------------------------------------------------------------------
void pqHistogramPlot::setOutline(const HistogramData& outline)
{
  this->Internals->Content.Outline = outline.IsValid() ? outline : HistogramData();
  this->Internals->Invalidate();
}

//------------------------------------------------------------------------------
void pqHistogramPlot::setEmptyText(const QString& text)
{
  this->Internals->Content.EmptyText = text;
  this->update();
}

//------------------------------------------------------------------------------
void pqHistogramPlot::showAcceptable(double low, double high)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  low = std::isnan(low) ? -infinity : low;
  high = std::isnan(high) ? infinity : high;
  const QSignalBlocker blocker(this);
  this->Internals->SetLimits(std::min(low, high), std::max(low, high));
}

//------------------------------------------------------------------------------
void pqHistogramPlot::showSelected(const HistogramData::Group& selected)
{
  camaron::HistogramContent& content = this->Internals->Content;
  content.Brush = HistogramBrush();
  const bool isValid = selected.Counts.size() + 1 == content.Data.Edges.size();
  content.Data.Selected = isValid ? selected : HistogramData::Group();
  this->update();
}

//------------------------------------------------------------------------------
void pqHistogramPlot::setLogarithmicCounts(bool logarithmic)
{
  this->Internals->Content.LogarithmicCounts = logarithmic;
  this->Internals->Invalidate();
}

//------------------------------------------------------------------------------
bool pqHistogramPlot::logarithmicCounts() const
{
  return this->Internals->Content.LogarithmicCounts;
}

//------------------------------------------------------------------------------
void pqHistogramPlot::setCumulative(bool cumulative)
{
  this->Internals->Content.Cumulative = cumulative;
  this->Internals->Invalidate();
}

//------------------------------------------------------------------------------
bool pqHistogramPlot::cumulative() const
{
  return this->Internals->Content.Cumulative;
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
qint64 pqHistogramPlot::brushedCount() const
{
  return this->Internals->Content.Brush.GetCount(this->data());
}

//------------------------------------------------------------------------------
HistogramBrush::Ranges pqHistogramPlot::brushedRanges() const
{
  return this->Internals->Content.Brush.GetRanges(this->data());
}

//------------------------------------------------------------------------------
QString pqHistogramPlot::binCounts() const
{
  QStringList counts;
  for (int bin = 0; bin < this->data().GetNumberOfBins(); ++bin)
  {
    counts << QString::number(this->data().GetCount(this->data().GetColumnOfBin(bin)));
  }
  return counts.join(' ');
}

//------------------------------------------------------------------------------
double pqHistogramPlot::acceptableLow() const
{
  return this->Internals->Content.Low;
}

//------------------------------------------------------------------------------
double pqHistogramPlot::acceptableHigh() const
{
  return this->Internals->Content.High;
}

//------------------------------------------------------------------------------
QPoint pqHistogramPlot::positionOf(double value, bool isLimit) const
{
  const camaron::HistogramLayout& layout = this->Internals->GetLayout();
  const QRectF& area = isLimit ? layout.HandleStrip : layout.Plot;
  return QPointF(layout.ToX(value), area.center().y()).toPoint();
}

//------------------------------------------------------------------------------
QSize pqHistogramPlot::sizeHint() const
{
  return Hint;
}

//------------------------------------------------------------------------------
QSize pqHistogramPlot::minimumSizeHint() const
{
  return MinimumHint;
}
