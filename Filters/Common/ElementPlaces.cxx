// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ElementPlaces.h"

#include "Statistics/OrderedKey.h"

#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace camaron
{
//------------------------------------------------------------------------------
void GetPlace(const ElementBlock& block, vtkIdType element, double place[3])
{
  if (block.Kind == ElementKind::Points)
  {
    block.Data->GetPoint(element, place);
    return;
  }
  vtkNew<vtkIdList> ids;
  block.Data->GetCellPoints(element, ids);
  // Coordinates are sorted before they are added: the order of points in a cell may depend on how
  // the mesh was split.
  std::vector<double> coordinates[3];
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    double point[3];
    block.Data->GetPoint(ids->GetId(i), point);
    for (int axis = 0; axis < 3; ++axis)
    {
      coordinates[axis].push_back(point[axis]);
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    std::sort(coordinates[axis].begin(), coordinates[axis].end());
    place[axis] = 0;
    for (const double coordinate : coordinates[axis])
    {
      place[axis] += coordinate / static_cast<double>(coordinates[axis].size());
    }
  }
}

//------------------------------------------------------------------------------
std::vector<std::array<double, 3>> FindPlaces(const std::vector<ElementPlace>& elements,
  const ElementBlocks& blocks, const BlockValues& values, Reducer& reducer)
{
  constexpr std::int64_t absent = std::numeric_limits<std::int64_t>::min();
  std::vector<std::int64_t> keys(3 * elements.size(), absent);
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    if (elements[i].Block >= 0)
    {
      double place[3];
      GetPlace(blocks.Get()[values.GetBlockNumbers()[elements[i].Block]], elements[i].Index, place);
      std::transform(place, place + 3, &keys[3 * i], ToKey);
    }
  }
  reducer.Max(keys.data(), keys.size());
  std::vector<std::array<double, 3>> places;
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    places.emplace_back();
    std::transform(&keys[3 * i], &keys[3 * i] + 3, places.back().begin(), [](std::int64_t key)
      { return key == absent ? std::numeric_limits<double>::quiet_NaN() : FromKey(key); });
  }
  return places;
}
}
