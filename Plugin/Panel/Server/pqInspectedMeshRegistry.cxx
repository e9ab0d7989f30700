// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The server's tables of criteria and presets.
#include "pqInspectedMesh.h"

#include "ProxyValues.h"

#include "pqActiveObjects.h"

#include "vtkSMSourceProxy.h"

using camaron::PanelTable;

//------------------------------------------------------------------------------
const camaron::PanelTable& pqInspectedMesh::registry(int port) const
{
  const camaron::UndoPause pause;
  if (!this->Registry.contains(port))
  {
    vtkSMSourceProxy* table = this->helper("sources", "CriteriaTable");
    this->Registry[port] = table ? this->fetch(table, port) : PanelTable();
  }
  return this->Registry[port];
}

//------------------------------------------------------------------------------
const QVector<camaron::CriterionInfo>& pqInspectedMesh::criteria() const
{
  if (this->Criteria.isEmpty() && pqActiveObjects::instance().activeServer())
  {
    const PanelTable& cells = this->registry(0);
    for (int row = 0; row < cells.size(); ++row)
    {
      camaron::CriterionInfo info;
      info.Element = "Cell";
      info.Name = cells.text(row, "Name");
      info.Label = cells.text(row, "Label");
      info.Family = cells.text(row, "Family");
      info.Unit = cells.text(row, "Unit");
      info.AppliesTo = cells.text(row, "AppliesTo");
      info.Description = cells.text(row, "Description");
      info.Consequence = cells.text(row, "Consequence");
      info.AcceptableFor = cells.text(row, "AcceptableFor");
      info.Source = cells.text(row, "AcceptableSource");
      info.Ideal = cells.number(row, "Ideal");
      info.Low = cells.number(row, "AcceptableLow");
      info.High = cells.number(row, "AcceptableHigh");
      info.IsHint = cells.integer(row, "AcceptableIsHint") != 0;
      const QString better = cells.text(row, "Better");
      info.Better = better == "Bigger" ? 1 : better == "Smaller" ? -1 : 0;
      this->Criteria << info;
    }
    const PanelTable& elements = this->registry(3);
    for (int row = 0; row < elements.size(); ++row)
    {
      camaron::CriterionInfo info;
      info.Element = elements.text(row, "Element");
      info.Name = info.Label = elements.text(row, "Name");
      info.Unit = elements.text(row, "Unit");
      info.AppliesTo = elements.text(row, "Cells");
      info.Description = elements.text(row, "Description");
      this->Criteria << info;
    }
  }
  return this->Criteria;
}

//------------------------------------------------------------------------------
const camaron::CriterionInfo* pqInspectedMesh::criterion(const QString& name) const
{
  for (const camaron::CriterionInfo& info : this->criteria())
  {
    if (info.Name == name)
    {
      return &info;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
const QVector<camaron::PresetInfo>& pqInspectedMesh::presets() const
{
  if (this->Presets.isEmpty() && pqActiveObjects::instance().activeServer())
  {
    const PanelTable& rules = this->registry(1);
    for (int row = 0; row < rules.size(); ++row)
    {
      const QString name = rules.text(row, "Preset");
      if (this->Presets.isEmpty() || this->Presets.back().Name != name)
      {
        this->Presets << camaron::PresetInfo{ name, rules.text(row, "Description"), {} };
      }
      this->Presets.back().Criteria << rules.text(row, "Criterion");
    }
  }
  return this->Presets;
}
