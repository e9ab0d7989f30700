// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSelectElements.h"

#include "AcceptableRanges.h"
#include "Base/Buffer.h"
#include "ControllerReducer.h"
#include "MeshOutputs.h"
#include "RequestFailure.h"
#include "Strategies/Strategy.h"

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <map>
#include <stdexcept>

vtkStandardNewMacro(vtkSelectElements);

namespace
{
//------------------------------------------------------------------------------
// An array with one value per element of a data set.
template <typename Array, typename Value>
vtkSmartPointer<Array> MakeArray(const char* name, const std::vector<Value>& values)
{
  const auto array = camaron::MakeLargeArray<Array>(static_cast<vtkIdType>(values.size()));
  array->SetName(name);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

//------------------------------------------------------------------------------
// Selects by global ids if there are any, because these do not change when the mesh is split
// differently.
void AddNode(vtkSelection* selection, const camaron::ElementBlocks& blocks, std::size_t number,
  const std::vector<unsigned char>& marks, int process)
{
  const camaron::ElementBlock& block = blocks.Get()[number];
  const camaron::ValueBlock values = blocks.GetValueBlock(block);
  vtkNew<vtkIdTypeArray> ids;
  for (std::size_t i = 0; i < marks.size(); ++i)
  {
    if (marks[i])
    {
      const auto index = static_cast<vtkIdType>(i);
      ids->InsertNextValue(blocks.HasGlobalIds() ? values.GetId(index) : index);
    }
  }
  vtkNew<vtkSelectionNode> node;
  node->SetContentType(
    blocks.HasGlobalIds() ? vtkSelectionNode::GLOBALIDS : vtkSelectionNode::INDICES);
  node->SetFieldType(
    block.Kind == camaron::ElementKind::Cells ? vtkSelectionNode::CELL : vtkSelectionNode::POINT);
  node->SetSelectionList(ids);
  node->GetProperties()->Set(vtkSelectionNode::PROCESS_ID(), process);
  if (blocks.IsComposite())
  {
    node->GetProperties()->Set(
      vtkSelectionNode::COMPOSITE_INDEX(), static_cast<int>(block.FlatIndex));
  }
  selection->AddNode(node);
}
}

//------------------------------------------------------------------------------
vtkSelectElements::vtkSelectElements()
  : PresetNames(camaron::MakePresetNames(camaron::GetDefaultRangesName()))
{
  this->SetNumberOfInputPorts(4);
  this->SetNumberOfOutputPorts(2);
  for (const camaron::Strategy& strategy : camaron::GetStrategies())
  {
    this->StrategyNames->InsertNextValue(strategy.Name);
    this->SelectedByStrategies->InsertNextValue(strategy.Selected);
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkSelectElements::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Shape ? std::max(own, this->Shape->GetMTime()) : own;
}

//------------------------------------------------------------------------------
void vtkSelectElements::AddPlaneNumber(double number)
{
  this->Planes.push_back(number);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSelectElements::ClearPlanes()
{
  if (!this->Planes.empty())
  {
    this->Planes.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkSelectElements::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkSelection");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    return 1;
  }
  if (port > 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkSelectElements::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkDataObject" : "vtkSelection");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSelectElements::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  if (!input)
  {
    return 0;
  }
  camaron::MakeOutput(input->GetDataObjectType(), 0, outputVector);
  camaron::MakeOutput(VTK_SELECTION, 1, outputVector);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSelectElements::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
  vtkSelection* selection = vtkSelection::GetData(outputVector, 1);
  this->Report.clear();
  this->NumberOfSelectedElements = 0;
  try
  {
    camaron::ControllerReducer reducer;
    camaron::ElementBlocks blocks(input, reducer, camaron::ParseElementKind(this->ElementType));
    const camaron::SelectionInputs inputs = { input, vtkSelection::GetData(inputVector[1]),
      vtkDataObject::GetData(inputVector[2]), vtkDataObject::GetData(inputVector[3]), this };
    camaron::SelectionTask task(
      *this, inputs, blocks, camaron::GetNumberOfPieces(outputVector), reducer);
    camaron::CheckAbortOnAllRanks(this, 0.1, reducer);
    camaron::SelectionMarks marks = this->Select(task, blocks);
    camaron::CheckAbortOnAllRanks(this, 0.8, reducer);

    std::int64_t selected = 0;
    std::map<unsigned int, std::size_t> blockOfFlatIndex; // without empty data sets
    for (std::size_t b = 0; b < marks.size(); ++b)
    {
      blockOfFlatIndex[blocks.Get()[b].FlatIndex] = b;
      selected += std::count(marks[b].begin(), marks[b].end(), 1);
      AddNode(selection, blocks, b, marks[b], reducer.GetProcess());
    }
    reducer.Sum(&selected, 1);
    this->NumberOfSelectedElements = static_cast<vtkIdType>(selected);
    if (!this->Report.empty() && !this->Quiet && reducer.GetProcess() == 0)
    {
      vtkWarningMacro("" << this->Report << '.');
    }
    task.MarkCopies(marks);
    task.MarkGhostCells(marks);
    std::int64_t hasCounts = !task.FailedCriteriaCounts.empty();
    reducer.Max(&hasCounts, 1);
    const auto kind = static_cast<int>(blocks.GetKind());
    const auto otherKind = static_cast<int>(camaron::GetOtherKind(blocks.GetKind()));
    camaron::CopyDataSets(input, output,
      [&](vtkDataSet* copy, unsigned int flatIndex)
      {
        const auto found = blockOfFlatIndex.find(flatIndex);
        const bool isEmpty = found == blockOfFlatIndex.end();
        // A mesh has one selection: remove marks of the other element type.
        copy->GetAttributes(otherKind)->RemoveArray(GetSelectedArrayName());
        copy->GetAttributes(kind)->AddArray(MakeArray<vtkUnsignedCharArray>(
          GetSelectedArrayName(), isEmpty ? std::vector<unsigned char>() : marks[found->second]));
        if (hasCounts)
        {
          copy->GetAttributes(kind)->AddArray(MakeArray<vtkIntArray>("FailedCriteriaCount",
            isEmpty ? std::vector<int>() : task.FailedCriteriaCounts[found->second]));
        }
      });
  }
  catch (...)
  {
    return camaron::FailRequest(this, "The selection cannot be computed", outputVector);
  }
  return 1;
}

//------------------------------------------------------------------------------
camaron::SelectionMarks vtkSelectElements::Select(
  camaron::SelectionTask& task, camaron::ElementBlocks& blocks)
{
  const camaron::Strategy& strategy = camaron::FindStrategy(this->Strategy);
  if (blocks.GetKind() == camaron::ElementKind::Points && !strategy.IsForPoints)
  {
    throw std::invalid_argument(
      "the strategy '" + this->Strategy + "' selects cells, but Element Type is Points");
  }
  task.Current = camaron::FindCurrentSelection(task);
  if (this->Combination == "Refine")
  {
    blocks.Restrict(task.Current);
  }
  camaron::SelectionMarks marks = camaron::MakeMarks(blocks);
  this->Report = strategy.Select(task, marks);
  camaron::MarkElements(
    marks, [&](std::size_t b, vtkIdType i) { return marks[b][i] && !blocks.Get()[b].IsGhost(i); });
  camaron::CombineSelections(this->Combination, task.Current, marks);
  return marks;
}
