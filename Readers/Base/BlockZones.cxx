// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockZones.h"

#include "Mesh/CellFacets.h"
#include "Mesh/MeshView.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <map>
#include <set>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
std::set<int> GetDimensions(vtkDataSet* dataSet)
{
  const MeshView mesh(dataSet);
  std::set<int> dimensions;
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    dimensions.insert(GetCellShape(mesh.GetCellType(cell)).Dimension);
  }
  return dimensions;
}

//------------------------------------------------------------------------------
void AddTo(vtkFieldData* data, vtkAbstractArray* array, const char* name)
{
  array->SetName(name);
  data->AddArray(array);
}
}

//------------------------------------------------------------------------------
void NameZones(std::vector<MeshPart>& parts, const std::vector<std::string>& names)
{
  std::map<int, std::set<int>> dimensions; // of the cells of blocks
  bool hasZones = false, hasSolids = false;
  for (const MeshPart& part : parts)
  {
    const std::set<int> own = GetDimensions(part.Mesh);
    dimensions[part.Block].insert(own.begin(), own.end());
    hasSolids = hasSolids || own.count(3) > 0;
    hasZones = hasZones || part.Mesh->GetCellData()->HasArray("Zone") ||
      part.Mesh->GetFieldData()->HasArray("ZoneIds");
  }
  vtkNew<vtkIntArray> ids;
  vtkNew<vtkStringArray> zoneNames;
  std::map<int, int> zones; // of blocks
  for (const auto& block : dimensions)
  {
    const auto index = static_cast<std::size_t>(block.first);
    if (block.second == std::set<int>{ 2 } && index < names.size() && !names[index].empty())
    {
      // Zone 1 is for the cells.
      zones[block.first] = static_cast<int>(ids->InsertNextValue(ids->GetNumberOfValues() + 2)) + 2;
      zoneNames->InsertNextValue(names[index]);
    }
  }
  if (hasZones || !hasSolids || zones.empty())
  {
    return;
  }
  for (MeshPart& part : parts)
  {
    const auto zone = zones.find(part.Block);
    const auto copy = vtkSmartPointer<vtkDataSet>::Take(part.Mesh->NewInstance());
    copy->ShallowCopy(part.Mesh);
    part.Mesh = copy;
    if (zone != zones.end())
    {
      vtkNew<vtkIntArray> values;
      values->SetNumberOfValues(copy->GetNumberOfCells());
      values->FillValue(zone->second);
      AddTo(copy->GetCellData(), values, "Zone");
      AddTo(copy->GetFieldData(), ids, "ZoneIds");
      AddTo(copy->GetFieldData(), zoneNames, "ZoneNames");
    }
  }
}
}
