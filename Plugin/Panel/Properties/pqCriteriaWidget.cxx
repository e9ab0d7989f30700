// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqCriteriaWidget.h"

#include "pqCriteriaTree.h"
#include "pqMeshQuestions.h"
#include "pqMeshServices.h"

#include "pqCoreUtilities.h"
#include "pqPropertiesPanel.h"
#include "pqSearchBox.h"

#include "vtkCommand.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMUncheckedPropertyHelper.h"

#include <QVBoxLayout>

namespace
{
//------------------------------------------------------------------------------
QStringList GetTicks(vtkSMProperty* property)
{
  vtkSMPropertyHelper ticks(property);
  QStringList names;
  for (unsigned i = 0; i + 1 < ticks.GetNumberOfElements(); i += 2)
  {
    if (qstrcmp(ticks.GetAsString(i + 1), "0") != 0)
    {
      names << QString::fromUtf8(ticks.GetAsString(i));
    }
  }
  return names;
}

//------------------------------------------------------------------------------
// Helper: vtkSMPropertyHelper, or the one for unchecked elements.
template <typename Helper>
void SetTicks(Helper&& ticks, const QStringList& names)
{
  ticks.SetNumberOfElements(static_cast<unsigned>(2 * names.size()));
  for (int i = 0; i < names.size(); ++i)
  {
    ticks.Set(static_cast<unsigned>(2 * i), names[i].toUtf8().constData());
    ticks.Set(static_cast<unsigned>(2 * i + 1), "1");
  }
}
}

//------------------------------------------------------------------------------
pqCriteriaWidget::pqCriteriaWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
  : Superclass(proxy, parent)
  , Tree(new pqCriteriaTree(this))
{
  this->setShowLabel(false);
  this->setProperty(property);
  auto* search = new pqSearchBox(this);
  search->setObjectName("Search");
  search->setPlaceholderText(tr("Search criteria"));
  this->Tree->setObjectName("Tree");
  this->Tree->setColumnCount(1);
  constexpr int visibleRows = 12;
  this->Tree->setMinimumHeight(visibleRows * (this->fontMetrics().height() + 4));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(pqPropertiesPanel::suggestedMargins());
  layout->setSpacing(pqPropertiesPanel::suggestedVerticalSpacing());
  layout->addWidget(search);
  layout->addWidget(this->Tree);
  this->Tree->setCriteria(pqMeshServices::instance()->Questions->criteria(), "Cell");
  this->showProperty();
  this->setChangeAvailableAsChangeFinished(true);
  QObject::connect(search, &pqSearchBox::textChanged, this->Tree, &pqCriteriaTree::search);
  QObject::connect(this->Tree, &pqCriteriaTree::ticksChanged, this,
    [this]
    {
      this->HasChanges = true;
      SetTicks(vtkSMUncheckedPropertyHelper(this->property()), this->Tree->ticks());
      Q_EMIT this->changeAvailable();
    });
  pqCoreUtilities::connect(property, vtkCommand::ModifiedEvent, this, SLOT(showProperty()));
}

//------------------------------------------------------------------------------
void pqCriteriaWidget::showProperty()
{
  this->HasChanges = false;
  this->Tree->setTicks(GetTicks(this->property()));
}

//------------------------------------------------------------------------------
void pqCriteriaWidget::apply()
{
  if (this->HasChanges) // else names that the server does not know would be lost
  {
    SetTicks(vtkSMPropertyHelper(this->property()), this->Tree->ticks());
  }
  this->Superclass::apply();
}

//------------------------------------------------------------------------------
void pqCriteriaWidget::reset()
{
  this->property()->ClearUncheckedElements();
  this->showProperty();
  this->Superclass::reset();
}
