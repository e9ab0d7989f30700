// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CheckedCells.h"

#include "Base/Parallel.h"
#include "Base/Text.h"
#include "Criteria/Criterion.h"
#include "Rules/ParsedRules.h"
#include "vtkCamaronCompat.h"
#include "vtkElementQuality.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"

#include <algorithm>
#include <stdexcept>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Name of the block for scopes.
std::string GetLabel(const std::string& blockName)
{
  return blockName.empty() ? "Block 0" : blockName;
}

//------------------------------------------------------------------------------
// The integers that the array has for the cells of a scope.
std::vector<double> GetValuesOfScope(const Scope& scope)
{
  std::vector<double> values;
  if (scope.Kind == ScopeKind::Array)
  {
    values.push_back(static_cast<double>(std::stoll(scope.Value)));
  }
  else if (scope.Kind == ScopeKind::Family)
  {
    for (const int family : scope.GetFamilyIds())
    {
      values.push_back(family);
    }
  }
  else
  {
    for (int type = 0; type < VTK_NUMBER_OF_CELL_TYPES; ++type)
    {
      if (GetCellClassName(type) == "vtk" + scope.Value)
      {
        values.push_back(type);
      }
    }
  }
  return values;
}

//------------------------------------------------------------------------------
std::runtime_error MakeError(const Rule& rule, const std::string& reason)
{
  return std::runtime_error(
    rule.Source.empty() ? reason : RuleProblem{ rule.Source, rule.Line, reason }.GetMessage());
}

//------------------------------------------------------------------------------
std::string DescribeMissing(const std::string& missing, const std::string& name,
  const std::vector<std::string>& known, const std::vector<std::string>& others)
{
  std::vector<std::string> all = known;
  all.insert(all.end(), others.begin(), others.end());
  const std::string similar = FindSimilarName(name, all);
  std::string list;
  for (const std::string& each : known)
  {
    list += (list.empty() ? "" : ", ") + each;
  }
  return "there is no " + missing + "; " +
    (!similar.empty()   ? "did you mean " + similar + "?"
        : !list.empty() ? "the mesh has " + list
                        : "the mesh has none");
}

//------------------------------------------------------------------------------
// Collective. Names of the cell arrays of all processes, with their numbers of components; 0 for
// texts.
std::vector<std::pair<std::string, int>> GatherArrays(
  const std::vector<DataSetLeaf>& leaves, Reducer& reducer)
{
  constexpr char separator = '\1'; // sorts before all characters of a name
  std::vector<std::string> own;
  for (const DataSetLeaf& leaf : leaves)
  {
    vtkCellData* const data = leaf.Data->GetCellData();
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* const array = data->GetAbstractArray(i);
      if (array->GetName())
      {
        own.push_back(array->GetName() + std::string(1, separator) +
          std::to_string(vtkDataArray::SafeDownCast(array) ? array->GetNumberOfComponents() : 0));
      }
    }
  }
  std::vector<std::pair<std::string, int>> arrays;
  for (const std::string& entry : reducer.GatherNames(own))
  {
    const std::size_t end = entry.find(separator);
    arrays.emplace_back(entry.substr(0, end), std::stoi(entry.substr(end + 1)));
  }
  return arrays;
}
}

//------------------------------------------------------------------------------
std::string GetArrayOfScope(const Scope& scope)
{
  switch (scope.Kind)
  {
    case ScopeKind::Family:
      return "CellFamilyId";
    case ScopeKind::CellType:
      return "CellTypeId";
    default:
      return scope.Array;
  }
}

//------------------------------------------------------------------------------
void ChooseCriteria(const std::vector<Rule>& rules, vtkElementQuality& evaluator)
{
  evaluator.ClearCriteria();
  const auto choose = [&](const std::string& name)
  {
    if (FindCriterion(name))
    {
      evaluator.SetCriterionStatus(name.c_str(), 1);
    }
  };
  for (const Rule& rule : rules)
  {
    if (rule.IsOfCells())
    {
      choose(rule.Criterion);
      choose(rule.Scope ? GetArrayOfScope(*rule.Scope) : "");
    }
  }
}

//------------------------------------------------------------------------------
void CheckScopes(const std::vector<Rule>& rules, const std::vector<DataSetLeaf>& leaves,
  const BlockNames& blockNames, Reducer& reducer)
{
  std::vector<std::string> blocks, arrays, criteria;
  for (const auto& block : blockNames)
  {
    blocks.push_back(GetLabel(block.second));
  }
  const auto components = GatherArrays(leaves, reducer);
  for (const auto& array : components)
  {
    arrays.push_back(array.first);
  }
  for (const Criterion& criterion : GetCriteria())
  {
    criteria.emplace_back(criterion.Name);
  }
  for (const Rule& rule : rules)
  {
    const Scope scope = rule.Scope.value_or(Scope());
    if (scope.Kind == ScopeKind::Block &&
      std::find(blocks.begin(), blocks.end(), scope.Value) == blocks.end())
    {
      throw MakeError(
        rule, DescribeMissing("block " + scope.Value + " with cells", scope.Value, blocks, {}));
    }
    if (scope.Kind == ScopeKind::Array && !FindCriterion(scope.Array))
    {
      const auto found = std::find(arrays.begin(), arrays.end(), scope.Array);
      if (found == arrays.end())
      {
        throw MakeError(
          rule, DescribeMissing("cell array " + scope.Array, scope.Array, arrays, criteria));
      }
      const int size = components[found - arrays.begin()].second;
      if (size != 1)
      {
        throw MakeError(rule,
          "the cell array " + scope.Array + " has " +
            (size == 0 ? "texts, not integers" : std::to_string(size) + " components, not one"));
      }
    }
  }
}

//------------------------------------------------------------------------------
CheckedCells::CheckedCells(
  const std::optional<Scope>& scope, const ElementBlocks& blocks, Reducer& reducer)
  : IsInside(blocks.Get().size(), !scope || scope->Kind == ScopeKind::Elements)
  , Skips(blocks.Get().size())
{
  if (scope && scope->Kind == ScopeKind::Block)
  {
    for (std::size_t b = 0; b < this->Skips.size(); ++b)
    {
      this->IsInside[b] = GetLabel(blocks.Get()[b].Name) == scope->Value;
    }
    return;
  }
  if (!scope || scope->Kind == ScopeKind::Elements)
  {
    return;
  }
  const std::vector<double> wanted = GetValuesOfScope(*scope);
  const BlockValues values(blocks, GetArrayOfScope(*scope), reducer);
  for (std::size_t i = 0; i < values.Get().size(); ++i)
  {
    const ValueBlock& block = values.Get()[i];
    const std::size_t number = values.GetBlockNumbers()[i];
    std::vector<unsigned char>& skip = this->Skips[number];
    this->IsInside[number] = true;
    skip.resize(block.Size);
    ParallelForEach(block.Size, LightGrain,
      [&](vtkIdType cell)
      {
        skip[cell] = !block.Contains(cell) ||
          std::find(wanted.begin(), wanted.end(), block.Values[cell]) == wanted.end();
      });
  }
}

//------------------------------------------------------------------------------
Population CheckedCells::Restrict(const BlockValues& values) const
{
  Population population = values.Get();
  for (std::size_t i = 0; i < population.size(); ++i)
  {
    const std::size_t number = values.GetBlockNumbers()[i];
    const std::vector<unsigned char>& skip = this->Skips[number];
    population[i].Size = this->IsInside[number] ? population[i].Size : 0;
    population[i].Skip = skip.empty() ? population[i].Skip : skip.data();
  }
  return population;
}
}
