// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FindDataPause.h"

#include "ThresholdSelection.h"

#include "pqOutputPort.h"
#include "pqSelectionManager.h"

#include <QEvent>
#include <QWidget>

namespace camaron
{
//------------------------------------------------------------------------------
FindDataPause::FindDataPause(QWidget* window)
  : QObject(window)
{
  for (QWidget* widget : window->findChildren<QWidget*>())
  {
    if (widget->inherits("pqFindDataCurrentSelectionFrame") && GetSelectionManager())
    {
      this->Table = widget;
      widget->installEventFilter(this);
      this->follow(widget->isVisible());
      return;
    }
  }
}

//------------------------------------------------------------------------------
void FindDataPause::follow(bool isVisible)
{
  pqSelectionManager* manager = GetSelectionManager();
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

//------------------------------------------------------------------------------
bool FindDataPause::eventFilter(QObject* watched, QEvent* event)
{
  if (watched == this->Table && (event->type() == QEvent::Show || event->type() == QEvent::Hide))
  {
    this->follow(event->type() == QEvent::Show);
  }
  return false;
}
}
