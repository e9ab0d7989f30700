// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Faces, edges and vertices of meshes small enough to count them by hand.
#include "Elements/MeshEdges.h"
#include "Elements/MeshFaces.h"
#include "TestMeshes.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
// Cubes in a row, as hexahedra.
Grid MakeRow(int cubes)
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
    cells.push_back(
      { VTK_HEXAHEDRON, { a, a + 4, a + 5, a + 1, a + 3, a + 7, a + 6, a + 2 } });
  }
  return MakeGrid(points, cells);
}

double Get(vtkPolyData* data, const char* name, vtkIdType i)
{
  return data->GetCellData()->GetArray(name)->GetComponent(i, 0);
}

double Sum(vtkPolyData* data, const char* name)
{
  double sum = 0;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    sum += Get(data, name, i);
  }
  return sum;
}

struct Elements
{
  vtkNew<vtkPolyData> Faces, Edges, Vertices;
  explicit Elements(vtkDataSet* mesh, const EvaluationOptions& options = {})
  {
    const MeshTopology topology(mesh);
    MakeFaces(mesh, topology, options, true, this->Faces);
    MakeEdges(mesh, topology, options, this->Edges);
    MakeVertices(mesh, topology, options, this->Vertices);
  }
};
}

//------------------------------------------------------------------------------
TEST(MeshElements, OfARowOfCubes)
{
  const Grid row = MakeRow(3);
  for (const Grid& grid : { row, ToPolyhedra(row) })
  {
    const Elements elements(grid);
    vtkPolyData* faces = elements.Faces;
    EXPECT_EQ(faces->GetNumberOfCells(), 16);
    EXPECT_EQ(Sum(faces, "IsBoundary"), 14);
    EXPECT_EQ(Sum(faces, "FaceCellCount"), 18);
    for (vtkIdType i = 0; i < 16; ++i)
    {
      EXPECT_EQ(faces->GetCellSize(i), 4);
      const bool isInner = Get(faces, "IsBoundary", i) == 0;
      EXPECT_EQ(Get(faces, "NeighborCell", i) >= 0, isInner);
      EXPECT_EQ(std::isnan(Get(faces, "NonOrthogonality", i)), !isInner);
      EXPECT_EQ(std::isnan(Get(faces, "BoundaryNonOrthogonality", i)), isInner);
      EXPECT_NEAR(Get(faces, "FaceSkewness", i), 0, 1e-12);
      EXPECT_NEAR(Get(faces, "FacePyramidVolume", i), 1.0 / 6, 1e-12);
      if (isInner)
      {
        EXPECT_EQ(Get(faces, "NeighborCell", i) - Get(faces, "OwnerCell", i), 1);
        EXPECT_NEAR(Get(faces, "FaceWeight", i), 0.5, 1e-12);
        EXPECT_NEAR(Get(faces, "VolumeRatio", i), 1, 1e-12);
      }
    }
    vtkPolyData* edges = elements.Edges;
    EXPECT_EQ(edges->GetNumberOfCells(), 28);
    EXPECT_EQ(Sum(edges, "EdgeLength"), 28);
    EXPECT_EQ(Sum(edges, "EdgeCellCount"), 36);
    EXPECT_EQ(Sum(edges, "EdgeFaceCount"), 4 * 16);
    EXPECT_EQ(Sum(edges, "IsBoundary"), 28);
    vtkPolyData* vertices = elements.Vertices;
    EXPECT_EQ(vertices->GetNumberOfCells(), 16);
    EXPECT_EQ(Sum(vertices, "VertexCellCount"), 24);
    EXPECT_EQ(Sum(vertices, "VertexEdgeCount"), 56);
    EXPECT_EQ(Sum(vertices, "VertexFaceCount"), 64);
    EXPECT_EQ(Sum(vertices, "UnusedPoint"), 0);
  }
}

//------------------------------------------------------------------------------
// The surface of a cube, with one face turned and one missing.
TEST(MeshElements, OfASurface)
{
  const Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
    { 1, 1, 1 }, { 0, 1, 1 }, { 5, 5, 5 } };
  const Grid surface = MakeGrid(points,
    { { VTK_QUAD, { 0, 3, 2, 1 } }, { VTK_QUAD, { 0, 1, 5, 4 } }, { VTK_QUAD, { 1, 2, 6, 5 } },
      { VTK_QUAD, { 2, 3, 7, 6 } }, { VTK_QUAD, { 0, 3, 7, 4 } } }); // the last one runs the other way
  const Elements elements(surface);
  EXPECT_EQ(elements.Faces->GetNumberOfCells(), 5);
  vtkPolyData* edges = elements.Edges;
  EXPECT_EQ(edges->GetNumberOfCells(), 12);
  EXPECT_EQ(Sum(edges, "IsBoundary"), 4);
  EXPECT_EQ(Sum(edges, "InconsistentEdge"), 3);
  for (vtkIdType i = 0; i < 12; ++i)
  {
    const double angle = Get(edges, "EdgeDihedralAngle", i);
    const bool isBoundary = Get(edges, "IsBoundary", i) != 0;
    EXPECT_EQ(std::isnan(angle), isBoundary);
    if (!isBoundary && Get(edges, "InconsistentEdge", i) == 0)
    {
      EXPECT_NEAR(angle, 90, 1e-9);
    }
  }
  EXPECT_EQ(Sum(elements.Vertices, "UnusedPoint"), 1);
  EXPECT_EQ(Get(elements.Vertices, "UnusedPoint", 8), 1);
  EXPECT_EQ(Sum(elements.Vertices, "IsBoundary"), 4);
}

//------------------------------------------------------------------------------
// If this fails, elements between processes count twice or not at all.
TEST(MeshElements, BelongToThePieceOfTheSmallestCell)
{
  const Grid pieces[] = { MakeRow(2), MakeRow(2) };
  double owned[3] = { 0, 0, 0 };
  for (int p = 0; p < 2; ++p)
  {
    // Cells 0 and 1 of three in the first piece, 1 and 2 in the second; cell 1 belongs to the first.
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName("GlobalCellIds");
    ids->InsertNextValue(p);
    ids->InsertNextValue(p + 1);
    pieces[p]->GetCellData()->SetGlobalIds(ids);
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->InsertNextValue(p == 1 ? vtkDataSetAttributes::DUPLICATECELL : 0);
    ghosts->InsertNextValue(0);
    pieces[p]->GetCellData()->AddArray(ghosts);
    const EvaluationOptions options;
    const Elements elements(pieces[p], options);
    vtkPolyData* sets[] = { elements.Faces, elements.Edges };
    for (int k = 0; k < 2; ++k)
    {
      for (vtkIdType i = 0; i < sets[k]->GetNumberOfCells(); ++i)
      {
        owned[k] += Get(sets[k], vtkDataSetAttributes::GhostArrayName(), i) == 0;
      }
    }
  }
  EXPECT_EQ(owned[0], 16);
  EXPECT_EQ(owned[1], 28);
}
