// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Events of Qt.
#include "pqHistogramPlot.h"

#include "PlotToolTip.h"
#include "pqHistogramPlotInternals.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>

namespace
{
// Angle of a step of the wheel; see QWheelEvent::angleDelta.
constexpr double AngleOfStep = 120;
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
