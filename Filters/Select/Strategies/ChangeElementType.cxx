// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/Strategy.h"

#include "MeshInput.h"
#include "PropertyValues.h"
#include "Ranks/Collective.h"
#include "vtkSelectElements.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <stdexcept>

namespace camaron
{
namespace
{
/// The elements of the mesh, or of another data set with the same points, block by block.
struct Elements
{
  const std::vector<LinkedPiece>* Pieces;
  ElementKind Kind;
  int Dimension; // -1 for points, because they also bound vertices
};

//------------------------------------------------------------------------------
// The largest dimension of cells on any process; -1 if there are no cells.
int FindDimension(const std::vector<LinkedPiece>& pieces, Reducer& reducer)
{
  std::int64_t dimension = -1;
  for (const LinkedPiece& piece : pieces)
  {
    const MeshView& mesh = piece.Topology->GetMesh();
    for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells() && dimension < 3; ++cell)
    {
      const int own = GetCellShape(mesh.GetCellType(cell)).Dimension;
      dimension = std::max<std::int64_t>(dimension, own);
    }
  }
  reducer.Max(&dimension, 1);
  return static_cast<int>(dimension);
}

//------------------------------------------------------------------------------
bool HaveSamePoints(vtkDataSet* a, vtkDataSet* b)
{
  const vtkIdType size = a->GetNumberOfPoints();
  if (b->GetNumberOfPoints() != size)
  {
    return false;
  }
  auto* pointsA = vtkPointSet::SafeDownCast(a);
  auto* pointsB = vtkPointSet::SafeDownCast(b);
  if (pointsA && pointsB && pointsA->GetPoints() == pointsB->GetPoints())
  {
    return true;
  }
  for (vtkIdType i = 0; i < size; ++i)
  {
    double x[3], y[3];
    a->GetPoint(i, x);
    b->GetPoint(i, y);
    // Two NaN are the same coordinate.
    const auto differ = [&](int c) { return x[c] != y[c] && (x[c] == x[c] || y[c] == y[c]); };
    if (differ(0) || differ(1) || differ(2))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// For each block of the mesh the corresponding data set of Elements.
std::vector<DataSetLeaf> FindOthers(
  const SelectionTask& task, const std::vector<DataSetLeaf>& leaves)
{
  std::vector<DataSetLeaf> others;
  for (const ElementBlock& block : task.Blocks.Get())
  {
    const auto other = std::find_if(leaves.begin(), leaves.end(),
      [&](const DataSetLeaf& leaf) { return leaf.FlatIndex == block.FlatIndex; });
    if (other == leaves.end() || !HaveSamePoints(block.Data, other->Data))
    {
      throw std::invalid_argument(
        "the points of Elements are not those of the mesh; Elements must be the mesh, or "
        "its faces, edges or vertices from Mesh Elements");
    }
    others.push_back(*other);
  }
  return others;
}

//------------------------------------------------------------------------------
// Cells if a data set on any process has marks of cells, else points.
ElementKind FindKind(const std::vector<DataSetLeaf>& leaves, Reducer& reducer)
{
  std::int64_t has[2] = { 0, 0 };
  for (const DataSetLeaf& leaf : leaves)
  {
    for (const ElementKind kind : { ElementKind::Points, ElementKind::Cells })
    {
      const int number = static_cast<int>(kind);
      has[number] |=
        leaf.Data->GetAttributes(number)->HasArray(vtkSelectElements::GetSelectedArrayName());
    }
  }
  std::int64_t count = static_cast<std::int64_t>(leaves.size());
  reducer.Max(has, 2);
  reducer.Sum(&count, 1);
  if (count > 0 && !has[0] && !has[1])
  {
    throw std::invalid_argument(
      "Elements have no array 'Selected'; create it with Select Elements");
  }
  return has[static_cast<int>(ElementKind::Cells)] ? ElementKind::Cells : ElementKind::Points;
}

//------------------------------------------------------------------------------
SelectionMarks Change(const Elements& from, const Elements& to, const SelectionMarks& marks,
  Quantifier quantifier, Reducer& reducer)
{
  if (from.Dimension == to.Dimension)
  {
    throw std::invalid_argument("Elements are already of the type to select");
  }
  const bool rises = from.Dimension < to.Dimension;
  const Elements& cells = rises ? to : from;
  const Elements& others = rises ? from : to;
  KindChange change(*cells.Pieces,
    { std::max(others.Dimension, 0), others.Kind == ElementKind::Points ? nullptr : others.Pieces },
    reducer);
  return rises ? change.MarkCells(marks, quantifier) : change.MarkBounding(marks, quantifier);
}

//------------------------------------------------------------------------------
Elements MakeElements(const std::vector<LinkedPiece>& pieces, ElementKind kind, Reducer& reducer)
{
  return { &pieces, kind, kind == ElementKind::Points ? -1 : FindDimension(pieces, reducer) };
}
}

//------------------------------------------------------------------------------
SelectionMarks ChangeElementTypeOf(
  const SelectionTask& task, const SelectionMarks& others, Quantifier quantifier)
{
  const DistributedMesh& pieces = task.GetPieces();
  KindChange change(pieces.Get(), {}, task.Reducer);
  if (task.Blocks.GetKind() == ElementKind::Points)
  {
    return change.MarkBounding(others, quantifier);
  }
  SelectionMarks ofPoints = others;
  pieces.ShareMarks(ofPoints);
  return change.MarkCells(ofPoints, quantifier);
}

//------------------------------------------------------------------------------
std::string ChangeElementType(const SelectionTask& task, SelectionMarks& marks)
{
  const auto quantifier = ParseChoice<Quantifier>("Quantifier", task.Parameters.Quantifier,
    { { "Any", Quantifier::Any }, { "All", Quantifier::All } });
  if (!task.Inputs.Elements)
  {
    const ElementKind other = GetOtherKind(task.Blocks.GetKind());
    marks = ChangeElementTypeOf(task, FindSelected(task, other), quantifier);
    return "";
  }
  std::vector<DataSetLeaf> leaves = GetMeshes(task.Inputs.Elements, task.Reducer);
  RunCollectively(task.Reducer, [&] { leaves = FindOthers(task, leaves); });
  const ElementKind kind = FindKind(leaves, task.Reducer);
  SelectionMarks selected;
  for (const DataSetLeaf& leaf : leaves)
  {
    selected.emplace_back(leaf.Data->GetNumberOfElements(static_cast<int>(kind)));
    MarkSelected(leaf.Data, kind, selected.back());
  }
  const std::unique_ptr<DistributedMesh> others = task.MakePieces(leaves);
  if (kind == ElementKind::Points)
  {
    others->ShareMarks(selected);
  }
  marks = Change(MakeElements(others->Get(), kind, task.Reducer),
    MakeElements(task.GetPieces().Get(), task.Blocks.GetKind(), task.Reducer), selected, quantifier,
    task.Reducer);
  return "";
}
}
