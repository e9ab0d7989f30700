// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Zones and boundaries as read from Fluent files.
#include "FluentMeshSamples.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

using namespace camaron;
using namespace camaron::testing;

//------------------------------------------------------------------------------
// If this fails, zones lose their names, or boundaries their faces.
TEST(FluentMeshZones, ReadsZonesAndBoundaries)
{
  FluentSample mesh = MakeMixed(2);
  mesh.BoundaryTypes[11] = 10;
  mesh.BoundaryTypes[12] = 14; // a fan, between cells
  int inlets = 0, walls = 0;
  for (FluentSample::Face& face : mesh.Faces)
  {
    if (face.Cells[1] < 0 && inlets < 3)
    {
      face.Zone = 11;
      ++inlets;
    }
    else if (face.Cells[1] >= 0)
    {
      face.Zone = &face == &mesh.Faces.front() ? 12 : 0;
    }
    walls += face.Cells[1] < 0 && face.Zone == 0;
  }
  mesh.Faces.back().Zone = 12;
  walls -= mesh.Faces.back().Cells[1] < 0;
  const File file(Encode(mesh) + "(45 (11 velocity-inlet \"in (left)\")())\n", "test.msh");
  vtkNew<vtkFluentMeshReader> reader;
  reader->SetFileName(file.Path.c_str());
  reader->Update();
  vtkUnstructuredGrid* grid = reader->GetOutput();
  auto* names = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray("ZoneNames"));
  auto* types = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray("ZoneTypes"));
  vtkDataArray* ids = grid->GetFieldData()->GetArray("ZoneIds");
  ASSERT_NE(names, nullptr);
  ASSERT_NE(types, nullptr);
  ASSERT_NE(ids, nullptr);
  std::map<int, std::string> zones;
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    zones[static_cast<int>(ids->GetTuple1(i))] = names->GetValue(i) + "/" + types->GetValue(i);
  }
  const std::map<int, std::string> expected = { { 2, "water/fluid" }, { 3, "inside/interior" },
    { 4, "skin/wall" }, { 5, "zone-5/fluid" }, { 11, "in (left)/velocity-inlet" },
    { 12, "zone-12/porous-jump" } };
  EXPECT_EQ(zones, expected);

  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(1));
  ASSERT_NE(blocks, nullptr);
  ASSERT_EQ(blocks->GetNumberOfBlocks(), 3u);
  std::map<std::string, vtkIdType> sizes;
  for (unsigned int i = 0; i < 3; ++i)
  {
    auto* surface = vtkPolyData::SafeDownCast(blocks->GetBlock(i));
    ASSERT_NE(surface, nullptr);
    sizes[blocks->GetMetaData(i)->Get(vtkCompositeDataSet::NAME())] = surface->GetNumberOfCells();
    EXPECT_LE(surface->GetNumberOfPoints(), grid->GetNumberOfPoints());
    ASSERT_NE(surface->GetCellData()->GetArray("Zone"), nullptr);
    ASSERT_NE(surface->GetCellData()->GetArray("BoundaryType"), nullptr);
    if (surface->GetCellData()->GetArray("Zone")->GetTuple1(0) == 11)
    {
      EXPECT_EQ(surface->GetCellData()->GetArray("BoundaryType")->GetTuple1(0), 10);
    }
  }
  const std::map<std::string, vtkIdType> expectedSizes = { { "skin", walls }, { "in (left)", 3 },
    { "zone-12",
      mesh.Faces.front().Zone == 12 && &mesh.Faces.front() != &mesh.Faces.back() ? 2 : 1 } };
  EXPECT_EQ(sizes, expectedSizes);
}

//------------------------------------------------------------------------------
// If this fails, surface meshes of Fluent Meshing are refused, or lose faces or zones.
TEST(FluentMeshZones, SurfacesWithoutCells)
{
  FluentSample mesh = MakeMixed(2);
  mesh.Cells.clear();
  mesh.BoundaryTypes[11] = 10;
  for (FluentSample::Face& face : mesh.Faces)
  {
    face.Zone = face.Cells[1] < 0 ? 0 : 11;
    face.Cells[0] = face.Cells[1] = -1;
  }
  for (const FluentEncoding& how : GetEncodings())
  {
    const File file(Encode(mesh, how), "test.msh");
    const Result result = ReadWith<vtkFluentMeshReader>(file.Path);
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_TRUE(result.Warnings.empty());
    vtkUnstructuredGrid* const grid = result.Grid;
    ASSERT_EQ(grid->GetNumberOfCells(), static_cast<vtkIdType>(mesh.Faces.size()));
    vtkDataArray* const zones = grid->GetCellData()->GetArray("Zone");
    vtkDataArray* const types = grid->GetCellData()->GetArray("BoundaryType");
    ASSERT_NE(zones, nullptr);
    ASSERT_NE(types, nullptr);
    std::multiset<std::set<int>> expected[2], found[2]; // of wall and inlet
    for (const FluentSample::Face& face : mesh.Faces)
    {
      expected[face.Zone == 11].insert({ face.Nodes.begin(), face.Nodes.end() });
    }
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      const IndexRange ids = MeshView(grid).GetCellPoints(cell);
      EXPECT_EQ(grid->GetCellType(cell), GetPolygonType(ids.Size));
      const bool isInlet = zones->GetTuple1(cell) == 11;
      EXPECT_EQ(types->GetTuple1(cell), isInlet ? 10 : 3);
      std::set<int> nodes;
      for (vtkIdType i = 0; i < ids.Size; ++i)
      {
        nodes.insert(static_cast<int>(ids[i]));
      }
      found[isInlet].insert(nodes);
    }
    EXPECT_EQ(found[0], expected[0]);
    EXPECT_EQ(found[1], expected[1]);
    EXPECT_NE(grid->GetFieldData()->GetAbstractArray("ZoneNames"), nullptr);
    ExpectPiecesMakeTheWhole<vtkFluentMeshReader>(file.Path, 3, 1);
  }
}

//------------------------------------------------------------------------------
// If this fails, faces of no cell vanish in silence.
TEST(FluentMeshZones, NamesFreeFaces)
{
  FluentSample mesh = MakeMixed(2);
  mesh.Faces.push_back({ { 0, 1, 2 }, { -1, -1 }, 11 });
  const File file(Encode(mesh) + "(45 (11 wall baffle)())\n", "test.msh");
  const Result result = ReadWith<vtkFluentMeshReader>(file.Path);
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  ASSERT_EQ(result.Warnings.size(), 1u);
  EXPECT_NE(result.Warnings[0].find("the zone 'baffle' that belong to no cell are left out: 1"),
    std::string::npos)
    << result.Warnings[0];
}

//------------------------------------------------------------------------------
// If this fails, boundary faces are oriented inward, so they look dark, or are at wrong positions.
TEST(FluentMeshZones, BoundariesEncloseTheMesh)
{
  const File file(Encode(MakeMixed(2)), "test.msh");
  for (const int pieces : { 1, 3 })
  {
    double inside = 0, enclosed = 0;
    for (int piece = 0; piece < pieces; ++piece)
    {
      vtkNew<vtkFluentMeshReader> reader;
      reader->SetFileName(file.Path.c_str());
      reader->UpdatePiece(piece, pieces, 1);
      vtkUnstructuredGrid* grid = reader->GetOutput();
      for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
      {
        const bool isGhost = grid->GetCellGhostArray() && grid->GetCellGhostArray()->GetValue(cell);
        inside += isGhost ? 0 : GetMeasure(grid, cell);
      }
      auto* blocks = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(1));
      ASSERT_EQ(blocks->GetNumberOfBlocks(), 1u);
      auto* surface = vtkPolyData::SafeDownCast(blocks->GetBlock(0));
      for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
      {
        const IndexRange ids = MeshView(surface).GetCellPoints(cell);
        for (vtkIdType i = 1; i + 1 < ids.Size; ++i)
        {
          double a[3], b[3], c[3];
          surface->GetPoint(ids[0], a);
          surface->GetPoint(ids[i], b);
          surface->GetPoint(ids[i + 1], c);
          enclosed += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                        a[2] * (b[0] * c[1] - b[1] * c[0])) /
            6;
        }
      }
    }
    EXPECT_NEAR(enclosed, inside, 1e-9) << pieces;
  }
}
