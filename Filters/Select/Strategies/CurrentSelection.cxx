// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/Strategy.h"

#include "Ranks/Collective.h"
#include "vtkSelectElements.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPVExtractSelection.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// The nodes for this process; nullptr if there are none.
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
// Uses ParaView's own evaluation, which adds an array of marks to the input.
vtkSmartPointer<vtkDataObject> Evaluate(vtkDataObject* input, vtkSelection* selection)
{
  vtkNew<vtkPVExtractSelection> extract;
  extract->SetInputDataObject(0, input);
  extract->SetInputDataObject(1, selection);
  extract->PreserveTopologyOn();
  if (!extract->GetExecutive()->Update())
  {
    throw std::invalid_argument("ParaView cannot evaluate the Selection");
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
void MarkEvaluated(
  vtkDataObject* evaluated, ElementKind kind, const ElementBlocks& blocks, SelectionMarks& marks)
{
  constexpr const char* inside = "vtkInsidedness"; // written by vtkExtractSelection
  const std::vector<DataSetLeaf> leaves = GetLeaves(evaluated);
  for (std::size_t b = 0; b < marks.size(); ++b)
  {
    const auto leaf = std::find_if(leaves.begin(), leaves.end(),
      [&](const DataSetLeaf& other) { return other.FlatIndex == blocks.Get()[b].FlatIndex; });
    if (leaf != leaves.end()) // otherwise nothing in this block is selected
    {
      MarkNonzero(leaf->Data->GetAttributes(static_cast<int>(kind))->GetArray(inside), marks[b]);
    }
  }
}

//------------------------------------------------------------------------------
struct Combination
{
  const char* Name;
  bool (*Apply)(bool current, bool mark);
};
const Combination Combinations[] = {
  { "Replace", [](bool, bool mark) { return mark; } },
  { "Add", [](bool current, bool mark) { return current || mark; } },
  { "Subtract", [](bool current, bool mark) { return current && !mark; } },
  { "Intersect", [](bool current, bool mark) { return current && mark; } },
  { "Toggle", [](bool current, bool mark) { return current != mark; } },
  { "Refine", [](bool current, bool mark) { return current && mark; } },
};
}

//------------------------------------------------------------------------------
ElementKind GetOtherKind(ElementKind kind)
{
  return kind == ElementKind::Cells ? ElementKind::Points : ElementKind::Cells;
}

//------------------------------------------------------------------------------
void MarkSelected(vtkDataSet* data, ElementKind kind, std::vector<unsigned char>& marks)
{
  MarkNonzero(data->GetAttributes(static_cast<int>(kind))
                ->GetArray(vtkSelectElements::GetSelectedArrayName()),
    marks);
}

//------------------------------------------------------------------------------
SelectionMarks FindSelected(const SelectionTask& task, ElementKind kind)
{
  SelectionMarks marks;
  RunCollectively(task.Reducer,
    [&]
    {
      for (const ElementBlock& block : task.Blocks.Get())
      {
        marks.emplace_back(block.Data->GetNumberOfElements(static_cast<int>(kind)));
        if (!task.Inputs.Selection)
        {
          MarkSelected(block.Data, kind, marks.back());
        }
      }
      if (task.Inputs.Selection)
      {
        if (const auto own = TakeOwnNodes(task.Inputs.Selection, task.Reducer.GetProcess()))
        {
          MarkEvaluated(Evaluate(task.Inputs.Mesh, own), kind, task.Blocks, marks);
        }
      }
    });
  return marks;
}

//------------------------------------------------------------------------------
SelectionMarks FindCurrentSelection(const SelectionTask& task)
{
  const ElementKind kind = task.Blocks.GetKind();
  SelectionMarks marks = FindSelected(task, kind);
  if (task.Inputs.Selection)
  {
    const SelectionMarks others = FindSelected(task, GetOtherKind(kind));
    std::int64_t hasOthers = 0;
    for (const std::vector<unsigned char>& block : others)
    {
      hasOthers |= std::find(block.begin(), block.end(), 1) != block.end();
    }
    task.Reducer.Max(&hasOthers, 1);
    if (hasOthers)
    {
      const SelectionMarks changed = ChangeElementTypeOf(task, others, Quantifier::Any);
      MarkElements(marks, [&](std::size_t b, vtkIdType i) { return marks[b][i] | changed[b][i]; });
    }
  }
  task.MarkCopies(marks);
  MarkElements(marks,
    [&](std::size_t b, vtkIdType i) { return marks[b][i] && !task.Blocks.Get()[b].IsGhost(i); });
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

//------------------------------------------------------------------------------
std::string SelectAll(const SelectionTask&, SelectionMarks& marks)
{
  MarkElements(marks, [](std::size_t, vtkIdType) { return true; });
  return "";
}

//------------------------------------------------------------------------------
std::string SelectCurrent(const SelectionTask& task, SelectionMarks& marks)
{
  marks = task.Current;
  return "";
}

//------------------------------------------------------------------------------
std::string SelectInverse(const SelectionTask& task, SelectionMarks& marks)
{
  MarkElements(marks, [&](std::size_t b, vtkIdType i) { return !task.Current[b][i]; });
  if (!task.Parameters.ExcludeUndefined)
  {
    return "";
  }
  const BlockValues values = FindValues(task);
  for (std::size_t v = 0; v < values.Get().size(); ++v)
  {
    const ValueBlock& block = values.Get()[v];
    std::vector<unsigned char>& mark = marks[values.GetBlockNumbers()[v]];
    for (vtkIdType i = 0; i < block.Size; ++i)
    {
      mark[i] = mark[i] && !std::isnan(block.Values[i]);
    }
  }
  return "";
}
}
