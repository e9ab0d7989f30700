// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The grids that valid Visf files become.
#include "SharedData.h"
#include "TestMeshes.h"
#include "VisfSamples.h"

#include "Mesh/MeshTopology.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <map>

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
std::string Replace(std::string text, const std::string& from, const std::string& to)
{
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at))
  {
    text.replace(at, from.size(), to);
    at += to.size();
  }
  return text;
}
}

//------------------------------------------------------------------------------
// If this fails, the smallest files of each type do not open.
TEST(VisfReader, SmallestMeshes)
{
  for (const Encoding encoding : Encodings)
  {
    VisfMesh mesh;
    mesh.Type = 0;
    Result result = ReadMesh(mesh, encoding);
    EXPECT_TRUE(result.IsEmpty());
    EXPECT_TRUE(result.Errors.empty()) << result.Errors[0];

    mesh.Points = { { { 1.5f, -2, 3e10f } } };
    result = ReadMesh(mesh, encoding);
    ASSERT_EQ(result.Grid->GetNumberOfCells(), 1);
    EXPECT_EQ(result.Grid->GetCellType(0), VTK_VERTEX);
    EXPECT_EQ(result.Grid->GetPoint(0)[2], double(3e10f));
    EXPECT_TRUE(result.Warnings.empty());

    mesh = MakeTetrahedron();
    mesh.Type = 1;
    mesh.Polyhedra.clear();
    result = ReadMesh(mesh, encoding);
    EXPECT_EQ(Count(result.Grid, VTK_TRIANGLE), 4);
    EXPECT_EQ(result.Grid->GetNumberOfCells(), 4);
    EXPECT_TRUE(result.Warnings.empty());

    result = ReadMesh(MakeTetrahedron(), encoding);
    ASSERT_EQ(result.Grid->GetNumberOfCells(), 1);
    EXPECT_EQ(result.Grid->GetCellType(0), VTK_TETRA);
    EXPECT_NEAR(GetMeasure(result.Grid, 0), 1. / 6, 1e-12);
    EXPECT_TRUE(result.Warnings.empty());
  }
}

//------------------------------------------------------------------------------
// If this fails, the encodings of one mesh give different grids.
TEST(VisfReader, EncodingsAgree)
{
  const VisfMesh mesh = MakeBar(7, 3);
  const Result expected = ReadMesh(mesh, Encoding::Ascii);
  ASSERT_TRUE(expected.Errors.empty());
  EXPECT_EQ(Count(expected.Grid, VTK_WEDGE), 6);
  EXPECT_EQ(Count(expected.Grid, VTK_POLYHEDRON), 1);
  EXPECT_EQ(Count(expected.Grid, VTK_HEXAHEDRON), 3);
  for (const Encoding encoding : Encodings)
  {
    const Result result = ReadMesh(mesh, encoding);
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_TRUE(result.Warnings.empty());
    ExpectSameGrid(result.Grid, expected.Grid);
  }
}

//------------------------------------------------------------------------------
// If this fails, a v0.1 file whose first bytes look like another version is misread.
TEST(VisfReader, HeaderlessFilesOfAllSizes)
{
  for (const Encoding encoding : { Encoding::Little01, Encoding::Big01 })
  {
    for (const int points : { 0, 1, 2, 255, 256, 257, 512, 65536 })
    {
      VisfMesh mesh;
      mesh.Type = 0;
      mesh.Points.resize(points);
      const Result result = ReadMesh(mesh, encoding);
      EXPECT_TRUE(result.Errors.empty()) << result.Errors[0];
      EXPECT_EQ(result.Grid->GetNumberOfPoints(), points);
      if (points > 2)
      {
        mesh.Type = 1;
        mesh.Polygons = { { 0, 1, 2 } };
        EXPECT_EQ(ReadMesh(mesh, encoding).Grid->GetNumberOfCells(), 1);
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, cells and polygons lose the order of the file, or polygons without cells are lost.
TEST(VisfReader, PolygonsWithoutCellsFollow)
{
  VisfMesh mesh = MakeTetrahedron();
  mesh.Polygons.insert(mesh.Polygons.begin(), { 3, 1, 0 }); // same points as a face of the cell
  mesh.Polygons.push_back({ 0, 1 });
  mesh.Polygons.push_back({ 2 });
  mesh.Polygons.push_back({});
  mesh.Polygons.push_back({ 0, 1, 2, 3 });
  mesh.Polygons.push_back({ 0, 1, 2, 3, 0 });
  mesh.Polyhedra = { {}, { 1, 2, 3, 4 } };
  mesh.Points.push_back({ { 9, 9, 9 } }); // unused
  const Result result = ReadMesh(mesh, Encoding::Ascii);
  EXPECT_TRUE(result.Errors.empty());
  const int expected[] = { VTK_EMPTY_CELL, VTK_TETRA, VTK_TRIANGLE, VTK_LINE, VTK_VERTEX, VTK_QUAD,
    VTK_POLYGON };
  ASSERT_EQ(result.Grid->GetNumberOfCells(), 7);
  for (vtkIdType cell = 0; cell < 7; ++cell)
  {
    EXPECT_EQ(result.Grid->GetCellType(cell), expected[cell]);
  }
  EXPECT_EQ(MeshView(result.Grid).GetCellPoints(2)[0], 3);
  EXPECT_EQ(result.Grid->GetNumberOfPoints(), 5);
  // No vertices, fewer than 3, a repeated one (0,1,2,3,0), no polygons.
  EXPECT_EQ(result.Warnings.size(), 4u);
}

//------------------------------------------------------------------------------
// If this fails, text written by people or other programs is refused or misread.
TEST(VisfReader, TextInAllItsForms)
{
  VisfMesh mesh = MakeBar(3, 1);
  mesh.Neighbors.resize(mesh.Polygons.size(), { 0, 1 });
  const std::string text = Encode(mesh, Encoding::Ascii);
  const Result expected = ReadBytes(text);
  ASSERT_TRUE(expected.Errors.empty());
  const std::string forms[] = {
    Replace(text, "\n", "\r\n"),
    Replace(text, "\n", "\r"),
    "\xef\xbb\xbf" + text,
    "# Generated by hand\n\n  # and again\n" + text,
    Replace(text, "\n", "\n\n \t\n# between 1 2 3\n"),
    Replace(text, " ", " \t "),
    Replace(text, " \n", "   # 1 2 3\n"),
    Replace(text, "\n", "\r\n# a comment\r\n"),
    text.substr(0, text.size() - 2), // no last newline
    "\n\n" + text + "\n\n# the end",
  };
  for (const std::string& form : forms)
  {
    const Result result = ReadBytes(form);
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_TRUE(result.Warnings.empty()) << result.Warnings[0];
    ExpectSameGrid(result.Grid, expected.Grid);
  }
  // Extra columns: colors, normals, text. Not in the lists of neighbors, which are free.
  mesh.Neighbors.clear();
  const std::string plain = Encode(mesh, Encoding::Ascii);
  ExpectSameGrid(ReadBytes(Replace(plain, "\n", "0.5 0.5 x\n")).Grid, expected.Grid);
  ExpectSameGrid(
    ReadBytes(Replace(Encode(mesh, Encoding::Web), "\n", " 255 0 0\n")).Grid, expected.Grid);
  // One record over several lines.
  ExpectSameGrid(
    ReadBytes(Replace(Replace(plain, "2 2 \n", "2\n2\n"), " 0 ", "\n0\n")).Grid, expected.Grid);
}

//------------------------------------------------------------------------------
// If this fails, coordinates lose bits, or depend on the user's language.
TEST(VisfReader, ReadsNumbersExactly)
{
  const std::string head = "2 0\n7\n";
  const std::string text = head +
    "0.1 1e-45 3.4028235e38\n+1.5 -.5 5.\n1.0D+00 1d-1 2.E2\n"
    "16777217 33554435 0.500000029802322388\n1.17549430e-38 7e-46 1e39\nnan inf -INF\n-0 0 "
    "1e-400\n";
  const float expected[] = { 0.1f, 1e-45f, 3.4028235e38f, 1.5f, -.5f, 5.f, 1.f, .1f, 200.f,
    16777216.f, 33554436.f, 0.50000006f, 1.17549430e-38f, 0.f, INFINITY, NAN, INFINITY, -INFINITY,
    -0.f, 0.f, 0.f };
  const Result result = ReadBytes(text);
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  for (int i = 0; i < 21; ++i)
  {
    const auto value =
      static_cast<float>(result.Grid->GetPoints()->GetData()->GetComponent(i / 3, i % 3));
    if (std::isnan(expected[i]))
    {
      EXPECT_TRUE(std::isnan(value));
      continue;
    }
    EXPECT_EQ(value, expected[i]) << i;
    EXPECT_EQ(std::signbit(value), std::signbit(expected[i])) << i;
  }
  ASSERT_EQ(result.Warnings.size(), 1u); // 1e39 overflows; nan and inf
  EXPECT_NE(result.Warnings[0].find("2 points with a coordinate that is not finite, the first is "
                                    "point 4 (counted from 0)"),
    std::string::npos);
}

//------------------------------------------------------------------------------
// If this fails, a contradiction between header and content is not reported, or is refused.
TEST(VisfReader, WarnsOfOddHeaders)
{
  VisfMesh mesh = MakeTetrahedron();
  mesh.Type = 0;
  Result result = ReadMesh(mesh, Encoding::Little03);
  EXPECT_EQ(result.Grid->GetNumberOfCells(), 1);
  ASSERT_EQ(result.Warnings.size(), 1u);
  EXPECT_NE(result.Warnings[0].find("polyhedron mesh (2)"), std::string::npos);

  for (const Encoding encoding : Encodings)
  {
    result = ReadBytes(Encode(MakeBar(2), encoding) + "more");
    EXPECT_EQ(result.Grid->GetNumberOfCells(), 2);
    EXPECT_EQ(result.Warnings.size(), 1u);
  }
  // No polygons: the flag may be there or not.
  for (const char* tail : { "0\n", "0\n0\n", "0\n0\n0\n" })
  {
    result = ReadBytes(std::string("2 0\n1\n1 2 3\n") + tail);
    EXPECT_EQ(result.Grid->GetNumberOfCells(), 1);
    EXPECT_TRUE(result.Warnings.empty());
  }
  result = ReadBytes("2 0\n1\n1 2 3\n0\n0\n7\n");
  EXPECT_EQ(result.Warnings.size(), 1u);
}

//------------------------------------------------------------------------------
// If this fails, the faces of a file with polyhedra are not those that MeshTopology would find.
TEST(VisfReader, HandsOverTheRightFaces)
{
  for (const int wedges : { 0, 2 })
  {
    VisfMesh mesh = MakeBar(6, wedges);
    std::reverse(mesh.Polyhedra[3].begin(), mesh.Polyhedra[3].end());
    // A face listed twice, once for each of its cells.
    const std::int32_t twin = mesh.Polyhedra.back().front();
    mesh.Polygons.push_back(mesh.Polygons[twin]);
    mesh.Polyhedra.back().front() = static_cast<std::int32_t>(mesh.Polygons.size() - 1);
    const Result result = ReadMesh(mesh, Encoding::Ascii);
    auto copy = vtkSmartPointer<vtkUnstructuredGrid>::New();
    copy->DeepCopy(result.Grid);
    const FacetTable& given = MeshTopology(result.Grid).GetFaces();
    const FacetTable& found = MeshTopology(copy).GetFaces();
    ASSERT_EQ(given.GetNumberOfFacets(), found.GetNumberOfFacets());
    for (vtkIdType cell = 0; cell < result.Grid->GetNumberOfCells(); ++cell)
    {
      for (Index f = 0; f < found.GetCellFacets(cell).size(); ++f)
      {
        EXPECT_EQ(given.GetCellFacets(cell)[f].Packed, found.GetCellFacets(cell)[f].Packed);
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, arrays are larger than necessary: every entry must be used, in 32 bits.
TEST(VisfReader, ArraysAreExact)
{
  const Result result = ReadMesh(MakeBar(9, 4), Encoding::Little03);
  vtkCellArray* const lists[] = { result.Grid->GetCells(), result.Grid->GetPolyhedronFaces(),
    result.Grid->GetPolyhedronFaceLocations() };
  for (vtkCellArray* list : lists)
  {
    EXPECT_FALSE(list->IsStorage64Bit());
    EXPECT_EQ(list->GetConnectivityArray()->GetSize(), list->GetNumberOfConnectivityIds());
    EXPECT_EQ(list->GetOffsetsArray()->GetSize(), list->GetNumberOfCells() + 1);
  }
  EXPECT_EQ(result.Grid->GetPoints()->GetData()->GetSize(), 3 * result.Grid->GetNumberOfPoints());
  // No face belongs to two cells.
  EXPECT_EQ(result.Grid->GetPolyhedronFaces()->GetNumberOfCells(),
    result.Grid->GetPolyhedronFaceLocations()->GetNumberOfConnectivityIds());
}

//------------------------------------------------------------------------------
// If this fails, an aborted reader leaves half a mesh, or does not stop.
TEST(VisfReader, StopsWhenAsked)
{
  const File file(Encode(MakeBar(50000), Encoding::Little03));
  vtkNew<vtkVisfReader> reader;
  reader->SetFileName(file.Path.c_str());
  int reports = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&reports);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  reader->AddObserver(vtkCommand::ProgressEvent, count);
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 50000);
  EXPECT_GT(reports, 10);
  EXPECT_LT(reports, 150);

  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkVisfReader*>(caller)->SetAbortExecuteAndUpdateTime(); });
  reader->AddObserver(vtkCommand::ProgressEvent, stop);
  reader->Modified();
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
}

//------------------------------------------------------------------------------
// If this fails, files of other programs do not open. Numbers are from an independent counter.
TEST(VisfReader, CollectedFiles)
{
  CAMARON_NEEDS_SHARED_DATA("visf");
  const std::string folder = GetSharedData("visf").string();
  using Counts = std::map<int, vtkIdType>;
  const Counts mixed = { { VTK_TETRA, 60 }, { VTK_PYRAMID, 60 }, { VTK_WEDGE, 60 },
    { VTK_HEXAHEDRON, 60 } };
  const Counts quads = { { VTK_QUAD, 6 } };
  const struct
  {
    const char* Name;
    vtkIdType Points;
    Counts Cells;
  } files[] = {
    { "camaron_ascii", 8, { { VTK_HEXAHEDRON, 1 } } },
    { "camaron_big_endian", 8, quads },
    { "camaron_hr3", 414, { { VTK_TETRA, 32 }, { VTK_PYRAMID, 68 }, { VTK_HEXAHEDRON, 256 } } },
    { "camaron_little_endian", 8, quads },
    { "camaron_old_v01_headerless", 8, quads },
    { "camaron_polyhedron_mesh", 8, { { VTK_HEXAHEDRON, 1 } } },
    { "camaron_vertex_cloud", 8, { { VTK_VERTEX, 8 } } },
    { "dev_cloud_v03_big", 231, { { VTK_VERTEX, 231 } } },
    { "dev_mixed_ascii_crlf_comments", 331, mixed },
    { "dev_mixed_ascii_web_dialect", 331, mixed },
    { "dev_mixed_v01_headerless", 331, mixed },
    { "dev_mixed_v02_big", 331, mixed },
    { "dev_mixed_v02_little", 331, mixed },
    { "dev_mixed_v03_big", 331, mixed },
    { "dev_mixed_v03_little_noneigh", 331, mixed },
    { "dev_surface_v03_big", 231, { { VTK_QUAD, 202 }, { VTK_POLYGON, 18 } } },
    { "polylla_basic", 8, { { VTK_POLYHEDRON, 1 } } },
    { "polylla_minimal_dupfaces", 8, { { VTK_POLYHEDRON, 1 }, { VTK_TRIANGLE, 4 } } },
    { "polylla_socket_dupfaces", 836,
      { { VTK_POLYHEDRON, 304 }, { VTK_TETRA, 55 }, { VTK_TRIANGLE, 1926 } } },
  };
  for (const auto& file : files)
  {
    const auto path = std::filesystem::path(folder) / (std::string(file.Name) + ".visf");
    vtkNew<vtkVisfReader> reader;
    EXPECT_EQ(reader->CanReadFile(path.string().c_str()), 1) << file.Name;
    const Result result = ReadFile(path.string());
    EXPECT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_EQ(result.Grid->GetNumberOfPoints(), file.Points) << file.Name;
    Counts counts;
    for (vtkIdType cell = 0; cell < result.Grid->GetNumberOfCells(); ++cell)
    {
      ++counts[result.Grid->GetCellType(cell)];
      if (result.Grid->GetCell(cell)->GetCellDimension() == 3 && result.Warnings.empty())
      {
        EXPECT_GT(GetMeasure(result.Grid, cell), 0) << file.Name << " cell " << cell;
      }
    }
    EXPECT_EQ(counts, file.Cells) << file.Name;
  }
}
