// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/FaceMesh/FaceTables.h"

#include "Intake/FaceMesh/FacesOfCells.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstdlib>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
bool SetSides(TableRows& cells, const ListSizes& sizes, const Buffer<std::int32_t>& faces,
  vtkIdType numberOfFaces, FaceMesh& mesh)
{
  mesh.HasSides = true;
  mesh.Sides = Buffer<std::int32_t>(2 * numberOfFaces);
  mesh.Types = Buffer<unsigned char>(cells.GetCount());
  std::fill_n(mesh.Sides.data(), mesh.Sides.size(), -1);
  std::fill_n(mesh.Types.data(), mesh.Types.size(), static_cast<unsigned char>(VTK_POLYHEDRON));
  for (vtkIdType cell = 0; cell < cells.GetCount(); ++cell)
  {
    for (vtkIdType i = sizes.GetOffset(cell); i < sizes.GetOffset(cell + 1); ++i)
    {
      const bool isInward = faces[i] < 0;
      const std::int32_t face = std::abs(faces[i]) - 1;
      if (mesh.HasEmptyFaces && mesh.Faces.GetSize(face) == 0)
      {
        continue; // it bounds nothing
      }
      std::int32_t& side = mesh.Sides[2 * face + (isInward ? 0 : 1)];
      if (side >= 0)
      {
        return cells.FailInRow(cell, ErrorKind::Index, "at most one cell on each side of a face",
          "face " + std::to_string(face) + " in cells " + std::to_string(side) + " and " +
            std::to_string(cell) + FromZero);
      }
      side = static_cast<std::int32_t>(cell);
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
bool ReadPoints(TableRows& points, ValueType type, const std::array<int, 3>& properties,
  FaceMesh& mesh, const Progress& progress)
{
  const vtkIdType count = points.GetCount();
  char* values = nullptr;
  if (type == ValueType::Double)
  {
    mesh.Doubles = Buffer<double>(3 * count);
    values = reinterpret_cast<char*>(mesh.Doubles.data());
  }
  else
  {
    mesh.Floats = Buffer<float>(3 * count);
    values = reinterpret_cast<char*>(mesh.Floats.data());
  }
  const int size = GetSize(type);
  mesh.Points = PointSource(values, count, type == ValueType::Double);
  std::vector<TableColumn> columns;
  for (int c = 0; c < 3; ++c)
  {
    if (properties[c] >= 0)
    {
      columns.push_back({ properties[c], -1, ValueConversion::Value, type, values + c * size, 3 });
    }
  }
  if (columns.size() < 3)
  {
    std::fill_n(values, 3 * count * size, '\0');
  }
  return points.ReadColumns(columns, TableTargets(), progress);
}

//------------------------------------------------------------------------------
bool ReadFaces(TableRows& faces, int list, const ListIds& points, const PieceRequest& request,
  FaceMesh& mesh, Warnings& warnings, const Progress& progress)
{
  ListSizes sizes;
  Buffer<std::int32_t> ids;
  IdLists::Expectation expected = mesh.ExpectFaces(points.Limit, request);
  if (!faces.ReadLists(list, points, sizes, ids, progress.Part(0, 0.8)) ||
    !mesh.Faces.Open(std::move(ids), std::move(sizes.Offsets), sizes.Common, faces.GetCount(),
      expected, progress.Part(0.8, 1)))
  {
    return false;
  }
  mesh.HasEmptyFaces = expected.Empty.Count > 0;
  if (request.Piece == 0)
  {
    warnings.Add(
      expected.Repeating, "face", "faces", "with the same point more than once", FromZero);
  }
  return true;
}

//------------------------------------------------------------------------------
bool ReadFacesOfCells(TableRows& cells, int list, const ListIds& faces, const PieceRequest& request,
  FaceMesh& mesh, Warnings& warnings, const Progress& progress)
{
  ListSizes sizes;
  Buffer<std::int32_t> ids;
  const vtkIdType numberOfCells = cells.GetCount();
  IdLists::Expectation expected = mesh.ExpectCells(faces.Limit);
  if (!cells.ReadLists(list, faces, sizes, ids, progress.Part(0, 0.7)))
  {
    return false;
  }
  if (faces.HaveSigns)
  {
    if (!SetSides(cells, sizes, ids, faces.Limit, mesh))
    {
      return false;
    }
    mesh.CellWords = ListFacesOfCells(mesh.Sides, numberOfCells);
  }
  if (!(faces.HaveSigns
          ? mesh.Cells.Open(mesh.CellWords, numberOfCells, expected, progress.Part(0.7, 1))
          : mesh.Cells.Open(std::move(ids), std::move(sizes.Offsets), sizes.Common, numberOfCells,
              expected, progress.Part(0.7, 1))))
  {
    return false;
  }
  if (request.Piece == 0)
  {
    warnings.Add(expected.Empty, "cell", "cells", "without faces", FromZero);
  }
  return true;
}

//------------------------------------------------------------------------------
void AddCellValues(const char* name, const Buffer<std::int32_t>& values, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  array->SetNumberOfValues(grid->GetNumberOfCells());
  vtkDataArray* const rows = grid->GetCellData()->GetGlobalIds(); // of a piece
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const vtkIdType row = rows ? static_cast<vtkIdType>(rows->GetTuple1(cell)) : cell;
    array->SetValue(cell, row < values.size() ? values[row] : 0); // faces follow the cells
  }
  grid->GetCellData()->AddArray(array);
}
}
