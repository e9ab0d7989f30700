// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ElementPlaces.h"

#include "Statistics/OrderedKey.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>

namespace camaron
{
//------------------------------------------------------------------------------
void PlaceFinder::Find(const ElementBlock& block, vtkIdType element, double place[3])
{
  if (block.Kind == ElementKind::Points)
  {
    block.Data->GetPoint(element, place);
    return;
  }
  block.Data->GetCellPoints(element, this->Ids);
  const vtkIdType count = this->Ids->GetNumberOfIds();
  this->Coordinates.resize(3 * count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    double point[3];
    block.Data->GetPoint(this->Ids->GetId(i), point);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Coordinates[axis * count + i] = point[axis];
    }
  }
  // Coordinates are sorted before they are added: the order of points in a cell may depend on how
  // the mesh was split.
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto begin = this->Coordinates.begin() + axis * count;
    std::sort(begin, begin + count);
    place[axis] = 0;
    std::for_each(begin, begin + count,
      [&](double coordinate) { place[axis] += coordinate / static_cast<double>(count); });
  }
}

//------------------------------------------------------------------------------
void GetPlace(const ElementBlock& block, vtkIdType element, double place[3])
{
  PlaceFinder().Find(block, element, place);
}

//------------------------------------------------------------------------------
double GetSize(const ElementBlock& block, vtkIdType element)
{
  if (block.Kind == ElementKind::Points)
  {
    return 0;
  }
  double bounds[6], lengths[3];
  block.Data->GetCellBounds(element, bounds);
  for (int axis = 0; axis < 3; ++axis)
  {
    lengths[axis] = std::max(0.0, bounds[2 * axis + 1] - bounds[2 * axis]);
  }
  return std::hypot(lengths[0], lengths[1], lengths[2]);
}

//------------------------------------------------------------------------------
void DescribeElement(
  const ElementBlocks& blocks, const BlockValues& values, int process, WorstElement& element)
{
  const ElementBlock& block = blocks.Get()[values.GetBlockNumbers()[element.Block]];
  element.Process = process;
  element.BlockNumber = block.Number;
  element.CellType =
    block.Kind == ElementKind::Points ? PointCellType : block.Data->GetCellType(element.Index);
  GetPlace(block, element.Index, element.Place);
  element.Size = GetSize(block, element.Index);
  element.IsJudged = values.Get()[element.Block].IsJudged(element.Index);
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

//------------------------------------------------------------------------------
ElementVertices::ElementVertices(const ElementBlocks& blocks, camaron::Reducer& reducer)
  : Blocks(blocks)
  , Reducer(reducer)
{
  std::vector<int> numbers;
  std::int64_t withoutIds = 0;
  for (const ElementBlock& block : blocks.Get())
  {
    numbers.push_back(block.Number);
    withoutIds += block.Data->GetPointData()->GetGlobalIds() == nullptr;
  }
  reducer.Sum(&withoutIds, 1);
  this->HaveGlobalIds = withoutIds == 0;
  std::map<int, int> pieces;
  for (const int number : reducer.GatherItems(numbers))
  {
    ++pieces[number];
  }
  for (const auto& block : pieces)
  {
    if (block.second == 1)
    {
      this->BlocksInOnePiece.insert(block.first);
    }
  }
}

//------------------------------------------------------------------------------
std::string ElementVertices::Describe(const ElementBlock& block, vtkIdType cell) const
{
  if (block.Kind == ElementKind::Points ||
    (!this->HaveGlobalIds && this->BlocksInOnePiece.count(block.Number) == 0))
  {
    return "";
  }
  vtkNew<vtkIdList> points;
  block.Data->GetCellPoints(cell, points);
  vtkDataArray* global = this->HaveGlobalIds ? block.Data->GetPointData()->GetGlobalIds() : nullptr;
  std::vector<std::int64_t> ids;
  for (const vtkIdType point : *points)
  {
    ids.push_back(global ? global->GetVariantValue(point).ToTypeInt64() : point);
  }
  if (block.Data->GetCellType(cell) == VTK_POLYHEDRON)
  {
    std::sort(ids.begin(), ids.end());
  }
  std::string text;
  for (const std::int64_t id : ids)
  {
    text += (text.empty() ? "" : " ") + std::to_string(id);
  }
  return text;
}

//------------------------------------------------------------------------------
std::vector<std::string> ElementVertices::Find(
  const std::vector<WorstElement>& elements, const BlockValues& values) const
{
  constexpr int width = 10; // digits of an index in the list, 32 bits
  std::vector<std::string> own;
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    if (elements[i].Process == this->Reducer.GetProcess())
    {
      char place[width + 1];
      std::snprintf(place, sizeof(place), "%0*u", width, static_cast<unsigned>(i));
      own.push_back(place +
        this->Describe(
          this->Blocks.Get()[values.GetBlockNumbers()[elements[i].Block]], elements[i].Index));
    }
  }
  std::vector<std::string> vertices(elements.size());
  for (const std::string& entry : this->Reducer.GatherNames(own))
  {
    vertices[std::atoll(entry.substr(0, width).c_str())] = entry.substr(width);
  }
  return vertices;
}
}
