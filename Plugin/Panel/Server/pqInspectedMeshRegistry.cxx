// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The server's tables of criteria and presets.
#include "pqInspectedMesh.h"

#include "CellTypeNames.h"
#include "ProxyValues.h"

#include "pqActiveObjects.h"
#include "pqUndoStack.h"

#include "vtkSMSourceProxy.h"

#include <algorithm>

using camaron::PanelTable;

namespace
{
//------------------------------------------------------------------------------
// Of tables of cells or of elements.
camaron::CriterionInfo ReadCriterion(const PanelTable& table, int row)
{
  camaron::CriterionInfo info;
  info.Element = "Cell";
  info.Name = table.text(row, "Name");
  info.Label = table.text(row, "Label");
  info.Family = table.text(row, "Family");
  info.Unit = table.text(row, "Unit");
  info.AppliesTo = table.text(row, "AppliesTo");
  info.Description = table.text(row, "Description");
  info.Consequence = table.text(row, "Consequence");
  info.AcceptableFor = table.text(row, "AcceptableFor");
  info.Source = table.text(row, "AcceptableSource");
  info.Ideal = table.number(row, "Ideal");
  info.Low = table.number(row, "AcceptableLow");
  info.High = table.number(row, "AcceptableHigh");
  info.IsHint = table.integer(row, "AcceptableIsHint") != 0;
  const QString better = table.text(row, "Better");
  info.Better = better == "Bigger" ? 1 : better == "Smaller" ? -1 : 0;
  return info;
}
}

//------------------------------------------------------------------------------
const camaron::PanelTable& pqInspectedMesh::registry(int port) const
{
  static const PanelTable none;
  const pqScopedUndoExclude pause;
  if (!this->Registry.contains(port))
  {
    vtkSMSourceProxy* table = this->Helpers.get("sources", "CriteriaTable");
    if (!table)
    {
      return none;
    }
    const PanelTable found = this->Helpers.fetch(table, port);
    if (found.isEmpty())
    {
      return none;
    }
    this->Registry[port] = found;
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
      this->Criteria << ReadCriterion(cells, row);
    }
    const PanelTable& elements = this->registry(3);
    for (int row = 0; row < elements.size(); ++row)
    {
      camaron::CriterionInfo info = ReadCriterion(elements, row);
      info.Element = elements.text(row, "Element");
      info.AppliesTo = elements.text(row, "Cells");
      this->Criteria << info;
    }
  }
  return this->Criteria;
}

//------------------------------------------------------------------------------
const camaron::CriterionInfo* pqInspectedMesh::criterion(const QString& name) const
{
  const QString type = this->elementType();
  const camaron::CriterionInfo* found = nullptr;
  for (const camaron::CriterionInfo& info : this->criteria())
  {
    if (info.Name == name && (!found || (info.Element == type && found->Element != type)))
    {
      found = &info;
    }
  }
  return found;
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
        this->Presets << camaron::PresetInfo{ name, rules.text(row, "Description"), {}, {}, {} };
      }
      this->Presets.back().Criteria << rules.text(row, "Criterion");
      this->Presets.back().Shapes << rules.text(row, "AcceptableFor");
      const QString line = rules.text(row, "Rule");
      if (!line.isEmpty())
      {
        const bool isHint = rules.integer(row, "AcceptableIsHint") != 0;
        this->Presets.back().Rules << (isHint ? line + " # hint" : line);
      }
    }
  }
  return this->Presets;
}

//------------------------------------------------------------------------------
QStringList pqInspectedMesh::unfitPresets() const
{
  const QStringList present = this->shapes();
  // The size of a cell says nothing about its shape.
  const QStringList sizes = { "Area", "Volume" };
  const auto fits = [&](const QString& criterion, const QString& shapes)
  {
    const camaron::CriterionInfo* info = this->criterion(criterion);
    return info && !sizes.contains(criterion) &&
      std::any_of(present.begin(), present.end(),
        [&](const QString& shape)
        {
          return camaron::IsAmong(shape, info->AppliesTo) &&
            (shapes.isEmpty() || camaron::IsAmong(shape, shapes));
        });
  };
  QStringList unfit;
  for (const camaron::PresetInfo& preset : this->presets())
  {
    bool isFit = present.isEmpty();
    for (int i = 0; i < preset.Criteria.size(); ++i)
    {
      isFit = isFit || fits(preset.Criteria[i], preset.Shapes[i]);
    }
    unfit += isFit ? QStringList() : QStringList(preset.Name);
  }
  return unfit;
}
