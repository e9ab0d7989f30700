// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PLYColumns.h"

#include "Intake/CellMesh/OutputWarnings.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"

#include <algorithm>
#include <limits>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
template <typename In, typename Out>
void AppendAs(const NumberEncoder& encoder, std::string& bytes, const void* values, vtkIdType index)
{
  constexpr Out missing =
    std::numeric_limits<Out>::has_quiet_NaN ? std::numeric_limits<Out>::quiet_NaN() : Out(0);
  encoder.Append(
    bytes, index < 0 ? missing : static_cast<Out>(static_cast<const In*>(values)[index]));
}

//------------------------------------------------------------------------------
std::string GetArrayName(vtkAbstractArray* array)
{
  return array->GetName() ? array->GetName() : "";
}

//------------------------------------------------------------------------------
// A word without blanks; letters of other scripts are kept.
std::string MakeWord(const std::string& name)
{
  std::string word = name;
  for (char& c : word)
  {
    c = static_cast<unsigned char>(c) <= ' ' || c == '\x7f' ? '_' : c;
  }
  return word.empty() ? "array" : word;
}

//------------------------------------------------------------------------------
// Names of the components of an array.
std::vector<std::string> GetNames(const std::string& base, int components)
{
  std::vector<std::string> names;
  for (int c = 0; c < components; ++c)
  {
    names.push_back(components > 1 ? base + "_" + std::to_string(c) : base);
  }
  return names;
}

//------------------------------------------------------------------------------
bool IsColor(vtkDataArray* array)
{
  return array && array->GetDataType() == VTK_UNSIGNED_CHAR &&
    (array->GetNumberOfComponents() == 3 || array->GetNumberOfComponents() == 4);
}

//------------------------------------------------------------------------------
// The array to write as colors: the one that the reader would create, or the active one.
vtkDataArray* FindColors(vtkDataSetAttributes* attributes)
{
  for (const char* name : { "RGBA", "RGB" })
  {
    vtkDataArray* const array = attributes->GetArray(name);
    if (IsColor(array) && array->GetNumberOfComponents() == (name[3] == 'A' ? 4 : 3))
    {
      return array;
    }
  }
  return IsColor(attributes->GetScalars()) ? attributes->GetScalars() : nullptr;
}

//------------------------------------------------------------------------------
vtkDataArray* FindReal(vtkDataArray* active, vtkDataArray* named, int components)
{
  for (vtkDataArray* array : { active, named })
  {
    if (array && array->GetNumberOfComponents() == components &&
      (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE))
    {
      return array;
    }
  }
  return nullptr;
}
}

//------------------------------------------------------------------------------
PLYColumns::PLYColumns(vtkDataSetAttributes* attributes, std::set<std::string> reserved,
  std::vector<std::string>& written, Warnings& warnings)
  : Messages(&warnings)
  , Names(std::move(reserved))
{
  vtkDataArray* const normals =
    FindReal(attributes->GetNormals(), attributes->GetArray("Normals"), 3);
  vtkDataArray* const textures =
    FindReal(attributes->GetTCoords(), attributes->GetArray("TCoords"), 2);
  vtkDataArray* const colors = FindColors(attributes);
  if (normals)
  {
    this->AddUsual(normals, "Normals", { "nx", "ny", "nz" });
  }
  if (colors)
  {
    std::vector<std::string> names = { "red", "green", "blue", "alpha" };
    names.resize(static_cast<std::size_t>(colors->GetNumberOfComponents()));
    this->AddUsual(colors, names.size() == 4 ? "RGBA" : "RGB", names);
  }
  if (textures)
  {
    this->AddUsual(
      textures, "TCoords", { "texture_u", "texture_v" }); // names in ParaView and MeshLab
  }
  std::vector<vtkDataArray*> others;
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = attributes->GetArray(i);
    ValueType type;
    if (!array || array == attributes->GetGlobalIds() ||
      GetArrayName(array) == vtkDataSetAttributes::GhostArrayName() ||
      !FindType(array->GetDataType(), type) || array->GetNumberOfComponents() == 0)
    {
      continue;
    }
    if (array != normals && array != textures && array != colors)
    {
      others.push_back(array);
      this->Reserve(array);
    }
    written.push_back(DescribeArray(array));
  }
  for (vtkDataArray* array : others)
  {
    this->AddOther(array);
  }
  if (!this->Renamed.empty())
  {
    warnings.Add("arrays are renamed, as PLY names are single words, some names have a meaning of "
                 "their own, and normals, colors and texture coordinates have fixed names: " +
      this->Renamed);
  }
  this->Messages = nullptr;
}

//------------------------------------------------------------------------------
// Other programs do not support 64-bit integers in PLY files.
ValueType PLYColumns::ChooseType(vtkDataArray* array, ValueType type)
{
  if (type != ValueType::Int64 && type != ValueType::UInt64)
  {
    return type;
  }
  double least = 0, greatest = 0;
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    double range[2];
    array->GetRange(range, c);
    least = std::min(least, range[0]);
    greatest = std::max(greatest, range[1]);
  }
  if (array->GetNumberOfTuples() == 0 || (least >= INT32_MIN && greatest <= INT32_MAX))
  {
    return ValueType::Int32;
  }
  if (least >= 0 && greatest <= UINT32_MAX)
  {
    return ValueType::UInt32;
  }
  WarnOfIntegers(array, *this->Messages);
  return ValueType::Double;
}

//------------------------------------------------------------------------------
void PLYColumns::Add(vtkDataArray* array, const std::vector<std::string>& names)
{
  vtkSmartPointer<vtkDataArray> values = array;
  if (!array->HasStandardMemoryLayout())
  {
    values.TakeReference(vtkDataArray::CreateDataArray(array->GetDataType()));
    values->DeepCopy(array);
  }
  this->Arrays.push_back(values);
  ValueType type;
  FindType(array->GetDataType(), type);
  const ValueType fileType = this->ChooseType(array, type);
  const AppendFunction append = WithType(type,
    [&](auto in) -> AppendFunction
    {
      using In = decltype(in);
      return fileType == type           ? &AppendAs<In, In>
        : fileType == ValueType::Int32  ? &AppendAs<In, std::int32_t>
        : fileType == ValueType::UInt32 ? &AppendAs<In, std::uint32_t>
                                        : &AppendAs<In, double>;
    });
  for (std::size_t c = 0; c < names.size(); ++c)
  {
    this->Names.insert(names[c]);
    this->Columns.push_back({ names[c], fileType, append,
      array->GetNumberOfTuples() > 0 ? values->GetVoidPointer(0) : nullptr,
      array->GetNumberOfComponents(), static_cast<int>(c) });
  }
}

//------------------------------------------------------------------------------
// Adds an array whose properties have standard names; @a name is the one used by the reader.
void PLYColumns::AddUsual(
  vtkDataArray* array, const char* name, const std::vector<std::string>& names)
{
  if (GetArrayName(array) != name)
  {
    this->AddRenamed(array, name);
  }
  this->Add(array, names);
}

//------------------------------------------------------------------------------
void PLYColumns::AddRenamed(vtkDataArray* array, const std::string& name)
{
  this->Renamed += (this->Renamed.empty() ? "" : ", ") + DescribeArray(array) + " to " + name;
}

//------------------------------------------------------------------------------
// Reserves the names of an array, if they are words, so that renamed arrays do not use them.
void PLYColumns::Reserve(vtkDataArray* array)
{
  const std::string name = GetArrayName(array);
  if (MakeWord(name) == name)
  {
    const std::vector<std::string> names = GetNames(name, array->GetNumberOfComponents());
    this->Reserved.insert(names.begin(), names.end());
  }
}

//------------------------------------------------------------------------------
void PLYColumns::AddOther(vtkDataArray* array)
{
  const int components = array->GetNumberOfComponents();
  const std::string own = GetArrayName(array), word = MakeWord(own);
  std::string base = word;
  std::vector<std::string> names;
  const auto areFree = [&]
  {
    names = GetNames(base, components);
    return std::none_of(names.begin(), names.end(), [&](const std::string& name)
      { return this->Names.count(name) > 0 || (base != own && this->Reserved.count(name) > 0); });
  };
  while (!areFree())
  {
    base += "_";
  }
  if (base != own)
  {
    this->AddRenamed(
      array, base + (word != own && word != base ? " (" + word + " is another)" : ""));
  }
  if (components > 1)
  {
    this->Comments += "comment components " + base + " " + std::to_string(components) + "\n";
  }
  this->Add(array, names);
}

//------------------------------------------------------------------------------
std::string PLYColumns::GetProperties() const
{
  std::string text;
  for (const Column& column : this->Columns)
  {
    text += std::string("property ") + GetName(column.Type) + " " + column.Name + "\n";
  }
  return text;
}
}
