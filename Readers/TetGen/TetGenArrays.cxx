// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TetGenArrays.h"

#include "Intake/CellMesh/OutputWarnings.h"
#include "TetGenRows.h"

#include "vtkDataSetAttributes.h"

#include <algorithm>
#include <climits>
#include <cstdint>

namespace camaron
{
namespace
{
const std::string MarkerName = "BoundaryMarker";
const std::string AttributePrefix = "attr_";

//------------------------------------------------------------------------------
bool IsMarker(vtkDataArray* array)
{
  if (!array->GetName() || array->GetName() != MarkerName || array->GetDataType() == VTK_FLOAT ||
    array->GetDataType() == VTK_DOUBLE)
  {
    return false;
  }
  const double* const range = array->GetRange(0);
  return range[0] >= INT32_MIN && range[1] <= INT32_MAX;
}

//------------------------------------------------------------------------------
// Index that the reader gave an attribute of this name, or a high number for others.
int GetRank(const std::string& name, const std::string& first)
{
  if (name == first)
  {
    return -1;
  }
  const std::size_t size = AttributePrefix.size();
  constexpr std::size_t MaxDigits = 4;
  if (name.compare(0, size, AttributePrefix) != 0 || name.size() == size ||
    name.size() > size + MaxDigits ||
    name.find_first_not_of("0123456789", size) != std::string::npos)
  {
    return INT_MAX;
  }
  return std::stoi(name.substr(size));
}

//------------------------------------------------------------------------------
// Whether an array is written differently: ids are renumbered, and ghosts are dropped.
bool IsIds(vtkDataSetAttributes* attributes, vtkDataArray* array)
{
  const std::string name = array->GetName() ? array->GetName() : "";
  return array == attributes->GetGlobalIds() || name == "OriginalPointId" ||
    name == "OriginalCellId" || name == vtkDataSetAttributes::GhostArrayName();
}
}

//------------------------------------------------------------------------------
void TetGenArrays::Column::Set(vtkDataArray* array)
{
  this->Array = array;
  if (!array->HasStandardMemoryLayout())
  {
    this->Array.TakeReference(vtkDataArray::CreateDataArray(array->GetDataType()));
    this->Array->DeepCopy(array);
  }
  this->Values = this->Array->GetVoidPointer(0);
  this->Name = DescribeArray(array);
}

//------------------------------------------------------------------------------
TetGenArrays::TetGenArrays(
  vtkDataSetAttributes* attributes, const std::string& first, bool hasMarkers)
  : First(first)
{
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = attributes->GetArray(i);
    if (!array || array->GetNumberOfComponents() != 1 || array->GetDataType() == VTK_BIT ||
      IsIds(attributes, array))
    {
      continue;
    }
    Column column;
    column.Set(array);
    if (hasMarkers && !this->HasMarkers() && IsMarker(array))
    {
      this->Marker = column;
    }
    else
    {
      this->Attributes.push_back(column);
    }
  }
  std::stable_sort(this->Attributes.begin(), this->Attributes.end(),
    [&](const Column& a, const Column& b)
    { return GetRank(a.Name, this->First) < GetRank(b.Name, this->First); });
  // Arrays beyond the limit of the reader are reported as not written.
  if (this->Attributes.size() > MaxTetGenAttributes)
  {
    this->Attributes.resize(MaxTetGenAttributes);
  }
}

//------------------------------------------------------------------------------
void TetGenArrays::AddNames(std::vector<std::string>& names) const
{
  names.insert(names.end(), { "OriginalPointId", "OriginalCellId" });
  for (const Column& column : this->Attributes)
  {
    names.push_back(column.Name);
  }
  if (this->HasMarkers())
  {
    names.push_back(MarkerName);
  }
}

//------------------------------------------------------------------------------
std::string TetGenArrays::DescribeRenamed() const
{
  std::string text;
  for (std::size_t i = 0; i < this->Attributes.size(); ++i)
  {
    const std::string name = i == 0 ? this->First : AttributePrefix + std::to_string(i);
    if (this->Attributes[i].Name != name)
    {
      text += (text.empty() ? "" : ", ") + this->Attributes[i].Name + " as " + name;
    }
  }
  return text;
}
}
