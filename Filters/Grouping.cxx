// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grouping.h"

#include "Mesh/MeshView.h"
#include "vtkCamaronCompat.h"

#include "vtkDataSet.h"

#include <cstdio>
#include <cstdlib>
#include <set>
#include <stdexcept>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
void GetCellTypes(const ElementBlock& block, std::vector<int>& keys)
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
void GetBlockNumber(const ElementBlock& block, std::vector<int>& keys)
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
  void (*GetKeys)(const ElementBlock& block, std::vector<int>& keys); ///< one, or one per cell
  std::string (*GetLabel)(const ElementBlock& block, int key);
};
const Way Ways[] = {
  { "None", nullptr, nullptr },
  { "Cell type", GetCellTypes, GetTypeLabelOfKey },
  { "Block", GetBlockNumber, GetBlockLabel },
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
// Union over all processes of numbers with labels, by number.
std::vector<std::pair<int, std::string>> GatherLabels(
  const std::set<std::pair<int, std::string>>& labels, Reducer& reducer)
{
  constexpr int width = 10; // digits of an int, so that the names sort like the numbers
  std::vector<std::string> names;
  for (const auto& label : labels)
  {
    char number[width + 1];
    std::snprintf(number, sizeof(number), "%0*d", width, label.first);
    names.push_back(number + label.second);
  }
  std::vector<std::pair<int, std::string>> result;
  for (const std::string& name : reducer.GatherNames(names))
  {
    result.emplace_back(std::atoi(name.substr(0, width).c_str()), name.substr(width));
  }
  return result;
}
}

//------------------------------------------------------------------------------
Grouping::Grouping(const std::string& name, const ElementBlocks& blocks, Reducer& reducer)
  : Blocks(blocks)
  , Labels(1, "All")
  , Keys(1, 0)
{
  const Way& way = FindWay(name);
  if (!way.GetKeys)
  {
    return;
  }
  std::set<std::pair<int, std::string>> labels;
  for (const ElementBlock& block : blocks.Get())
  {
    std::vector<int> keys;
    way.GetKeys(block, keys);
    int last = -1;
    for (std::size_t cell = 0; cell < keys.size(); ++cell)
    {
      const bool perCell = static_cast<vtkIdType>(keys.size()) == block.Data->GetNumberOfCells();
      const bool isGhost = perCell && block.IsGhost(static_cast<vtkIdType>(cell));
      if (!isGhost && keys[cell] != last)
      {
        last = keys[cell];
        labels.emplace(last, way.GetLabel(block, last));
      }
    }
    this->BlockKeys.push_back(keys);
  }
  for (const auto& label : GatherLabels(labels, reducer))
  {
    this->Keys.push_back(label.first);
    this->Labels.push_back(label.second);
  }
}

//------------------------------------------------------------------------------
Population Grouping::GetPopulation(std::size_t group, const BlockValues& values)
{
  if (group == 0)
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
            mask[cell] = keys[cell] != this->Keys[group] || !block.Contains(cell);
          }
        });
      block.Skip = mask.data();
    }
    else if (keys.front() != this->Keys[group])
    {
      block.Size = 0; // stays in the list, so that places in it keep their meaning
    }
    population.push_back(block);
  }
  return population;
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
