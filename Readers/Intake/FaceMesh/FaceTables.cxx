// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/FaceMesh/FaceTables.h"

#include "Intake/FaceMesh/FacesOfCells.h"
#include "Intake/FaceMesh/GridBuilder.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
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
// Reads values of rows, from this property on, into arrays of their points or cells.
bool ReadValues(TableRows& rows, std::size_t first, vtkDataSetAttributes* attributes,
  vtkIdType tuples, const Progress& progress)
{
  std::vector<TableColumn> columns;
  const std::vector<TableProperty>& properties = rows.GetTable().Properties;
  for (std::size_t i = first; i < properties.size(); ++i)
  {
    if (!properties[i].IsList)
    {
      const vtkSmartPointer<vtkDataArray> array = MakeArray(properties[i].Type, 1, tuples);
      array->SetName(properties[i].Name.c_str());
      array->Fill(0);
      attributes->AddArray(array);
      columns.push_back({ static_cast<int>(i), -1, ValueConversion::Value, properties[i].Type,
        array->GetVoidPointer(0), 1 });
    }
  }
  TableTargets targets;
  Buffer<std::int32_t> places;
  if (attributes->GetGlobalIds()) // of a piece
  {
    places = FindPlaces(attributes, rows.GetCount());
    targets.Places = places.data();
  }
  return columns.empty() || rows.ReadColumns(columns, targets, progress);
}

//------------------------------------------------------------------------------
int FindList(const TableRows& rows)
{
  const std::vector<TableProperty>& properties = rows.GetTable().Properties;
  const auto list = std::find_if(properties.begin(), properties.end(),
    [](const TableProperty& property) { return property.IsList; });
  return static_cast<int>(list - properties.begin());
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
Buffer<std::int32_t> FindPlaces(vtkDataSetAttributes* attributes, vtkIdType numberOfItems)
{
  Buffer<std::int32_t> places(numberOfItems);
  std::fill(places.data(), places.data() + numberOfItems, -1);
  vtkDataArray* const ids = attributes->GetGlobalIds();
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    const auto id = static_cast<vtkIdType>(ids->GetTuple1(i));
    if (id < numberOfItems)
    {
      places[id] = static_cast<std::int32_t>(i);
    }
  }
  return places;
}

//------------------------------------------------------------------------------
bool ReadFaceTables(FaceTables& tables, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress)
{
  grid->Initialize();
  warnings = Warnings();
  TableRows &points = *tables.Points, &faces = *tables.Faces, &cells = *tables.Cells;
  tables.PointsOfFaces.Limit = points.GetCount();
  tables.FacesOfCells.Limit = faces.GetCount();
  FaceMesh mesh;
  return ReadPoints(points, points.GetTable().Properties[0].Type, { 0, 1, 2 }, mesh,
           progress.Part(0, 0.2)) &&
    ReadFaces(faces, FindList(faces), tables.PointsOfFaces, request, mesh, warnings,
      progress.Part(0.2, 0.4)) &&
    ReadFacesOfCells(cells, FindList(cells), tables.FacesOfCells, request, mesh, warnings,
      progress.Part(0.4, 0.6)) &&
    points.RefuseLongRows() && faces.RefuseLongRows() && cells.RefuseLongRows() &&
    BuildGrid(mesh, request, grid, warnings, error, progress.Part(0.6, 0.9)) &&
    ReadValues(
      points, 3, grid->GetPointData(), grid->GetNumberOfPoints(), progress.Part(0.9, 0.95)) &&
    ReadValues(cells, 0, grid->GetCellData(), grid->GetNumberOfCells(), progress.Part(0.95, 1));
}
}
