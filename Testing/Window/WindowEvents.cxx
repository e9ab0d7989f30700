// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Commands for sessions of ParaView's window (events as in its own tests) that QtTesting lacks;
// each is a row of the table below.
#include "TextFit.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqEventPlayer.h"
#include "pqLoadDataReaction.h"
#include "pqProgressManager.h"
#include "pqPropertiesPanel.h"
#include "pqServer.h"
#include "pqSettings.h"
#include "pqTestUtility.h"
#include "pqWidgetEventPlayer.h"

#include "vtkPVProgressHandler.h"
#include "vtkSMSession.h"

#include <QApplication>
#include <QDockWidget>
#include <QImage>
#include <QMainWindow>
#include <QMap>
#include <QMenu>
#include <QMouseEvent>
#include <QPalette>
#include <QPixmap>
#include <QStyleFactory>
#include <QTableView>
#include <QToolButton>
#include <QWidget>

#include <iostream>

namespace
{
//------------------------------------------------------------------------------
// picture PATH: writes what the widget shows, and in what font.
bool SavePicture(QWidget* widget, const QString& path)
{
  QImage image = widget->grab().toImage();
  image.setText("Font", widget->font().toString());
  return image.save(path);
}

//------------------------------------------------------------------------------
// width PIXELS: fixes the width of the widget.
bool FixWidth(QWidget* widget, const QString& width)
{
  widget->setFixedWidth(width.toInt());
  QCoreApplication::processEvents(); // lays it out
  return widget->width() == width.toInt();
}

//------------------------------------------------------------------------------
// raise: brings a dock to the front of its tabs. Qt keeps tabs that it does not show, which other
// players would choose.
bool Raise(QWidget* widget, const QString&)
{
  widget->show();
  widget->raise();
  return true;
}

//------------------------------------------------------------------------------
// resize WIDTH,HEIGHT: as if the user resized the window.
bool Resize(QWidget* widget, const QString& size)
{
  const QSize wanted(size.section(',', 0, 0).toInt(), size.section(',', 1).toInt());
  widget->resize(wanted);
  QCoreApplication::processEvents(); // what follows the size is posted
  QCoreApplication::processEvents();
  return widget->size() == wanted;
}

//------------------------------------------------------------------------------
// seen ROWS: fails unless one sees the whole widget, or with ROWS the first ones of a table.
bool CheckSeen(QWidget* widget, const QString& rows)
{
  auto* table = qobject_cast<QTableView*>(widget);
  if (table && !rows.isEmpty())
  {
    const QRect last = table->visualRect(table->model()->index(rows.toInt() - 1, 0));
    return !last.isEmpty() && table->viewport()->visibleRegion().contains(last.bottomLeft());
  }
  return widget->visibleRegion().boundingRect() == widget->rect();
}

//------------------------------------------------------------------------------
// palette dark: colors of a dark theme for the application.
bool ChoosePalette(QWidget*, const QString& name)
{
  if (name != "dark")
  {
    return false;
  }
  const QColor window(49, 54, 59), base(35, 38, 41), text(239, 240, 241), pale(127, 140, 141);
  QPalette palette(window, window);
  for (const auto role : { QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
         QPalette::ToolTipText, QPalette::BrightText })
  {
    palette.setColor(role, text);
    palette.setColor(QPalette::Disabled, role, pale);
  }
  palette.setColor(QPalette::PlaceholderText, pale);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, QColor(42, 46, 50));
  palette.setColor(QPalette::Button, window);
  palette.setColor(QPalette::ToolTipBase, window);
  palette.setColor(QPalette::Highlight, QColor(61, 174, 233));
  palette.setColor(QPalette::HighlightedText, base);
  palette.setColor(QPalette::Link, QColor(41, 128, 185));
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  QApplication::setPalette(palette);
  QCoreApplication::processEvents();
  return true;
}

//------------------------------------------------------------------------------
// texts: fails if a text in the widget is cut off.
bool CheckTexts(QWidget* widget, const QString&)
{
  const QStringList cut = camaron::FindCutTexts(widget);
  for (const QString& line : cut)
  {
    std::cerr << "cut off at a width of " << widget->width() << ": " << line.toStdString() << '\n';
  }
  return cut.isEmpty();
}

//------------------------------------------------------------------------------
void SendMouse(QWidget* widget, QEvent::Type type, QPoint position, Qt::KeyboardModifiers modifiers)
{
  const bool isMove = type == QEvent::MouseMove, isRelease = type == QEvent::MouseButtonRelease;
  QMouseEvent event(type, position, widget->mapToGlobal(position),
    isMove ? Qt::NoButton : Qt::LeftButton, isRelease ? Qt::NoButton : Qt::LeftButton, modifiers);
  QCoreApplication::sendEvent(widget, &event);
}

//------------------------------------------------------------------------------
// drag FROM,TO,PART,MODIFIERS: drags with the mouse from one value to another in a histogram, over
// its "bars", or the handle of a limit at "handles".
bool Drag(QWidget* widget, const QString& arguments)
{
  const QStringList words = arguments.split(',');
  if (words.size() != 4)
  {
    return false;
  }
  QPoint ends[2];
  for (int i = 0; i < 2; ++i)
  {
    if (!QMetaObject::invokeMethod(widget, "positionOf", Q_RETURN_ARG(QPoint, ends[i]),
          Q_ARG(double, words[i].toDouble()), Q_ARG(bool, words[2] == "handles")))
    {
      return false;
    }
  }
  const Qt::KeyboardModifiers modifiers(words[3].toInt());
  SendMouse(widget, QEvent::MouseButtonPress, ends[0], modifiers);
  SendMouse(widget, QEvent::MouseMove, (ends[0] + ends[1]) / 2, modifiers);
  SendMouse(widget, QEvent::MouseMove, ends[1], modifiers);
  SendMouse(widget, QEvent::MouseButtonRelease, ends[1], modifiers);
  return true;
}

//------------------------------------------------------------------------------
// menu PLACE: chooses an item, from 0, of the menu of a button; fails if it is disabled.
bool ChooseItem(QWidget* widget, const QString& place)
{
  auto* button = qobject_cast<QToolButton*>(widget);
  if (!button || !button->menu())
  {
    return false;
  }
  Q_EMIT button->menu()->aboutToShow();
  const QList<QAction*> actions = button->menu()->actions();
  QAction* action = actions.value(place.toInt());
  if (!action || !action->isEnabled())
  {
    std::cerr << "a menu of " << actions.size() << " items has no item " << place.toStdString()
              << " that can be chosen\n";
    return false;
  }
  action->trigger();
  return true;
}

QMetaObject::Connection HandlingEvents; // until the session ends

//------------------------------------------------------------------------------
// events: from now on, the window handles events at each progress of the server, as ParaView 6.1
// does outside tests; one of them is that the active source has other data.
bool HandleEvents(QWidget*, const QString&)
{
  constexpr double shortest = 0.01; // that ParaView allows
  auto* application = pqApplicationCore::instance();
  const auto* progress = application->getProgressManager();
  application->getActiveServer()->session()->GetProgressHandler()->SetProgressInterval(shortest);
  HandlingEvents = QObject::connect(progress, &pqProgressManager::progress, progress,
    []
    {
      Q_EMIT pqActiveObjects::instance().dataUpdated();
      QCoreApplication::processEvents();
    });
  return true;
}

//------------------------------------------------------------------------------
// sections MODE: what the panel of properties shows, a number of pqPropertiesPanel.
bool ChooseSections(QWidget* widget, const QString& mode)
{
  auto* panel = qobject_cast<pqPropertiesPanel*>(widget);
  if (!panel)
  {
    return false;
  }
  panel->setPanelMode(mode.toInt());
  return true;
}

//------------------------------------------------------------------------------
// fresh: makes the Mesh Inspector anew, without settings of its own, in a window of the first size.
bool MakeFresh(QWidget* widget, const QString&)
{
  auto* window = qobject_cast<QMainWindow*>(widget);
  auto* panel = widget->findChild<QDockWidget*>("pqMeshInspectorPanel");
  if (!window || !panel)
  {
    return false;
  }
  QObject::disconnect(HandlingEvents);
  static const QSize size = window->size();
  window->resize(size);
  const QMetaObject* type = panel->metaObject();
  delete panel;
  pqApplicationCore::instance()->settings()->remove("Camaron");
  panel = qobject_cast<QDockWidget*>(type->newInstance(Q_ARG(QWidget*, window)));
  window->addDockWidget(Qt::RightDockWidgetArea, panel);
  QCoreApplication::processEvents(); // it finds its place
  return true;
}

//------------------------------------------------------------------------------
// open PATH: opens a file of the server as File > Open does, without the dialog.
bool OpenFile(QWidget*, const QString& path)
{
  return pqLoadDataReaction::loadData(QStringList(path)) != nullptr;
}

//------------------------------------------------------------------------------
// run PATH: runs a script in the Python shell as its button does, but without the dialog, and
// nothing stays of it.
bool RunScript(QWidget* widget, const QString& path)
{
  return QMetaObject::invokeMethod(widget, "executeScript",
    Q_ARG(QString, QString("exec(open(r'%1').read(), {'__name__': '__main__'})").arg(path)));
}

//------------------------------------------------------------------------------
// unseen: fails if one sees any of the widget.
bool CheckUnseen(QWidget* widget, const QString&)
{
  return widget->visibleRegion().isEmpty();
}

//------------------------------------------------------------------------------
// Collects the texts of a label that are painted.
class PaintedTexts : public QObject
{
public:
  using QObject::QObject;
  QStringList Texts;

protected:
  bool eventFilter(QObject* label, QEvent* event) override
  {
    if (event->type() == QEvent::Paint)
    {
      this->Texts << label->property("text").toString();
    }
    return false;
  }
};

//------------------------------------------------------------------------------
// watch: from now on, "painted" knows the texts of the label.
bool Watch(QWidget* widget, const QString&)
{
  auto* texts = new PaintedTexts(widget);
  texts->setObjectName("PaintedTexts");
  widget->installEventFilter(texts);
  return true;
}

//------------------------------------------------------------------------------
// painted TEXT: fails if the label has not shown this text since "watch", be it for a moment.
bool CheckPainted(QWidget* widget, const QString& text)
{
  auto* texts = static_cast<PaintedTexts*>(widget->findChild<QObject*>("PaintedTexts"));
  return texts && texts->Texts.contains(text);
}

const QMap<QString, bool (*)(QWidget*, const QString&)> Commands = {
  { "drag", Drag },
  { "events", HandleEvents },
  { "fresh", MakeFresh },
  { "menu", ChooseItem },
  { "painted", CheckPainted },
  { "palette", ChoosePalette },
  { "open", OpenFile },
  { "picture", SavePicture },
  { "raise", Raise },
  { "resize", Resize },
  { "run", RunScript },
  { "sections", ChooseSections },
  { "seen", CheckSeen },
  { "texts", CheckTexts },
  { "unseen", CheckUnseen },
  { "watch", Watch },
  { "width", FixWidth },
};

class CamaronWindowEvents : public pqWidgetEventPlayer
{
  Q_OBJECT

public:
  using pqWidgetEventPlayer::playEvent;
  using pqWidgetEventPlayer::pqWidgetEventPlayer;

  bool playEvent(
    QObject* object, const QString& command, const QString& arguments, bool& error) override
  {
    auto* widget = qobject_cast<QWidget*>(object);
    const auto run = Commands.value(command);
    if (!widget || !run)
    {
      return false;
    }
    error = !run(widget, arguments);
    return true;
  }
};
}

//------------------------------------------------------------------------------
// To be called in the process of the window.
extern "C" Q_DECL_EXPORT void AddWindowEvents()
{
  pqEventPlayer* player = pqApplicationCore::instance()->testUtility()->eventPlayer();
  player->addWidgetEventPlayer(new CamaronWindowEvents(player));
}

#include "WindowEvents.moc"
