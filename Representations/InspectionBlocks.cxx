// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InspectionBlocks.h"

#include "InspectionArrays.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedIntArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>
#include <string>

namespace camaron
{
namespace
{
using Leaf = vtkSmartPointer<vtkUnstructuredGrid>;

bool IsByte(int type)
{
  return type == VTK_UNSIGNED_CHAR || type == VTK_CHAR || type == VTK_SIGNED_CHAR;
}

/// An array that some blocks have.
struct SharedArray
{
  int Type = VTK_VOID;
  int NumberOfComponents = 1;
  std::size_t NumberOfLeaves = 0;
  bool IsOfOneType = true;
};

//------------------------------------------------------------------------------
std::map<std::string, SharedArray> FindArrays(const std::vector<Leaf>& leaves, int association)
{
  std::map<std::string, SharedArray> found;
  for (const Leaf& leaf : leaves)
  {
    vtkDataSetAttributes* attributes = leaf->GetAttributes(association);
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = attributes->GetAbstractArray(i);
      if (!array->GetName())
      {
        continue;
      }
      SharedArray& shared = found[array->GetName()];
      if (shared.NumberOfLeaves == 0)
      {
        shared.Type = array->GetDataType();
        shared.NumberOfComponents = array->GetNumberOfComponents();
      }
      shared.IsOfOneType = shared.IsOfOneType && array->GetDataType() == shared.Type;
      shared.NumberOfLeaves += array->GetNumberOfComponents() == shared.NumberOfComponents;
    }
  }
  for (auto& entry : found)
  {
    SharedArray& shared = entry.second;
    const bool isNumber = shared.Type != VTK_STRING && shared.Type != VTK_VARIANT;
    const bool hasNull = shared.Type == VTK_FLOAT || shared.Type == VTK_DOUBLE || IsByte(shared.Type);
    if (isNumber && (!shared.IsOfOneType || (shared.NumberOfLeaves < leaves.size() && !hasNull)))
    {
      shared.Type = VTK_DOUBLE;
    }
  }
  return found;
}

//------------------------------------------------------------------------------
// An array for a leaf that has none of this kind.
vtkSmartPointer<vtkAbstractArray> MakeNulls(const SharedArray& like, vtkIdType size)
{
  vtkSmartPointer<vtkAbstractArray> made;
  made.TakeReference(vtkAbstractArray::CreateArray(like.Type));
  made->SetNumberOfComponents(like.NumberOfComponents);
  made->SetNumberOfTuples(size);
  if (auto* numbers = vtkDataArray::SafeDownCast(made))
  {
    numbers->Fill(IsByte(like.Type) ? 0.0 : vtkMath::Nan());
  }
  return made;
}

//------------------------------------------------------------------------------
// The same arrays of the same types on all leaves; which of them are attributes is left to names.
void MakeAlike(const std::vector<Leaf>& leaves, int association)
{
  const std::map<std::string, SharedArray> arrays = FindArrays(leaves, association);
  for (const Leaf& leaf : leaves)
  {
    vtkDataSetAttributes* attributes = leaf->GetAttributes(association);
    for (int kind = 0; kind < vtkDataSetAttributes::NUM_ATTRIBUTES; ++kind)
    {
      attributes->SetActiveAttribute(-1, kind);
    }
    for (const auto& entry : arrays)
    {
      const SharedArray& shared = entry.second;
      vtkAbstractArray* array = attributes->GetAbstractArray(entry.first.c_str());
      vtkSmartPointer<vtkAbstractArray> other;
      if (!array || array->GetNumberOfComponents() != shared.NumberOfComponents)
      {
        other = MakeNulls(shared, leaf->GetNumberOfElements(association));
      }
      else if (array->GetDataType() != shared.Type && vtkDataArray::SafeDownCast(array))
      {
        other.TakeReference(vtkAbstractArray::CreateArray(shared.Type));
        other->DeepCopy(array);
      }
      if (other)
      {
        other->SetName(entry.first.c_str());
        attributes->RemoveArray(entry.first.c_str());
        attributes->AddArray(other);
      }
    }
  }
}

//------------------------------------------------------------------------------
// Replaces an array of the whole grid, unless it is the same; null: there is none.
template <typename Array>
void SetFieldArray(vtkUnstructuredGrid* grid, const char* name, Array* array)
{
  auto* old = Array::SafeDownCast(grid->GetFieldData()->GetArray(name));
  if (old && array && old->GetNumberOfValues() == array->GetNumberOfValues() &&
    std::equal(array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues(),
      old->GetPointer(0)))
  {
    return;
  }
  grid->GetFieldData()->RemoveArray(name);
  if (array)
  {
    grid->GetFieldData()->AddArray(array);
  }
}

/// What a block has of its own, or of a block that it is part of.
struct Look
{
  bool IsVisible = true;
  bool HasColor = false;
  double Color[3] = { 0, 0, 0 };
  double Opacity = -1; ///< below 0: none
};

//------------------------------------------------------------------------------
// The looks of the grids below a node.
void FindLooks(vtkDataObject* node, vtkCompositeDataDisplayAttributes* attributes, Look look,
  std::map<vtkDataObject*, Look>& looks)
{
  if (attributes->HasBlockVisibility(node))
  {
    look.IsVisible = attributes->GetBlockVisibility(node);
  }
  if (attributes->HasBlockColor(node))
  {
    look.HasColor = true;
    attributes->GetBlockColor(node, look.Color);
  }
  if (attributes->HasBlockOpacity(node))
  {
    look.Opacity = attributes->GetBlockOpacity(node);
  }
  auto* tree = vtkDataObjectTree::SafeDownCast(node);
  if (!tree)
  {
    looks[node] = look;
    return;
  }
  for (unsigned int i = 0; i < tree->GetNumberOfChildren(); ++i)
  {
    if (vtkDataObject* child = tree->GetChild(i))
    {
      FindLooks(child, attributes, look, looks);
    }
  }
}

//------------------------------------------------------------------------------
// What the arrays of a leaf say about its colour; false where cells or points have colours of their own.
bool GetColorOfArray(
  vtkUnstructuredGrid* leaf, vtkMapper* mapper, const double missing[3], double color[3])
{
  if (!mapper->GetScalarVisibility() || !mapper->GetArrayName() || !*mapper->GetArrayName())
  {
    return false;
  }
  const char* name = mapper->GetArrayName();
  switch (mapper->GetScalarMode())
  {
    case VTK_SCALAR_MODE_USE_POINT_FIELD_DATA:
      std::copy_n(missing, 3, color);
      return !leaf->GetPointData()->HasArray(name);
    case VTK_SCALAR_MODE_USE_CELL_FIELD_DATA:
      std::copy_n(missing, 3, color);
      return !leaf->GetCellData()->HasArray(name);
    case VTK_SCALAR_MODE_USE_FIELD_DATA:
      break;
    default:
      return false;
  }
  std::copy_n(missing, 3, color);
  vtkAbstractArray* array = leaf->GetFieldData()->GetAbstractArray(name);
  if (array && array->GetNumberOfTuples() > 0)
  {
    vtkSmartPointer<vtkUnsignedCharArray> mapped;
    mapped.TakeReference(mapper->GetLookupTable()->MapScalars(
      array, mapper->GetColorMode(), mapper->GetArrayComponent(), VTK_RGBA));
    for (int i = 0; i < 3 && mapped; ++i)
    {
      color[i] = mapped->GetTypedComponent(0, i) / 255.0;
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
bool InspectionBlocks::IsNew(vtkDataObject* data) const
{
  return data != this->Data || (data && data->GetMTime() != this->Time);
}

//------------------------------------------------------------------------------
vtkUnstructuredGrid* InspectionBlocks::Join(vtkDataObject* data)
{
  auto* tree = vtkCompositeDataSet::SafeDownCast(data);
  if (!tree)
  {
    *this = InspectionBlocks();
    return vtkUnstructuredGrid::SafeDownCast(data);
  }
  if (!this->IsNew(data))
  {
    return this->Grid;
  }
  this->Data = data;
  this->Time = data->GetMTime();
  this->Leaves.clear();
  std::vector<Leaf> copies;
  for (vtkUnstructuredGrid* leaf : vtkCompositeDataSet::GetDataSets<vtkUnstructuredGrid>(tree))
  {
    if (leaf->GetNumberOfCells() == 0)
    {
      continue;
    }
    auto copy = Leaf::New();
    copy->ShallowCopy(leaf);
    vtkNew<vtkUnsignedIntArray> numbers;
    numbers->SetName(LeavesName);
    numbers->SetNumberOfValues(leaf->GetNumberOfCells());
    numbers->FillValue(static_cast<unsigned int>(this->Leaves.size()));
    copy->GetCellData()->AddArray(numbers);
    copies.push_back(copy);
    this->Leaves.emplace_back(leaf);
  }
  MakeAlike(copies, vtkDataObject::POINT);
  MakeAlike(copies, vtkDataObject::CELL);
  this->Grid = Leaf::New();
  if (!copies.empty())
  {
    vtkNew<vtkAppendFilter> append;
    for (const Leaf& copy : copies)
    {
      append->AddInputData(copy);
    }
    append->Update();
    this->Grid->ShallowCopy(append->GetOutput());
    for (const Leaf& leaf : this->Leaves)
    {
      if (vtkDataArray* normals = leaf->GetPointData()->GetNormals())
      {
        this->Grid->GetPointData()->SetActiveNormals(normals->GetName());
      }
    }
  }
  return this->Grid;
}

//------------------------------------------------------------------------------
void InspectionBlocks::SetLooks(
  vtkCompositeDataDisplayAttributes* attributes, vtkMapper* mapper, const double missing[3])
{
  if (!this->Grid)
  {
    return;
  }
  const auto size = static_cast<vtkIdType>(this->Leaves.size());
  vtkNew<vtkUnsignedCharArray> hidden;
  hidden->SetName(HiddenLeavesName);
  hidden->SetNumberOfValues(size);
  vtkNew<vtkFloatArray> looks;
  looks->SetName(LeafLooksName);
  looks->SetNumberOfComponents(4);
  looks->SetNumberOfTuples(size);
  std::map<vtkDataObject*, Look> ofLeaves;
  FindLooks(this->Data, attributes, Look(), ofLeaves);
  bool hasHidden = false;
  bool hasLooks = false;
  for (vtkIdType i = 0; i < size; ++i)
  {
    Look look = ofLeaves[this->Leaves[i]];
    look.HasColor =
      look.HasColor || GetColorOfArray(this->Leaves[i], mapper, missing, look.Color);
    hidden->SetValue(i, look.IsVisible ? 0 : 1);
    looks->SetTuple4(
      i, look.HasColor ? look.Color[0] : -1, look.Color[1], look.Color[2], look.Opacity);
    hasHidden = hasHidden || !look.IsVisible;
    hasLooks = hasLooks || look.HasColor || look.Opacity >= 0;
  }
  SetFieldArray(this->Grid, HiddenLeavesName, hasHidden ? hidden.Get() : nullptr);
  SetFieldArray(this->Grid, LeafLooksName, hasLooks ? looks.Get() : nullptr);
}
}
