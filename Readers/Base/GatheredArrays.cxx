// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GatheredArrays.h"

#include "PartialArrays.h"
#include "Scan/ScanError.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributesFieldList.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <string>
#include <utility>

namespace camaron
{
namespace
{
using Piece = GatheredPieces::Piece;

//------------------------------------------------------------------------------
// A FieldList sorts arrays by name; this restores the order of the mesh.
void RestoreOrder(vtkDataSetAttributes* data, vtkDataSetAttributes* model)
{
  std::vector<std::pair<vtkSmartPointer<vtkAbstractArray>, int>> arrays;
  for (int i = 0; i < model->GetNumberOfArrays(); ++i)
  {
    const char* const name = model->GetAbstractArray(i)->GetName();
    int index = -1;
    vtkAbstractArray* const array = name ? data->GetAbstractArray(name, index) : nullptr;
    if (array)
    {
      arrays.emplace_back(array, data->IsArrayAnAttribute(index));
    }
  }
  for (const auto& array : arrays)
  {
    data->RemoveArray(array.first->GetName());
  }
  for (const auto& array : arrays)
  {
    const int index = data->AddArray(array.first);
    if (array.second >= 0)
    {
      data->SetActiveAttribute(index, array.second);
    }
  }
}
}

//------------------------------------------------------------------------------
void MergeArrays(const GatheredPieces& pieces, vtkUnstructuredGrid* grid, Warnings& warnings)
{
  vtkDataSetAttributes::FieldList pointFields, cellFields;
  for (const Piece& piece : pieces.GetPieces())
  {
    pointFields.IntersectFieldList(piece.Mesh->GetPointData());
    cellFields.IntersectFieldList(piece.Mesh->GetCellData());
  }
  vtkPointData* points = grid->GetPointData();
  points->CopyGlobalIdsOn(); // all points merged into one have the same id
  points->CopyAllocate(pointFields, pieces.GetNumberOfNewPoints());
  for (vtkIdType i = 0; points->GetNumberOfArrays() > 0 && i < pieces.GetNumberOfNewPoints(); ++i)
  {
    const vtkIdType point = pieces.GetOldPoint(i);
    const Piece& piece = pieces.FindPiece(point, &Piece::FirstPoint);
    pointFields.CopyData(static_cast<int>(pieces.GetIndex(piece)), piece.Mesh->GetPointData(),
      point - piece.FirstPoint, points, i);
  }
  vtkCellData* cells = grid->GetCellData();
  cells->CopyGlobalIdsOn();
  cells->CopyAllocate(cellFields, grid->GetNumberOfCells());
  vtkIdType next = 0;
  if (cells->GetNumberOfArrays() > 0)
  {
    pieces.ForEachCell(
      [&](const Piece& piece, vtkIdType cell)
      {
        cellFields.CopyData(
          static_cast<int>(pieces.GetIndex(piece)), piece.Mesh->GetCellData(), cell, cells, next++);
      });
  }
  for (vtkDataSetAttributes* data :
    { static_cast<vtkDataSetAttributes*>(points), static_cast<vtkDataSetAttributes*>(cells) })
  {
    data->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  }
  if (pieces.GetPieces().empty())
  {
    return;
  }
  RestoreOrder(points, pieces.GetPieces().front().Mesh->GetPointData());
  RestoreOrder(cells, pieces.GetPieces().front().Mesh->GetCellData());

  std::vector<vtkDataSetAttributes*> pointParts, cellParts;
  for (const Piece& piece : pieces.GetPieces())
  {
    pointParts.push_back(piece.Mesh->GetPointData());
    cellParts.push_back(piece.Mesh->GetCellData());
  }
  const auto getSource = [&pieces](vtkIdType id, vtkIdType Piece::* first)
  {
    const Piece& piece = pieces.FindPiece(id, first);
    return TupleSource{ pieces.GetIndex(piece), id - piece.*first };
  };
  std::vector<std::string> leftOut = AddPartialArrays(
    pointParts, pieces.GetNumberOfNewPoints(),
    [&](vtkIdType i) { return getSource(pieces.GetOldPoint(i), &Piece::FirstPoint); }, points);
  const std::vector<std::string> ofCells = AddPartialArrays(
    cellParts, grid->GetNumberOfCells(),
    [&](vtkIdType i) { return getSource(pieces.GetOldCell(i), &Piece::FirstCell); }, cells);
  leftOut.insert(leftOut.end(), ofCells.begin(), ofCells.end());
  std::string names;
  for (const std::string& name : leftOut)
  {
    names += (names.empty() ? "" : ", ") + name;
  }
  if (!names.empty())
  {
    warnings.Add(
      "arrays that some parts of the mesh lack or store in another form are omitted: " + names);
  }
}

//------------------------------------------------------------------------------
void MergeFieldData(const std::vector<MeshPart>& parts, vtkFieldData* merged)
{
  for (const MeshPart& part : parts)
  {
    vtkFieldData* const data = part.Mesh->GetFieldData();
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* const array = data->GetAbstractArray(i);
      if (array->GetName() && !merged->HasArray(array->GetName()))
      {
        merged->AddArray(array);
      }
    }
  }
}
}
