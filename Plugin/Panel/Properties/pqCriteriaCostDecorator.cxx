// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqCriteriaCostDecorator.h"

#include "NumberText.h"
#include "pqMeshFilters.h"
#include "pqMeshServices.h"

#include "pqCoreUtilities.h"
#include "pqPropertyWidget.h"

#include "vtkCommand.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
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
void pqCriteriaCostDecorator::updateText()
{
  vtkSMProxy* proxy = this->parentWidget()->proxy();
  const QString preset = GetUnapplied(proxy, "Preset").value(0).toString();
  const bool isOfPreset = this->parentWidget()->property() == proxy->GetProperty("Preset");
  vtkSMPropertyHelper input(proxy, "Input");
  auto* source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  const auto port = static_cast<int>(input.GetOutputPort());
  const double seconds = isOfPreset == (preset != Ticked)
    ? pqMeshServices::instance()->Filters->estimatedSeconds(
        GetUnapplied(proxy, "Criteria"), preset, source, port)
    : 0;
  this->Label->setVisible(seconds >= LongSeconds);
  const qint64 cells = source ? source->GetDataInformation(port)->GetNumberOfCells() : 0;
  this->Label->setText(tr("About %1 for %2 cells.")
      .arg(camaron::FormatDuration(seconds), camaron::GroupedInteger(cells)));
}
