// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Points and elements of TetGen and Triangle: how they are read, with any ids, threads and pieces.
#include "SharedData.h"
#include "TetGenReading.h"
#include "TetGenSamples.h"

#include "Base/Progress.h"

#include "vtkSMPTools.h"

#include <algorithm>

using namespace camaron;
using namespace camaron::testing;

namespace
{
using Ids = std::vector<vtkIdType>;
using Values = std::vector<double>;
}

//------------------------------------------------------------------------------
// If this fails, some first id, line end or file name gives another mesh.
TEST(TetGenReader, ReadsElementsWithAnyBase)
{
  for (const int base : { 0, 1, 17 })
  {
    for (const std::string end : { "\n", "\r\n", "\r", " # comment\n\n" })
    {
      TwoTetrahedra files(base, end);
      files.Files["ele"] = "\xef\xbb\xbf" + files.Files["ele"];
      const Mesh mesh(files.Files);
      for (const std::string extension : { "ele", "node", "neigh" })
      {
        const Result result = mesh.Read(extension);
        ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
        EXPECT_TRUE(result.Warnings.empty()) << result.Warnings[0];
        vtkUnstructuredGrid* const grid = result.Grid;
        ASSERT_EQ(grid->GetNumberOfPoints(), 5);
        ASSERT_EQ(grid->GetNumberOfCells(), 2);
        EXPECT_EQ(grid->GetPoints()->GetDataType(), VTK_DOUBLE);
        EXPECT_EQ(GetCell(result, 0), (Ids{ VTK_TETRA, 0, 1, 2, 3 }));
        EXPECT_EQ(GetCell(result, 1), (Ids{ VTK_TETRA, 1, 2, 3, 4 }));
        double x[3];
        grid->GetPoint(4, x);
        EXPECT_EQ(x[0] + 10 * x[1] + 100 * x[2], 111);

        vtkPointData* const points = grid->GetPointData();
        EXPECT_EQ(GetValues(points, "attr_0"), (Values{ 0.5, 1.5, 2.5, 3.5, 4.5 }));
        EXPECT_EQ(GetValues(points, "attr_1"), (Values{ 7, 7, 7, 7, 7 }));
        EXPECT_EQ(points->GetArray("attr_1")->GetDataType(), VTK_DOUBLE);
        EXPECT_EQ(GetValues(points, "BoundaryMarker"), (Values{ -2, -1, 0, 1, 2 }));
        EXPECT_EQ(points->GetArray("BoundaryMarker")->GetDataType(), VTK_INT);
        vtkCellData* const cells = grid->GetCellData();
        EXPECT_EQ(GetValues(cells, "Region"), (Values{ 10, -20 }));
        EXPECT_EQ(cells->GetArray("Region")->GetDataType(), VTK_INT);
        EXPECT_EQ(GetValues(cells, "attr_1"), (Values{ 0.5, 1.5 }));
        const double first = base;
        EXPECT_EQ(GetValues(points, "OriginalPointId"),
          base == 0 ? Values{} : (Values{ first, first + 1, first + 2, first + 3, first + 4 }));
        EXPECT_EQ(
          GetValues(cells, "OriginalCellId"), base == 0 ? Values{} : (Values{ first, first + 1 }));
        EXPECT_EQ(GetValues(cells, "Neighbors"),
          extension == "neigh" ? (Values{ 1, -1, -1, -1, -1, -1, -1, 0 }) : Values{});
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, ids with gaps or in no order lead to wrong nodes.
TEST(TetGenReader, IdsMayBeInAnyOrder)
{
  const std::string ele = "2 3 0\n9 2000000000 0 7\n4 7 0 30\n";
  const Mesh mesh({ { "node", "4 2 0 0\n7 0 0\n2000000000 1 0\n0 0 1\n30 1 1\n" }, { "ele", ele },
    { "neigh", "2 3\n4 -1 -1 9\n9 4 -1 -1\n" } });
  const Result result = mesh.Read("neigh");
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  EXPECT_EQ(GetCell(result, 0), (Ids{ VTK_TRIANGLE, 1, 2, 0 }));
  EXPECT_EQ(GetCell(result, 1), (Ids{ VTK_TRIANGLE, 0, 2, 3 }));
  EXPECT_EQ(GetValues(result.Grid->GetPointData(), "OriginalPointId"), (Values{ 7, 2e9, 0, 30 }));
  EXPECT_EQ(GetValues(result.Grid->GetCellData(), "OriginalCellId"), (Values{ 9, 4 }));
  EXPECT_EQ(GetValues(result.Grid->GetCellData(), "Neighbors"), (Values{ 1, -1, -1, -1, -1, 0 }));
}

//------------------------------------------------------------------------------
TEST(TetGenReader, ReadsTrianglesInTwoAndThreeDimensions)
{
  const std::string ele = "1 3 1\n1 3 2 1 0.25\n";
  const Result flat = Mesh({ { "node", "3 2\n1 0 5\n2 1 5\n3 0 6" }, { "ele", ele } }).Read("ele");
  ASSERT_TRUE(flat.Errors.empty()) << flat.Errors[0];
  EXPECT_EQ(GetCell(flat, 0), (Ids{ VTK_TRIANGLE, 2, 1, 0 }));
  EXPECT_EQ(flat.Grid->GetPoint(2)[1], 6);
  EXPECT_EQ(flat.Grid->GetPoint(2)[2], 0);
  EXPECT_EQ(GetValues(flat.Grid->GetCellData(), "Region"), (Values{ 0.25 }));
  const Result solid =
    Mesh({ { "node", "3\n1 0 0 7\n2 1 0 8\n3 0 1 9\n" }, { "ele", ele } }).Read("ele");
  ASSERT_TRUE(solid.Errors.empty()) << solid.Errors[0];
  EXPECT_EQ(solid.Grid->GetPoint(2)[2], 9);
  EXPECT_EQ(solid.Grid->GetPointData()->GetNumberOfArrays(), 1); // OriginalPointId
}

//------------------------------------------------------------------------------
TEST(TetGenReader, NodesAloneAreACloud)
{
  const Result result = Mesh({ { "node", "2 3 1 1\n0 0 0 0 2.5 4\n1 1 0 0 3 5\n" } }).Read("node");
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  EXPECT_EQ(Count(result.Grid, VTK_VERTEX), 2);
  EXPECT_EQ(GetValues(result.Grid->GetPointData(), "attr_0"), (Values{ 2.5, 3 }));
  EXPECT_EQ(GetValues(result.Grid->GetPointData(), "BoundaryMarker"), (Values{ 4, 5 }));
  const Result empty = Mesh({ { "node", "0 3 0 0\n" } }).Read("node");
  EXPECT_TRUE(empty.Errors.empty() && empty.IsEmpty());
}

//------------------------------------------------------------------------------
// Midside nodes may be listed in any order, which is inferred from a skewed element. If this fails,
// quadratic elements are tangled.
TEST(TetGenReader, FindsTheOrderOfMidpoints)
{
  const double corners[4][3] = { { 0, 0, 0 }, { 2, 0.1, 0 }, { 0.3, 3, 0.2 }, { 0.4, 0.5, 5 } };
  const int edges[6][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };
  for (const int size : { 4, 3 })
  {
    const int count = size == 4 ? 6 : 3;
    std::vector<int> order{ 0, 1, 2, 3, 4, 5 };
    order.resize(count);
    do
    {
      std::string node = std::to_string(size + count) + " 3 0 0\n";
      std::string ele = "1 " + std::to_string(size + count) + " 0\n0";
      for (int i = 0; i < size + count; ++i)
      {
        node += std::to_string(i);
        for (int c = 0; c < 3; ++c)
        {
          // Slightly off the middle, as on curved edges.
          const int* const edge = edges[i < size ? 0 : order[i - size]];
          const double x =
            i < size ? corners[i][c] : 0.48 * corners[edge[0]][c] + 0.52 * corners[edge[1]][c];
          node += " " + std::to_string(x);
        }
        node += "\n";
        ele += " " + std::to_string(i);
      }
      const Mesh mesh({ { "node", node }, { "ele", ele + "\n" } });
      const Result result = mesh.Read("ele");
      ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
      EXPECT_TRUE(result.Warnings.empty()) << result.Warnings[0];
      Ids expected{ size == 4 ? VTK_QUADRATIC_TETRA : VTK_QUADRATIC_TRIANGLE, 0, 1, 2 };
      expected.resize(1 + size);
      expected[size] = size - 1;
      for (int edge = 0; edge < count; ++edge)
      {
        expected.push_back(size + (std::find(order.begin(), order.end(), edge) - order.begin()));
      }
      EXPECT_EQ(GetCell(result, 0), expected);
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

//------------------------------------------------------------------------------
TEST(TetGenReader, MidpointsThatAreNoneAreInTheUsualOrder)
{
  std::string node = "10 3 0 0\n";
  for (int i = 0; i < 10; ++i)
  {
    node +=
      std::to_string(i) + " " + std::to_string(i * i) + " " + std::to_string(i * i * i) + " 0\n";
  }
  const Result result =
    Mesh({ { "node", node }, { "ele", "1 10 0\n0 0 1 2 3 4 5 6 7 8 9\n" } }).Read("ele");
  ASSERT_TRUE(result.Errors.empty());
  ASSERT_EQ(result.Warnings.size(), 1u);
  EXPECT_NE(result.Warnings[0].find("far from the middle"), std::string::npos);
  EXPECT_EQ(GetCell(result, 0), (Ids{ VTK_QUADRATIC_TETRA, 0, 1, 2, 3, 6, 7, 9, 5, 8, 4 }));
}

//------------------------------------------------------------------------------
TEST(TetGenReader, WarnsOfOddThings)
{
  const auto warning =
    [](const std::map<std::string, std::string>& files, const char* extension, const char* expected)
  {
    const Result result = Mesh(files).Read(extension);
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    ASSERT_EQ(result.Warnings.size(), 1u) << expected;
    EXPECT_NE(result.Warnings[0].find(expected), std::string::npos) << result.Warnings[0];
  };
  const std::string node = "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n";
  const std::string ele = "1 4 0\n0 0 1 2 3\n";
  warning({ { "node", "1 3 0 0\n0 0 nan 0\n" } }, "node", "1 point with a coordinate that is not");
  warning({ { "node", "3 3 0 1\n0 0 0 0 1\n1 0 0 0\n2 0 0 0 # none\n" } }, "node",
    "2 nodes without the boundary marker");
  warning({ { "node", "3 3 0 0\n0 0 0 0\n1 1 0 0 7 7 # two\n2 0 1 0 8\n" } }, "node",
    "values after those that the header declares are omitted, the first of node 1");
  warning({ { "node", node }, { "ele", "1 4 0\n0 0 1 2 3 5\n" } }, "ele", "the first of element 0");
  warning({ { "poly", node + "2 1\n1 0 5\n3 0 1 2\n1\n3 0 1 3\n0\n" } }, "poly",
    "1 facet without the boundary marker that the header declares");
  // Read as pairs of lines first, which fails.
  warning({ { "poly", node + "2 1\n2 0 5\n3 0 1 2\n3 0 2 3\n1\n3 0 1 3\n0\n" } }, "poly",
    "1 facet without the boundary marker that the header declares");
  warning({ { "smesh", node + "2 1\n3 0 1 2\n3 0 1 3 4\n0\n" } }, "smesh",
    "1 facet without the boundary marker that the header declares");
  warning(
    { { "node", node }, { "ele", "1 4 0\n0 0 1 2 2\n" } }, "ele", "1 cell with repeated points");
  warning({ { "node", node }, { "ele", ele + "1 0 1 2 3\n" } }, "ele",
    "there is more data after the end of mesh.ele");
  warning({ { "node", node + "4 1 1 1\n" }, { "ele", ele } }, "ele",
    "there is more data after the end of mesh.node");
}

//------------------------------------------------------------------------------
// If this fails, the mesh depends on threads, or on where text is split for them.
TEST(TetGenReader, ThreadsAndChunksChangeNothing)
{
  for (const std::string end : { "\n", " # \r\n\r\n", "\r" })
  {
    const Mesh mesh(MakeStrip(1000, end));
    for (const std::string extension : { "ele", "neigh", "face", "edge", "poly", "smesh" })
    {
      vtkNew<vtkUnstructuredGrid> expected;
      Warnings warnings;
      ScanError error;
      const std::string path = mesh.GetPath(extension);
      ASSERT_TRUE(ReadTetGen(path, {}, expected, warnings, error)) << error.Message;
      EXPECT_EQ(expected->GetNumberOfCells(), 1000);
      EXPECT_GT(expected->GetCellData()->GetNumberOfArrays(), 1);
      for (const int threads : { 1, 2, 3 })
      {
        for (const vtkIdType chunk : { 50, 1000, 20000 })
        {
          vtkNew<vtkUnstructuredGrid> grid;
          vtkSMPTools::LocalScope(vtkSMPTools::Config(threads),
            [&] { ASSERT_TRUE(ReadTetGen(path, {}, grid, warnings, error, Progress(), chunk)); });
          EXPECT_TRUE(warnings.GetSentences().empty());
          ExpectSameGrid(expected, grid);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, several processes together have another mesh than one.
TEST(TetGenReader, PiecesMakeTheWhole)
{
  auto files = MakeStrip(60);
  files["node"] += "1000 0 0 0 0 0\n"; // unused
  files["node"].replace(0, 2, "64");
  const Mesh mesh(files);
  for (const std::string extension : { "ele", "neigh", "face", "edge", "poly", "smesh" })
  {
    ExpectPiecesMakeTheWhole<vtkTetGenReader>(mesh.GetPath(extension), 3, 0);
    ExpectPiecesMakeTheWhole<vtkTetGenReader>(mesh.GetPath(extension), 3, 2);
    ExpectPiecesMakeTheWhole<vtkTetGenReader>(mesh.GetPath(extension), 70, 1);
  }
  const Mesh cloud({ { "node", files["node"] } }, "cloud");
  ExpectPiecesMakeTheWhole<vtkTetGenReader>(cloud.GetPath("node"), 3, 0);
  // The type of Region must not depend on the values in a piece.
  const Mesh real({ { "node", "4 2\n0 0 0\n1 1 0\n2 0 1\n3 1 1\n" },
                    { "ele", "2 3 1\n0 0 1 2 1\n1 1 3 2 1.5\n" } },
    "real");
  for (const int piece : { 0, 1 })
  {
    const Result part = ReadWith<vtkTetGenReader>(real.GetPath("ele"), piece, 2);
    ASSERT_TRUE(part.Errors.empty());
    EXPECT_EQ(part.Grid->GetCellData()->GetArray("Region")->GetDataType(), VTK_DOUBLE);
  }
}

//------------------------------------------------------------------------------
// If this fails, an error in the nodes is lost when only pieces are read, and the mesh is empty.
TEST(TetGenReader, PiecesFailLikeTheWhole)
{
  auto files = MakeStrip(60);
  files["node"].replace(files["node"].find("0.300000"), 1, "x");
  const Mesh mesh(files);
  for (const std::string extension : { "ele", "neigh", "face", "edge", "poly", "smesh" })
  {
    for (const int pieces : { 1, 2 })
    {
      const Result part = ReadWith<vtkTetGenReader>(mesh.GetPath(extension), pieces - 1, pieces);
      ASSERT_EQ(part.Errors.size(), 1u) << extension;
      EXPECT_NE(
        part.Errors[0].find("mesh.node:5: expected a coordinate of a node"), std::string::npos)
        << part.Errors[0];
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, processes disagree about midside nodes, as their own nodes differ.
TEST(TetGenReader, PiecesAgreeOnMidpoints)
{
  // A row of elements whose midpoints are in VTK's order, which is not the usual one.
  std::string node, ele;
  constexpr int Cells = 5;
  for (int cell = 0; cell < Cells; ++cell)
  {
    const double corners[4][3] = { { 0, 0, 0 }, { 2, 0.1, 0 }, { 0.3, 3, 0.2 }, { 0.4, 0.5, 5 } };
    const int edges[6][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };
    ele += std::to_string(cell);
    for (int i = 0; i < 10; ++i)
    {
      node += std::to_string(10 * cell + i);
      for (int c = 0; c < 3; ++c)
      {
        const double* const a = corners[i < 4 ? i : edges[i - 4][0]];
        const double* const b = corners[i < 4 ? i : edges[i - 4][1]];
        node += " " + std::to_string((a[c] + b[c]) / 2 + 10 * cell);
      }
      node += "\n";
      ele += " " + std::to_string(10 * cell + i);
    }
    ele += "\n";
  }
  const Mesh mesh({ { "node", "50 3\n" + node }, { "ele", "5 10\n" + ele } });
  EXPECT_EQ(GetCell(mesh.Read("ele"), 1),
    (Ids{ VTK_QUADRATIC_TETRA, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19 }));
  ExpectPiecesMakeTheWhole<vtkTetGenReader>(mesh.GetPath("ele"), 3, 1);
}

//------------------------------------------------------------------------------
// If this fails, an abort is ignored, or an incomplete mesh is shown.
TEST(TetGenReader, StopsWhenAsked)
{
  const Mesh mesh(MakeStrip(2000));
  for (const double when : { 0.0, 0.3, 0.7 })
  {
    vtkNew<vtkUnstructuredGrid> grid;
    Warnings warnings;
    ScanError error;
    const Progress progress([when](double fraction) { return fraction < when; });
    EXPECT_FALSE(ReadTetGen(mesh.GetPath("ele"), {}, grid, warnings, error, progress, 1000));
    EXPECT_FALSE(error) << error.Message;
    EXPECT_EQ(grid->GetNumberOfPoints(), 0);
  }
}

//------------------------------------------------------------------------------
// Counts are those of independent programs, see the README of the collected files.
TEST(TetGenReader, CollectedFiles)
{
  CAMARON_NEEDS_SHARED_DATA("tetgen");
  const std::string folder = GetSharedData("tetgen").string();
  const struct
  {
    const char* Name;
    int Type;
    vtkIdType Points, Cells;
  } files[] = { { "camaron_gen4096.1.ele", VTK_TETRA, 4096, 27098 },
    { "camaron_gen4096.1.node", VTK_TETRA, 4096, 27098 },
    { "camaron_polygon_mesh.ele", VTK_TRIANGLE, 8, 18 },
    { "camaron_polyhedron_mesh.node", VTK_TETRA, 8, 6 }, { "foam_beam.1.ele", VTK_TETRA, 213, 724 },
    { "foam_beam.1.face", VTK_TRIANGLE, 213, 1617 },
    { "polylla2d_pikachu.1.neigh", VTK_TRIANGLE, 352, 531 },
    { "polylla_3D_100.ele", VTK_TETRA, 100, 535 },
    { "polylla_3D_100.face", VTK_TRIANGLE, 100, 1096 },
    { "tetgen_example.1.edge", VTK_LINE, 303, 165 },
    { "tetgen_example.1.ele", VTK_TETRA, 303, 976 },
    { "tetgen_example.1.face", VTK_TRIANGLE, 303, 2233 },
    { "tetgen_example.1.neigh", VTK_TETRA, 303, 976 }, { "tetgen_example.poly", VTK_QUAD, 28, 24 },
    { "tetgen_o2_zero.1.edge", VTK_QUADRATIC_EDGE, 1508, 135 },
    { "tetgen_o2_zero.1.ele", VTK_QUADRATIC_TETRA, 1508, 795 },
    { "tetgen_o2_zero.1.face", VTK_QUADRATIC_TRIANGLE, 1508, 1821 },
    { "tetgen_o2_zero.1.neigh", VTK_QUADRATIC_TETRA, 1508, 795 } };
  for (const auto& file : files)
  {
    const std::string path = folder + "/" + file.Name;
    const Result result = ReadWith<vtkTetGenReader>(path);
    EXPECT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_EQ(result.Warnings.size(), std::string(file.Name) == "tetgen_example.poly" ? 1u : 0u)
      << file.Name;
    EXPECT_EQ(result.Grid->GetNumberOfPoints(), file.Points) << file.Name;
    EXPECT_EQ(Count(result.Grid, file.Type), file.Cells) << file.Name;
    EXPECT_EQ(result.Grid->GetNumberOfCells(), file.Cells) << file.Name;
    vtkNew<vtkTetGenReader> reader;
    EXPECT_EQ(reader->CanReadFile(path.c_str()), 1) << file.Name;
    // Every midside node is in the middle of the right edge in VTK's order.
    const int edges[6][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };
    const int size = file.Type == VTK_QUADRATIC_TETRA ? 4
      : file.Type == VTK_QUADRATIC_TRIANGLE           ? 3
      : file.Type == VTK_QUADRATIC_EDGE               ? 2
                                                      : 0;
    for (vtkIdType cell = 0; size > 0 && cell < file.Cells; ++cell)
    {
      const Ids ids = GetCell(result, cell);
      for (std::size_t i = 1 + size; i < ids.size(); ++i)
      {
        double a[3], b[3], middle[3];
        result.Grid->GetPoint(ids[1 + edges[i - size - 1][0]], a);
        result.Grid->GetPoint(ids[1 + edges[i - size - 1][1]], b);
        result.Grid->GetPoint(ids[i], middle);
        for (int c = 0; c < 3; ++c)
        {
          ASSERT_NEAR(middle[c], (a[c] + b[c]) / 2, 1e-12) << file.Name << " " << cell;
        }
      }
    }
  }
  const Result slit = ReadWith<vtkTetGenReader>(folder + "/tetgen_slit-1.smesh");
  EXPECT_TRUE(slit.Errors.empty() && slit.Warnings.empty());
  EXPECT_EQ(slit.Grid->GetNumberOfPoints(), 14);
  EXPECT_EQ(slit.Grid->GetNumberOfCells(), 13);
  const Result poly = ReadWith<vtkTetGenReader>(folder + "/tetgen_example.poly");
  EXPECT_EQ(GetValues(poly.Grid->GetFieldData(), "Holes").size(), 3u * 2);
  EXPECT_EQ(GetValues(poly.Grid->GetFieldData(), "Regions").size(), 5u * 2);
}
