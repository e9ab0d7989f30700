// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqMeshInspectorPanel.h"

#include "pqCheckCard.h"
#include "pqCriteriaCard.h"
#include "pqElementCard.h"
#include "pqHistogramCard.h"
#include "pqInspectedMesh.h"
#include "pqInspectorCard.h"
#include "pqInspectorState.h"
#include "pqMeshCard.h"
#include "pqReportCard.h"
#include "pqSelectionCard.h"
#include "pqViewCard.h"
#include "pqWorstCard.h"

#include "pqApplicationCore.h"
#include "pqSettings.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QMainWindow>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

namespace
{
constexpr const char* PlacedKey = "Camaron/MeshInspector/Placed";

//------------------------------------------------------------------------------
// Widgets that Tab reaches, as they are placed: from top to bottom and left to right.
QList<QWidget*> FindTabStops(QLayout* layout)
{
  QList<QWidget*> stops;
  for (int i = 0; i < layout->count(); ++i)
  {
    QLayoutItem* item = layout->itemAt(i);
    QWidget* widget = item->widget();
    QLayout* inner = widget ? widget->layout() : item->layout();
    if (widget && (widget->focusPolicy() & Qt::TabFocus))
    {
      stops << widget;
    }
    if (inner)
    {
      stops << FindTabStops(inner);
    }
  }
  return stops;
}

// The wheel scrolls the cards, unless the widget under it has the focus: it would change lists and
// numbers that the user only passes.
class WheelFilter : public QObject
{
public:
  using QObject::QObject;

  static void install(QWidget* widget, QObject* filter)
  {
    if (qobject_cast<QComboBox*>(widget) || qobject_cast<QAbstractSpinBox*>(widget) ||
      qobject_cast<QAbstractSlider*>(widget))
    {
      widget->installEventFilter(filter);
    }
    else if (auto* area = qobject_cast<QAbstractScrollArea*>(widget))
    {
      area->viewport()->installEventFilter(filter);
    }
    if (widget->focusPolicy() == Qt::WheelFocus)
    {
      widget->setFocusPolicy(Qt::StrongFocus);
    }
  }

protected:
  bool eventFilter(QObject* watched, QEvent* event) override
  {
    auto* widget = qobject_cast<QWidget*>(watched);
    if (event->type() != QEvent::Wheel || !widget || widget->hasFocus() ||
      qobject_cast<QScrollBar*>(widget) ||
      (qobject_cast<QAbstractScrollArea*>(widget->parentWidget()) &&
        widget->parentWidget()->hasFocus()))
    {
      return false;
    }
    event->ignore(); // the parents get it
    return true;
  }
};

//------------------------------------------------------------------------------
// Beside other panels, it wants no more width than they do, but always what its cards need.
class CardArea : public QScrollArea
{
public:
  using QScrollArea::QScrollArea;

  QSize minimumSizeHint() const override
  {
    const int width =
      this->widget()->minimumSizeHint().width() + this->verticalScrollBar()->sizeHint().width();
    return { width, this->QScrollArea::minimumSizeHint().height() };
  }
  QSize sizeHint() const override
  {
    constexpr int width = 300;
    return { width, this->QScrollArea::sizeHint().height() };
  }
};

template <typename Card>
pqInspectorCard* MakeCard(pqInspectorState* state, QWidget* parent)
{
  return new Card(state, parent);
}

// From top to bottom.
pqInspectorCard* (*const MakeCards[])(pqInspectorState*, QWidget*) = {
  MakeCard<pqMeshCard>,
  MakeCard<pqCriteriaCard>,
  MakeCard<pqHistogramCard>,
  MakeCard<pqWorstCard>,
  MakeCard<pqElementCard>,
  MakeCard<pqSelectionCard>,
  MakeCard<pqCheckCard>,
  MakeCard<pqViewCard>,
  MakeCard<pqReportCard>,
};
}

//------------------------------------------------------------------------------
pqMeshInspectorPanel::pqMeshInspectorPanel(QWidget* parent)
  : Superclass(tr("Mesh Inspector"), parent)
{
  this->setObjectName("pqMeshInspectorPanel");
  auto* state = new pqInspectorState(pqInspectedMesh::instance(), this);
  auto* area = new CardArea(this);
  area->setObjectName("Scroll");
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* cards = new QWidget(area);
  cards->setObjectName("Cards");
  auto* layout = new QVBoxLayout(cards);
  constexpr int margin = 2;
  layout->setContentsMargins(margin, margin, margin, margin);
  for (const auto make : MakeCards)
  {
    layout->addWidget(make(state, cards));
  }
  layout->addStretch(1);
  auto* wheel = new WheelFilter(this);
  for (QWidget* widget : cards->findChildren<QWidget*>())
  {
    WheelFilter::install(widget, wheel);
  }
  const QList<QWidget*> stops = FindTabStops(layout);
  for (int i = 1; i < stops.size(); ++i)
  {
    QWidget::setTabOrder(stops[i - 1], stops[i]);
  }
  area->setWidget(cards);
  this->setWidget(area);
  QObject::connect(this, &QDockWidget::visibilityChanged, pqInspectedMesh::instance(),
    &pqInspectedMesh::setFollowing);
  if (parent && !parent->isVisible())
  {
    parent->installEventFilter(this);
  }
  else
  {
    QMetaObject::invokeMethod(this, &pqMeshInspectorPanel::findPlace, Qt::QueuedConnection);
  }
}

//------------------------------------------------------------------------------
pqMeshInspectorPanel::~pqMeshInspectorPanel() = default;

//------------------------------------------------------------------------------
bool pqMeshInspectorPanel::eventFilter(QObject* watched, QEvent* event)
{
  if (watched == this->parentWidget() && event->type() == QEvent::Show)
  {
    watched->removeEventFilter(this);
    // Posted, so that it follows the layout of the window.
    QMetaObject::invokeMethod(this, &pqMeshInspectorPanel::findPlace, Qt::QueuedConnection);
  }
  return this->Superclass::eventFilter(watched, event);
}

//------------------------------------------------------------------------------
void pqMeshInspectorPanel::findPlace()
{
  auto* window = qobject_cast<QMainWindow*>(this->parentWidget());
  if (!window)
  {
    return;
  }
  pqSettings* settings = pqApplicationCore::instance()->settings();
  const bool isKnown = settings->value(PlacedKey, false).toBool();
  settings->setValue(PlacedKey, true);
  if (isKnown && window->restoreDockWidget(this))
  {
    return;
  }
  // Beside the view if the window is wide, else with the panels on the left.
  constexpr int wideWindow = 1200, width = 350;
  const bool isWide = window->width() >= wideWindow;
  auto* neighbor =
    window->findChild<QDockWidget*>(isWide ? "colorMapEditorDock" : "propertiesDock");
  if (neighbor && !neighbor->isFloating())
  {
    window->tabifyDockWidget(neighbor, this);
  }
  this->show();
  if (isWide)
  {
    window->resizeDocks({ this }, { width }, Qt::Horizontal);
  }
  else if (neighbor)
  {
    neighbor->raise();
  }
}
