// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentInteriorZones.h"

#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"

#include <set>

namespace camaron
{
//------------------------------------------------------------------------------
void FluentInteriorZones::Find(const FluentFaces& faces)
{
  std::set<int> zones;
  for (const FluentFaces::Run& run : faces.GetRuns())
  {
    if (run.BoundaryType == FluentBoundary::Interior)
    {
      zones.insert(run.Zone);
    }
  }
  this->Several = zones.size() > 1;
}

//------------------------------------------------------------------------------
void FluentInteriorZones::AddAll(const FluentFaces& faces, const FluentCells& cells)
{
  for (const FluentFaces::Run& run : faces.GetRuns())
  {
    if (this->Several && run.BoundaryType == FluentBoundary::Interior)
    {
      FluentFaces::ForEachOf(run, run.Begin, run.End,
        [&](vtkIdType, const FluentFace& face)
        {
          const std::int32_t first = face.GetCell(0), second = face.GetCell(1);
          const vtkIdType a = first > 0 ? cells.GetLeaf(first) : -1;
          const vtkIdType b = second > 0 ? cells.GetLeaf(second) : -1;
          if (a >= 0 && b >= 0)
          {
            this->Add(run.Zone, cells.GetZone(a), cells.GetZone(b), face.Nodes.Size);
          }
        });
    }
  }
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
