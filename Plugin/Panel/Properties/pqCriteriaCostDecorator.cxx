// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqCriteriaCostDecorator.h"

#include "NumberText.h"

#include "Criteria/CostEstimate.h"

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

#include <string>
#include <vector>

namespace
{
constexpr double LongSeconds = 10;

//------------------------------------------------------------------------------
// The criteria that Apply will evaluate: those of the preset, if there is one, else the ticked
// ones.
std::vector<const camaron::Criterion*> GetCriteria(vtkSMProxy* proxy, const camaron::Preset* preset)
{
  std::vector<std::string> names;
  if (preset)
  {
    for (const camaron::Preset::Rule& rule : preset->Rules)
    {
      names.emplace_back(rule.Criterion);
    }
  }
  else
  {
    vtkSMUncheckedPropertyHelper ticks(proxy, "Criteria");
    for (unsigned int i = 0; i + 1 < ticks.GetNumberOfElements(); i += 2)
    {
      if (std::string(ticks.GetAsString(i + 1)) != "0")
      {
        names.emplace_back(ticks.GetAsString(i));
      }
    }
  }
  std::vector<const camaron::Criterion*> criteria;
  for (const std::string& name : names)
  {
    if (const camaron::Criterion* criterion = camaron::FindCriterion(name))
    {
      criteria.push_back(criterion);
    }
  }
  return criteria;
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
pqCriteriaCostDecorator::~pqCriteriaCostDecorator() = default;

//------------------------------------------------------------------------------
void pqCriteriaCostDecorator::updateText()
{
  vtkSMProxy* proxy = this->parentWidget()->proxy();
  const camaron::Preset* preset =
    camaron::FindPreset(vtkSMUncheckedPropertyHelper(proxy, "Preset").GetAsString());
  const bool isOfPreset = this->parentWidget()->property() == proxy->GetProperty("Preset");
  vtkSMProperty* corners = proxy->GetProperty("NumberOfCorners");
  vtkSMProperty* threads = proxy->GetProperty("NumberOfThreads");
  proxy->UpdatePropertyInformation(corners);
  proxy->UpdatePropertyInformation(threads);
  camaron::GroupCorners ofGroups = {};
  vtkSMPropertyHelper(corners).Get(ofGroups.data(), camaron::NumberOfCostGroups);
  const double seconds = camaron::EstimateSeconds(
    GetCriteria(proxy, preset), ofGroups, vtkSMPropertyHelper(threads).GetAsInt());
  this->Label->setVisible(isOfPreset == (preset != nullptr) && seconds >= LongSeconds);
  vtkSMPropertyHelper input(proxy, "Input");
  auto* source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  const qint64 cells =
    source ? source->GetDataInformation(input.GetOutputPort())->GetNumberOfCells() : 0;
  this->Label->setText(tr("About %1 for %2 cells.")
      .arg(camaron::FormatDuration(seconds), camaron::GroupedInteger(cells)));
}
