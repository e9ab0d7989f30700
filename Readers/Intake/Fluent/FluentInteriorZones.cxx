// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentInteriorZones.h"

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
void FluentInteriorZones::Add(const FluentFaces::Run& run, const FluentMesh& mesh,
  const FluentFaceBatches::Face* faces, vtkIdType size)
{
  if (!this->Several || run.BoundaryType != FluentBoundary::Interior)
  {
    return;
  }
  const std::lock_guard<std::mutex> lock(this->Mutex);
  const auto getZone = [&](vtkIdType cell) { return mesh.Cells.GetZone(mesh.Piece.GetLeaf(cell)); };
  for (vtkIdType i = 0; i < size; ++i)
  {
    const FluentFaceBatches::Face& face = faces[i];
    if (face.Cells[0] >= 0 && face.Cells[1] >= 0)
    {
      this->Add(run.Zone, getZone(face.Cells[0]), getZone(face.Cells[1]), face.Size);
    }
  }
}

//------------------------------------------------------------------------------
bool FluentInteriorZones::AddAll(
  const FluentFaces& faces, const FluentCells& cells, const Progress& progress)
{
  if (!this->Several)
  {
    return true;
  }
  return faces.ForEach(progress,
    [&](const FluentFaces::Run& run, vtkIdType, const FluentFace& face)
    {
      const vtkIdType a = cells.FindLeaf(face.GetCell(0)), b = cells.FindLeaf(face.GetCell(1));
      if (run.BoundaryType == FluentBoundary::Interior && a >= 0 && b >= 0)
      {
        const std::lock_guard<std::mutex> lock(this->Mutex);
        this->Add(run.Zone, cells.GetZone(a), cells.GetZone(b), face.Nodes.Size);
      }
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
