// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSelectionTable.h"

#include "ControllerReducer.h"
#include "ElementBlocks.h"
#include "ElementPlaces.h"
#include "Grouping.h"
#include "RequestFailure.h"
#include "TableRows.h"
#include "vtkSelectElements.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <set>
#include <stdexcept>

vtkStandardNewMacro(vtkSelectionTable);

namespace
{
//------------------------------------------------------------------------------
// The element type of the marks; cells if there are marks of both types or none.
camaron::ElementKind FindKind(vtkDataObject* input, camaron::Reducer& reducer)
{
  std::int64_t has[2] = { 0, 0 };
  for (const camaron::DataSetLeaf& leaf : camaron::GetLeaves(input))
  {
    for (const camaron::ElementKind kind :
      { camaron::ElementKind::Points, camaron::ElementKind::Cells })
    {
      const int number = static_cast<int>(kind);
      has[number] |= leaf.Data->GetNumberOfElements(number) > 0 &&
        leaf.Data->GetAttributes(number)->HasArray(vtkSelectElements::GetSelectedArrayName());
    }
  }
  reducer.Max(has, 2);
  const bool isOfPoints = has[static_cast<int>(camaron::ElementKind::Points)] &&
    !has[static_cast<int>(camaron::ElementKind::Cells)];
  return isOfPoints ? camaron::ElementKind::Points : camaron::ElementKind::Cells;
}

//------------------------------------------------------------------------------
/// The columns before those of the arrays.
class PlaceColumns
{
public:
  static constexpr int Number = 6;

  explicit PlaceColumns(vtkTable* table)
  {
    this->Id->SetName("Id");
    this->Block->SetName("Block");
    this->Type->SetName("CellType");
    table->AddColumn(this->Id);
    table->AddColumn(this->Block);
    table->AddColumn(this->Type);
    for (int c = 0; c < 3; ++c)
    {
      constexpr const char* names[] = { "X", "Y", "Z" };
      this->Place[c]->SetName(names[c]);
      table->AddColumn(this->Place[c]);
    }
  }

  void Add(const camaron::ElementBlock& block, vtkIdType element, vtkIdType id)
  {
    double place[3];
    camaron::GetPlace(block, element, place);
    this->Id->InsertNextValue(id);
    this->Block->InsertNextValue(block.Name);
    this->Type->InsertNextValue(block.Kind == camaron::ElementKind::Points
        ? std::string("Point")
        : camaron::GetCellTypeLabel(block.Data->GetCellType(element)));
    for (int c = 0; c < 3; ++c)
    {
      this->Place[c]->InsertNextValue(place[c]);
    }
  }

private:
  vtkNew<camaron::IntegerColumn> Id;
  vtkNew<vtkStringArray> Block, Type;
  vtkNew<vtkDoubleArray> Place[3];
};

//------------------------------------------------------------------------------
// The names, in order, of the arrays that all blocks of all processes have.
std::vector<std::string> FindArrays(const camaron::ElementBlocks& blocks, camaron::Reducer& reducer)
{
  std::vector<std::string> lacking, names;
  for (const camaron::ElementBlock& block : blocks.Get())
  {
    for (int i = 0; i < block.GetAttributes()->GetNumberOfArrays(); ++i)
    {
      const char* name = block.GetAttributes()->GetArrayName(i);
      if (name && name[0])
      {
        names.emplace_back(name);
      }
    }
  }
  names = reducer.GatherNames(names);
  for (const std::string& name : names)
  {
    for (const camaron::ElementBlock& block : blocks.Get())
    {
      if (!block.GetAttributes()->GetAbstractArray(name.c_str()))
      {
        lacking.push_back(name);
      }
    }
  }
  const std::vector<std::string> gathered = reducer.GatherNames(lacking);
  const std::set<std::string> left(gathered.begin(), gathered.end());
  const auto isLeft = [&](const std::string& name)
  {
    return left.count(name) || name == vtkSelectElements::GetSelectedArrayName() ||
      name == vtkDataSetAttributes::GhostArrayName() || name == "Id" || name == "Block" ||
      name == "CellType" || name == "X" || name == "Y" || name == "Z" ||
      // Only pieces of a mesh have these, which are the ids.
      name == "GlobalCellIds" || name == "GlobalPointIds";
  };
  names.erase(std::remove_if(names.begin(), names.end(), isLeft), names.end());
  return names;
}

//------------------------------------------------------------------------------
std::vector<std::vector<vtkIdType>> FindRows(const camaron::ElementBlocks& blocks)
{
  std::vector<std::vector<vtkIdType>> rows;
  for (const camaron::ElementBlock& block : blocks.Get())
  {
    rows.emplace_back();
    vtkDataArray* selected = block.GetArray(vtkSelectElements::GetSelectedArrayName());
    for (vtkIdType i = 0; selected && i < block.GetSize(); ++i)
    {
      if (selected->GetComponent(i, 0) != 0 && !block.IsGhost(i))
      {
        rows.back().push_back(i);
      }
    }
  }
  return rows;
}
}

//------------------------------------------------------------------------------
int vtkSelectionTable::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSelectionTable::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkTable* table = vtkTable::GetData(outputVector);
  try
  {
    camaron::ControllerReducer reducer;
    const camaron::ElementBlocks blocks(input, reducer, FindKind(input, reducer));
    const std::vector<std::vector<vtkIdType>> rows = FindRows(blocks);
    camaron::CheckAbortOnAllRanks(this, 0.2, reducer);
    PlaceColumns places(table);
    for (std::size_t b = 0; b < rows.size(); ++b)
    {
      const camaron::ElementBlock& block = blocks.Get()[b];
      const camaron::ValueBlock values = blocks.GetValueBlock(block);
      for (const vtkIdType row : rows[b])
      {
        places.Add(block, row, values.GetId(row));
      }
    }
    for (const std::string& name : FindArrays(blocks, reducer))
    {
      vtkSmartPointer<vtkAbstractArray> column;
      for (std::size_t b = 0; b < rows.size(); ++b)
      {
        vtkAbstractArray* array = blocks.Get()[b].GetAttributes()->GetAbstractArray(name.c_str());
        if (!column)
        {
          const bool isOfIds = vtkIdTypeArray::SafeDownCast(array);
          column.TakeReference(isOfIds ? camaron::IntegerColumn::New() : array->NewInstance());
          column->SetName(name.c_str());
          column->SetNumberOfComponents(array->GetNumberOfComponents());
          column->CopyComponentNames(array);
        }
        for (const vtkIdType row : rows[b])
        {
          column->InsertNextTuple(row, array);
        }
      }
      if (column) // null on processes without elements
      {
        table->AddColumn(column);
      }
    }
    if (!this->SortBy.empty())
    {
      camaron::SortRows(table, this->SortBy, this->Descending, PlaceColumns::Number, reducer);
    }
  }
  catch (...)
  {
    return camaron::FailRequest(this, "The selected elements cannot be listed", outputVector);
  }
  return 1;
}
