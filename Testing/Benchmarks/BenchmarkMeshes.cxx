// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkMeshes.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTypeInt32Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <unordered_map>
#include <vector>

namespace camaron
{
namespace
{
using Coordinates = std::array<float, 3>;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPoints> MakePoints(const std::vector<Coordinates>& coordinates)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetNumberOfPoints(static_cast<vtkIdType>(coordinates.size()));
  for (std::size_t i = 0; i < coordinates.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), coordinates[i].data());
  }
  return points;
}

//------------------------------------------------------------------------------
// Lists as a cell array with 32 bit storage of exact size.
vtkSmartPointer<vtkCellArray> MakeCellArray(
  const std::vector<std::int32_t>& offsets, const std::vector<std::int32_t>& values)
{
  vtkNew<vtkTypeInt32Array> offsetArray, valueArray;
  offsetArray->SetNumberOfValues(static_cast<vtkIdType>(offsets.size()));
  std::copy(offsets.begin(), offsets.end(), offsetArray->GetPointer(0));
  valueArray->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), valueArray->GetPointer(0));
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsetArray, valueArray);
  return cells;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> MakeTetrahedra(vtkIdType numberOfCells)
{
  // A ball fills pi / 6 of its cube.
  const int n = static_cast<int>(std::cbrt(static_cast<double>(numberOfCells) / 6 / 0.5236));
  const int order[6][3] = { { 0, 1, 2 }, { 0, 2, 1 }, { 1, 0, 2 }, { 1, 2, 0 }, { 2, 0, 1 },
    { 2, 1, 0 } };
  std::mt19937 random(1);
  std::uniform_real_distribution<float> jitter(-0.2f, 0.2f);
  std::vector<std::int32_t> ids(static_cast<std::size_t>(n + 1) * (n + 1) * (n + 1), -1);
  std::vector<Coordinates> coordinates;
  std::vector<std::array<std::int32_t, 4>> cells;
  const auto point = [&](const int* p)
  {
    std::int32_t& id = ids[p[0] + (n + 1) * (p[1] + static_cast<std::size_t>(n + 1) * p[2])];
    if (id < 0)
    {
      id = static_cast<std::int32_t>(coordinates.size());
      coordinates.push_back(
        { { p[0] + jitter(random), p[1] + jitter(random), p[2] + jitter(random) } });
    }
    return id;
  };
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        const double x = i + .5 - .5 * n, y = j + .5 - .5 * n, z = k + .5 - .5 * n;
        if (x * x + y * y + z * z > .25 * n * n)
        {
          continue;
        }
        for (int t = 0; t < 6; ++t)
        {
          // Along the edges of the cube from its first to its last corner.
          int p[3] = { i, j, k };
          std::array<std::int32_t, 4> cell;
          cell[0] = point(p);
          for (int step = 0; step < 3; ++step)
          {
            ++p[order[t][step]];
            cell[step + 1] = point(p);
          }
          const bool odd = t == 1 || t == 2 || t == 5;
          if (odd)
          {
            std::swap(cell[2], cell[3]);
          }
          cells.push_back(cell);
        }
      }
    }
  }
  // Mesh generators number neither points nor cells along a grid.
  std::vector<std::int32_t> renumbered(coordinates.size());
  for (std::size_t i = 0; i < renumbered.size(); ++i)
  {
    renumbered[i] = static_cast<std::int32_t>(i);
  }
  constexpr std::size_t window = 4096; // what is near in space stays roughly near in memory
  for (std::size_t first = 0; first < renumbered.size(); first += window)
  {
    std::shuffle(renumbered.begin() + first,
      renumbered.begin() + std::min(first + window, renumbered.size()), random);
  }
  std::vector<Coordinates> moved(coordinates.size());
  for (std::size_t i = 0; i < moved.size(); ++i)
  {
    moved[renumbered[i]] = coordinates[i];
  }
  for (std::size_t first = 0; first < cells.size(); first += window)
  {
    std::shuffle(
      cells.begin() + first, cells.begin() + std::min(first + window, cells.size()), random);
  }
  std::vector<std::int32_t> offsets, values;
  for (const auto& cell : cells)
  {
    offsets.push_back(static_cast<std::int32_t>(values.size()));
    for (const std::int32_t id : cell)
    {
      values.push_back(renumbered[id]);
    }
  }
  offsets.push_back(static_cast<std::int32_t>(values.size()));
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(MakePoints(moved));
  grid->SetCells(VTK_TETRA, MakeCellArray(offsets, values));
  return grid;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> MakeSurface(vtkIdType numberOfCells, bool isMixed)
{
  // Squares of two triangles; of a mixed sheet two in three stay whole.
  const double perSquare = isMixed ? 4. / 3 : 2;
  const int n = std::max(
    1, static_cast<int>(std::lround(std::sqrt(static_cast<double>(numberOfCells) / perSquare))));
  std::mt19937 random(3);
  std::uniform_real_distribution<float> jitter(-0.2f, 0.2f);
  std::vector<Coordinates> coordinates;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const auto x = static_cast<float>(i), y = static_cast<float>(j);
      coordinates.push_back({ { x + jitter(random), y + jitter(random),
        10 * std::sin(x / 100) * std::cos(y / 130) + jitter(random) } });
    }
  }
  std::vector<std::vector<std::int32_t>> cells;
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const std::int32_t a = i + j * (n + 1), b = a + 1, c = b + n + 1, d = a + n + 1;
      if (isMixed && (i + j) % 3 != 0)
      {
        cells.push_back({ a, b, c, d });
      }
      else
      {
        cells.push_back({ a, b, c });
        cells.push_back({ a, c, d });
      }
    }
  }
  constexpr std::size_t window = 4096; // what is near in space stays roughly near in memory
  for (std::size_t first = 0; first < cells.size(); first += window)
  {
    std::shuffle(
      cells.begin() + first, cells.begin() + std::min(first + window, cells.size()), random);
  }
  std::vector<std::int32_t> offsets(1, 0), values;
  vtkNew<vtkUnsignedCharArray> types;
  for (const auto& cell : cells)
  {
    values.insert(values.end(), cell.begin(), cell.end());
    offsets.push_back(static_cast<std::int32_t>(values.size()));
    types->InsertNextValue(cell.size() == 3 ? VTK_TRIANGLE : VTK_QUAD);
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(MakePoints(coordinates));
  grid->SetCells(types, MakeCellArray(offsets, values));
  return grid;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> MakeTruncatedOctahedra(vtkIdType numberOfCells)
{
  // Cells around the points of a lattice with period 4 and around the centers of its cubes.
  const int n = static_cast<int>(std::lround(std::cbrt(static_cast<double>(numberOfCells) / 2)));
  std::mt19937 random(2);
  std::uniform_real_distribution<float> jitter(-0.05f, 0.05f);
  // Faces: squares about (+-2, 0, 0) and hexagons about (+-1, +-1, +-1), outward.
  std::vector<std::vector<std::array<int, 3>>> faces;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int side : { -2, 2 })
    {
      std::vector<std::array<int, 3>> face;
      for (int corner = 0; corner < 4; ++corner)
      {
        const int turn = side > 0 ? corner : 3 - corner;
        std::array<int, 3> p = { { 0, 0, 0 } };
        p[axis] = side;
        p[(axis + 1) % 3] = turn == 0 ? 1 : turn == 2 ? -1 : 0;
        p[(axis + 2) % 3] = turn == 1 ? 1 : turn == 3 ? -1 : 0;
        face.push_back(p);
      }
      faces.push_back(face);
    }
  }
  for (int octant = 0; octant < 8; ++octant)
  {
    const int sign[3] = { octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1 };
    const int ring[6][3] = { { 2, 1, 0 }, { 1, 2, 0 }, { 0, 2, 1 }, { 0, 1, 2 }, { 1, 0, 2 },
      { 2, 0, 1 } };
    std::vector<std::array<int, 3>> face;
    for (const auto& corner : ring)
    {
      face.push_back({ { sign[0] * corner[0], sign[1] * corner[1], sign[2] * corner[2] } });
    }
    if (sign[0] * sign[1] * sign[2] < 0)
    {
      std::reverse(face.begin(), face.end());
    }
    faces.push_back(face);
  }
  std::unordered_map<std::int64_t, std::int32_t> ids;
  std::vector<Coordinates> coordinates;
  std::vector<std::int32_t> offsets(1, 0), points, faceOffsets(1, 0), facePoints, locations;
  std::vector<std::int32_t> locationOffsets(1, 0);
  std::vector<std::int32_t> cellPoints;
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        for (const int half : { 0, 2 })
        {
          const int center[3] = { 4 * i + half + 2, 4 * j + half + 2, 4 * k + half + 2 };
          cellPoints.clear();
          for (const auto& face : faces)
          {
            for (const auto& p : face)
            {
              const std::int64_t x = center[0] + p[0], y = center[1] + p[1], z = center[2] + p[2];
              const auto known = ids.emplace(
                (z << 42) + (y << 21) + x, static_cast<std::int32_t>(coordinates.size()));
              if (known.second)
              {
                coordinates.push_back(
                  { { x + jitter(random), y + jitter(random), z + jitter(random) } });
              }
              facePoints.push_back(known.first->second);
              cellPoints.push_back(known.first->second);
            }
            locations.push_back(static_cast<std::int32_t>(faceOffsets.size()) - 1);
            faceOffsets.push_back(static_cast<std::int32_t>(facePoints.size()));
          }
          std::sort(cellPoints.begin(), cellPoints.end());
          cellPoints.erase(std::unique(cellPoints.begin(), cellPoints.end()), cellPoints.end());
          points.insert(points.end(), cellPoints.begin(), cellPoints.end());
          offsets.push_back(static_cast<std::int32_t>(points.size()));
          locationOffsets.push_back(static_cast<std::int32_t>(locations.size()));
        }
      }
    }
  }
  vtkNew<vtkUnsignedCharArray> types;
  types->SetNumberOfValues(static_cast<vtkIdType>(offsets.size()) - 1);
  types->FillValue(VTK_POLYHEDRON);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(MakePoints(coordinates));
  grid->SetPolyhedralCells(types, MakeCellArray(offsets, points),
    MakeCellArray(locationOffsets, locations), MakeCellArray(faceOffsets, facePoints));
  return grid;
}
}
