// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/Strategy.h"

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

// The functions of the table, except those that Strategy.h declares.
SelectFunction ChangeElementType, SelectByCount, SelectByStatus, SelectByRules, SelectByType,
  SelectCurrent, SelectConnected, SelectConnectedToIds, SelectExpanded, SelectFailed,
  SelectInHalfSpaces, SelectInShape, SelectInSurface, SelectInShapeFile, SelectSet, SelectInverse,
  SelectUndefined, SelectComponent, SelectShrunk, SelectWorst, SelectWorstPercentage;

//------------------------------------------------------------------------------
const std::vector<Strategy>& GetStrategies()
{
  static const std::vector<Strategy> strategies = {
    { "By criterion", &SelectByCriterion, true,
      "values of an array outside or inside a range, limits included" },
    { "Worst N", &SelectWorst, true, "exactly the N worst values of an array, equal ones by id" },
    { "Undefined", &SelectUndefined, true, "undefined values (NaN) of an array" },
    { "Worst percentage", &SelectWorstPercentage, true,
      "the worst percentage of the elements that have a value, rounded down" },
    { "Status", &SelectByStatus, false,
      "cells with defects: any bit of CellStatus from Element Quality, or the named bits" },
    { "Cell type", &SelectByType, false, "cells of given types, by name or by VTK's number" },
    { "Number of elements", &SelectByCount, false,
      "cells with given numbers of faces, edges or vertices" },
    { "Failed criteria", &SelectFailed, true,
      "elements outside the acceptable ranges of at least a given number of criteria, among the "
      "arrays of the mesh" },
    { "Failed rules", &SelectByRules, false,
      "cells that violate rules, written as those of Check Quality, whatever these tolerate; their "
      "criteria are evaluated as there" },
    { "By id", &SelectById, true, "a list of ids such as 3, 10-20, 40" },
    { "Shape", &SelectInShape, true,
      "elements in a sphere, a box or an infinite cylinder, or behind a plane, on the side "
      "opposite to its normal" },
    { "Half-spaces", &SelectInHalfSpaces, true,
      "elements behind all planes of a list, that is, in a convex polyhedron" },
    { "Surface", &SelectInSurface, true,
      "elements in a closed surface, convex or not, with any number of components and holes" },
    { "Shape file", &SelectInShapeFile, true,
      "elements in a shape from a text file: a sphere, planes or polygons" },
    { "Set", &SelectSet, true,
      "the cells or points of an OpenFOAM set or zone; of a set of faces the cells on both sides" },
    { "Expand", &SelectExpanded, true, "the current selection with layers of neighbors" },
    { "Shrink", &SelectShrunk, true,
      "the current selection without layers of neighbors of unselected elements" },
    { "Connected", &SelectConnected, false, "all elements connected to the current selection" },
    { "Connected to ids", &SelectConnectedToIds, false,
      "the elements of a list of ids, and all elements connected to them" },
    { "Component", &SelectComponent, false,
      "the n-th largest connected component of the current selection; of components of equal size, "
      "the one with the smallest id comes first" },
    { "Change element type", &ChangeElementType, true,
      "cells with any or all of their faces, edges or points selected, or the faces, edges or "
      "points of selected cells" },
    { "Boundary", &SelectBoundary, true,
      "3D cells with a face and 2D cells with an edge that no other cell of any piece shares, or "
      "the points of these faces and edges" },
    { "All", &SelectAll, true, "all elements" },
    { "Current", &SelectCurrent, true, "the current selection" },
    { "Invert", &SelectInverse, true, "all elements outside the current selection" },
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
  throw std::invalid_argument("there is no strategy named '" + name + "'");
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
  BlockValues values(task.Blocks, name, task.Reducer);
  const std::string kind = task.HasCells() ? "cell" : "point";
  const std::string missing = task.HasCells() ? "no Array is chosen" : "no Point Array is chosen";
  task.Blocks.RequireAny(values.Get().size(),
    name.empty() ? missing : "there is no one-component " + kind + " array named '" + name + "'",
    task.Reducer);
  return values;
}
}
