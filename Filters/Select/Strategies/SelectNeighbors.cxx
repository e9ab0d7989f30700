// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/Strategy.h"

#include "PropertyValues.h"
#include "Selection/Growth.h"

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
Adjacency FindAdjacency(const SelectionTask& task)
{
  return ParseChoice<Adjacency>("Adjacency", task.Parameters.Adjacency,
    { { "Face", Adjacency::Facet }, { "Edge", Adjacency::Edge }, { "Vertex", Adjacency::Vertex } });
}

//------------------------------------------------------------------------------
/// Pieces have to be linked only to measure angles between their cells.
const std::vector<LinkedPiece>& FindPieces(const SelectionTask& task)
{
  return task.Parameters.FeatureAngle < 180 ? task.GetLinkedPieces().Get() : task.GetPieces().Get();
}

//------------------------------------------------------------------------------
/// The elements to which a selection may be extended.
SelectionMarks FindAllowed(const SelectionTask& task)
{
  SelectionMarks allowed = MakeMarks(task.Blocks);
  SelectAll(task, allowed);
  const auto keep = [&](SelectFunction* select)
  {
    SelectionMarks marks = MakeMarks(task.Blocks);
    select(task, marks);
    MarkElements(allowed, [&](std::size_t b, vtkIdType i) { return allowed[b][i] && marks[b][i]; });
  };
  if (task.Parameters.OnlyBoundary)
  {
    keep(&SelectBoundary);
  }
  if (task.Parameters.OnlyInRange)
  {
    keep(&SelectByCriterion);
  }
  MarkElements(allowed,
    [&](std::size_t b, vtkIdType i) { return allowed[b][i] && !task.Blocks.Get()[b].IsGhost(i); });
  return allowed;
}

//------------------------------------------------------------------------------
void Expand(const SelectionTask& task, const SelectionMarks& allowed, SelectionMarks& marks)
{
  const int numberOfLayers = task.Parameters.NumberOfLayers;
  CheckNumber("Number Of Layers", numberOfLayers, 0);
  if (task.HasCells())
  {
    Grow(FindPieces(task), FindNeighborhood(task), numberOfLayers, allowed, task.Reducer, marks);
    return;
  }
  GrowPoints(
    task.GetPieces().Get(), FindAdjacency(task), numberOfLayers, allowed, task.Reducer, marks);
}
}

//------------------------------------------------------------------------------
Neighborhood FindNeighborhood(const SelectionTask& task)
{
  CheckNumber("Feature Angle", task.Parameters.FeatureAngle, 0.0);
  return { FindAdjacency(task), task.Parameters.FeatureAngle };
}

//------------------------------------------------------------------------------
std::string SelectExpanded(const SelectionTask& task, SelectionMarks& marks)
{
  marks = task.Current;
  Expand(task, FindAllowed(task), marks);
  return "";
}

//------------------------------------------------------------------------------
// Keeps the selected elements that the others do not reach when these expand.
std::string SelectShrunk(const SelectionTask& task, SelectionMarks& marks)
{
  SelectionMarks all = MakeMarks(task.Blocks);
  SelectAll(task, all);
  const auto isOther = [&](std::size_t b, vtkIdType i)
  { return !task.Current[b][i] && !task.Blocks.Get()[b].IsGhost(i); };
  MarkElements(marks, isOther);
  Expand(task, all, marks);
  MarkElements(
    marks, [&](std::size_t b, vtkIdType i) { return task.Current[b][i] && !marks[b][i]; });
  return "";
}

//------------------------------------------------------------------------------
std::string SelectConnected(const SelectionTask& task, SelectionMarks& marks)
{
  marks = task.Current;
  Flood(FindPieces(task), FindNeighborhood(task), FindAllowed(task), task.Reducer, marks);
  return "";
}

//------------------------------------------------------------------------------
std::string SelectConnectedToIds(const SelectionTask& task, SelectionMarks& marks)
{
  const std::string report = SelectById(task, marks);
  Flood(FindPieces(task), FindNeighborhood(task), FindAllowed(task), task.Reducer, marks);
  return report;
}

//------------------------------------------------------------------------------
std::vector<std::vector<vtkIdType>> ListIds(const ElementBlocks& blocks)
{
  std::vector<std::vector<vtkIdType>> ids;
  for (const ElementBlock& block : blocks.Get())
  {
    const ValueBlock values = blocks.GetValueBlock(block);
    ids.emplace_back(values.Size);
    for (vtkIdType i = 0; i < values.Size; ++i)
    {
      ids.back()[i] = values.GetId(i);
    }
  }
  return ids;
}

//------------------------------------------------------------------------------
std::string SelectComponent(const SelectionTask& task, SelectionMarks& marks)
{
  marks = task.Current;
  const int number = task.Parameters.ComponentNumber;
  CheckNumber("Component Number", number, 1);
  const std::int64_t components = KeepComponent(
    FindPieces(task), FindNeighborhood(task), number, ListIds(task.Blocks), task.Reducer, marks);
  return number <= components ? ""
                              : "the selection has " + std::to_string(components) +
      (components == 1 ? " component" : " components");
}
}
