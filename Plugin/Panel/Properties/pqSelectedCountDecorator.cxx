// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqSelectedCountDecorator.h"

#include "NumberText.h"
#include "ProxyValues.h"

#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqPipelineSource.h"
#include "pqPropertyWidget.h"
#include "pqServerManagerModel.h"

#include "vtkCommand.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <QLabel>
#include <QLayout>

//------------------------------------------------------------------------------
pqSelectedCountDecorator::pqSelectedCountDecorator(vtkPVXMLElement* xml, pqPropertyWidget* parent)
  : Superclass(xml, parent)
  , Label(new QLabel(parent))
{
  this->Label->setObjectName("SelectedCount");
  this->Label->setWordWrap(true);
  this->Label->hide();
  if (QLayout* layout = parent->layout())
  {
    layout->addWidget(this->Label);
  }
  auto* source =
    pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(
      parent->proxy());
  if (source)
  {
    // Queued, because the filter is in the middle of an update.
    QObject::connect(source, QOverload<pqPipelineSource*>::of(&pqPipelineSource::dataUpdated), this,
      &pqSelectedCountDecorator::updateText, Qt::QueuedConnection);
  }
  // After a change of a property the count is outdated until the filter has executed.
  pqCoreUtilities::connect(
    parent->proxy(), vtkCommand::UpdatePropertyEvent, this->Label, SLOT(hide()));
}

//------------------------------------------------------------------------------
void pqSelectedCountDecorator::updateText()
{
  vtkSMProxy* proxy = this->parentWidget()->proxy();
  if (!camaron::UpdateInformation(proxy))
  {
    return;
  }
  const vtkIdType count = vtkSMPropertyHelper(proxy, "NumberOfSelectedElements").GetAsIdType();
  const bool isOfPoints =
    qstrcmp(vtkSMPropertyHelper(proxy, "ElementType").GetAsString(), "Points") == 0;
  const QString report = vtkSMPropertyHelper(proxy, "Report").GetAsString();
  const QString elements = isOfPoints ? (count == 1 ? tr("point") : tr("points"))
                                      : (count == 1 ? tr("cell") : tr("cells"));
  const QString text = tr("%1 %2 selected.").arg(camaron::GroupedInteger(count), elements);
  this->Label->setText(report.isEmpty() ? text : QString("%1 %2.").arg(text, report));
  this->Label->show();
}
