// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/CurrentSelection.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkExecutive.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPVExtractSelection.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <algorithm>
#include <stdexcept>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// The nodes that are of this process; nullptr if there are none.
vtkSmartPointer<vtkSelection> TakeOwnNodes(vtkSelection* selection, int process)
{
  auto own = vtkSmartPointer<vtkSelection>::New();
  own->ShallowCopy(selection);
  for (unsigned int i = own->GetNumberOfNodes(); i-- > 0;)
  {
    vtkInformation* properties = own->GetNode(i)->GetProperties();
    if (properties->Has(vtkSelectionNode::PROCESS_ID()) &&
      properties->Get(vtkSelectionNode::PROCESS_ID()) >= 0 &&
      properties->Get(vtkSelectionNode::PROCESS_ID()) != process)
    {
      own->RemoveNode(i);
    }
  }
  return own->GetNumberOfNodes() > 0 ? own : nullptr;
}

//------------------------------------------------------------------------------
// ParaView's own evaluation, which adds an array to what is selected of.
vtkSmartPointer<vtkDataObject> Evaluate(vtkDataObject* input, vtkSelection* selection)
{
  vtkNew<vtkPVExtractSelection> extract;
  extract->SetInputDataObject(0, input);
  extract->SetInputDataObject(1, selection);
  extract->PreserveTopologyOn();
  if (!extract->GetExecutive()->Update())
  {
    throw std::invalid_argument("the selection cannot be evaluated");
  }
  return extract->GetOutputDataObject(0);
}

//------------------------------------------------------------------------------
void MarkNonzero(vtkDataArray* array, std::vector<unsigned char>& marks)
{
  if (array && array->GetNumberOfTuples() == static_cast<vtkIdType>(marks.size()))
  {
    for (std::size_t i = 0; i < marks.size(); ++i)
    {
      marks[i] = array->GetComponent(static_cast<vtkIdType>(i), 0) != 0;
    }
  }
}

//------------------------------------------------------------------------------
// Points of the selected cells, or cells of the selected points.
void MarkIncident(vtkDataSet* data, ElementKind kind, vtkDataArray* selected, std::vector<unsigned char>& marks)
{
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    if (kind == ElementKind::Points && selected->GetComponent(cell, 0) == 0)
    {
      continue;
    }
    data->GetCellPoints(cell, points);
    for (const vtkIdType point : *points)
    {
      if (kind == ElementKind::Points)
      {
        marks[point] = 1;
      }
      else if (selected->GetComponent(point, 0) != 0)
      {
        marks[cell] = 1;
      }
    }
  }
}

//------------------------------------------------------------------------------
void MarkSelected(
  vtkDataObject* evaluated, const ElementBlocks& blocks, SelectionMarks& marks)
{
  constexpr const char* inside = "vtkInsidedness"; // of vtkExtractSelection
  const std::vector<DataSetLeaf> leaves = GetLeaves(evaluated);
  for (std::size_t b = 0; b < marks.size(); ++b)
  {
    const ElementBlock& block = blocks.Get()[b];
    const auto leaf = std::find_if(leaves.begin(), leaves.end(),
      [&](const DataSetLeaf& other) { return other.FlatIndex == block.FlatIndex; });
    if (leaf == leaves.end())
    {
      continue; // nothing of it is selected
    }
    const bool isOfCells = block.Kind == ElementKind::Cells;
    const auto kind = static_cast<int>(block.Kind);
    const int other = isOfCells ? vtkDataObject::POINT : vtkDataObject::CELL;
    MarkNonzero(leaf->Data->GetAttributes(kind)->GetArray(inside), marks[b]);
    if (vtkDataArray* selected = leaf->Data->GetAttributes(other)->GetArray(inside))
    {
      MarkIncident(leaf->Data, block.Kind, selected, marks[b]);
    }
  }
}

//------------------------------------------------------------------------------
using Operation = unsigned char (*)(unsigned char current, unsigned char mark);
struct Combination
{
  const char* Name;
  Operation Apply;
};
const Combination Combinations[] = {
  { "Replace", [](unsigned char, unsigned char mark) -> unsigned char { return mark; } },
  { "Add", [](unsigned char current, unsigned char mark) -> unsigned char { return current | mark; } },
  { "Subtract",
    [](unsigned char current, unsigned char mark) -> unsigned char { return current && !mark; } },
  { "Intersect",
    [](unsigned char current, unsigned char mark) -> unsigned char { return current & mark; } },
  { "Toggle", [](unsigned char current, unsigned char mark) -> unsigned char { return current ^ mark; } },
  { "Refine", [](unsigned char current, unsigned char mark) -> unsigned char { return current & mark; } },
};
}

//------------------------------------------------------------------------------
SelectionMarks FindCurrentSelection(vtkDataObject* input, vtkSelection* selection,
  const char* arrayName, int process, const ElementBlocks& blocks)
{
  SelectionMarks marks = MakeMarks(blocks);
  if (!selection)
  {
    for (std::size_t b = 0; b < marks.size(); ++b)
    {
      MarkNonzero(blocks.Get()[b].GetArray(arrayName), marks[b]);
    }
  }
  else if (const auto own = TakeOwnNodes(selection, process))
  {
    MarkSelected(Evaluate(input, own), blocks, marks);
  }
  for (std::size_t b = 0; b < marks.size(); ++b)
  {
    const std::vector<unsigned char>& skip = blocks.Get()[b].Skip;
    for (std::size_t i = 0; i < skip.size(); ++i)
    {
      marks[b][i] = marks[b][i] && !skip[i];
    }
  }
  return marks;
}

//------------------------------------------------------------------------------
void CombineSelections(
  const std::string& combination, const SelectionMarks& current, SelectionMarks& marks)
{
  const auto* found = std::find_if(std::begin(Combinations), std::end(Combinations),
    [&](const Combination& known) { return combination == known.Name; });
  if (found == std::end(Combinations))
  {
    throw std::invalid_argument("there is no combination named '" + combination + "'");
  }
  for (std::size_t b = 0; b < marks.size(); ++b)
  {
    std::transform(
      current[b].begin(), current[b].end(), marks[b].begin(), marks[b].begin(), found->Apply);
  }
}
}
