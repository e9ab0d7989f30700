// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqCriteriaCostDecorator.h"

#include "NumberText.h"
#include "ProxyValues.h"

#include "pqCoreUtilities.h"
#include "pqPropertyWidget.h"
#include "pqUndoStack.h"

#include "vtkCommand.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"

#include <QLabel>
#include <QLayout>
#include <QVariant>

namespace
{
constexpr double LongSeconds = 10;
constexpr const char* Ticked = "Ticked criteria"; // the choice of Preset for no preset

//------------------------------------------------------------------------------
// What Apply will set.
QVariantList GetUnapplied(vtkSMProxy* proxy, const char* name)
{
  vtkSMUncheckedPropertyHelper elements(proxy, name);
  QVariantList values;
  for (unsigned int i = 0; i < elements.GetNumberOfElements(); ++i)
  {
    values << QString(elements.GetAsString(i));
  }
  return values;
}
}

//------------------------------------------------------------------------------
pqCriteriaCostDecorator::pqCriteriaCostDecorator(vtkPVXMLElement* xml, pqPropertyWidget* parent)
  : Superclass(xml, parent)
  , Label(new QLabel(parent))
{
  this->Label->setObjectName("CriteriaCost");
  this->Label->setWordWrap(true);
  if (QLayout* layout = parent->layout())
  {
    layout->addWidget(this->Label);
  }
  vtkSMProxy* proxy = parent->proxy();
  for (const char* name : { "Criteria", "Preset", "Input" })
  {
    if (vtkSMProperty* property = proxy->GetProperty(name))
    {
      for (const auto event :
        { vtkCommand::UncheckedPropertyModifiedEvent, vtkCommand::ModifiedEvent })
      {
        pqCoreUtilities::connect(property, event, this, SLOT(updateText()));
      }
    }
  }
  this->updateText();
}

//------------------------------------------------------------------------------
double pqCriteriaCostDecorator::estimate()
{
  const pqScopedUndoExclude pause;
  vtkSMProxy* proxy = this->parentWidget()->proxy();
  if (!this->Estimating)
  {
    this->Estimating.TakeReference(
      proxy->GetSessionProxyManager()->NewProxy(proxy->GetXMLGroup(), proxy->GetXMLName()));
  }
  vtkSMProperty* seconds = this->Estimating->GetProperty("EstimatedSeconds");
  vtkSMPropertyHelper input(proxy, "Input");
  if (!seconds || !input.GetAsProxy())
  {
    return 0;
  }
  vtkSMPropertyHelper(this->Estimating, "Input").Set(input.GetAsProxy(), input.GetOutputPort());
  camaron::SetProperties(this->Estimating,
    { { "Criteria", GetUnapplied(proxy, "Criteria") },
      { "Preset", GetUnapplied(proxy, "Preset") } });
  camaron::UpdateInformation(this->Estimating, seconds);
  return vtkSMPropertyHelper(seconds).GetAsDouble();
}

//------------------------------------------------------------------------------
void pqCriteriaCostDecorator::updateText()
{
  vtkSMProxy* proxy = this->parentWidget()->proxy();
  const bool hasPreset = GetUnapplied(proxy, "Preset") != QVariantList{ QString(Ticked) };
  const bool isOfPreset = this->parentWidget()->property() == proxy->GetProperty("Preset");
  const double seconds = isOfPreset == hasPreset ? this->estimate() : 0;
  this->Label->setVisible(seconds >= LongSeconds);
  vtkSMPropertyHelper input(proxy, "Input");
  auto* source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  const qint64 cells =
    source ? source->GetDataInformation(input.GetOutputPort())->GetNumberOfCells() : 0;
  this->Label->setText(tr("About %1 for %2 cells.")
      .arg(camaron::FormatDuration(seconds), camaron::GroupedInteger(cells)));
}
