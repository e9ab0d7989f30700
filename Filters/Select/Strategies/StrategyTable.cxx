// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/Strategy.h"

#include "Base/FormerNames.h"
#include "Ranks/Collective.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"

#include <algorithm>
#include <stdexcept>

namespace camaron
{
//------------------------------------------------------------------------------
SelectionMarks MakeMarks(const ElementBlocks& blocks)
{
  SelectionMarks marks;
  for (const ElementBlock& block : blocks.Get())
  {
    marks.emplace_back(block.GetSize(), static_cast<unsigned char>(0));
  }
  return marks;
}

//------------------------------------------------------------------------------
SelectionTask::SelectionTask(const SelectionParameters& parameters, const SelectionInputs& inputs,
  const ElementBlocks& blocks, int numberOfRequestedPieces, camaron::Reducer& reducer)
  : Parameters(parameters)
  , Inputs(inputs)
  , Blocks(blocks)
  , Reducer(reducer)
  , NumberOfRequestedPieces(numberOfRequestedPieces)
  , ArrayName(this->FindArrayName())
{
}

//------------------------------------------------------------------------------
// Collective.
std::string SelectionTask::FindArrayName() const
{
  std::vector<std::string> active, all;
  for (const ElementBlock& block : this->Blocks.Get())
  {
    vtkDataSetAttributes* attributes = block.GetAttributes();
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      const char* name = attributes->GetArrayName(i);
      if (name && block.GetArray(name))
      {
        const bool isActive = attributes->GetArray(i) == attributes->GetScalars();
        (isActive ? active : all).emplace_back(name);
      }
    }
  }
  return AgreeOnName(this->HasCells() ? this->Parameters.Array : this->Parameters.PointArray,
    { active, all }, this->Reducer);
}

//------------------------------------------------------------------------------
std::unique_ptr<DistributedMesh> SelectionTask::MakePieces(
  const std::vector<DataSetLeaf>& leaves) const
{
  return std::make_unique<DistributedMesh>(
    leaves, EvaluationOptions(), this->NumberOfRequestedPieces, this->Reducer);
}

//------------------------------------------------------------------------------
const DistributedMesh& SelectionTask::GetPieces() const
{
  if (!this->Pieces)
  {
    this->Pieces = this->MakePieces({ this->Blocks.Get().begin(), this->Blocks.Get().end() });
  }
  return *this->Pieces;
}

//------------------------------------------------------------------------------
const DistributedMesh& SelectionTask::GetLinkedPieces() const
{
  this->GetPieces();
  if (!this->IsLinked)
  {
    this->Pieces->Link();
    this->IsLinked = true;
  }
  return *this->Pieces;
}

//------------------------------------------------------------------------------
void SelectionTask::MarkCopies(SelectionMarks& marks) const
{
  if (!this->Blocks.HasCopiesOfPoints())
  {
    return;
  }
  const DistributedMesh& pieces = this->GetPieces();
  if (!this->SharedPoints)
  {
    this->SharedPoints =
      std::make_unique<SharedElements>(SharedElements::OfPoints(pieces.Get(), this->Reducer));
  }
  pieces.ShareMarks(marks);
  this->SharedPoints->Share(marks);
  pieces.ShareMarks(marks);
}

//------------------------------------------------------------------------------
void SelectionTask::MarkGhostCells(SelectionMarks& marks) const
{
  const std::vector<ElementBlock>& blocks = this->Blocks.Get();
  std::int64_t hasGhosts = this->HasCells() &&
    std::any_of(blocks.begin(), blocks.end(),
      [](const ElementBlock& block) { return block.Data->HasAnyGhostCells(); });
  this->Reducer.Max(&hasGhosts, 1);
  if (!hasGhosts)
  {
    return;
  }
  const std::vector<LinkedPiece>& pieces = this->GetPieces().Get();
  SharedElements shared = SharedElements::OfCells(pieces, this->Reducer);
  const auto isCopy = [&](const SharedElements::Element& cell)
  { return pieces[cell.Piece].IsCopy(cell.Number); };
  std::vector<std::int64_t> values;
  for (const SharedElements::Element& cell : shared.Get())
  {
    values.push_back(marks[cell.Piece][cell.Number] && !isCopy(cell) ? 0 : 1);
  }
  shared.Minimize(values);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const SharedElements::Element& cell = shared.Get()[i];
    if (isCopy(cell))
    {
      marks[cell.Piece][cell.Number] = values[i] == 0;
    }
  }
}

//------------------------------------------------------------------------------
const std::vector<Strategy>& GetStrategies()
{
  static const std::vector<Strategy> strategies = {
    { "By criterion", &SelectByCriterion, true },
    { "Worst N", &SelectWorst, true },
    { "Undefined", &SelectUndefined, true },
    { "Worst percentage", &SelectWorstPercentage, true },
    { "Status", &SelectByStatus, false },
    { "Cell type", &SelectByType, false },
    { "Number of elements", &SelectByCount, false },
    { "Failed criteria", &SelectFailed, true },
    { "Failed rules", &SelectByRules, false },
    { "By id", &SelectById, true },
    { "Shape", &SelectInShape, true },
    { "Half-spaces", &SelectInHalfSpaces, true },
    { "Surface", &SelectInSurface, true },
    { "Shape file", &SelectInShapeFile, true },
    { "Set", &SelectSet, true },
    { "Expand", &SelectExpanded, true },
    { "Shrink", &SelectShrunk, true },
    { "Connected", &SelectConnected, false },
    { "Connected to ids", &SelectConnectedToIds, false },
    { "Component", &SelectComponent, false },
    { "Change element type", &ChangeElementType, true },
    { "Boundary", &SelectBoundary, true },
    { "All", &SelectAll, true },
    { "Current", &SelectCurrent, true },
    { "Invert", &SelectInverse, true },
  };
  return strategies;
}

//------------------------------------------------------------------------------
const Strategy& FindStrategy(const std::string& name)
{
  for (const Strategy& strategy : GetStrategies())
  {
    if (name == strategy.Name)
    {
      return strategy;
    }
  }
  throw std::invalid_argument(
    "there is no strategy named '" + name + "'" + DescribeFormerName(name));
}

//------------------------------------------------------------------------------
std::string FindUnit(const SelectionTask& task, const std::string& arrayName)
{
  std::vector<std::string> units;
  for (const ElementBlock& block : task.Blocks.Get())
  {
    vtkDataArray* array = block.GetArray(arrayName);
    if (array && array->HasInformation() &&
      array->GetInformation()->Has(vtkDataArray::UNITS_LABEL()))
    {
      units.emplace_back(array->GetInformation()->Get(vtkDataArray::UNITS_LABEL()));
    }
  }
  units = task.Reducer.GatherNames(units);
  return units.empty() ? std::string() : units.back();
}

//------------------------------------------------------------------------------
BlockValues FindValues(const SelectionTask& task)
{
  const std::string& name = task.GetArrayName();
  BlockValues values(task.Blocks, name);
  const std::string kind = task.HasCells() ? "cell" : "point";
  const std::string missing = task.HasCells() ? "no Array is chosen" : "no Point Array is chosen";
  task.Blocks.RequireAny(values.Get().size(),
    name.empty() ? missing : "there is no one-component " + kind + " array named '" + name + "'",
    task.Reducer);
  return values;
}
}
