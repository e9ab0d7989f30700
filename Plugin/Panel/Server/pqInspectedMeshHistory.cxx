// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Past selections of the session.
#include "pqInspectedMesh.h"

#include "NumberText.h"
#include "ProxyValues.h"
#include "ThresholdSelection.h"

#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqSelectionManager.h"

#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

#include <algorithm>

namespace
{
constexpr int MostSelections = 20;
}

//------------------------------------------------------------------------------
void pqInspectedMesh::rememberSelection()
{
  vtkSMSourceProxy* selected = this->Port ? this->Port->getSelectionInput() : nullptr;
  const QString ofBrush = this->BrushText;
  this->BrushText.clear();
  const auto isKnown = [&](const PastSelection& past) { return past.Selection == selected; };
  if (!this->IsFollowing || !selected ||
    vtkSMPropertyHelper(selected, "Input").GetNumberOfElements() == 0 ||
    std::any_of(this->Past.cbegin(), this->Past.cend(), isKnown))
  {
    return;
  }
  vtkSMProxy* source = this->Port->getSourceProxy();
  const QString text = !ofBrush.isEmpty()                          ? ofBrush
    : camaron::IsFilter(this->Port->getSource(), "SelectElements") ? this->spellStep(source)
                                                                   : tr("Selected in the view");
  const camaron::SelectionInfo info = this->selection();
  this->Past.prepend({ tr("%1: %2 %3")
                         .arg(text, camaron::GroupedInteger(info.Count),
                           info.IsOfPoints ? tr("points") : this->elements()),
    this->Port, selected });
  this->Past = this->Past.mid(0, MostSelections);
}

//------------------------------------------------------------------------------
QStringList pqInspectedMesh::pastSelections() const
{
  QStringList texts;
  for (const PastSelection& past : this->Past)
  {
    texts << past.Text;
  }
  return texts;
}

//------------------------------------------------------------------------------
void pqInspectedMesh::reselect(int place)
{
  pqSelectionManager* manager = camaron::GetSelectionManager();
  const PastSelection past = this->Past.value(place);
  if (!manager || !past.Port)
  {
    return;
  }
  if (past.Port != this->Port)
  {
    this->inspect(past.Port);
  }
  const camaron::UndoPause pause;
  past.Port->setSelectionInput(past.Selection, 0);
  manager->select(past.Port);
}
