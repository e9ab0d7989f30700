// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMeshes.h
 * @brief Small meshes for the tests.
 */
#ifndef camaron_TestMeshes_h
#define camaron_TestMeshes_h

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace camaron
{
namespace testing
{
using Point = std::array<double, 3>;
using Points = std::vector<Point>;
using Cells = std::vector<std::pair<int, std::vector<vtkIdType>>>;
using Faces = std::vector<std::vector<vtkIdType>>;
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

constexpr int StandardTypes3D[] = { VTK_TETRA, VTK_VOXEL, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID,
  VTK_PENTAGONAL_PRISM, VTK_HEXAGONAL_PRISM };

inline vtkSmartPointer<vtkPoints> MakePoints(const Points& points)
{
  auto result = vtkSmartPointer<vtkPoints>::New(VTK_DOUBLE);
  for (const Point& point : points)
  {
    result->InsertNextPoint(point.data());
  }
  return result;
}

/// Cells of fixed types.
inline Grid MakeGrid(const Points& points, const Cells& cells)
{
  auto grid = Grid::New();
  grid->SetPoints(MakePoints(points));
  for (const auto& cell : cells)
  {
    grid->InsertNextCell(
      cell.first, static_cast<vtkIdType>(cell.second.size()), cell.second.data());
  }
  return grid;
}

/// One cell with these nodes in their order.
inline Grid MakeCell(int type, const Points& nodes)
{
  std::vector<vtkIdType> ids(nodes.size());
  std::iota(ids.begin(), ids.end(), 0);
  return MakeGrid(nodes, { { type, ids } });
}

/// Several VTK_POLYHEDRON cells, each given by its faces.
inline Grid MakePolyhedra(vtkPoints* points, const std::vector<Faces>& cells)
{
  auto grid = Grid::New();
  grid->SetPoints(points);
  vtkNew<vtkCellArray> connectivity, faces, locations;
  vtkNew<vtkUnsignedCharArray> types;
  for (const Faces& cell : cells)
  {
    std::vector<vtkIdType> distinct, ids;
    for (const auto& face : cell)
    {
      ids.push_back(faces->InsertNextCell(static_cast<vtkIdType>(face.size()), face.data()));
      for (const vtkIdType point : face)
      {
        if (std::find(distinct.begin(), distinct.end(), point) == distinct.end())
        {
          distinct.push_back(point);
        }
      }
    }
    connectivity->InsertNextCell(static_cast<vtkIdType>(distinct.size()), distinct.data());
    locations->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    types->InsertNextValue(VTK_POLYHEDRON);
  }
  grid->SetPolyhedralCells(types, connectivity, locations, faces);
  return grid;
}

inline Grid MakePolyhedron(const Points& points, const Faces& faces)
{
  return MakePolyhedra(MakePoints(points), { faces });
}

/// The faces of a cell, as VTK lists them.
inline Faces GetFaces(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  Faces faces;
  vtkCell* vtkcell = grid->GetCell(cell);
  for (int f = 0; f < vtkcell->GetNumberOfFaces(); ++f)
  {
    vtkCell* face = vtkcell->GetFace(f);
    faces.emplace_back();
    for (vtkIdType i = 0; i < face->GetNumberOfPoints(); ++i)
    {
      faces.back().push_back(face->GetPointId(i));
    }
    if (face->GetCellType() == VTK_PIXEL)
    {
      std::swap(faces.back()[2], faces.back()[3]);
    }
  }
  return faces;
}

/// The same mesh with every 3D cell as VTK_POLYHEDRON.
inline Grid ToPolyhedra(vtkUnstructuredGrid* grid)
{
  std::vector<Faces> cells;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    cells.push_back(GetFaces(grid, cell));
  }
  return MakePolyhedra(grid->GetPoints(), cells);
}

/// The same mesh moved by @a shift along x, then 2^@a exponent times as large; in double precision.
inline Grid Scale(vtkUnstructuredGrid* mesh, int exponent, double shift = 0)
{
  auto grid = Grid::New();
  grid->ShallowCopy(mesh);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* const x = mesh->GetPoint(i);
    points->InsertNextPoint(
      std::ldexp(shift + x[0], exponent), std::ldexp(x[1], exponent), std::ldexp(x[2], exponent));
  }
  grid->SetPoints(points);
  return grid;
}

/// A block of unit cubes.
inline Grid MakeHexahedra(int nx, int ny, int nz, bool asPolyhedra)
{
  Points points;
  for (int k = 0; k <= nz; ++k)
  {
    for (int j = 0; j <= ny; ++j)
    {
      for (int i = 0; i <= nx; ++i)
      {
        points.push_back({ double(i), double(j), double(k) });
      }
    }
  }
  const auto id = [=](int i, int j, int k) -> vtkIdType
  { return i + (nx + 1) * (j + (ny + 1) * vtkIdType(k)); };
  Cells cells;
  for (int k = 0; k < nz; ++k)
  {
    for (int j = 0; j < ny; ++j)
    {
      for (int i = 0; i < nx; ++i)
      {
        cells.push_back({ VTK_HEXAHEDRON,
          { id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k), id(i, j + 1, k), id(i, j, k + 1),
            id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1) } });
      }
    }
  }
  const Grid grid = MakeGrid(points, cells);
  return asPolyhedra ? ToPolyhedra(grid) : grid;
}

/// Regular n-gon with unit edge in the plane z.
inline Points MakeRegularPolygon(int n, double z)
{
  Points points;
  const double pi = std::acos(-1.0), radius = 0.5 / std::sin(pi / n);
  for (int i = 0; i < n; ++i)
  {
    points.push_back({ radius * std::cos(2 * pi * i / n), radius * std::sin(2 * pi * i / n), z });
  }
  return points;
}

/// A stack of hexagonal prisms.
inline Grid MakeHexagonalPrisms(int n)
{
  Points points;
  Cells cells;
  for (int layer = 0; layer <= n; ++layer)
  {
    const Points ring = MakeRegularPolygon(6, layer);
    points.insert(points.end(), ring.begin(), ring.end());
    if (layer > 0)
    {
      cells.push_back({ VTK_HEXAGONAL_PRISM, {} });
      for (int i = 0; i < 12; ++i)
      {
        cells.back().second.push_back(6 * (layer - 1) + i);
      }
    }
  }
  return MakeGrid(points, cells);
}

/// One valid cell of a standard 3D type, nodes in VTK's order, with positive volume.
inline Grid MakeStandardCell(int type)
{
  Points points;
  switch (type)
  {
    case VTK_TETRA:
      points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
      break;
    case VTK_VOXEL:
      points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
        { 0, 1, 1 }, { 1, 1, 1 } };
      break;
    case VTK_HEXAHEDRON:
      points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
        { 1, 1, 1 }, { 0, 1, 1 } };
      break;
    case VTK_WEDGE: // (0,1,2) seen by the right-hand rule points away from (3,4,5)
      points = { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, 1 }, { 0, 1, 1 }, { 1, 0, 1 } };
      break;
    case VTK_PYRAMID:
      points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { .5, .5, 1 } };
      break;
    default:
    {
      const int n = type == VTK_PENTAGONAL_PRISM ? 5 : 6;
      points = MakeRegularPolygon(n, 0);
      const Points top = MakeRegularPolygon(n, 1);
      points.insert(points.end(), top.begin(), top.end());
    }
  }
  std::vector<vtkIdType> ids(points.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    ids[i] = static_cast<vtkIdType>(i);
  }
  return MakeGrid(points, { { type, ids } });
}
}
}

#endif
