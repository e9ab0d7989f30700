// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grouping.h"

#include "AgreedName.h"
#include "Mesh/MeshView.h"
#include "StatisticsArrays.h"
#include "vtkCamaronCompat.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <set>
#include <stdexcept>
#include <tuple>

namespace camaron
{
namespace
{
constexpr int NoKey = std::numeric_limits<int>::min(); // of cells that are in no group but that of all
constexpr std::size_t Any = std::numeric_limits<std::size_t>::max();

//------------------------------------------------------------------------------
void GetCellTypes(const ElementBlock& block, const std::string&, std::vector<int>& keys)
{
  const vtkIdType size = block.Data->GetNumberOfCells();
  const MeshView mesh(block.Data);
  keys.resize(size);
  for (vtkIdType cell = 0; cell < size; ++cell)
  {
    keys[cell] =
      mesh.GetNumberOfCells() == size ? mesh.GetCellType(cell) : block.Data->GetCellType(cell);
  }
}

std::string GetTypeLabelOfKey(const ElementBlock&, int cellType)
{
  return GetCellTypeLabel(cellType);
}

//------------------------------------------------------------------------------
// Whole numbers are keys, whatever the type of the array; a region may be a double.
void GetArrayValues(
  const ElementBlock& block, const std::string& arrayName, std::vector<int>& keys)
{
  keys.assign(block.GetSize(), NoKey);
  vtkDataArray* array = block.GetArray(arrayName);
  if (!array)
  {
    return;
  }
  vtkNew<vtkDoubleArray> values;
  values->DeepCopy(array);
  for (std::size_t cell = 0; cell < keys.size(); ++cell)
  {
    const double value = values->GetValue(static_cast<vtkIdType>(cell));
    // False for NaN.
    if (std::abs(value) <= std::numeric_limits<int>::max() && std::trunc(value) == value)
    {
      keys[cell] = static_cast<int>(value);
    }
  }
}

std::string GetNumberLabel(const ElementBlock&, int key)
{
  return std::to_string(key);
}

//------------------------------------------------------------------------------
void GetBlockNumber(const ElementBlock& block, const std::string&, std::vector<int>& keys)
{
  keys.assign(1, block.Number);
}

std::string GetBlockLabel(const ElementBlock& block, int)
{
  return block.Name.empty() ? "Block 0" : block.Name;
}

//------------------------------------------------------------------------------
// Groups are in the order of their keys.
struct Way
{
  const char* Name;
  /// One key, or one per cell.
  void (*GetKeys)(const ElementBlock& block, const std::string& arrayName, std::vector<int>& keys);
  std::string (*GetLabel)(const ElementBlock& block, int key);
  std::size_t MaxNumberOfGroups; ///< more are an error
  bool IsForPoints;
};
const Way Ways[] = {
  { "None", nullptr, nullptr, Any, true },
  { "Cell type", GetCellTypes, GetTypeLabelOfKey, Any, false },
  { "Block", GetBlockNumber, GetBlockLabel, Any, true },
  { "Cell array", GetArrayValues, GetNumberLabel, 1000, true }, // else these are ids, or were measured
};

const Way& FindWay(const std::string& name)
{
  for (const Way& way : Ways)
  {
    if (name == way.Name)
    {
      return way;
    }
  }
  throw std::invalid_argument("there is no way to group by '" + name + "'");
}

//------------------------------------------------------------------------------
// Collective. Ids and ghost types are no groups.
std::string FindArrayName(const std::string& told, const ElementBlocks& blocks, Reducer& reducer)
{
  std::vector<std::string> ofIntegers, all;
  for (const ElementBlock& block : blocks.Get())
  {
    vtkDataSetAttributes* attributes = block.GetAttributes();
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      const char* name = attributes->GetArrayName(i);
      vtkDataArray* array = name ? block.GetArray(name) : nullptr;
      if (array && array != attributes->GetGlobalIds() && array != attributes->GetPedigreeIds() &&
        std::strcmp(name, vtkDataSetAttributes::GhostArrayName()) != 0)
      {
        (IsOfIntegers(array) ? ofIntegers : all).emplace_back(name);
      }
    }
  }
  return AgreeOnName(told, { ofIntegers, all }, reducer);
}

//------------------------------------------------------------------------------
// Union over all processes of numbers with labels, by number.
std::vector<std::pair<int, std::string>> GatherLabels(
  const std::set<std::pair<int, std::string>>& labels, Reducer& reducer)
{
  // Names sort like the numbers: all have as many digits, and the smallest int is 0.
  constexpr int width = 10;
  constexpr std::int64_t offset = -std::int64_t(std::numeric_limits<int>::min());
  std::vector<std::string> names;
  for (const auto& label : labels)
  {
    char number[width + 1];
    std::snprintf(number, sizeof(number), "%0*u", width, static_cast<unsigned>(label.first + offset));
    names.push_back(number + label.second);
  }
  std::vector<std::pair<int, std::string>> result;
  for (const std::string& name : reducer.GatherNames(names))
  {
    const std::int64_t number = std::atoll(name.substr(0, width).c_str());
    result.emplace_back(static_cast<int>(number - offset), name.substr(width));
  }
  return result;
}
}

//------------------------------------------------------------------------------
Grouping::Grouping(const std::string& name, const std::string& arrayName, const ElementBlocks& blocks,
  Reducer& reducer)
  : Blocks(blocks)
  , Groups(1, Group{ true, 0, "All" })
{
  const Way& way = FindWay(name);
  if (!way.GetKeys)
  {
    return;
  }
  if (blocks.GetKind() == ElementKind::Points && !way.IsForPoints)
  {
    throw std::invalid_argument("points are not grouped by '" + name + "'");
  }
  if (way.GetKeys == &GetArrayValues)
  {
    this->ArrayName = FindArrayName(arrayName, blocks, reducer);
  }
  std::set<std::pair<int, std::string>> labels;
  std::int64_t numberWithoutGroup = 0;
  for (const ElementBlock& block : blocks.Get())
  {
    std::vector<int> keys;
    way.GetKeys(block, this->ArrayName, keys);
    const bool perCell = static_cast<vtkIdType>(keys.size()) == block.GetSize();
    std::set<int> found = { NoKey };
    for (std::size_t cell = 0; cell < keys.size() && labels.size() <= way.MaxNumberOfGroups; ++cell)
    {
      const bool isGhost = perCell && block.IsGhost(static_cast<vtkIdType>(cell));
      if (!isGhost && found.insert(keys[cell]).second)
      {
        labels.emplace(keys[cell], way.GetLabel(block, keys[cell]));
      }
    }
    numberWithoutGroup += std::count(keys.begin(), keys.end(), NoKey);
    this->BlockKeys.push_back(keys);
  }
  reducer.Sum(&numberWithoutGroup, 1);
  for (const auto& label : GatherLabels(labels, reducer))
  {
    this->Groups.push_back({ false, label.first, label.second });
  }
  if (this->Groups.size() - 1 > way.MaxNumberOfGroups)
  {
    throw std::invalid_argument("the array '" + this->ArrayName + "' has more than " +
      std::to_string(way.MaxNumberOfGroups) + " different values, too many to group by");
  }
  this->OneGroup = this->Groups.size() == 2 && numberWithoutGroup == 0;
}

//------------------------------------------------------------------------------
Population Grouping::GetPopulation(const Group& group, const BlockValues& values)
{
  if (group.IsAll)
  {
    return values.Get();
  }
  this->Masks.assign(values.Get().size(), {});
  Population population;
  for (std::size_t i = 0; i < values.Get().size(); ++i)
  {
    const std::size_t number = values.GetBlockNumbers()[i];
    const std::vector<int>& keys = this->BlockKeys[number];
    ValueBlock block = values.Get()[i];
    if (keys.size() != 1)
    {
      std::vector<unsigned char>& mask = this->Masks[i];
      mask.resize(keys.size());
      ParallelFor(block.Size, 1 << 16,
        [&](vtkIdType begin, vtkIdType end)
        {
          for (vtkIdType cell = begin; cell < end; ++cell)
          {
            mask[cell] = keys[cell] != group.Key || !block.Contains(cell);
          }
        });
      block.Skip = mask.data();
    }
    else if (keys.front() != group.Key)
    {
      block.Size = 0; // stays in the list, so that places in it keep their meaning
    }
    population.push_back(block);
  }
  return population;
}

//------------------------------------------------------------------------------
std::vector<Group> JoinGroups(const std::vector<Group>& a, const std::vector<Group>& b)
{
  std::vector<Group> groups = a;
  for (const Group& group : b)
  {
    if (std::find(a.begin(), a.end(), group) == a.end())
    {
      groups.push_back(group);
    }
  }
  std::sort(groups.begin(), groups.end(), [](const Group& x, const Group& y)
    { return std::tie(y.IsAll, x.Key, x.Label) < std::tie(x.IsAll, y.Key, y.Label); });
  return groups;
}

//------------------------------------------------------------------------------
std::string GetCellTypeLabel(int cellType)
{
  const std::string name = GetCellClassName(cellType);
  return name.compare(0, 3, "vtk") == 0 ? name.substr(3) : name;
}

//------------------------------------------------------------------------------
std::vector<std::pair<int, std::string>> GetBlockNames(
  const ElementBlocks& blocks, Reducer& reducer)
{
  std::set<std::pair<int, std::string>> names;
  for (const ElementBlock& block : blocks.Get())
  {
    names.emplace(block.Number, block.Name);
  }
  return GatherLabels(names, reducer);
}
}
