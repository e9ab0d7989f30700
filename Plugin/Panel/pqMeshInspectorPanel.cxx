// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqMeshInspectorPanel.h"

#include "ThresholdSelection.h"
#include "pqCheckCard.h"
#include "pqCriteriaCard.h"
#include "pqElementCard.h"
#include "pqHistogramCard.h"
#include "pqInspectedMesh.h"
#include "pqInspectorCard.h"
#include "pqInspectorState.h"
#include "pqMeshCard.h"
#include "pqMeshServices.h"
#include "pqReportCard.h"
#include "pqSelectionCard.h"
#include "pqViewCard.h"
#include "pqWorstCard.h"

#include "pqApplicationCore.h"
#include "pqOutputPort.h"
#include "pqSelectionManager.h"
#include "pqSettings.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QMainWindow>
#include <QPointer>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>

namespace
{
// A setting: there when the dock was placed, true when it was placed beside the view.
constexpr const char* PlacedKey = "Camaron/MeshInspector/Placed";
constexpr const char* PropertiesDock = "propertiesDock";

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

// The wheel scrolls the cards also over lists and numbers, unless these have the focus. ParaView's
// own filter of the application would drop such events.
class WheelFilter : public QObject
{
public:
  explicit WheelFilter(QScrollArea* area)
    : QObject(area)
    , Area(area)
  {
    QCoreApplication::instance()->installEventFilter(this);
  }

protected:
  bool eventFilter(QObject* watched, QEvent* event) override
  {
    auto* widget = event->type() == QEvent::Wheel ? qobject_cast<QWidget*>(watched) : nullptr;
    if (!widget || !this->Area->widget()->isAncestorOf(widget) || widget->hasFocus() ||
      widget->parentWidget()->hasFocus())
    {
      return false;
    }
    auto* list = qobject_cast<QAbstractScrollArea*>(widget->parentWidget());
    const bool isPassed = qobject_cast<QComboBox*>(widget) || qobject_cast<QSlider*>(widget) ||
      qobject_cast<QAbstractSpinBox*>(widget) || (list && list->viewport() == widget);
    return isPassed && QCoreApplication::sendEvent(this->Area->verticalScrollBar(), event);
  }

private:
  QScrollArea* Area;
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

//------------------------------------------------------------------------------
// Keeps ParaView's panel Find Data from computing its table of the selected elements while it is
// hidden, which takes as long as it takes to draw them.
class FindDataPause : public QObject
{
public:
  explicit FindDataPause(QWidget* window)
    : QObject(window)
  {
    for (QWidget* widget : window->findChildren<QWidget*>())
    {
      if (widget->inherits("pqFindDataCurrentSelectionFrame") && camaron::GetSelectionManager())
      {
        this->Table = widget;
        widget->installEventFilter(this);
        this->follow(widget->isVisible());
        return;
      }
    }
  }

protected:
  bool eventFilter(QObject* watched, QEvent* event) override
  {
    if (watched == this->Table && (event->type() == QEvent::Show || event->type() == QEvent::Hide))
    {
      this->follow(event->type() == QEvent::Show);
    }
    return false;
  }

private:
  void follow(bool isVisible)
  {
    pqSelectionManager* manager = camaron::GetSelectionManager();
    const char* const changed = SIGNAL(selectionChanged(pqOutputPort*));
    const char* const show = SLOT(showSelectedData(pqOutputPort*));
    QObject::disconnect(manager, changed, this->Table, show);
    pqOutputPort* selected = nullptr;
    if (isVisible)
    {
      QObject::connect(manager, changed, this->Table, show);
      selected = manager->getSelectedPort();
    }
    QMetaObject::invokeMethod(this->Table, "showSelectedData", Q_ARG(pqOutputPort*, selected));
  }

  QPointer<QObject> Table;
};

//------------------------------------------------------------------------------
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
  auto* state = new pqInspectorState(*pqMeshServices::instance(), this);
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
  layout->setSpacing(margin);
  for (const auto make : MakeCards)
  {
    layout->addWidget(make(state, cards));
  }
  layout->addStretch(1);
  const QList<QWidget*> stops = FindTabStops(layout);
  for (int i = 1; i < stops.size(); ++i)
  {
    QWidget::setTabOrder(stops[i - 1], stops[i]);
  }
  area->setWidget(cards);
  // Posted, because the last filter of an application is the first to run; the area owns it.
  QMetaObject::invokeMethod(area, [area] { new WheelFilter(area); }, Qt::QueuedConnection);
  if (parent)
  { // when the window has all its panels
    QMetaObject::invokeMethod(this, [parent] { new FindDataPause(parent); }, Qt::QueuedConnection);
  }
  this->setWidget(area);
  QObject::connect(this, &QDockWidget::visibilityChanged, pqMeshServices::instance()->Mesh,
    &pqInspectedMesh::setFollowing);
  this->raiseFromMenu();
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
void pqMeshInspectorPanel::raiseFromMenu()
{
  QObject::connect(this, &QDockWidget::visibilityChanged, this,
    [this](bool isVisible)
    {
      if (isVisible || !this->isHidden())
      {
        this->IsBehind = !isVisible;
      }
    });
  QObject::connect(this->toggleViewAction(), &QAction::triggered, this,
    [this](bool isShown)
    {
      if (isShown || this->IsBehind)
      {
        this->show();
        this->raise();
      }
    });
}

//------------------------------------------------------------------------------
bool pqMeshInspectorPanel::eventFilter(QObject* watched, QEvent* event)
{
  if (watched == this->parentWidget() && event->type() == QEvent::Show && !this->WasShown)
  {
    watched->removeEventFilter(this);
    this->WasShown = true;
    if (qEnvironmentVariableIsSet("CAMARON_VIEW"))
    {
      this->skipWelcome();
    }
    // Posted, so that it follows the layout of the window.
    QMetaObject::invokeMethod(this, &pqMeshInspectorPanel::findPlace, Qt::QueuedConnection);
  }
  else if (watched == this->parentWidget() && event->type() == QEvent::Resize)
  {
    QMetaObject::invokeMethod(this, &pqMeshInspectorPanel::moveBesideView, Qt::QueuedConnection);
  }
  return this->Superclass::eventFilter(watched, event);
}

//------------------------------------------------------------------------------
void pqMeshInspectorPanel::skipWelcome()
{
  const QString key = "GeneralSettings.ShowWelcomeDialog"; // ParaView reads it in the show event
  pqSettings* settings = pqApplicationCore::instance()->settings();
  const QVariant before = settings->value(key);
  settings->setValue(key, false);
  QMetaObject::invokeMethod(
    this,
    [settings, key, before]
    {
      if (before.isValid())
      {
        settings->setValue(key, before);
      }
      else
      {
        settings->remove(key);
      }
    },
    Qt::QueuedConnection);
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
  const bool isKnown = settings->contains(PlacedKey) && window->restoreDockWidget(this);
  auto* properties = window->findChild<QDockWidget*>(PropertiesDock);
  this->IsPlaced = isKnown && settings->value(PlacedKey).toBool();
  // Not before ParaView keeps the layout of its window: one that is killed leaves neither.
  QObject::connect(QCoreApplication::instance(), &QCoreApplication::aboutToQuit, this,
    [this, settings] { settings->setValue(PlacedKey, this->IsPlaced); });
  if (!isKnown)
  {
    if (properties && !properties->isFloating())
    {
      window->tabifyDockWidget(properties, this);
    }
    this->show();
  }
  if (!this->IsPlaced)
  {
    window->installEventFilter(this);
    this->moveBesideView();
  }
  if (!isKnown && !this->IsPlaced && properties && !qEnvironmentVariableIsSet("CAMARON_VIEW"))
  { // `camaron view` applies the properties of its meshes itself
    properties->raise();
  }
}

//------------------------------------------------------------------------------
void pqMeshInspectorPanel::moveBesideView()
{
  auto* window = qobject_cast<QMainWindow*>(this->parentWidget());
  constexpr int wideWindow = 1200, smallWidth = 350;
  // Of a large window: at 1600 x 1000, the criteria, the histogram and six worst rows are seen.
  constexpr double share = 0.27;
  if (window->width() < wideWindow)
  {
    return;
  }
  window->removeEventFilter(this);
  this->IsPlaced = true;
  auto* properties = window->findChild<QDockWidget*>(PropertiesDock);
  auto* colors = window->findChild<QDockWidget*>("colorMapEditorDock");
  if (properties && window->tabifiedDockWidgets(this).contains(properties) && colors &&
    !colors->isFloating())
  {
    const bool wasInFront = !this->IsBehind && !this->isHidden();
    window->tabifyDockWidget(colors, this);
    const int wanted = std::max(smallWidth, int(share * window->width()));
    window->resizeDocks({ this }, { wanted }, Qt::Horizontal);
    if (wasInFront)
    {
      properties->raise();
    }
  }
}
