// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What the writer writes, and that nothing is lost when it is read again.
#include "SharedData.h"
#include "TestMeshes.h"
#include "VisfSamples.h"

#include "vtkVisfWriter.h"

#include "Mesh/MeshView.h"

#include "vtkAppendFilter.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <set>

#if defined(__linux__)
#include <csignal>
#include <sys/resource.h>
#endif

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
Written WriteFile(const std::string& path, vtkDataSet* mesh, int encoding = vtkVisfWriter::ASCII,
  bool neighbors = false)
{
  return WriteTo<vtkVisfWriter>(path, mesh,
    [=](vtkVisfWriter* writer)
    {
      writer->SetEncoding(encoding);
      writer->SetWriteNeighbors(neighbors);
    });
}

//------------------------------------------------------------------------------
std::string WriteBytes(
  vtkDataSet* mesh, int encoding = vtkVisfWriter::ASCII, bool neighbors = false)
{
  const File file("", "written.visf");
  const Written result = WriteFile(file.Path, mesh, encoding, neighbors);
  EXPECT_EQ(result.Success, 1);
  EXPECT_TRUE(result.Errors.empty());
  return GetBytes(file.Path);
}

//------------------------------------------------------------------------------
int CountFiles(const std::filesystem::path& folder)
{
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    count += !entry.path().empty();
  }
  return count;
}

//------------------------------------------------------------------------------
// Same points bit by bit, same cells in the same order with the same nodes; faces of polyhedra in
// the same order and orientation, though they may start at another point.
void ExpectSameMesh(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
  if (a->GetNumberOfPoints() > 0)
  {
    EXPECT_TRUE(HaveSameValues(a->GetPoints()->GetData(), b->GetPoints()->GetData()));
  }
  const MeshView meshA(a), meshB(b);
  const auto get = [](const IndexRange& range)
  {
    std::vector<vtkIdType> ids(range.Size);
    for (vtkIdType i = 0; i < range.Size; ++i)
    {
      ids[i] = range[i];
    }
    return ids;
  };
  for (vtkIdType cell = 0; cell < a->GetNumberOfCells(); ++cell)
  {
    ASSERT_EQ(meshA.GetCellType(cell), meshB.GetCellType(cell));
    if (meshA.GetCellType(cell) != VTK_POLYHEDRON)
    {
      EXPECT_EQ(get(meshA.GetCellPoints(cell)), get(meshB.GetCellPoints(cell)));
      continue;
    }
    const IndexRange facesA = meshA.GetPolyhedronFaces(cell),
                     facesB = meshB.GetPolyhedronFaces(cell);
    ASSERT_EQ(facesA.Size, facesB.Size);
    for (vtkIdType f = 0; f < facesA.Size; ++f)
    {
      auto faceA = get(meshA.GetPolyhedronFacePoints(facesA[f]));
      auto faceB = get(meshB.GetPolyhedronFacePoints(facesB[f]));
      std::rotate(faceA.begin(), std::min_element(faceA.begin(), faceA.end()), faceA.end());
      std::rotate(faceB.begin(), std::min_element(faceB.begin(), faceB.end()), faceB.end());
      EXPECT_EQ(faceA, faceB);
    }
  }
}

//------------------------------------------------------------------------------
// Meshes with everything that a Visf file can store.
std::vector<VisfMesh> MakeGallery()
{
  std::mt19937 random(2);
  std::vector<VisfMesh> gallery = { MakeBar(1), MakeBar(9, 4), MakeBar(9), MakeBar(3, 3) };
  VisfMesh mixed = MakeBar(40, 17);
  mixed.Polygons.push_back({ 0, 1, 2, 3, 5 });
  mixed.Polygons.push_back({ 3, 4 });
  mixed.Polygons.push_back({ 7 });
  mixed.Polygons.push_back(mixed.Polygons.front());
  mixed.Polyhedra.push_back({});
  mixed.Polyhedra.push_back({ 1, 2, 3 }); // not closed
  mixed.Points.push_back({ { 5, 5, 5 } });
  for (auto& point : mixed.Points)
  {
    for (float& x : point)
    {
      x = x * 1.1f + static_cast<float>(random() % 1000) * 1.7e-5f;
    }
  }
  gallery.push_back(mixed);
  VisfMesh surface = mixed;
  surface.Polyhedra.clear();
  gallery.push_back(surface);
  VisfMesh cloud = surface;
  cloud.Polygons.clear();
  cloud.Points.push_back({ { NAN, INFINITY, -INFINITY } });
  cloud.Points.push_back({ { -0.f, 1e-45f, 3.4028235e38f } });
  gallery.push_back(cloud);
  // A polygon with one vertex is not a cloud of all points.
  VisfMesh vertex;
  vertex.Type = 1;
  vertex.Points.resize(4);
  vertex.Polygons = { { 3 } };
  gallery.push_back(vertex);
  gallery.emplace_back();
  return gallery;
}
}

//------------------------------------------------------------------------------
// If this fails, a mesh changes when it is written and read again.
TEST(VisfWriter, RoundTrip)
{
  for (const VisfMesh& mesh : MakeGallery())
  {
    const Result first = ReadMesh(mesh, Encoding::Little03);
    ASSERT_TRUE(first.Errors.empty());
    std::set<std::string> texts;
    for (int encoding = vtkVisfWriter::ASCII; encoding <= vtkVisfWriter::BINARY_VERSION_02;
      ++encoding)
    {
      for (const bool neighbors : { false, true })
      {
        const std::string bytes = WriteBytes(first.Grid, encoding, neighbors);
        const Result second = ReadBytes(bytes);
        ASSERT_TRUE(second.Errors.empty()) << second.Errors[0];
        ExpectSameMesh(first.Grid, second.Grid);
        EXPECT_EQ(WriteBytes(second.Grid, encoding, neighbors), bytes);
        texts.insert(WriteBytes(second.Grid));
      }
    }
    EXPECT_EQ(texts.size(), 1u);
  }
}

//------------------------------------------------------------------------------
// If this fails, the original Camarón no longer finds the layout that it writes itself.
TEST(VisfWriter, TextIsLaidOutAsSpecified)
{
  const auto grid = MakeGrid(
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 0.1f, 0 } }, { { 0, 0, 1e-7f } }, { { 1, 1, 1 } } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 0, 1, 4 } },
      { VTK_TETRA, { 1, 4, 2, 3 } } });
  const std::string text = WriteBytes(grid);
  EXPECT_EQ(text,
    "2 2\n5\n0 0 0\n1 0 0\n0 0.1 0\n0 0 1e-07\n1 1 1\n"
    "8\n3 0 1 3\n3 1 2 3\n3 2 0 3\n3 0 2 1\n3 0 1 4\n3 1 4 3\n3 4 2 3\n3 1 2 4\n"
    "0\n2\n4 0 1 2 3\n4 5 6 1 7\n");
  EXPECT_EQ(WriteBytes(grid, vtkVisfWriter::BINARY_LITTLE_ENDIAN).substr(0, 9),
    std::string("1\2\0\0\0\5\0\0\0", 9));
  EXPECT_EQ(WriteBytes(grid, vtkVisfWriter::BINARY_BIG_ENDIAN).substr(0, 9),
    std::string("0\0\0\0\2\0\0\0\5", 9));
  EXPECT_EQ(WriteBytes(grid, vtkVisfWriter::BINARY_VERSION_02).substr(0, 9),
    std::string("\1\2\0\0\0\5\0\0\0", 9));
  EXPECT_EQ(WriteBytes(MakeGrid({ { { 1, 2, 3 } } }, {})), "2 0\n1\n1 2 3\n");
  EXPECT_EQ(
    WriteBytes(MakeGrid({ { { 1, 2, 3 } } }, { { VTK_VERTEX, { 0 } } })), "2 0\n1\n1 2 3\n");
}

//------------------------------------------------------------------------------
// If this fails, lists of neighbors differ from their definition: two or more common vertices.
TEST(VisfWriter, Neighbors)
{
  const VisfMesh mesh = MakeBar(4, 2);
  std::istringstream text(WriteBytes(ReadMesh(mesh, Encoding::Ascii).Grid, 0, true));
  int number, points;
  float x;
  text >> number >> number >> points;
  for (int i = 0; i < 3 * points; ++i)
  {
    text >> x;
  }
  const auto readLists = [&text](int count)
  {
    std::vector<std::set<int>> lists(count);
    for (auto& list : lists)
    {
      int size, id;
      text >> size;
      for (; size > 0; --size)
      {
        text >> id;
        EXPECT_TRUE(list.insert(id).second);
      }
    }
    return lists;
  };
  text >> number;
  const auto polygons = readLists(number);
  text >> number;
  EXPECT_EQ(number, 1);
  const auto neighbors = readLists(static_cast<int>(polygons.size()));
  for (std::size_t p = 0; p < polygons.size(); ++p)
  {
    std::set<int> expected;
    for (std::size_t q = 0; q < polygons.size(); ++q)
    {
      std::vector<int> common;
      std::set_intersection(polygons[p].begin(), polygons[p].end(), polygons[q].begin(),
        polygons[q].end(), std::back_inserter(common));
      if (p != q && common.size() > 1)
      {
        expected.insert(static_cast<int>(q));
      }
    }
    EXPECT_EQ(neighbors[p], expected);
  }
}

//------------------------------------------------------------------------------
// If this fails, cells of other types are lost without a warning, or become something else.
TEST(VisfWriter, OtherTypesOfCells)
{
  Points points;
  for (int i = 0; i < 27; ++i)
  {
    points.push_back({ { double(i % 3), double(i / 3 % 3), double(i / 9) } });
  }
  auto grid = MakeGrid(points,
    { { VTK_VOXEL, { 0, 1, 3, 4, 9, 10, 12, 13 } }, { VTK_PIXEL, { 0, 1, 3, 4 } },
      { VTK_QUADRATIC_TRIANGLE, { 0, 2, 6, 1, 4, 3 } }, { VTK_TRIANGLE_STRIP, { 0, 1, 3, 4, 6 } },
      { VTK_LINE, { 0, 1 } }, { VTK_POLY_LINE, { 0, 1, 2 } }, { VTK_QUADRATIC_EDGE, { 2, 0, 1 } },
      { VTK_POLY_VERTEX, { 7, 5 } },
      { VTK_QUADRATIC_TETRA, { 0, 2, 6, 18, 1, 4, 3, 9, 10, 12 } } });
  const File file("", "written.visf");
  const Written written = WriteFile(file.Path, grid);
  ASSERT_EQ(written.Warnings.size(), 2u);
  EXPECT_NE(written.Warnings[0].find("3 cells of higher order"), std::string::npos);
  EXPECT_NE(written.Warnings[1].find("4 cells of dimension 0 or 1"), std::string::npos);
  const Result result = ReadFile(file.Path);
  const int types[] = { VTK_HEXAHEDRON, VTK_TETRA, VTK_QUAD, VTK_TRIANGLE, VTK_TRIANGLE,
    VTK_TRIANGLE, VTK_TRIANGLE, VTK_LINE, VTK_LINE, VTK_LINE, VTK_LINE, VTK_VERTEX, VTK_VERTEX };
  ASSERT_EQ(result.Grid->GetNumberOfCells(), 13);
  for (vtkIdType cell = 0; cell < 13; ++cell)
  {
    EXPECT_EQ(result.Grid->GetCellType(cell), types[cell]);
  }
  vtkNew<vtkIdList> ids;
  result.Grid->GetCellPoints(2, ids); // the pixel, as a quadrilateral
  EXPECT_EQ(ids->GetId(2), 4);
  result.Grid->GetCellPoints(5, ids); // every second triangle of a strip is reversed
  EXPECT_EQ(ids->GetId(0), 1);
  EXPECT_EQ(ids->GetId(1), 4);
  EXPECT_EQ(ids->GetId(2), 3);
  const std::vector<std::vector<vtkIdType>> pieces = { { 0, 1 }, { 0, 1 }, { 1, 2 }, { 2, 0 },
    { 7 }, { 5 } };
  for (vtkIdType piece = 0; piece < 6; ++piece)
  {
    result.Grid->GetCellPoints(7 + piece, ids);
    EXPECT_EQ(
      std::vector<vtkIdType>(ids->begin(), ids->end()), pieces[static_cast<std::size_t>(piece)]);
  }

  vtkNew<vtkPolyData> surface;
  surface->SetPoints(grid->GetPoints());
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 4, 3 });
  polygons->InsertNextCell({ 1, 2, 5 });
  surface->SetPolys(polygons);
  const Result polygonsAgain = ReadBytes(WriteBytes(surface));
  EXPECT_EQ(Count(polygonsAgain.Grid, VTK_QUAD), 1);
  EXPECT_EQ(Count(polygonsAgain.Grid, VTK_TRIANGLE), 1);
  EXPECT_EQ(polygonsAgain.Grid->GetNumberOfPoints(), 27);
}

//------------------------------------------------------------------------------
// If this fails, vertices are read as others: a cloud has all points in their order.
TEST(VisfWriter, VerticesThatAreNoCloud)
{
  const Points points = { { 0, 0, 0 }, { 1, 0, 0 } };
  const auto read = [&](const Cells& cells)
  {
    const Result result = ReadBytes(WriteBytes(MakeGrid(points, cells)));
    std::vector<vtkIdType> ids;
    vtkNew<vtkIdList> list;
    for (vtkIdType cell = 0; cell < result.Grid->GetNumberOfCells(); ++cell)
    {
      EXPECT_EQ(result.Grid->GetCellType(cell), VTK_VERTEX);
      result.Grid->GetCellPoints(cell, list);
      ids.push_back(list->GetId(0));
    }
    return ids;
  };
  EXPECT_EQ(
    read({ { VTK_VERTEX, { 0 } }, { VTK_VERTEX, { 1 } } }), (std::vector<vtkIdType>{ 0, 1 }));
  EXPECT_EQ(
    read({ { VTK_VERTEX, { 0 } }, { VTK_VERTEX, { 0 } } }), (std::vector<vtkIdType>{ 0, 0 }));
  EXPECT_EQ(
    read({ { VTK_VERTEX, { 1 } }, { VTK_VERTEX, { 0 } } }), (std::vector<vtkIdType>{ 1, 0 }));
  EXPECT_EQ(read({ { VTK_POLY_VERTEX, { 1, 1 } } }), (std::vector<vtkIdType>{ 1, 1 }));
}

//------------------------------------------------------------------------------
// If this fails, convex point sets, which do not list their faces, are lost.
TEST(VisfWriter, HullsOfPointSets)
{
  const auto octahedron =
    MakeGrid({ { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } },
      { { VTK_CONVEX_POINT_SET, { 0, 1, 2, 3, 4, 5 } } });
  const Result result = ReadBytes(WriteBytes(octahedron));
  ASSERT_EQ(Count(result.Grid, VTK_POLYHEDRON), 1);
  EXPECT_EQ(result.Grid->GetCell(0)->GetNumberOfFaces(), 8);
}

//------------------------------------------------------------------------------
// If this fails, arrays or digits are lost without a warning.
TEST(VisfWriter, SaysWhatIsLost)
{
  auto grid = MakeGrid(
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 0.1, 0 } } }, { { VTK_TRIANGLE, { 0, 1, 2 } } });
  vtkNew<vtkDoubleArray> array;
  array->SetName("Pressure");
  array->SetNumberOfTuples(3);
  grid->GetPointData()->AddArray(array);
  const File file("");
  const Written written = WriteFile(file.Path, grid);
  EXPECT_EQ(written.Success, 1);
  ASSERT_EQ(written.Warnings.size(), 2u);
  EXPECT_NE(written.Warnings[0].find("not written: Pressure"), std::string::npos);
  EXPECT_NE(
    written.Warnings[1].find("1 point rounded to single precision: point 2"), std::string::npos);

  grid->GetPoints()->SetPoint(1, 0, -1e300, 0);
  const Written refused = WriteFile((File::GetFolder() / "refused.visf").string(), grid);
  EXPECT_EQ(refused.Success, 0);
  ASSERT_EQ(refused.Errors.size(), 1u);
  EXPECT_NE(
    refused.Errors[0].find("refused.visf: expected coordinates up to 3.4e38"), std::string::npos);
  EXPECT_NE(refused.Errors[0].find("found -1e+300 of point 1"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(File::GetFolder() / "refused.visf"));
}

//------------------------------------------------------------------------------
// If this fails, inverted cells are corrected without a warning, or the warning names others.
TEST(VisfWriter, TellsOfInvertedCells)
{
  const auto tells = [](vtkUnstructuredGrid* grid)
  {
    const Written written = WriteFile(File("").Path, grid);
    return std::any_of(written.Warnings.begin(), written.Warnings.end(),
      [](const std::string& warning)
      {
        return warning.find("1 cell with inverted orientation, which is lost because Visf files") !=
          std::string::npos;
      });
  };
  for (const int type : StandardTypes3D)
  {
    Grid cell = MakeStandardCell(type);
    EXPECT_FALSE(tells(cell)) << type;
    for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
    {
      double x[3];
      cell->GetPoint(i, x);
      cell->GetPoints()->SetPoint(i, -x[0], x[1], x[2]);
    }
    EXPECT_TRUE(tells(cell)) << type;
    // Faces of polyhedra may have any orientation, and flat cells have no inside.
    EXPECT_FALSE(tells(ToPolyhedra(cell))) << type;
  }
  EXPECT_FALSE(
    tells(MakeGrid({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 1, 1, 0 } } },
      { { VTK_TETRA, { 0, 1, 2, 3 } } })));
}

//------------------------------------------------------------------------------
// If this fails, a face of three or four cells is written with more than two cells, or twice for
// two.
TEST(VisfWriter, FacesOfManyCells)
{
  for (int cells = 1; cells <= 5; ++cells)
  {
    Points points = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } };
    Cells tetrahedra;
    for (int i = 0; i < cells; ++i)
    {
      points.push_back({ { double(i), 0, 1 } });
      tetrahedra.push_back({ VTK_TETRA, { 0, 1, 2, 3 + i } });
    }
    const auto grid = MakeGrid(points, tetrahedra);
    std::istringstream text(WriteBytes(grid));
    std::string line;
    std::vector<std::string> lines;
    while (std::getline(text, line))
    {
      lines.push_back(line);
    }
    const int common = (cells + 1) / 2;
    EXPECT_EQ(std::stoi(lines[2 + points.size()]), 3 * cells + common);
    EXPECT_EQ(std::count(lines.begin(), lines.end(), "3 0 2 1"), common);
    const Result again = ReadBytes(text.str());
    EXPECT_EQ(Count(again.Grid, VTK_TETRA), cells);
    EXPECT_EQ(again.Grid->GetNumberOfCells(), cells);
  }
}

//------------------------------------------------------------------------------
// If this fails, a cell gets the face of its neighbor, with the same points in another order, or a
// face that repeats a point comes and goes with every writing.
TEST(VisfWriter, FacesWithTheSamePointsInAnotherOrder)
{
  const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n0 0 -1\n";
  for (const std::string face : { "4 0 2 1 3", "4 0 1 3 2", "5 0 1 2 1 3", "4 0 1 2 3" })
  {
    const std::string text = "2 2\n6\n" + points +
      "10\n4 0 1 2 3\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n" + face +
      "\n3 0 1 5\n3 1 2 5\n3 2 3 5\n3 3 0 5\n0\n2\n5 0 1 2 3 4\n5 5 6 7 8 9\n";
    const std::string written = WriteBytes(ReadBytes(text).Grid);
    const bool isShared = face == "4 0 1 2 3"; // and turned, because both cells are closed
    const std::string found = isShared ? "\n9\n4 0 3 2 1\n" : "\n" + face + "\n";
    EXPECT_NE(written.find(found), std::string::npos) << face << ":\n" << written;
    EXPECT_EQ(WriteBytes(ReadBytes(written).Grid), written);
  }

  // Found by a fuzzer.
  const std::string text =
    "2 2\n9\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 1 1\n1 0 1\n1 1 1\n0 1 1\n0.5 0.5 2\n10\n"
    "4 0 3 2 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 0 3 2 1\n4 4 5 3 4 5 8\n3 5 6 8\n3 6 7 8\n"
    "3 7 4 8\n1\n4 2 3 4 5\n8 2 3 4 5 6 7 8 9\n5 0 1 3 5 6\n5 0 1 2 4 7\n5 0 1 3 5 8\n5 0 1 2 4 9\n"
    "4 1 2 7 9\n4 1 3 6 8\n4 1 4 7 9\n4 1 5 6 8\n2\n1 0 1 2 3 4 5\n5 1 6 7 8 9\n";
  const std::string written = WriteBytes(ReadBytes(text).Grid);
  EXPECT_EQ(WriteBytes(ReadBytes(written).Grid), written);
}

//------------------------------------------------------------------------------
// If this fails, a small mesh far from the origin is written as cells without size, or a mesh is
// refused that stays as it is.
TEST(VisfWriter, RefusesCellsThatRoundingChanges)
{
  const auto makeAt = [](double x, double size)
  {
    return MakeGrid(
      { { x, 0, 0 }, { x + size, 0, 0 }, { x, size, 0 }, { x, 0, size }, { x, 0, -4 * size } },
      { { VTK_TETRA, { 0, 2, 1, 4 } }, { VTK_TETRA, { 0, 1, 2, 3 } } });
  };
  const auto write = [](vtkDataSet* mesh, bool allows)
  {
    const File file("", "written.visf");
    return WriteTo<vtkVisfWriter>(
      file.Path, mesh, [allows](vtkVisfWriter* writer) { writer->SetAllowRounding(allows); });
  };
  EXPECT_EQ(write(makeAt(1. / 3, 1), false).Success, 1);
  EXPECT_EQ(write(makeAt(1e5 + 1. / 3, 1), false).Success, 1);
  const Written far = write(makeAt(5e6 + 1. / 3, 0.7), false);
  EXPECT_EQ(far.Success, 0);
  ASSERT_EQ(far.Errors.size(), 1u);
  EXPECT_NE(far.Errors[0].find("expected cells that keep their shape in single precision, found an "
                               "edge of cell 0 that changes by 28.6 %"),
    std::string::npos)
    << far.Errors[0];
  const Written allowed = write(makeAt(5e6 + 1. / 3, 0.7), true);
  EXPECT_EQ(allowed.Success, 1);

  // No edge changes much, but the nearly flat cell turns inside out.
  const double step = std::ldexp(1, -10); // of single precision near 1e4
  const auto flat = MakeGrid({ { 1e4 + 0.51 * step, 0, 0 }, { 1e4 + 0.51 * step, 100, 0 },
                               { 1e4 - 0.49 * step, 0, 100 }, { 1e4 + 0.3 * step, 33, 33 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } } });
  for (const Grid& mesh : { flat, ToPolyhedra(flat) })
  {
    const Written turned = write(mesh, false);
    EXPECT_EQ(turned.Success, 0);
    EXPECT_NE(turned.Errors.at(0).find("found cell 0, which rounding inverts"), std::string::npos);
  }
  const auto line = MakeGrid({ { 1e8, 0, 0 }, { 1e8 + 1, 0, 0 } }, { { VTK_LINE, { 0, 1 } } });
  EXPECT_EQ(write(line, false).Success, 0);
}

//------------------------------------------------------------------------------
// If this fails, a mesh distributed over processes is written with seams, twice, or in another
// order.
TEST(VisfWriter, PiecesAreMerged)
{
  for (const VisfMesh& mesh : MakeGallery())
  {
    if (mesh.Polygons.empty())
    {
      continue;
    }
    const File file(Encode(mesh, Encoding::Ascii));
    const std::string expected = WriteBytes(ReadFile(file.Path).Grid);
    for (const int ghostLevels : { 0, 1 })
    {
      vtkNew<vtkAppendFilter> append;
      for (int piece = 0; piece < 3; ++piece)
      {
        append->AddInputData(ReadFile(file.Path, piece, 3, ghostLevels).Grid);
      }
      append->Update();
      EXPECT_EQ(WriteBytes(append->GetOutput()), expected);
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, a failed write destroys the existing file, or leaves temporary files.
TEST(VisfWriter, FailureLeavesNoTrace)
{
  const auto grid = ReadMesh(MakeBar(20000), Encoding::Little03).Grid;
  const File file("precious");
  const int files = CountFiles(File::GetFolder());

  Written written = WriteFile((File::GetFolder() / "no" / "such" / "folder.visf").string(), grid);
  EXPECT_EQ(written.Success, 0);
  EXPECT_EQ(written.Errors.size(), 1u);
  written = WriteFile(File::GetFolder().string(), grid);
  EXPECT_EQ(written.Errors.size(), 1u);
  written = WriteFile("", grid);
  EXPECT_EQ(written.ErrorCode, static_cast<unsigned long>(vtkErrorCode::NoFileNameError));

#if defined(__linux__)
  // A limit on the size of files acts like a full disk.
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before;
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit limit = before;
  limit.rlim_cur = 100000;
  setrlimit(RLIMIT_FSIZE, &limit);
  for (const int encoding : { vtkVisfWriter::ASCII, vtkVisfWriter::BINARY_BIG_ENDIAN })
  {
    written = WriteFile(file.Path, grid, encoding);
    EXPECT_EQ(written.Success, 0);
    EXPECT_EQ(written.ErrorCode, static_cast<unsigned long>(vtkErrorCode::OutOfDiskSpaceError));
    EXPECT_EQ(written.Errors.size(), 1u);
    EXPECT_EQ(GetBytes(file.Path), "precious");
    EXPECT_EQ(CountFiles(File::GetFolder()), files);
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  written = WriteFile("/dev/full", grid);
  EXPECT_EQ(written.ErrorCode, static_cast<unsigned long>(vtkErrorCode::OutOfDiskSpaceError));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
#endif

  // An abort is not an error, but does not change the file either.
  vtkNew<vtkVisfWriter> writer;
  std::vector<std::string> errors;
  Observe(writer, vtkCommand::ErrorEvent, errors);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkVisfWriter*>(caller)->SetAbortExecuteAndUpdateTime(); });
  writer->AddObserver(vtkCommand::ProgressEvent, stop);
  writer->SetInputData(grid);
  writer->SetFileName(file.Path.c_str());
  writer->Write();
  EXPECT_TRUE(errors.empty());
  EXPECT_EQ(GetBytes(file.Path), "precious");
  EXPECT_EQ(CountFiles(File::GetFolder()), files);

  // A link remains a link, and the file keeps its permissions.
  namespace fs = std::filesystem;
  const fs::path link = File::GetFolder() / "link.visf";
  fs::create_symlink(file.Path, link);
  fs::permissions(file.Path, fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(WriteFile(link.string(), grid).Success, 1);
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(ReadFile(file.Path).Grid->GetNumberOfCells(), 20000);
  EXPECT_EQ(fs::status(file.Path).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  fs::remove(link);
}

//------------------------------------------------------------------------------
// If this fails, closed cells without volume that share polygons with an open one turn each time.
TEST(VisfWriter, FlatCellsBesideAnOpenCell)
{
  const std::string first = "2 2\n8\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                            "5\n2 2 0\n4 2 3 7 6\n4 3 0 2 0\n2 1 2\n4 2 3 7 6\n0\n"
                            "3\n3 1 2 4\n3 2 3 4\n3 1 4 0\n";
  const auto rewrite = [](const std::string& bytes)
  { return WriteBytes(ReadBytes(bytes).Grid, vtkVisfWriter::ASCII); };
  const std::string second = rewrite(first);
  EXPECT_EQ(rewrite(second), second);
}

//------------------------------------------------------------------------------
// If this fails, files of other programs change when they are read and written again.
TEST(VisfWriter, CollectedFilesRoundTrip)
{
  CAMARON_NEEDS_SHARED_DATA("visf");
  for (const auto& entry : std::filesystem::directory_iterator(GetSharedData("visf")))
  {
    const Result first = ReadFile(entry.path().string());
    const Result second = ReadBytes(WriteBytes(first.Grid, vtkVisfWriter::BINARY_LITTLE_ENDIAN));
    SCOPED_TRACE(entry.path().filename().string());
    ExpectSameMesh(first.Grid, second.Grid);
  }
}
