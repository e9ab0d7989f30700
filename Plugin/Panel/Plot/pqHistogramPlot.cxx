// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqHistogramPlot.h"

#include "PlotText.h"
#include "pqHistogramPlotInternals.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <limits>

using camaron::CumulativeCounts;
using camaron::HistogramBrush;
using camaron::HistogramData;

namespace
{
constexpr QSize Hint(360, 150), MinimumHint(240, 130);

// Angle of a step of the wheel; see QWheelEvent::angleDelta.
constexpr double AngleOfStep = 120;
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
  low = std::isnan(low) ? -camaron::Infinity : low;
  high = std::isnan(high) ? camaron::Infinity : high;
  const QSignalBlocker blocker(this);
  this->Internals->SetLimits(std::min(low, high), std::max(low, high));
}

//------------------------------------------------------------------------------
void pqHistogramPlot::showSelected(
  const HistogramData::Group& selected, const std::vector<HistogramData::Group>& groups)
{
  camaron::HistogramContent& content = this->Internals->Content;
  content.Brush = HistogramBrush();
  const bool isValid =
    selected.Counts.size() == static_cast<std::size_t>(content.Data.GetNumberOfColumns());
  content.Data.Selected = isValid ? selected : HistogramData::Group();
  content.Data.SelectedGroups = isValid ? groups : std::vector<HistogramData::Group>();
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

//------------------------------------------------------------------------------
void pqHistogramPlot::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  const camaron::PlotColors colors(this->palette());
  painter.fillRect(this->rect(), colors.Background);
  camaron::HistogramPainter(
    &painter, this->Internals->Content, this->Internals->GetLayout(), colors)
    .Paint(this->Internals->Marks);
  if (this->hasFocus())
  {
    // The style's own frame may be filled, which would change the colors of the bars.
    painter.setPen(this->palette().color(QPalette::Highlight));
    painter.drawRect(this->rect().adjusted(0, 0, -1, -1));
  }
}

//------------------------------------------------------------------------------
bool pqHistogramPlot::event(QEvent* event)
{
  if (event->type() == QEvent::ToolTip)
  {
    auto* help = static_cast<QHelpEvent*>(event);
    QRect area;
    const QString text = camaron::GetToolTip(
      this->Internals->Content, this->Internals->GetLayout(), help->pos(), area);
    if (text.isEmpty() || this->Internals->IsDragging())
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
    const bool canEscape = this->Internals->IsDragging() || this->Internals->HasSelection();
    if (isZoom || (key == Qt::Key_Escape && canEscape))
    { // ParaView has shortcuts with these keys
      event->accept();
      return true;
    }
  }
  return Superclass::event(event);
}

//------------------------------------------------------------------------------
void pqHistogramPlot::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
  {
    this->Internals->Invalidate();
  }
  Superclass::changeEvent(event);
}

//------------------------------------------------------------------------------
void pqHistogramPlot::mousePressEvent(QMouseEvent* event)
{
  if (event->button() == Qt::LeftButton)
  {
    this->Internals->Press(
      event->position(), event->modifiers() & (Qt::ShiftModifier | Qt::ControlModifier));
  }
  else
  {
    event->ignore(); // such as for a context menu
  }
}

//------------------------------------------------------------------------------
void pqHistogramPlot::mouseMoveEvent(QMouseEvent* event)
{
  if (this->Internals->IsDragging())
  {
    this->Internals->Drag(event->position(), event->modifiers());
  }
  else if (event->buttons() == Qt::NoButton)
  {
    this->Internals->Hover(event->position());
  }
}

//------------------------------------------------------------------------------
void pqHistogramPlot::mouseReleaseEvent(QMouseEvent* event)
{
  if (event->button() == Qt::LeftButton && this->Internals->IsDragging())
  {
    this->Internals->Release(event->position());
  }
}

//------------------------------------------------------------------------------
void pqHistogramPlot::mouseDoubleClickEvent(QMouseEvent* event)
{
  if (event->button() == Qt::LeftButton)
  {
    this->Internals->DoubleClick(event->position());
  }
}

//------------------------------------------------------------------------------
void pqHistogramPlot::leaveEvent(QEvent* event)
{
  if (!this->Internals->IsDragging())
  {
    this->Internals->Forget();
  }
  Superclass::leaveEvent(event);
}

//------------------------------------------------------------------------------
void pqHistogramPlot::hideEvent(QHideEvent* event)
{
  if (this->Internals->IsDragging())
  {
    this->Internals->Cancel();
  }
  Superclass::hideEvent(event);
}

//------------------------------------------------------------------------------
void pqHistogramPlot::wheelEvent(QWheelEvent* event)
{
  // Else it scrolls the panel, also when the plot passes below the mouse.
  const bool isMeant = this->hasFocus() || (event->modifiers() & Qt::ControlModifier);
  event->setAccepted(
    isMeant && this->Internals->Wheel(event->position(), event->angleDelta().y() / AngleOfStep));
}

//------------------------------------------------------------------------------
void pqHistogramPlot::keyPressEvent(QKeyEvent* event)
{
  if (!this->Internals->Key(event->key(), event->modifiers()))
  {
    Superclass::keyPressEvent(event);
  }
}
