// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Fluent files: what becomes of them in every encoding.
#include "FluentMeshReading.h"
#include "FluentMeshSamples.h"
#include "vtkFluentMeshReader.h"

#include "Mesh/MeshTopology.h"

#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"
#include "vtk_zlib.h"

#include <random>

using namespace camaron;
using namespace camaron::testing;

namespace
{
Result ReadBytes(const std::string& bytes, const std::string& name = "test.msh")
{
  return ReadWith<vtkFluentMeshReader>(File(bytes, name).Path);
}

//------------------------------------------------------------------------------
// The nodes of a cell, and for 2D cells and polyhedra the way around, as sets that can be compared.
std::vector<vtkIdType> GetSortedPoints(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  const IndexRange points = MeshView(grid).GetCellPoints(cell);
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < points.Size; ++i)
  {
    ids.push_back(points[i]);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

//------------------------------------------------------------------------------
std::string Gzip(const std::string& bytes)
{
  constexpr int GzipFormat = 16;
  z_stream stream = {};
  EXPECT_EQ(
    deflateInit2(&stream, 9, Z_DEFLATED, MAX_WBITS + GzipFormat, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string packed(deflateBound(&stream, static_cast<uLong>(bytes.size())) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(&packed[0]);
  stream.avail_out = static_cast<uInt>(packed.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

//------------------------------------------------------------------------------
// A cube of hexahedra.
FluentSample MakeHexahedra(int size)
{
  FluentSample mesh;
  const auto point = [size](int i, int j, int k) { return i + (size + 1) * (j + (size + 1) * k); };
  for (int p = 0; p < (size + 1) * (size + 1) * (size + 1); ++p)
  {
    mesh.AddPoint(p % (size + 1), p / (size + 1) % (size + 1), p / ((size + 1) * (size + 1)));
  }
  for (int i = 0; i < size; ++i)
  {
    for (int j = 0; j < size; ++j)
    {
      for (int k = 0; k < size; ++k)
      {
        mesh.AddVTKCell(4, VTK_HEXAHEDRON,
          { point(i, j, k), point(i + 1, j, k), point(i + 1, j + 1, k), point(i, j + 1, k),
            point(i, j, k + 1), point(i + 1, j, k + 1), point(i + 1, j + 1, k + 1),
            point(i, j + 1, k + 1) });
      }
    }
  }
  return mesh;
}

//------------------------------------------------------------------------------
// Cubes of six tetrahedra along a line.
FluentSample MakeTetrahedra(int size)
{
  FluentSample mesh;
  for (int p = 0; p < 4 * (size + 1); ++p)
  {
    mesh.AddPoint(p / 4, p % 2, p / 2 % 2);
  }
  // Along the edges of the cube from its first to its last corner.
  const int steps[6][2] = { { 4, 1 }, { 1, 2 }, { 2, 4 }, { 1, 4 }, { 2, 1 }, { 4, 2 } };
  for (int i = 0; i < size; ++i)
  {
    for (const auto& step : steps)
    {
      const int a = 4 * i, b = a + step[0], c = b + step[1];
      mesh.AddVTKCell(2, VTK_TETRA, { a, b, c, a + 7 });
    }
  }
  return mesh;
}

//------------------------------------------------------------------------------
// Polyhedra; if they are pairs, they need not be in one part, and may have a face on both sides.
FluentSample MakePolyhedra(int columns, bool arePairs)
{
  FluentSample mesh = MakeMixed(columns);
  if (arePairs)
  {
    mesh.Cells.resize((mesh.Cells.size() + 1) / 2);
    for (FluentSample::Face& face : mesh.Faces)
    {
      for (int& cell : face.Cells)
      {
        cell = cell < 0 ? cell : cell / 2;
      }
    }
  }
  for (FluentSample::Cell& cell : mesh.Cells)
  {
    cell.Element = 7;
  }
  return mesh;
}

const std::map<int, int> TypesOf3D = { { 2, VTK_TETRA }, { 4, VTK_HEXAHEDRON }, { 5, VTK_PYRAMID },
  { 6, VTK_WEDGE }, { 7, VTK_POLYHEDRON } };
}

//------------------------------------------------------------------------------
// If this fails, some encoding gives other points, types, nodes or faces than the file has.
TEST(FluentMeshReader, ReadsEveryEncoding)
{
  const FluentSample mesh = MakeMixed();
  for (const FluentEncoding& how : GetEncodings())
  {
    const Result result = ReadBytes(Encode(mesh, how));
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_TRUE(result.Warnings.empty());
    vtkUnstructuredGrid* grid = result.Grid;
    ASSERT_EQ(grid->GetNumberOfPoints(), static_cast<vtkIdType>(mesh.Points.size()));
    ASSERT_EQ(grid->GetNumberOfCells(), static_cast<vtkIdType>(mesh.Cells.size()));
    EXPECT_EQ(grid->GetPoints()->GetDataType(), how.RealSize == 4 ? VTK_FLOAT : VTK_DOUBLE);
    for (std::size_t i = 0; i < mesh.Points.size(); ++i)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        const double x = mesh.Points[i][c];
        EXPECT_EQ(grid->GetPoint(static_cast<vtkIdType>(i))[c],
          how.RealSize == 4 ? static_cast<float>(x) : x);
      }
    }
    vtkDataArray* zones = grid->GetCellData()->GetArray("Zone");
    ASSERT_NE(zones, nullptr);
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      const FluentSample::Cell& expected = mesh.Cells[static_cast<std::size_t>(cell)];
      EXPECT_EQ(grid->GetCellType(cell), TypesOf3D.at(expected.Element)) << cell;
      EXPECT_EQ(GetFaceSet(grid, cell), GetFaceSet(mesh, static_cast<int>(cell))) << cell;
      EXPECT_GT(GetMeasure(grid, cell), 0.05) << cell;
      EXPECT_EQ(zones->GetTuple1(cell), expected.Zone);
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, an inverted element is silently repaired, or a good one inverted.
TEST(FluentMeshReader, InvertedCellsStayInverted)
{
  FluentSample mesh = MakeMixed(1);
  for (auto& point : mesh.Points)
  {
    point[0] = -point[0];
  }
  for (const FluentEncoding& how : GetEncodings())
  {
    const Result result = ReadBytes(Encode(mesh, how));
    ASSERT_TRUE(result.Errors.empty());
    for (vtkIdType cell = 0; cell < result.Grid->GetNumberOfCells(); ++cell)
    {
      EXPECT_LT(GetMeasure(result.Grid, cell), -0.05) << cell;
    }
  }
  FluentSample flat = MakeFlat();
  for (auto& point : flat.Points)
  {
    point[1] = -point[1];
  }
  const Result result = ReadBytes(Encode(flat));
  ASSERT_TRUE(result.Errors.empty());
  for (vtkIdType cell = 0; cell < result.Grid->GetNumberOfCells(); ++cell)
  {
    EXPECT_LT(GetMeasure(result.Grid, cell), -0.1) << cell;
  }
}

//------------------------------------------------------------------------------
// If this fails, polyhedra are taken for something simpler, or simple cells of unknown type are not
// recognised, or a wrong type is believed.
TEST(FluentMeshReader, TheDeclaredTypeDecides)
{
  FluentSample mesh = MakeMixed(2);
  const FluentSample original = mesh;
  for (const int element : { 7, 0 })
  {
    for (FluentSample::Cell& cell : mesh.Cells)
    {
      cell.Element = element;
    }
    for (const FluentEncoding& how : GetEncodings())
    {
      const Result result = ReadBytes(Encode(mesh, how));
      ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
      EXPECT_TRUE(result.Warnings.empty());
      for (vtkIdType cell = 0; cell < result.Grid->GetNumberOfCells(); ++cell)
      {
        EXPECT_EQ(result.Grid->GetCellType(cell),
          TypesOf3D.at(element == 7 ? 7 : original.Cells[static_cast<std::size_t>(cell)].Element));
        EXPECT_EQ(GetFaceSet(result.Grid, cell), GetFaceSet(mesh, static_cast<int>(cell)));
      }
    }
  }
  // A hexahedron that is declared a tetrahedron, and a wedge that is declared a pyramid.
  mesh = original;
  mesh.Cells[0].Element = 2;
  mesh.Cells[1].Element = 5;
  const Result result = ReadBytes(Encode(mesh));
  ASSERT_TRUE(result.Errors.empty());
  ASSERT_EQ(result.Warnings.size(), 1u);
  EXPECT_NE(result.Warnings[0].find("2 cells whose faces are not those of the declared type"),
    std::string::npos)
    << result.Warnings[0];
  for (vtkIdType cell = 0; cell < result.Grid->GetNumberOfCells(); ++cell)
  {
    EXPECT_EQ(result.Grid->GetCellType(cell),
      cell < 2 ? VTK_POLYHEDRON
               : TypesOf3D.at(original.Cells[static_cast<std::size_t>(cell)].Element));
    EXPECT_EQ(GetFaceSet(result.Grid, cell), GetFaceSet(mesh, static_cast<int>(cell)));
  }
}

//------------------------------------------------------------------------------
TEST(FluentMeshReader, ReadsFlatMeshes)
{
  FluentSample mesh = MakeFlat(7);
  std::vector<int> circle; // a polygon of more edges than are tried one by one
  for (int i = 0; i < 40; ++i)
  {
    circle.push_back(mesh.AddPoint(20 + std::cos(i * 0.157), std::sin(i * 0.157)));
  }
  mesh.AddPolygon(7, circle);
  for (FluentEncoding how : GetEncodings())
  {
    for (const bool hasDimension : { true, false })
    {
      how.HasDimension = hasDimension;
      const Result result = ReadBytes(Encode(mesh, how));
      ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
      EXPECT_TRUE(result.Warnings.empty());
      for (vtkIdType cell = 0; cell < result.Grid->GetNumberOfCells(); ++cell)
      {
        const int element = mesh.Cells[static_cast<std::size_t>(cell)].Element;
        EXPECT_EQ(result.Grid->GetCellType(cell),
          element == 1     ? VTK_TRIANGLE
            : element == 3 ? VTK_QUAD
                           : VTK_POLYGON);
        EXPECT_GT(GetMeasure(result.Grid, cell), 0.4) << cell;
        EXPECT_EQ(result.Grid->GetPoint(cell)[2], 0);
      }
      EXPECT_EQ(GetSortedPoints(result.Grid, 0), (std::vector<vtkIdType>{ 0, 1, 2, 3 }));
    }
  }
  // Edges that make no ring: the cell is there, but empty.
  mesh = MakeFlat(1);
  mesh.Faces[1].Nodes = { 0, 3 };
  const Result result = ReadBytes(Encode(mesh));
  ASSERT_TRUE(result.Errors.empty());
  EXPECT_EQ(result.Grid->GetCellType(0), VTK_EMPTY_CELL);
  ASSERT_EQ(result.Warnings.size(), 1u);
  EXPECT_NE(result.Warnings[0].find("no ring"), std::string::npos);
}

//------------------------------------------------------------------------------
namespace
{
// A cube beside four slabs that were refined; the face between is split. Without parents, it has
// nine faces.
std::string MakeHanging(bool withTree, int element, const FluentEncoding& how = {})
{
  FluentSample mesh;
  std::vector<int> cube;
  for (int i = 0; i < 8; ++i)
  {
    cube.push_back(mesh.AddPoint((i & 1) ^ (i >> 1 & 1), i >> 1 & 1, i >> 2));
  }
  // Places (y, z) of a 3 x 3 grid on the side x = 1 and behind it.
  int front[3][3], back[3][3];
  for (int y = 0; y < 3; ++y)
  {
    for (int z = 0; z < 3; ++z)
    {
      const bool isCorner = y != 1 && z != 1;
      front[y][z] = isCorner ? cube[static_cast<std::size_t>((y == 0 ? 1 : 2) + (z == 0 ? 0 : 4))]
                             : mesh.AddPoint(1, y / 2., z / 2.);
      back[y][z] = mesh.AddPoint(1.5, y / 2., z / 2.);
    }
  }
  std::vector<std::vector<int>> faces = { { cube[0], cube[4], cube[7], cube[3] },
    { cube[0], cube[1], cube[5], cube[4] }, { cube[3], cube[7], cube[6], cube[2] },
    { cube[0], cube[3], cube[2], cube[1] }, { cube[4], cube[5], cube[6], cube[7] } };
  for (int y = 0; y < 2; ++y)
  {
    for (int z = 0; z < 2; ++z)
    {
      faces.push_back({ front[y][z], front[y + 1][z], front[y + 1][z + 1], front[y][z + 1] });
    }
  }
  mesh.AddCell(element, faces);
  for (int y = 0; y < 2; ++y)
  {
    for (int z = 0; z < 2; ++z)
    {
      mesh.AddVTKCell(4, VTK_HEXAHEDRON,
        { front[y][z], back[y][z], back[y + 1][z], front[y + 1][z], front[y][z + 1], back[y][z + 1],
          back[y + 1][z + 1], front[y + 1][z + 1] });
    }
  }
  std::string bytes;
  if (withTree)
  {
    // The faces between are first; the split one comes last, and is of the parent of the slabs.
    mesh.Cells.push_back({ 4, 9 });
    mesh.BoundaryTypes[8] = 31;
    mesh.Faces.push_back({ { cube[1], cube[5], cube[6], cube[2] }, { 0, 5 }, 8 });
    bytes = Encode(mesh, how);
    const std::string parent = "12 (9 6 6 1 4)", inactive = "12 (9 6 6 20 4)";
    bytes.replace(bytes.find(parent), parent.size(), inactive);
    std::string last;
    AppendHex(last, mesh.Faces.size());
    if (how.RealSize > 0)
    {
      const auto face = static_cast<int>(mesh.Faces.size());
      FluentWords words(bytes, how);
      words.Open(59, { face, face, 8, 3 });
      for (const int word : { 4, 1, 2, 3, 4 })
      {
        words.Integer(word, false);
      }
      words.Close();
      return bytes;
    }
    return bytes + "(59 (" + last + " " + last +
      " 8 3)(\n4 1 2 3 4\n))\n(58 (6 6 9 2)(\n4 2 3 4 5\n))\n";
  }
  return Encode(mesh);
}
}

//------------------------------------------------------------------------------
// If this fails, a cell beside refined ones is not the hexahedron that it is, or parents are shown.
TEST(FluentMeshReader, ReadsHangingNodes)
{
  const Result joined = ReadBytes(MakeHanging(true, 4));
  ASSERT_TRUE(joined.Errors.empty()) << joined.Errors[0];
  EXPECT_TRUE(joined.Warnings.empty()) << joined.Warnings[0];
  EXPECT_EQ(Count(joined.Grid, VTK_HEXAHEDRON), 5);
  EXPECT_EQ(joined.Grid->GetNumberOfCells(), 5);
  EXPECT_NEAR(GetMeasure(joined.Grid, 0), 1, 1e-12);
  EXPECT_EQ(joined.Grid->GetCellData()->GetArray("OriginalCellId"), nullptr);

  for (const FluentEncoding& how : GetEncodings())
  {
    const Result encoded = ReadBytes(MakeHanging(true, 4, how));
    ASSERT_TRUE(encoded.Errors.empty()) << encoded.Errors[0];
    EXPECT_EQ(Count(encoded.Grid, VTK_HEXAHEDRON), 5);
  }

  const Result open = ReadBytes(MakeHanging(false, 4));
  ASSERT_TRUE(open.Errors.empty()) << open.Errors[0];
  EXPECT_EQ(open.Warnings.size(), 1u);
  EXPECT_EQ(open.Grid->GetCellType(0), VTK_POLYHEDRON);
  EXPECT_EQ(Count(open.Grid, VTK_HEXAHEDRON), 4);
  EXPECT_NEAR(GetMeasure(open.Grid, 0), 1, 1e-12);

  const Result polyhedron = ReadBytes(MakeHanging(true, 7));
  ASSERT_TRUE(polyhedron.Errors.empty());
  EXPECT_EQ(polyhedron.Grid->GetCellType(0), VTK_POLYHEDRON);
  EXPECT_EQ(GetFaceSet(polyhedron.Grid, 0).size(), 9u);

  // Parents among the others: ids of cells have a gap.
  std::string bytes = MakeHanging(true, 4);
  const std::string cells = "(12 (2 1 5 1 4))\n(12 (9 6 6 20 4))";
  ASSERT_NE(bytes.find(cells), std::string::npos);
  bytes.replace(bytes.find(cells), cells.size(), "(12 (9 1 1 20 4))\n(12 (2 2 6 1 4))");
  const Result shifted = ReadBytes(bytes);
  ASSERT_TRUE(shifted.Errors.empty());
  ASSERT_NE(shifted.Grid->GetCellData()->GetArray("OriginalCellId"), nullptr);
  EXPECT_EQ(shifted.Grid->GetCellData()->GetArray("OriginalCellId")->GetTuple1(0), 2);
}

//------------------------------------------------------------------------------
// Two triangles above a quadrilateral whose upper edge is split.
TEST(FluentMeshReader, ReadsHangingNodesOfFlatMeshes)
{
  const std::string head = "(2 2)\n(10 (0 1 6 0))\n(12 (0 1 4 0))\n(13 (0 1 9 0))\n(10 (1 1 6 1)(\n"
                           "0 0\n2 0\n2 1\n0 1\n1 1\n1 2\n))\n(12 (2 1 1 1 3))\n(12 (2 2 3 1 1))\n"
                           "(12 (3 4 4 20 1))\n";
  const std::string faces = "(13 (4 1 8 3 2)(\n1 2 1 0\n2 3 1 0\n3 5 1 2\n5 4 1 3\n4 1 1 0\n"
                            "3 6 2 0\n6 5 2 3\n6 4 3 0\n))\n(13 (5 9 9 1f 2)(\n3 4 1 4\n))\n";
  const Result joined = ReadBytes(head + faces + "(59 (9 9 5 4)(2 3 4))");
  ASSERT_TRUE(joined.Errors.empty()) << joined.Errors[0];
  EXPECT_TRUE(joined.Warnings.empty());
  EXPECT_EQ(joined.Grid->GetCellType(0), VTK_QUAD);
  EXPECT_EQ(GetSortedPoints(joined.Grid, 0), (std::vector<vtkIdType>{ 0, 1, 2, 3 }));
  EXPECT_NEAR(GetMeasure(joined.Grid, 0), 2, 1e-12);
  EXPECT_EQ(Count(joined.Grid, VTK_TRIANGLE), 2);
  const Result open = ReadBytes(head + faces);
  ASSERT_TRUE(open.Errors.empty());
  EXPECT_EQ(open.Grid->GetCellType(0), VTK_POLYGON);
  EXPECT_NEAR(GetMeasure(open.Grid, 0), 2, 1e-12);
}

//------------------------------------------------------------------------------
// If this fails, faces where meshes that do not fit meet become faces of cells.
TEST(FluentMeshReader, LeavesOutNonconformalFaces)
{
  FluentSample mesh = MakeMixed(1);
  const auto count = static_cast<vtkIdType>(mesh.Faces.size());
  mesh.BoundaryTypes[20] = 1012;
  mesh.Faces.push_back({ {}, { 0, -1 }, 20 });
  mesh.Faces.push_back({ { 0, 1, 4 }, { 0, 1 }, 20 });
  for (const FluentEncoding& how : GetEncodings())
  {
    const Result result = ReadBytes(Encode(mesh, how));
    if (how.Uniform && how.RealSize >= 0)
    {
      // A section of faces of no nodes does not say so in its header.
      continue;
    }
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_EQ(result.Grid->GetCellType(0), VTK_HEXAHEDRON);
    EXPECT_EQ(result.Grid->GetNumberOfCells(), static_cast<vtkIdType>(mesh.Cells.size()));
  }
  // The same by section 61, whatever their own type is.
  mesh.BoundaryTypes[20] = 3;
  std::string range;
  AppendHex(range, static_cast<std::uint64_t>(count + 1));
  range += " ";
  AppendHex(range, static_cast<std::uint64_t>(count + 2));
  const Result result = ReadBytes(Encode(mesh) + "(61 (" + range + ")(1 2 1 2))\n");
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  EXPECT_EQ(result.Grid->GetCellType(0), VTK_HEXAHEDRON);
}

//------------------------------------------------------------------------------
// If this fails, zones lose their names, or boundaries their faces.
TEST(FluentMeshReader, ReadsZonesAndBoundaries)
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
// If this fails, boundary faces run inward, so that they look dark, or are of other places.
TEST(FluentMeshReader, BoundariesEncloseTheMesh)
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

//------------------------------------------------------------------------------
// If this fails, a section that is not needed hides those that are.
TEST(FluentMeshReader, SkipsOtherSections)
{
  const FluentSample mesh = MakeMixed(1);
  const std::string text = Encode(mesh);
  const Result expected = ReadBytes(text);
  ASSERT_TRUE(expected.Errors.empty());
  const std::string others =
    "(0 \"quoted ))) \\\" (((\")(0 grid written by (someone)\n on two lines)\n"
    "(1 (header) \"x)\")\n(37 ((a 1) (b \"(\") (c ())))\n\n"
    "(64 ())(40 (1 2 3)(4 5 6))\n(18 (1 1 4 4)(\n1 1\n))\n";
  const std::string binary = "(2041 (1 8)\n(\x01((((\x02)))) End of Binary Section 3041) \"x\n"
                             "End of Binary Section   2041)\n";
  for (const std::string& bytes :
    { others + text, text + others, binary + text, text + binary, "\xef\xbb\xbf\n\n" + text })
  {
    const Result result = ReadBytes(bytes);
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    ExpectSameGrid(expected.Grid, result.Grid);
  }
  // A lone quotation mark.
  const Result result = ReadBytes("(0 3\" pipe)\n" + text);
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  ExpectSameGrid(expected.Grid, result.Grid);
  // All on one line, headers in upper case, zones after a body.
  std::string flat = text;
  std::replace(flat.begin(), flat.end(), '\n', ' ');
  const Result onOneLine = ReadBytes(flat);
  ASSERT_TRUE(onOneLine.Errors.empty()) << onOneLine.Errors[0];
  ExpectSameGrid(expected.Grid, onOneLine.Grid);
}

//------------------------------------------------------------------------------
// If this fails, meshes of old programs, which do not declare types of cells, are refused.
TEST(FluentMeshReader, CellsNeedNotBeDeclared)
{
  const std::string text = Encode(MakeMixed(1));
  std::string bytes = text;
  const auto begin = bytes.find("(12 (0 1 ") + 1;
  const auto first = bytes.find("(12 (", begin), last = bytes.find("(13 (3", first);
  ASSERT_NE(last, std::string::npos);
  bytes.erase(first, last - first);
  const Result result = ReadBytes(bytes);
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  EXPECT_EQ(Count(result.Grid, VTK_WEDGE), 2);
  EXPECT_EQ(Count(result.Grid, VTK_TETRA), 1);
  EXPECT_EQ(result.Warnings.size(), 1u);
}

//------------------------------------------------------------------------------
// If this fails, files of writers that are wrong about the order of bytes are refused.
TEST(FluentMeshReader, FindsTheOrderOfBytes)
{
  FluentEncoding how;
  how.RealSize = 8;
  std::string bytes = Encode(MakeMixed(1), how);
  const std::string little = "(4 (60 ", big = "(4 (22 ";
  bytes.replace(bytes.find(little), little.size(), big);
  const Result result = ReadBytes(bytes);
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  ASSERT_EQ(result.Warnings.size(), 1u);
  EXPECT_NE(result.Warnings[0].find("byte order"), std::string::npos);
  EXPECT_GT(GetMeasure(result.Grid, 0), 0);
}

//------------------------------------------------------------------------------
// If this fails, the mesh depends on threads, or on where text is cut for them.
TEST(FluentMeshReader, ThreadsAndChunksChangeNothing)
{
  for (const FluentSample& mesh :
    { MakeMixed(60), MakeFlat(200), MakeTetrahedra(50), MakePolyhedra(60, true) })
  {
    for (const FluentEncoding& how : GetEncodings())
    {
      const File file(Encode(mesh, how), "test.msh");
      vtkNew<vtkUnstructuredGrid> expected;
      Warnings warnings;
      ScanError error;
      ASSERT_TRUE(ReadFluentMesh(file.Path, {}, expected, nullptr, warnings, error, Progress()));
      EXPECT_EQ(expected->GetNumberOfCells(), static_cast<vtkIdType>(mesh.Cells.size()));
      for (const int threads : { 1, 3 })
      {
        for (const vtkIdType chunk : { 50, 1000, 20000 })
        {
          vtkNew<vtkUnstructuredGrid> grid;
          vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, "STDThread", false),
            [&]
            {
              ASSERT_TRUE(
                ReadFluentMesh(file.Path, {}, grid, nullptr, warnings, error, Progress(), chunk))
                << error.Message;
            });
          ExpectSameGrid(expected, grid);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, cells of standard types or polyhedra, which are made while the faces are read, are
// not those that all faces of a cell together lead to: the same file with a tree of split faces,
// even if none is, is read in the other way. Faces come in any order, start anywhere, run either
// way.
TEST(FluentMeshReader, BothWaysFindTheSameNodes)
{
  std::mt19937 random(5);
  const std::string tree = "(59 (1 1 3 3)(0))\n";
  for (FluentSample mesh : { MakeMixed(40), MakeFlat(2), MakeHexahedra(4), MakeTetrahedra(9),
         MakePolyhedra(9, false), MakePolyhedra(9, true) })
  {
    for (int round = 0; round < 20; ++round)
    {
      std::shuffle(mesh.Faces.begin(), mesh.Faces.end(), random);
      for (FluentSample::Face& face : mesh.Faces)
      {
        face.Zone = 9; // one section
        std::rotate(face.Nodes.begin(),
          face.Nodes.begin() + (mesh.Dimension == 3 ? random() % face.Nodes.size() : 0),
          face.Nodes.end());
        if (random() % 2)
        {
          std::reverse(face.Nodes.begin(), face.Nodes.end());
          std::swap(face.Cells[0], face.Cells[1]);
        }
      }
      for (const int size : { 0, 4 })
      {
        FluentEncoding how;
        how.RealSize = size;
        how.Uniform = round % 2 == 1;
        const std::string bytes = Encode(mesh, how);
        const Result standard = ReadBytes(bytes), general = ReadBytes(bytes + tree);
        ASSERT_TRUE(standard.Errors.empty() && general.Errors.empty());
        ExpectSameGrid(standard.Grid, general.Grid);
        EXPECT_TRUE(standard.Warnings.empty());
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, tetrahedra are made of faces that are not theirs: the sums of the ids of nodes
// alone do not show that 1 5 6 is not 3 4 5.
TEST(FluentMeshReader, SumsOfNodesAreNotEnough)
{
  FluentSample mesh;
  for (int p = 0; p < 6; ++p)
  {
    mesh.AddPoint(p % 2, p % 3, p * p);
  }
  mesh.AddVTKCell(2, VTK_TETRA, { 2, 3, 4, 5 });
  ASSERT_EQ(ReadBytes(Encode(mesh)).Grid->GetCellType(0), VTK_TETRA);
  for (FluentSample::Face& face : mesh.Faces)
  {
    std::vector<int> sorted = face.Nodes;
    std::sort(sorted.begin(), sorted.end());
    if (sorted == std::vector<int>{ 2, 3, 4 })
    {
      for (int& node : face.Nodes)
      {
        node = node == 2 ? 0 : node + 1;
      }
    }
  }
  const Result result = ReadBytes(Encode(mesh));
  ASSERT_TRUE(result.Errors.empty());
  EXPECT_EQ(result.Grid->GetCellType(0), VTK_POLYHEDRON);
  ASSERT_EQ(result.Warnings.size(), 1u);
  EXPECT_NE(result.Warnings[0].find("1 cell whose faces are not those of the declared type"),
    std::string::npos)
    << result.Warnings[0];
}

//------------------------------------------------------------------------------
TEST(FluentMeshReader, PiecesMakeTheWhole)
{
  FluentSample orphans = MakeMixed(6);
  orphans.AddPoint(9, 9, 9);
  for (const FluentSample& mesh :
    { orphans, MakePolyhedra(6, false), MakePolyhedra(6, true), MakeFlat(20), MakeTetrahedra(8) })
  {
    for (const int size : { 0, 8 })
    {
      FluentEncoding how;
      how.RealSize = size;
      const File file(Encode(mesh, how), "test.msh");
      ExpectPiecesMakeTheWhole<vtkFluentMeshReader>(file.Path, 3, 0);
      ExpectPiecesMakeTheWhole<vtkFluentMeshReader>(file.Path, 3, 2);
      ExpectPiecesMakeTheWhole<vtkFluentMeshReader>(file.Path, 40, 1);
    }
  }
  const File hanging(MakeHanging(true, 4), "test.msh");
  ExpectPiecesMakeTheWhole<vtkFluentMeshReader>(hanging.Path, 3, 1);
}

//------------------------------------------------------------------------------
// If this fails, evaluation sees other neighbours than the mesh has: faces handed over are wrong.
TEST(FluentMeshReader, HandsOverFaces)
{
  FluentSample mesh = MakeMixed(8);
  for (std::size_t i = 0; i < mesh.Cells.size(); i += 2)
  {
    mesh.Cells[i].Element = 7;
  }
  const File file(Encode(mesh), "test.msh");
  for (const int pieces : { 1, 2 })
  {
    const Result result = ReadWith<vtkFluentMeshReader>(file.Path, pieces - 1, pieces, 1);
    ASSERT_TRUE(result.Errors.empty());
    vtkNew<vtkUnstructuredGrid> copy;
    copy->DeepCopy(result.Grid);
    MeshTopology given(result.Grid), found(copy);
    std::vector<Index> a, b;
    for (vtkIdType cell = 0; cell < copy->GetNumberOfCells(); ++cell)
    {
      given.GetNeighbors(cell, Adjacency::Facet, a);
      found.GetNeighbors(cell, Adjacency::Facet, b);
      EXPECT_EQ(a, b) << cell;
    }
    EXPECT_EQ(given.GetFaces().GetNumberOfFacets(), found.GetFaces().GetNumberOfFacets());
  }
}

//------------------------------------------------------------------------------
// If this fails, compressed files cannot be read, or a small one can fill the memory.
TEST(FluentMeshReader, ReadsCompressedFiles)
{
  const std::string text = Encode(MakeMixed(40));
  const Result expected = ReadBytes(text);
  const std::string packed = Gzip(text);
  const Result result = ReadBytes(packed, "test.msh.gz");
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  ExpectSameGrid(expected.Grid, result.Grid);
  const std::size_t half = text.size() / 2;
  const Result parts =
    ReadBytes(Gzip(text.substr(0, half)) + Gzip(text.substr(half)) + std::string(100, '\0'));
  ASSERT_TRUE(parts.Errors.empty()) << parts.Errors[0];
  ExpectSameGrid(expected.Grid, parts.Grid);
  for (std::size_t size = 3; size < packed.size(); size += 13)
  {
    EXPECT_TRUE(ReadBytes(packed.substr(0, size)).IsProperError()) << size;
  }
  const Result bomb = ReadBytes(Gzip(text + "(0 " + std::string(200 << 20, ' ') + ")"));
  ASSERT_TRUE(bomb.IsProperError());
  EXPECT_NE(bomb.Errors[0].find("inflates more than 100 times"), std::string::npos);
  vtkNew<vtkFluentMeshReader> reader;
  EXPECT_TRUE(reader->CanReadFile(File(packed, "test.cas.gz").Path.c_str()));
  EXPECT_FALSE(reader->CanReadFile(File(Gzip("solid"), "test.cas.gz").Path.c_str()));
}

//------------------------------------------------------------------------------
// If this fails, files of other formats under the same names are claimed, or ours are not.
TEST(FluentMeshReader, KnowsItsFiles)
{
  vtkNew<vtkFluentMeshReader> reader;
  const auto canRead = [&](const std::string& bytes)
  { return reader->CanReadFile(File(bytes, "test.msh").Path.c_str()) == 1; };
  for (const char* bytes : { "(0 \"a comment\")", "\n (2 3)", "(10(0 1 18cf 1))", "(1 \"x\")",
         "(3010 (1 1 2 1 3)", "(37 ((a b)))" })
  {
    EXPECT_TRUE(canRead(bytes)) << bytes;
  }
  for (const char* bytes : { "", "$MeshFormat\n2.2 0 8\n", "\x89HDF\r\n\x1a\n", "5\n1 2 3\n", "(x)",
         "(define a 1)", "(2 4)", "(300 (1 1))", "((10 1))" })
  {
    EXPECT_FALSE(canRead(bytes)) << bytes;
  }
  EXPECT_FALSE(reader->CanReadFile(nullptr));
  EXPECT_FALSE(reader->CanReadFile("/no/such/file.msh"));
}
