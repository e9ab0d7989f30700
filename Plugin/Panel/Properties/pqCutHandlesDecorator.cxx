// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqCutHandlesDecorator.h"

#include "ProxyValues.h"

#include "pqCoreUtilities.h"
#include "pqInteractivePropertyWidgetAbstract.h"
#include "pqPropertyWidget.h"
#include "pqUndoStack.h"

#include "vtkCommand.h"
#include "vtkSMProperty.h"
#include "vtkSMProxy.h"

#include <QCheckBox>

namespace
{
constexpr const char* HandlesName = "CutHandles";
}

//------------------------------------------------------------------------------
pqCutHandlesDecorator::pqCutHandlesDecorator(vtkPVXMLElement* xml, pqPropertyWidget* parent)
  : Superclass(xml, parent)
{
  // Later, so that the widget of another shape is there.
  this->Timer.setSingleShot(true);
  this->Timer.setInterval(0);
  QObject::connect(&this->Timer, &QTimer::timeout, this, &pqCutHandlesDecorator::update);
  vtkSMProxy* display = parent->proxy();
  for (vtkSMProperty* property : { parent->property(), display->GetProperty(HandlesName) })
  {
    pqCoreUtilities::connect(property, vtkCommand::ModifiedEvent, &this->Timer, SLOT(start()));
  }
  this->updateLater();
}

//------------------------------------------------------------------------------
void pqCutHandlesDecorator::update()
{
  const bool areShown = camaron::GetProperty(this->parentWidget()->proxy(), HandlesName).toBool();
  for (auto* handles : this->parentWidget()->findChildren<pqInteractivePropertyWidgetAbstract*>())
  {
    handles->setWidgetVisible(areShown);
    // ParaView shows them when the widget appears.
    QObject::connect(handles, &pqInteractivePropertyWidgetAbstract::widgetVisibilityToggled, this,
      &pqCutHandlesDecorator::updateLater, Qt::UniqueConnection);
    if (auto* box = handles->findChild<QCheckBox*>("show3DWidget"))
    {
      QObject::connect(
        box, &QCheckBox::clicked, this, &pqCutHandlesDecorator::choose, Qt::UniqueConnection);
    }
  }
}

//------------------------------------------------------------------------------
void pqCutHandlesDecorator::choose(bool areShown)
{
  const pqScopedUndoSet undo(tr("Change Cut"));
  camaron::SetTracedProperties(
    this->parentWidget()->proxy(), { { HandlesName, areShown ? 1 : 0 } });
}
