// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StatisticsArrays.h"

#include "Criteria/Criterion.h"
#include "Elements/ElementCriteria.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Names of the arrays of vtkMeshElements that are measures, not ids, counts or flags, and that are
// not also names of criteria.
std::vector<std::string> GetMeasuresOfElements()
{
  std::vector<std::string> names;
  for (const ElementTable& table : GetElementTables())
  {
    for (const Criterion& criterion : table.Criteria)
    {
      if (!criterion.IsInteger() && !FindCriterion(criterion.Name) &&
        std::find(names.begin(), names.end(), criterion.Name) == names.end())
      {
        names.emplace_back(criterion.Name);
      }
    }
  }
  return names;
}
}

//------------------------------------------------------------------------------
bool IsOfIntegers(vtkDataArray* array)
{
  const Criterion* criterion = array->GetName() ? FindCriterion(array->GetName()) : nullptr;
  return criterion ? criterion->IsInteger()
                   : array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
}

//------------------------------------------------------------------------------
std::vector<StatisticsArray> FindArrays(const ElementBlocks& blocks, Reducer& reducer)
{
  constexpr char separator = '\1'; // sorts before all characters of a name
  std::vector<std::string> own;
  for (const ElementBlock& block : blocks.Get())
  {
    vtkDataSetAttributes* data = block.GetAttributes();
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = data->GetArray(i);
      if (array && array->GetName() && array->GetNumberOfComponents() == 1)
      {
        const bool hasUnit =
          array->HasInformation() && array->GetInformation()->Has(vtkDataArray::UNITS_LABEL());
        own.push_back(std::string(array->GetName()) + separator +
          (hasUnit ? array->GetInformation()->Get(vtkDataArray::UNITS_LABEL()) : "") +
          (IsOfIntegers(array) ? 'i' : 'r'));
      }
    }
  }
  std::vector<StatisticsArray> arrays;
  for (const std::string& entry : reducer.GatherNames(own))
  {
    const std::size_t end = entry.find(separator);
    const StatisticsArray array{ entry.substr(0, end),
      entry.substr(end + 1, entry.size() - end - 2), entry.back() == 'i' };
    if (arrays.empty() || arrays.back().Name != array.Name)
    {
      arrays.push_back(array);
    }
    else
    {
      arrays.back().Unit = std::max(arrays.back().Unit, array.Unit); // prefers any unit over none
      arrays.back().OfIntegers = arrays.back().OfIntegers && array.OfIntegers;
    }
  }
  return arrays;
}

//------------------------------------------------------------------------------
std::vector<StatisticsArray> ChooseArrays(const std::vector<StatisticsArray>& present,
  const std::vector<std::string>& wanted, std::vector<std::string>& missing)
{
  std::vector<StatisticsArray> chosen;
  const auto find = [](const std::vector<StatisticsArray>& arrays, const std::string& name)
  {
    return std::find_if(arrays.begin(), arrays.end(),
      [&](const StatisticsArray& array) { return array.Name == name; });
  };
  const auto choose = [&](const std::string& name)
  {
    const auto found = find(present, name);
    if (found != present.end() && find(chosen, name) == chosen.end())
    {
      chosen.push_back(*found);
      const Criterion* criterion = FindCriterion(name);
      if (criterion && found->Unit.empty())
      {
        chosen.back().Unit = criterion->UnitLabel();
      }
    }
    return found != present.end();
  };
  for (const std::string& name : wanted)
  {
    if (!choose(name))
    {
      missing.push_back(name);
    }
  }
  if (wanted.empty())
  {
    for (const Criterion& criterion : GetCriteria())
    {
      choose(criterion.Name);
    }
    for (const std::string& name : GetMeasuresOfElements())
    {
      choose(name);
    }
  }
  return chosen;
}
}
