// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InspectionBlocks.h"

#include "InspectionArrays.h"

#include "vtkCellData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkMapper.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>
#include <string>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Sets, replaces or (null) removes a field array of the grid; keeps an equal one.
template <typename Array>
void SetFieldArray(vtkUnstructuredGrid* grid, const char* name, Array* array)
{
  auto* old = Array::SafeDownCast(grid->GetFieldData()->GetArray(name));
  if (old && array && old->GetNumberOfValues() == array->GetNumberOfValues() &&
    std::equal(
      array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues(), old->GetPointer(0)))
  {
    return;
  }
  grid->GetFieldData()->RemoveArray(name);
  if (array)
  {
    grid->GetFieldData()->AddArray(array);
  }
}

/// The look of a block, its own or inherited from its parents.
struct Look
{
  bool IsVisible = true;
  bool HasColor = false;
  double Color[3] = { 0, 0, 0 };
  double Opacity = -1; ///< below 0: that of the mesh
};

//------------------------------------------------------------------------------
// Finds the looks of all samples below a node.
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
// The color of a sample by its arrays; false if cells or points have their own colors.
bool GetColorOfArray(
  vtkUnstructuredGrid* sample, vtkMapper* mapper, const double missing[3], double color[3])
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
      return !sample->GetPointData()->HasArray(name);
    case VTK_SCALAR_MODE_USE_CELL_FIELD_DATA:
      std::copy_n(missing, 3, color);
      return !sample->GetCellData()->HasArray(name);
    case VTK_SCALAR_MODE_USE_FIELD_DATA:
      break;
    default:
      return false;
  }
  std::copy_n(missing, 3, color);
  vtkAbstractArray* array = sample->GetFieldData()->GetAbstractArray(name);
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
std::vector<Block> FindBlocks(vtkDataObjectTree* tree)
{
  std::vector<Block> found;
  const auto add = [](vtkDataObject* data, Block& block)
  {
    auto* piece = vtkUnstructuredGrid::SafeDownCast(data);
    if (piece && piece->GetNumberOfCells() > 0)
    {
      block.push_back(piece);
    }
  };
  if (vtkPartitionedDataSet::SafeDownCast(tree))
  {
    found.emplace_back();
  }
  for (unsigned int i = 0; i < tree->GetNumberOfChildren(); ++i)
  {
    vtkDataObject* child = tree->GetChild(i);
    if (vtkPartitionedDataSet::SafeDownCast(tree))
    {
      add(child, found.front());
    }
    else if (auto* branch = vtkDataObjectTree::SafeDownCast(child))
    {
      const std::vector<Block> ofBranch = FindBlocks(branch);
      found.insert(found.end(), ofBranch.begin(), ofBranch.end());
    }
    else
    {
      found.emplace_back();
      add(child, found.back());
    }
  }
  return found;
}

//------------------------------------------------------------------------------
void SetLooks(vtkUnstructuredGrid* grid, vtkDataObjectTree* samples,
  vtkCompositeDataDisplayAttributes* attributes, vtkMapper* mapper, const double missing[3])
{
  Block pieces;
  for (const Block& block : FindBlocks(samples))
  {
    pieces.insert(pieces.end(), block.begin(), block.end());
  }
  const auto size = static_cast<vtkIdType>(pieces.size());
  vtkNew<vtkUnsignedCharArray> hidden;
  hidden->SetName(HiddenLeavesName);
  hidden->SetNumberOfValues(size);
  vtkNew<vtkFloatArray> looks;
  looks->SetName(LeafLooksName);
  looks->SetNumberOfComponents(4);
  looks->SetNumberOfTuples(size);
  std::map<vtkDataObject*, Look> ofSamples;
  FindLooks(samples, attributes, Look(), ofSamples);
  bool hasHidden = false;
  bool hasLooks = false;
  for (vtkIdType i = 0; i < size; ++i)
  {
    Look look = ofSamples[pieces[i]];
    look.HasColor = look.HasColor || GetColorOfArray(pieces[i], mapper, missing, look.Color);
    hidden->SetValue(i, look.IsVisible ? 0 : 1);
    looks->SetTuple4(
      i, look.HasColor ? look.Color[0] : -1, look.Color[1], look.Color[2], look.Opacity);
    hasHidden = hasHidden || !look.IsVisible;
    hasLooks = hasLooks || look.HasColor || look.Opacity >= 0;
  }
  SetFieldArray(grid, HiddenLeavesName, hasHidden ? hidden.Get() : nullptr);
  SetFieldArray(grid, LeafLooksName, hasLooks ? looks.Get() : nullptr);
}
}
