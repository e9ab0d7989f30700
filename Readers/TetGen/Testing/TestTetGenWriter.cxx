// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Written TetGen and Triangle files: exact bytes, the same mesh when they are read again, and no
// files of different meshes.
#include "TestMeshes.h"
#include "TetGenRows.h"
#include "TetGenSamples.h"
#include "vtkTetGenWriter.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkSMPTools.h"

using namespace camaron;
using namespace camaron::testing;

namespace
{
namespace fs = std::filesystem;
using Ids = std::vector<vtkIdType>;
using Values = std::vector<double>;
using Configure = std::function<void(vtkTetGenWriter*)>;

//------------------------------------------------------------------------------
/// The files in a folder after a mesh was written there.
struct WrittenFiles : Written
{
  std::map<std::string, std::string> Files; ///< by extension

  Result Read(const std::string& extension) const
  {
    return Mesh(this->Files, "again").Read(extension);
  }
};

WrittenFiles Write(vtkDataObject* mesh, const Configure& configure = {},
  const std::map<std::string, std::string>& before = {}, const std::string& name = "part.1.ele")
{
  const fs::path folder = File::GetFolder() / "written";
  fs::create_directory(folder);
  for (const auto& file : before)
  {
    std::ofstream(folder / ("part.1." + file.first), std::ios::binary) << file.second;
  }
  WrittenFiles result{ WriteTo<vtkTetGenWriter>((folder / name).string(), mesh, configure), {} };
  for (const auto& file : fs::directory_iterator(folder))
  {
    const std::string extension = file.path().extension().string();
    result.Files[extension.empty() ? "" : extension.substr(1)] = GetBytes(file.path().string());
  }
  fs::remove_all(folder);
  return result;
}

//------------------------------------------------------------------------------
template <typename Array>
void AddArray(
  vtkDataSetAttributes* data, const char* name, const Values& values, int components = 1)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetComponent(i / components, static_cast<int>(i % components), values[i]);
  }
  data->AddArray(array);
}

Grid MakeTwoTetrahedra()
{
  return MakeGrid({ { 0, 0, 0 }, { 1, 0, 0.1 }, { 0, 1, 1e-30 }, { 0, 0, 1 }, { 1, 1, 1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 2, 3, 4 } } });
}

void ExpectSameMesh(const Grid& expected, const Result& result)
{
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  expected->GetCells()->ConvertTo32BitStorage();
  ExpectSameGrid(expected, result.Grid);
}

/// With a triangle in between, as from readers of other formats.
Grid MakeTetrahedraWithTriangles()
{
  Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0.1 }, { 0, 1, 1e-30 }, { 0, 0, 1 }, { 1, 1, 1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 2, 1, 3 } }, { VTK_TETRA, { 1, 2, 3, 4 } },
      { VTK_TRIANGLE, { 0, 2, 1 } } });
  AddArray<vtkIntArray>(grid->GetCellData(), "BoundaryMarker", { 0, 5, 0, -6 });
  AddArray<vtkIntArray>(grid->GetCellData(), "Region", { 10, 0, 20, 0 });
  return grid;
}
}

//------------------------------------------------------------------------------
// The exact bytes. Some programs do not read comments: the first line must be the header.
TEST(TetGenWriter, WritesNodesAndElements)
{
  for (const char* name : { "part.1.ele", "part.1.node" })
  {
    const WrittenFiles zero = Write(MakeTwoTetrahedra(), {}, {}, name);
    ASSERT_TRUE(zero.Success);
    EXPECT_TRUE(zero.Warnings.empty()) << zero.Warnings[0];
    EXPECT_EQ(zero.Files.size(), 2u);
    EXPECT_EQ(
      zero.Files.at("node"), "5 3 0 0\n0 0 0 0\n1 1 0 0.1\n2 0 1 1e-30\n3 0 0 1\n4 1 1 1\n");
    EXPECT_EQ(zero.Files.at("ele"), "2 4 0\n0 0 1 2 3\n1 1 2 3 4\n");
  }
  const WrittenFiles one = Write(MakeTwoTetrahedra(), [](vtkTetGenWriter* w) { w->SetFirstId(1); });
  EXPECT_EQ(one.Files.at("node"), "5 3 0 0\n1 0 0 0\n2 1 0 0.1\n3 0 1 1e-30\n4 0 0 1\n5 1 1 1\n");
  EXPECT_EQ(one.Files.at("ele"), "2 4 0\n1 1 2 3 4\n2 2 3 4 5\n");
  ExpectSameMesh(MakeTwoTetrahedra(), Write(MakeTwoTetrahedra()).Read("ele"));
  // An unknown extension is kept, and ours is appended.
  EXPECT_EQ(Write(MakeTwoTetrahedra(), {}, {}, "part.1").Files.count("ele"), 1u);
}

//------------------------------------------------------------------------------
TEST(TetGenWriter, WritesArraysWithoutNames)
{
  Grid grid = MakeTwoTetrahedra();
  AddArray<vtkIntArray>(grid->GetPointData(), nullptr, { 1, 2, 3, 4, 5 });
  const WrittenFiles written = Write(grid);
  ASSERT_TRUE(written.Success);
  ASSERT_EQ(written.Warnings.size(), 1u);
  EXPECT_NE(written.Warnings[0].find("an unnamed array as attr_0"), std::string::npos);
}

//------------------------------------------------------------------------------
TEST(TetGenWriter, WritesAttributesAndMarkers)
{
  Grid grid = MakeTwoTetrahedra();
  AddArray<vtkDoubleArray>(grid->GetPointData(), "attr_1", { 0.5, 1.5, 2.5, 3.5, 1e300 });
  AddArray<vtkDoubleArray>(grid->GetPointData(), "attr_0", { 1, 2, 3, 4, 1.0 / 3 });
  AddArray<vtkIntArray>(grid->GetPointData(), "BoundaryMarker", { 1, -2, 0, 7, 2147483647 });
  AddArray<vtkDoubleArray>(grid->GetCellData(), "attr_1", { 0.25, 0.75 });
  AddArray<vtkIntArray>(grid->GetCellData(), "Region", { 1000000, -20 });
  const WrittenFiles written = Write(grid);
  ASSERT_TRUE(written.Success);
  EXPECT_TRUE(written.Warnings.empty()) << written.Warnings[0];
  EXPECT_EQ(written.Files.at("ele"), "2 4 2\n0 0 1 2 3 1000000 0.25\n1 1 2 3 4 -20 0.75\n");
  ExpectSameMesh(grid, written.Read("ele"));

  const WrittenFiles plain = Write(grid, [](vtkTetGenWriter* w) { w->WriteArraysOff(); });
  EXPECT_TRUE(plain.Warnings.empty());
  EXPECT_EQ(plain.Files.at("ele"), "2 4 0\n0 0 1 2 3\n1 1 2 3 4\n");
  EXPECT_EQ(plain.Files.at("node").substr(0, 8), "5 3 0 0\n");
}

//------------------------------------------------------------------------------
// If this fails, something is lost, or read under another name, without a warning.
TEST(TetGenWriter, SaysWhatIsLost)
{
  Grid grid = MakeTwoTetrahedra();
  AddArray<vtkFloatArray>(grid->GetPointData(), "Pressure", { 0.1, 2, 3, 4, 5 });
  AddArray<vtkDoubleArray>(grid->GetCellData(), "Flow", { 1, 2, 3, 4, 5, 6 }, 3);
  AddArray<vtkDoubleArray>(grid->GetPointData(), "BoundaryMarker", { 0.5, 0, 0, 0, 0 });
  const WrittenFiles written = Write(grid);
  ASSERT_TRUE(written.Success);
  ASSERT_EQ(written.Warnings.size(), 2u);
  EXPECT_NE(written.Warnings[0].find("not written: Flow"), std::string::npos)
    << written.Warnings[0];
  EXPECT_NE(
    written.Warnings[1].find("Pressure as attr_0, BoundaryMarker as attr_1"), std::string::npos)
    << written.Warnings[1];
  EXPECT_NE(written.Files.at("node").find("\n0 0 0 0 0.1 0.5\n"), std::string::npos);

  const WrittenFiles old =
    Write(MakeTwoTetrahedra(), {}, { { "neigh", "old" }, { "face", "old" } });
  ASSERT_EQ(old.Warnings.size(), 1u);
  EXPECT_NE(old.Warnings[0].find("part.1.face, part.1.neigh"), std::string::npos);
  EXPECT_EQ(old.Files.at("neigh"), "old");
}

//------------------------------------------------------------------------------
TEST(TetGenWriter, TrianglesBesideTetrahedraAreFaces)
{
  const WrittenFiles written = Write(MakeTetrahedraWithTriangles());
  ASSERT_TRUE(written.Success) << written.Errors[0];
  EXPECT_TRUE(written.Warnings.empty()) << written.Warnings[0];
  EXPECT_EQ(written.Files.at("ele"), "2 4 1\n0 0 1 2 3 10\n1 1 2 3 4 20\n");
  EXPECT_EQ(written.Files.at("face"), "2 1\n0 2 1 3 5\n1 0 2 1 -6\n");
  const Result faces = written.Read("face");
  EXPECT_EQ(GetCell(faces, 1), (Ids{ VTK_TRIANGLE, 0, 2, 1 }));
  EXPECT_EQ(GetValues(faces.Grid->GetCellData(), "BoundaryMarker"), (Values{ 5, -6 }));
  EXPECT_EQ(Count(written.Read("ele").Grid, VTK_TETRA), 2);

  // Data that these files cannot store is reported.
  const Grid marked = MakeTetrahedraWithTriangles();
  marked->GetCellData()->GetArray("BoundaryMarker")->SetComponent(2, 0, 8);
  marked->GetCellData()->GetArray("Region")->SetComponent(1, 0, 30);
  marked->GetCellData()->GetArray("Region")->SetComponent(3, 0, 30);
  const WrittenFiles lost = Write(marked);
  ASSERT_EQ(lost.Warnings.size(), 2u);
  EXPECT_NE(lost.Warnings[0].find("2 cells written as a face, with nonzero values other than"),
    std::string::npos);
  EXPECT_NE(lost.Warnings[0].find("the first is cell 1 (counted from 0)"), std::string::npos)
    << lost.Warnings[0];
  EXPECT_NE(lost.Warnings[1].find("1 cell written as an element, with a BoundaryMarker"),
    std::string::npos);

  const WrittenFiles boundary =
    Write(MakeTwoTetrahedra(), [](vtkTetGenWriter* w) { w->WriteBoundaryFacesOn(); });
  const Result sides = boundary.Read("face");
  ASSERT_TRUE(sides.Errors.empty());
  EXPECT_EQ(Count(sides.Grid, VTK_TRIANGLE), 6);
  EXPECT_EQ(GetValues(sides.Grid->GetCellData(), "BoundaryMarker"), (Values{ 1, 1, 1, 1, 1, 1 }));
  for (vtkIdType cell = 0; cell < 6; ++cell)
  {
    const Ids ids = GetCell(sides, cell);
    EXPECT_FALSE(std::count(ids.begin() + 1, ids.end(), 0) == 0 &&
      std::count(ids.begin() + 1, ids.end(), 4) == 0)
      << "the face between the tetrahedra";
  }
}

//------------------------------------------------------------------------------
TEST(TetGenWriter, TrianglesInTwoOrThreeDimensions)
{
  const Grid flat =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { VTK_TRIANGLE, { 2, 1, 0 } } });
  const WrittenFiles two = Write(flat);
  EXPECT_EQ(two.Files.at("node"), "3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n");
  EXPECT_EQ(two.Files.at("ele"), "1 3 0\n0 2 1 0\n");
  ExpectSameMesh(flat, two.Read("node"));
  const Grid raised =
    MakeGrid({ { 0, 0, 2 }, { 1, 0, 2 }, { 0, 1, 2 } }, { { VTK_TRIANGLE, { 2, 1, 0 } } });
  const WrittenFiles three = Write(raised);
  EXPECT_EQ(three.Files.at("node"), "3 3 0 0\n0 0 0 2\n1 1 0 2\n2 0 1 2\n");
  ExpectSameMesh(raised, three.Read("ele"));
}

//------------------------------------------------------------------------------
// Midside nodes in TetGen's order. If this fails, other programs read tangled elements.
TEST(TetGenWriter, SecondOrder)
{
  std::vector<Point> points = { { 0, 0, 0 }, { 2, 0.1, 0 }, { 0.3, 3, 0.2 }, { 0.4, 0.5, 5 } };
  const int edges[6][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };
  for (const auto& edge : edges)
  {
    Point middle = points[edge[0]];
    for (int c = 0; c < 3; ++c)
    {
      middle[c] = (middle[c] + points[edge[1]][c]) / 2;
    }
    points.push_back(middle);
  }
  const Ids ten{ 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 }, six{ 0, 1, 2, 4, 5, 6 };
  const Grid solid =
    MakeGrid(points, { { VTK_QUADRATIC_TETRA, ten }, { VTK_QUADRATIC_TRIANGLE, six } });
  const WrittenFiles written = Write(solid);
  ASSERT_TRUE(written.Success) << written.Errors[0];
  // File positions 4 to 9 are the edges 23 03 01 12 13 02, of triangles those opposite of 0 1 2.
  EXPECT_EQ(written.Files.at("ele"), "1 10 0\n0 0 1 2 3 9 7 4 5 8 6\n");
  EXPECT_EQ(written.Files.at("face"), "1 0\n0 0 1 2 5 6 4\n");
  const Result again = written.Read("ele");
  EXPECT_TRUE(again.Warnings.empty());
  EXPECT_EQ(GetCell(again, 0), (Ids{ VTK_QUADRATIC_TETRA, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 }));
  EXPECT_EQ(GetCell(written.Read("face"), 0), (Ids{ VTK_QUADRATIC_TRIANGLE, 0, 1, 2, 4, 5, 6 }));

  // Next to linear elements they lose these nodes.
  const Grid both =
    MakeGrid(points, { { VTK_QUADRATIC_TETRA, ten }, { VTK_TETRA, { 0, 1, 2, 9 } } });
  const WrittenFiles linear = Write(both);
  ASSERT_TRUE(linear.Success);
  EXPECT_FALSE(linear.Warnings.empty());
  EXPECT_EQ(Count(linear.Read("ele").Grid, VTK_TETRA), 2);
}

//------------------------------------------------------------------------------
TEST(TetGenWriter, PointsWithoutElements)
{
  const Grid cloud =
    MakeGrid({ { 1, 2, 3 }, { 4, 5, 6 } }, { { VTK_VERTEX, { 0 } }, { VTK_VERTEX, { 1 } } });
  const WrittenFiles written = Write(cloud);
  ASSERT_TRUE(written.Success) << written.Errors[0];
  EXPECT_EQ(written.Files.at("node"), "2 3 0 0\n0 1 2 3\n1 4 5 6\n");
  EXPECT_EQ(written.Files.at("ele"), "0 4 0\n"); // replaces an earlier mesh
  ExpectSameMesh(cloud, written.Read("ele"));
  ExpectSameMesh(cloud, written.Read("node"));
  const WrittenFiles empty = Write(MakeGrid({}, {}));
  EXPECT_EQ(empty.Files.at("node"), "0 3 0 0\n");
  EXPECT_TRUE(empty.Read("ele").Errors.empty());
  // Arrays of cells that are not elements are not reported as attributes of elements.
  AddArray<vtkDoubleArray>(cloud->GetCellData(), "Region", { 1, 2 });
  const WrittenFiles regions = Write(cloud);
  EXPECT_EQ(regions.Files.at("ele"), "0 4 0\n");
  ASSERT_EQ(regions.Warnings.size(), 1u);
  EXPECT_NE(regions.Warnings[0].find("not written: Region"), std::string::npos);
}

//------------------------------------------------------------------------------
// If this fails, a file is written that the reader refuses.
TEST(TetGenWriter, MoreArraysThanAttributes)
{
  const Grid grid = MakeTwoTetrahedra();
  for (int i = 0; i <= MaxTetGenAttributes; ++i)
  {
    AddArray<vtkIntArray>(grid->GetCellData(), ("attr_" + std::to_string(i)).c_str(), { 1, 2 });
  }
  const WrittenFiles written = Write(grid);
  ASSERT_TRUE(written.Success);
  EXPECT_NE(written.Warnings[0].find("not written: attr_1000"), std::string::npos)
    << written.Warnings[0];
  EXPECT_EQ(written.Files.at("ele").substr(0, 9), "2 4 1000\n");
  EXPECT_TRUE(written.Read("ele").Errors.empty());
}

//------------------------------------------------------------------------------
// If this fails, a mesh that could not be written damages existing files.
TEST(TetGenWriter, WhatItCannotHold)
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { VTK_PYRAMID, { 0, 1, 2, 3, 4 } }, { VTK_TETRA, { 4, 2, 0, 3 } } });
  const std::map<std::string, std::string> before{ { "node", "old" }, { "ele", "old" } };
  const WrittenFiles refused = Write(grid, {}, before);
  EXPECT_EQ(refused.Success, 0);
  EXPECT_EQ(refused.Files, before);
  ASSERT_EQ(refused.Errors.size(), 1u);
  const WrittenFiles converted = Write(
    grid, [](vtkTetGenWriter* w) { w->SetUnsupportedCells(vtkTetGenWriter::CONVERT); }, before);
  ASSERT_TRUE(converted.Success);
  EXPECT_EQ(Count(converted.Read("ele").Grid, VTK_TETRA), 3);
  const WrittenFiles skipped =
    Write(grid, [](vtkTetGenWriter* w) { w->SetUnsupportedCells(vtkTetGenWriter::SKIP); });
  ASSERT_TRUE(skipped.Success);
  EXPECT_FALSE(skipped.Warnings.empty());
  EXPECT_EQ(skipped.Read("ele").Grid->GetNumberOfCells(), 1);

  const WrittenFiles wrongName = Write(MakeTwoTetrahedra(), {}, {}, "part.1.poly");
  EXPECT_EQ(wrongName.Success, 0);
  EXPECT_TRUE(wrongName.Files.empty());
  ASSERT_EQ(wrongName.Errors.size(), 1u);
  EXPECT_NE(
    wrongName.Errors[0].find("part.1.poly: expected a name that ends with"), std::string::npos);
}

//------------------------------------------------------------------------------
// If this fails, nodes of one mesh may be combined with elements of another.
TEST(TetGenWriter, AllFilesOrNone)
{
  const fs::path folder = File::GetFolder() / "written" / "part.1.ele";
  fs::create_directories(folder); // where the elements would be
  const WrittenFiles written = Write(MakeTwoTetrahedra(), {}, { { "node", "old" } });
  EXPECT_EQ(written.Success, 0);
  ASSERT_EQ(written.Errors.size(), 1u);
  EXPECT_NE(written.Errors[0].find("part.1.ele"), std::string::npos);
  EXPECT_EQ(written.Files.at("node"), "old");
  EXPECT_EQ(written.Files.size(), 2u); // and no temporary ones
}

//------------------------------------------------------------------------------
TEST(TetGenWriter, ThreadsChangeNothing)
{
  const Mesh mesh(MakeStrip(20000));
  const Grid grid = mesh.Read("ele").Grid;
  const WrittenFiles expected = Write(grid);
  ASSERT_TRUE(expected.Success);
  for (const int threads : { 1, 2, 3 })
  {
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config(threads), [&] { EXPECT_EQ(Write(grid).Files, expected.Files); });
  }
  const Result again = expected.Read("ele");
  grid->GetPointData()->RemoveArray("OriginalPointId");
  grid->GetCellData()->RemoveArray("OriginalCellId");
  ExpectSameMesh(grid, again);
}
