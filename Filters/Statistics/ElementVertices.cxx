// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ElementVertices.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>

namespace camaron
{
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
  std::vector<ExactValue> ids;
  for (const vtkIdType point : *points)
  {
    ids.push_back(global ? GetExact(global, point) : ToExact(static_cast<std::int64_t>(point)));
  }
  if (block.Data->GetCellType(cell) == VTK_POLYHEDRON)
  {
    std::sort(ids.begin(), ids.end());
  }
  std::string text;
  for (const ExactValue& id : ids)
  {
    text += (text.empty() ? "" : " ") + ToText(id);
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
