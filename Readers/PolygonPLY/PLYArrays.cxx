// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PLYArrays.h"

#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"

#include <algorithm>
#include <set>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Finds the arrays of one element.
class Planner
{
public:
  Planner(const PLYElement& element, std::vector<bool>& used)
    : Element(element)
    , Used(used)
  {
  }

  void AddPoints();
  void AddKnown(PLYArrayPlan::Role kind, const char* name, const std::vector<std::string>& names);
  void AddColors();
  void AddVectors(const std::map<std::string, int>& components);
  void AddScalars(const std::vector<PLYListShape>& lists);
  std::vector<PLYArrayPlan> Plans;

private:
  const TableProperty& Get(int property) const { return this->Element.Properties[property]; }
  /// A property that is not used yet; -1 if there is none.
  int Find(const std::string& name) const
  {
    for (std::size_t i = 0; i < this->Element.Properties.size(); ++i)
    {
      const TableProperty& property = this->Element.Properties[i];
      if (!this->Used[i] && !property.IsList && property.Name == name)
      {
        return static_cast<int>(i);
      }
    }
    return -1;
  }
  /// The properties with these names, or empty if one of them is missing.
  std::vector<int> FindAll(const std::vector<std::string>& names) const
  {
    std::vector<int> found;
    for (const std::string& name : names)
    {
      found.push_back(this->Find(name));
    }
    const bool all = std::find(found.begin(), found.end(), -1) == found.end();
    return all ? found : std::vector<int>();
  }
  ValueType GetRealType(const std::vector<int>& properties) const
  {
    ValueType type = ValueType::Float;
    for (const int property : properties)
    {
      type = property < 0 ? type : camaron::GetRealType(type, this->Get(property).Type);
    }
    return type;
  }
  bool HaveOneType(const std::vector<int>& properties) const
  {
    return std::all_of(properties.begin(), properties.end(),
      [&](int p) { return this->Get(p).Type == this->Get(properties[0]).Type; });
  }
  void Add(PLYArrayPlan::Role kind, const std::string& name, ValueType type,
    const std::vector<int>& properties, ValueConversion conversion = ValueConversion::Value);

  const PLYElement& Element;
  std::vector<bool>& Used;
  std::set<std::string> Names;
};

//------------------------------------------------------------------------------
void Planner::Add(PLYArrayPlan::Role kind, const std::string& name, ValueType type,
  const std::vector<int>& properties, ValueConversion conversion)
{
  PLYArrayPlan plan;
  plan.Kind = kind;
  plan.Type = type;
  plan.Conversion = conversion;
  plan.Properties = properties;
  plan.Name = name;
  for (int number = 2; !this->Names.insert(plan.Name).second; ++number)
  {
    plan.Name = name + "_" + std::to_string(number);
  }
  for (const int property : properties)
  {
    if (property >= 0)
    {
      this->Used[property] = true;
    }
  }
  this->Plans.push_back(plan);
}

//------------------------------------------------------------------------------
void Planner::AddPoints()
{
  const std::vector<int> found = { this->Find("x"), this->Find("y"), this->Find("z") };
  this->Add(PLYArrayPlan::Role::Points, "Points", this->GetRealType(found), found);
}

//------------------------------------------------------------------------------
// Adds an array of real numbers whose properties have these names, if there are all.
void Planner::AddKnown(
  PLYArrayPlan::Role kind, const char* name, const std::vector<std::string>& names)
{
  const std::vector<int> found = this->FindAll(names);
  if (!found.empty() && this->Names.count(name) == 0)
  {
    this->Add(kind, name, this->GetRealType(found), found);
  }
}

//------------------------------------------------------------------------------
void Planner::AddColors()
{
  for (const std::string prefix : { "", "diffuse_" })
  {
    std::vector<int> found =
      this->FindAll({ prefix + "red", prefix + "green", prefix + "blue", prefix + "alpha" });
    if (found.empty())
    {
      found = this->FindAll({ prefix + "red", prefix + "green", prefix + "blue" });
    }
    // Integers of other types have no known range.
    const bool areColors = !found.empty() && this->HaveOneType(found) &&
      (this->Get(found[0]).Type == ValueType::UInt8 || IsReal(this->Get(found[0]).Type) ||
        this->Element.HasByteColors);
    if (areColors)
    {
      this->Add(PLYArrayPlan::Role::Scalars, found.size() == 4 ? "RGBA" : "RGB", ValueType::UInt8,
        found, ValueConversion::Color);
      return;
    }
  }
}

//------------------------------------------------------------------------------
void Planner::AddVectors(const std::map<std::string, int>& components)
{
  for (const auto& entry : components)
  {
    if (entry.second > static_cast<int>(this->Element.Properties.size()))
    {
      continue;
    }
    std::vector<std::string> names;
    for (int i = 0; i < entry.second; ++i)
    {
      names.push_back(entry.first + "_" + std::to_string(i));
    }
    const std::vector<int> found = this->FindAll(names);
    if (!found.empty() && this->HaveOneType(found))
    {
      this->Add(PLYArrayPlan::Role::Scalars, entry.first, this->Get(found[0]).Type, found);
    }
  }
}

//------------------------------------------------------------------------------
// Adds the other properties: first single values, then lists.
void Planner::AddScalars(const std::vector<PLYListShape>& lists)
{
  const auto count = static_cast<int>(this->Used.size());
  for (int i = 0; i < count; ++i)
  {
    const TableProperty& property = this->Get(i);
    if (!property.IsList && !this->Used[i])
    {
      this->Add(PLYArrayPlan::Role::Scalars, property.Name, property.Type, { i });
    }
  }
  for (int i = 0; i < count && !lists.empty(); ++i)
  {
    const TableProperty& property = this->Get(i);
    const PLYListShape& shape = lists[i];
    if (shape.Components == 0 || this->Used[i])
    {
      continue;
    }
    this->Add(PLYArrayPlan::Role::Scalars, property.Name, property.Type,
      std::vector<int>(static_cast<std::size_t>(shape.Components), i));
    this->Plans.back().AreItems = true;
    this->Plans.back().IsPadded = shape.Varies;
    if (shape.Varies)
    {
      this->Add(PLYArrayPlan::Role::Scalars, property.Name + "_length", ValueType::Int32, { i });
    }
  }
}
}

//------------------------------------------------------------------------------
std::vector<PLYArrayPlan> PlanArrays(const PLYElement& element, PLYSubject subject,
  const std::map<std::string, int>& components, std::vector<bool> used,
  const std::vector<PLYListShape>& lists)
{
  used.resize(element.Properties.size(), false);
  Planner planner(element, used);
  if (subject == PLYSubject::Points)
  {
    planner.AddPoints();
    for (const auto& names : { std::vector<std::string>{ "texture_u", "texture_v" }, { "u", "v" },
           { "s", "t" }, { "texture_s", "texture_t" } })
    {
      planner.AddKnown(PLYArrayPlan::Role::TextureCoordinates, "TCoords", names);
    }
  }
  if (subject != PLYSubject::Other)
  {
    planner.AddKnown(PLYArrayPlan::Role::Normals, "Normals", { "nx", "ny", "nz" });
    planner.AddColors();
  }
  planner.AddVectors(components);
  planner.AddScalars(lists);
  return planner.Plans;
}

//------------------------------------------------------------------------------
void PLYArrays::Add(std::vector<PLYArrayPlan>& plans)
{
  const auto find = [&](const std::string& name)
  {
    return std::find_if(this->Arrays.begin(), this->Arrays.end(),
      [&](const Entry& entry) { return entry.Plan.Name == name; });
  };
  for (PLYArrayPlan& plan : plans)
  {
    auto known = find(plan.Name);
    while (known != this->Arrays.end() &&
      (known->Plan.Properties.size() != plan.Properties.size() || known->Plan.Kind != plan.Kind ||
        known->Plan.Conversion != plan.Conversion))
    {
      plan.Name += "_";
      known = find(plan.Name);
    }
    if (known == this->Arrays.end())
    {
      this->Arrays.push_back({ plan, nullptr });
    }
    else
    {
      known->Plan.IsPadded = known->Plan.IsPadded || plan.IsPadded;
      if (known->Plan.Type != plan.Type)
      {
        known->Plan.Type = GetRealType(known->Plan.Type, plan.Type);
      }
    }
  }
}

//------------------------------------------------------------------------------
void PLYArrays::Allocate(vtkIdType tuples, bool isCovered)
{
  for (Entry& entry : this->Arrays)
  {
    const PLYArrayPlan& plan = entry.Plan;
    const auto components = static_cast<int>(plan.Properties.size());
    entry.Array = MakeArray(plan.Type, components, tuples);
    entry.Array->SetName(plan.Name.c_str());
    const bool isFull = isCovered && !plan.IsPadded &&
      std::find(plan.Properties.begin(), plan.Properties.end(), -1) == plan.Properties.end();
    if (!isFull)
    {
      const bool isMissing = IsReal(plan.Type) && plan.Kind != PLYArrayPlan::Role::Points;
      entry.Array->Fill(isMissing ? std::numeric_limits<double>::quiet_NaN() : 0);
    }
  }
}

//------------------------------------------------------------------------------
vtkDataArray* PLYArrays::Get(const std::string& name) const
{
  for (const Entry& entry : this->Arrays)
  {
    if (entry.Plan.Name == name)
    {
      return entry.Array;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
std::vector<TableColumn> PLYArrays::GetColumns(const std::vector<PLYArrayPlan>& plans) const
{
  std::vector<TableColumn> columns;
  for (const PLYArrayPlan& plan : plans)
  {
    vtkDataArray* const array = this->Get(plan.Name);
    if (array->GetNumberOfTuples() == 0)
    {
      continue;
    }
    const int components = array->GetNumberOfComponents();
    ValueType type = plan.Type;
    FindType(array->GetDataType(), type);
    for (int c = 0; c < components; ++c)
    {
      if (plan.Properties[c] >= 0)
      {
        columns.push_back({ plan.Properties[c], plan.AreItems ? c : -1, plan.Conversion, type,
          static_cast<char*>(array->GetVoidPointer(0)) + c * GetSize(type), components });
      }
    }
  }
  return columns;
}

//------------------------------------------------------------------------------
void PLYArrays::MoveTo(vtkDataSetAttributes* attributes)
{
  for (Entry& entry : this->Arrays)
  {
    switch (entry.Plan.Kind)
    {
      case PLYArrayPlan::Role::Normals:
        attributes->SetNormals(entry.Array);
        break;
      case PLYArrayPlan::Role::TextureCoordinates:
        attributes->SetTCoords(entry.Array);
        break;
      case PLYArrayPlan::Role::Scalars:
        attributes->AddArray(entry.Array);
        break;
      default:
        break;
    }
  }
  this->Arrays.clear();
}

//------------------------------------------------------------------------------
void PLYArrays::MoveTo(vtkFieldData* fields, const std::string& prefix)
{
  for (Entry& entry : this->Arrays)
  {
    entry.Array->SetName((prefix + entry.Plan.Name).c_str());
    fields->AddArray(entry.Array);
  }
  this->Arrays.clear();
}
}
