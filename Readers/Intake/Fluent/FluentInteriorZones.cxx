// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentInteriorZones.h"

#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"

namespace camaron
{
//------------------------------------------------------------------------------
void FluentInteriorZones::Find(const FluentFaces& faces)
{
  const FluentFaces::Run* first = nullptr;
  for (const FluentFaces::Run& run : faces.GetRuns())
  {
    if (run.BoundaryType == FluentBoundary::Interior)
    {
      first = first ? first : &run;
      this->Several = this->Several || run.Zone != first->Zone;
    }
  }
}

//------------------------------------------------------------------------------
void FluentInteriorZones::Add(
  const FluentFaces::Run& run, vtkIdType begin, vtkIdType end, const FluentCells& cells)
{
  if (!this->Several || run.BoundaryType != FluentBoundary::Interior)
  {
    return;
  }
  const std::lock_guard<std::mutex> lock(this->Mutex);
  auto last = this->Zones.end();
  FluentFaces::ForEachOf(run, begin, end,
    [&](vtkIdType, const FluentFace& face)
    {
      const vtkIdType a = cells.FindLeaf(face.GetCell(0)), b = cells.FindLeaf(face.GetCell(1));
      if (a < 0 || b < 0)
      {
        return;
      }
      const Key key = MakeKey(cells.GetZone(a), cells.GetZone(b), face.Size);
      if (last == this->Zones.end() || last->first != key)
      {
        last = this->Zones.emplace(key, run.Zone).first;
      }
      last->second = last->second == run.Zone ? run.Zone : Ambiguous;
    });
}

//------------------------------------------------------------------------------
void FluentInteriorZones::Load(vtkFieldData* fieldData)
{
  vtkDataArray* const table = fieldData->GetArray(ArrayName);
  if (!table || table->GetNumberOfComponents() != 4)
  {
    return;
  }
  for (vtkIdType row = 0; row < table->GetNumberOfTuples(); ++row)
  {
    int entry[4];
    for (int i = 0; i < 4; ++i)
    {
      const double value = table->GetComponent(row, i);
      entry[i] = value >= 0 && value <= INT32_MAX ? static_cast<int>(value) : 0;
    }
    this->Zones.emplace(MakeKey(entry[1], entry[2], entry[3]), entry[0]);
  }
}

//------------------------------------------------------------------------------
void FluentInteriorZones::AddTo(vtkFieldData* fieldData) const
{
  if (!this->Several)
  {
    return;
  }
  vtkNew<vtkIntArray> table;
  table->SetName(ArrayName);
  table->SetNumberOfComponents(4);
  for (const auto& entry : this->Zones)
  {
    if (entry.second != Ambiguous)
    {
      table->InsertNextTuple4(entry.second, entry.first[0], entry.first[1], entry.first[2]);
    }
  }
  fieldData->AddArray(table);
}
}
