// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MAPDLOutputTypes.h"

#include "MAPDLElements.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkIntArray.h"

#include <algorithm>
#include <limits>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Whether a cell is read as the same cell if it is written as an element of a type.
bool IsReadBack(const MAPDLType& type, unsigned char cellType)
{
  const MAPDLClass elementClass = GetMAPDLClass(type.Element, type.Shape);
  const MAPDLForm form = GetMAPDLForm(cellType, elementClass);
  std::int32_t nodes[MaxMAPDLNodes];
  std::transform(form.Order, form.Order + form.NumberOfNodes, nodes,
    [](unsigned char point) { return point + 1; });
  MAPDLCell cell;
  MakeMAPDLCell(elementClass, nodes, form.NumberOfNodes, false, cell);
  bool isSame = cell.Type == cellType && elementClass != MAPDLClass::Undefined;
  for (std::int32_t i = 0; i < cell.Size && isSame; ++i)
  {
    isSame = cell.Nodes[i] == i + 1;
  }
  return isSame;
}
}

//------------------------------------------------------------------------------
MAPDLNumbers::MAPDLNumbers(vtkDataSetAttributes* attributes, const char* name, std::int32_t missing)
  : MAPDLNumbers(attributes, name, missing, missing)
{
}

//------------------------------------------------------------------------------
MAPDLNumbers::MAPDLNumbers(
  vtkDataSetAttributes* attributes, const char* name, std::int32_t missing, std::int32_t reserved)
  : Missing(missing)
  , Reserved(reserved)
{
  vtkDataArray* const array = attributes->GetArray(name);
  if (array && array->GetNumberOfComponents() == 1 && array->GetDataType() != VTK_FLOAT &&
    array->GetDataType() != VTK_DOUBLE)
  {
    this->Array = array;
    vtkIntArray* const ints = vtkIntArray::SafeDownCast(array);
    this->Values = ints ? ints->GetPointer(0) : nullptr;
  }
}

//------------------------------------------------------------------------------
MAPDLOutputTypes::MAPDLOutputTypes(vtkDataSet* mesh, const OutputMesh& output)
  : Output(output)
  , TypeIds(mesh->GetCellData(), "TypeId", 0)
  , Elements(mesh->GetCellData(), "ElementType", 0)
{
  std::vector<Key> keys; // in order of occurrence
  for (vtkIdType cell = 0; cell < output.GetNumberOfCells(); ++cell)
  {
    const Key key = this->GetKey(cell);
    if ((keys.empty() || key != keys.back()) && this->TypeOfKey.emplace(key, Choice()).second)
    {
      keys.push_back(key);
    }
  }
  for (const Key& key : keys)
  {
    const std::int32_t id = std::get<0>(key), element = std::get<1>(key);
    const unsigned char cellType = std::get<2>(key);
    const int shape = element == MeshOnly ? GetMAPDLForm(cellType).MeshOnlyShape : 0;
    const auto known = this->Types.find(id);
    const MAPDLType type = known == this->Types.end() ? MAPDLType{ element, shape } : known->second;
    if (id >= 1 && element >= 1 && type.Element == element && IsReadBack(type, cellType))
    {
      this->Types[id] = type;
      this->TypeOfKey[key].Id = id;
      this->KeepsTypes = true;
    }
  }
  const auto findFree = [this](std::int32_t id)
  {
    while (this->Types.count(id))
    {
      id = id == std::numeric_limits<std::int32_t>::max() ? 1 : id + 1;
    }
    return id;
  };
  std::int32_t next = findFree(this->Types.empty() ? 1 : this->Types.rbegin()->first);
  std::map<int, std::int32_t> usual;
  for (const Key& key : keys)
  {
    if (this->TypeOfKey[key].Id == 0)
    {
      const int element = GetMAPDLForm(std::get<2>(key)).Element;
      const auto added = usual.emplace(element, next);
      if (added.second)
      {
        this->Types[next] = { element, 0 };
        next = findFree(next);
      }
      this->TypeOfKey[key].Id = added.first->second;
    }
    Choice& choice = this->TypeOfKey[key];
    const MAPDLType& type = this->Types[choice.Id];
    choice.Form = GetMAPDLForm(std::get<2>(key), GetMAPDLClass(type.Element, type.Shape));
  }
}

//------------------------------------------------------------------------------
Tally MAPDLOutputTypes::FindOtherTypes() const
{
  Tally others;
  vtkIdType last = -1; // a cell may have been cut into several ones, which are consecutive
  for (vtkIdType cell = 0; cell < this->Output.GetNumberOfCells(); ++cell)
  {
    const vtkIdType from = this->Output.GetInputCell(cell);
    const std::int32_t id = this->TypeIds[from], element = this->Elements[from];
    const std::int32_t writtenId = this->GetType(cell).Id;
    const bool isSame = (!this->TypeIds.HasArray() || id == writtenId) &&
      (!this->Elements.HasArray() || element == this->Types.find(writtenId)->second.Element);
    const bool isToldOf =
      id != 0 || element != 0 || !this->TypeIds.IsKept(from) || !this->Elements.IsKept(from);
    if (isToldOf && !isSame && from != last)
    {
      others.Add(from);
      last = from;
    }
  }
  return others;
}

//------------------------------------------------------------------------------
MAPDLOutputTypes::Key MAPDLOutputTypes::GetKey(vtkIdType cell) const
{
  const vtkIdType from = this->Output.GetInputCell(cell);
  return { this->TypeIds[from], this->Elements[from], this->Output.GetCellType(cell) };
}
}
