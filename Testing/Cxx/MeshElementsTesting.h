// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshElementsTesting.h
 * @brief What the tests of faces, edges and vertices share: meshes, and all elements of one, with
 * all arrays.
 */
#ifndef camaron_MeshElementsTesting_h
#define camaron_MeshElementsTesting_h

#include "Elements/MeshElements.h"
#include "TestMeshes.h"

#include "vtkCellData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace camaron
{
namespace testing
{
inline double Get(vtkPolyData* data, const char* name, vtkIdType i)
{
  return data->GetCellData()->GetArray(name)->GetComponent(i, 0);
}

inline double Sum(vtkPolyData* data, const char* name)
{
  double sum = 0;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    sum += Get(data, name, i);
  }
  return sum;
}

inline std::vector<std::string> GetNames(const std::vector<ElementArray>& rows)
{
  std::vector<std::string> names;
  for (const ElementArray& row : rows)
  {
    names.emplace_back(row.Name);
  }
  return names;
}

// With all arrays that there are.
struct Elements
{
  vtkNew<vtkPolyData> Faces, Edges, Vertices;
  explicit Elements(vtkDataSet* mesh, double mergeTolerance = 0, const ElementSource& source = {})
  {
    const MeshTopology topology(mesh);
    const ElementContext context(mesh, topology, EvaluationOptions(), mergeTolerance, source);
    MakeFaces(context, GetNames(GetFaceArrays()), this->Faces);
    MakeEdges(context, GetNames(GetEdgeArrays()), this->Edges);
    MakeVertices(context, GetNames(GetVertexArrays()), this->Vertices);
    AddWorstOfCells(context, this->Vertices);
  }
};

/// Cubes in a row, as hexahedra.
inline Grid MakeRow(int cubes)
{
  Points points;
  Cells cells;
  for (int i = 0; i <= cubes; ++i)
  {
    const double x = i;
    points.insert(points.end(), { { x, 0, 0 }, { x, 1, 0 }, { x, 1, 1 }, { x, 0, 1 } });
  }
  for (vtkIdType a = 0; a < 4 * cubes; a += 4)
  {
    cells.push_back({ VTK_HEXAHEDRON, { a, a + 4, a + 5, a + 1, a + 3, a + 7, a + 6, a + 2 } });
  }
  return MakeGrid(points, cells);
}

/// The same mesh with its inner points moved at random; of a block of unit cubes of that size.
inline Grid Warp(const Grid& grid, int size)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(-0.15, 0.15);
  vtkPoints* points = grid->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double x[3];
    points->GetPoint(i, x);
    if (std::all_of(x, x + 3, [=](double c) { return c > 0 && c < size; }))
    {
      points->SetPoint(i, x[0] + noise(random), x[1] + noise(random), x[2] + noise(random));
    }
  }
  return grid;
}

/// The cubes of a block, each cut into the six tetrahedra around a diagonal.
inline Grid MakeTetrahedra(int size)
{
  const Grid block = MakeHexahedra(size, size, size, false);
  Cells cells;
  for (vtkIdType cube = 0; cube < block->GetNumberOfCells(); ++cube)
  {
    vtkNew<vtkIdList> ids;
    block->GetCellPoints(cube, ids);
    const int around[] = { 1, 2, 3, 7, 4, 5 };
    for (int i = 0; i < 6; ++i)
    {
      cells.push_back({ VTK_TETRA,
        { ids->GetId(0), ids->GetId(around[i]), ids->GetId(around[(i + 1) % 6]), ids->GetId(6) } });
    }
  }
  const Grid grid = MakeGrid({}, cells);
  grid->SetPoints(block->GetPoints());
  return grid;
}
}
}

#endif
