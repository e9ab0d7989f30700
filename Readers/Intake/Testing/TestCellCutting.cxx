// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The triangles and tetrahedra that writers cut cells into.
#include "CellConversionTesting.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace camaron;
using namespace camaron::testing;

//------------------------------------------------------------------------------
// If this fails, a point in the middle of an edge of a polyhedron is lost without a word.
TEST(CellCutting, TellsOfPointsThatCuttingLoses)
{
  const Grid grid =
    MakePolyhedra(MakePoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.5, 0, 0 } }),
      { { { 0, 2, 1, 4 }, { 0, 4, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } } });
  const Converted result = Convert(grid, { VTK_TETRA }, UnsupportedCells::Convert);
  ASSERT_TRUE(result.Success);
  EXPECT_EQ(result.Mesh.GetNumberOfCells(), 1);
  EXPECT_EQ(result.Mesh.GetNumberOfPoints(), 4);
  const std::vector<std::string>& sentences = result.Warned.GetSentences();
  EXPECT_EQ(
    std::count(sentences.begin(), sentences.end(), "1 point omitted, used by no written cell"), 1);
}

//------------------------------------------------------------------------------
// A fan would cover the gap between the teeth and turn triangles over.
TEST(CellCutting, CutsConcavePolygons)
{
  for (const bool reversed : { false, true })
  {
    Grid grid = MakeComb();
    if (reversed)
    {
      grid->GetCells()->ReverseCellAtId(0);
    }
    const Converted result = Convert(grid, { VTK_TRIANGLE }, UnsupportedCells::Convert);
    ASSERT_EQ(result.Mesh.GetNumberOfCells(), 4);
    double area = 0;
    for (vtkIdType cell = 0; cell < 4; ++cell)
    {
      const Ids t = result.Get(cell);
      const Vector normal =
        Cross(result.Place(t[1]) - result.Place(t[0]), result.Place(t[2]) - result.Place(t[0]));
      EXPECT_GT(reversed ? -normal.Z : normal.Z, 0);
      area += std::abs(normal.Z) / 2;
    }
    // The shoelace formula.
    EXPECT_DOUBLE_EQ(area, 9);
    EXPECT_EQ(result.GetWarnings(), "1 cell of type polygon cut into triangles: cell 0\n");
  }
  // Quadrilaterals that are concave at either end of a diagonal.
  for (int turn = 0; turn < 4; ++turn)
  {
    const Points dart = { { 0, 0, 0 }, { 2, 0, 0 }, { .5, .5, 0 }, { 0, 2, 0 } };
    Points turned;
    for (int i = 0; i < 4; ++i)
    {
      turned.push_back(dart[(i + turn) % 4]);
    }
    const Grid grid = MakeGrid(turned, { { VTK_QUAD, { 0, 1, 2, 3 } } });
    const Converted result = Convert(grid, { VTK_TRIANGLE }, UnsupportedCells::Convert);
    for (vtkIdType cell = 0; cell < 2; ++cell)
    {
      const Ids t = result.Get(cell);
      EXPECT_GT(
        Cross(result.Place(t[1]) - result.Place(t[0]), result.Place(t[2]) - result.Place(t[0])).Z,
        0);
    }
  }
}

//------------------------------------------------------------------------------
// Large coordinates, and polygons of no shape at all, must not stop a conversion.
TEST(CellCutting, CutsOddPolygons)
{
  Points far;
  for (const Point& x : MakeRegularPolygon(7, 0))
  {
    far.push_back({ x[0] + 1e7, x[1] - 1e7, 5e6 });
  }
  const Ids all = { 0, 1, 2, 3, 4, 5, 6 };
  Converted result =
    Convert(MakeGrid(far, { { VTK_POLYGON, all } }), { VTK_TRIANGLE }, UnsupportedCells::Convert);
  EXPECT_EQ(result.Mesh.GetNumberOfCells(), 5);
  const Grid point = MakeGrid(Points(7, Point{ 1, 2, 3 }), { { VTK_POLYGON, all } });
  result = Convert(point, { VTK_TRIANGLE }, UnsupportedCells::Convert);
  EXPECT_EQ(result.Mesh.GetNumberOfCells(), 5);
  EXPECT_NE(result.GetWarnings().find("which are triangulated arbitrarily"), std::string::npos);
}

//------------------------------------------------------------------------------
// Volumes show that nothing is missing, duplicated or inverted.
TEST(CellCutting, CutsCellsIntoTetrahedra)
{
  const Grid grid = MakeAllStandardCells();
  const double triangle = std::sqrt(3.0) / 4;
  const double pentagon = std::sqrt(25 + 10 * std::sqrt(5.0)) / 4;
  const std::map<int, double> volumes = { { VTK_TETRA, 1. / 6 }, { VTK_VOXEL, 1 },
    { VTK_HEXAHEDRON, 1 }, { VTK_WEDGE, .5 }, { VTK_PYRAMID, 1. / 3 },
    { VTK_PENTAGONAL_PRISM, pentagon }, { VTK_HEXAGONAL_PRISM, 6 * triangle } };
  for (const Grid& mesh : { grid, ToPolyhedra(grid) })
  {
    const Converted result = Convert(mesh, { VTK_TETRA }, UnsupportedCells::Convert);
    ASSERT_TRUE(result.Success);
    std::map<int, double> found;
    for (vtkIdType cell = 0; cell < result.Mesh.GetNumberOfCells(); ++cell)
    {
      EXPECT_GT(result.GetVolume(cell), 0);
      found[grid->GetCellType(result.Mesh.GetInputCell(cell))] += result.GetVolume(cell);
    }
    for (const auto& volume : volumes)
    {
      EXPECT_NEAR(found[volume.first], volume.second, 1e-12) << volume.first;
    }
    EXPECT_EQ(result.GetWarnings().find("positive volume"), std::string::npos);
  }
}

//------------------------------------------------------------------------------
// Neighbors must cut their common faces in the same way, whatever their types.
TEST(CellCutting, CutsFacesOnce)
{
  for (const bool asPolyhedra : { false, true })
  {
    const Grid grid = MakeHexahedra(5, 4, 3, asPolyhedra);
    // Ids in no particular order, so that smallest ids are anywhere in a cell.
    vtkNew<vtkPoints> points;
    const vtkIdType n = grid->GetNumberOfPoints();
    points->SetNumberOfPoints(n);
    const auto shuffle = [n](vtkIdType id) { return (id * 37 + 11) % n; };
    ASSERT_EQ(n % 37 == 0, false);
    Cells cells;
    for (vtkIdType id = 0; id < n; ++id)
    {
      points->SetPoint(shuffle(id), grid->GetPoint(id));
    }
    std::vector<Faces> polyhedra;
    const auto turned = Grid::New();
    turned->SetPoints(points);
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      polyhedra.push_back(GetFaces(grid, cell));
      for (Ids& face : polyhedra.back())
      {
        std::transform(face.begin(), face.end(), face.begin(), shuffle);
      }
      if (!asPolyhedra)
      {
        Ids ids(
          grid->GetCell(cell)->GetPointIds()->begin(), grid->GetCell(cell)->GetPointIds()->end());
        std::transform(ids.begin(), ids.end(), ids.begin(), shuffle);
        turned->InsertNextCell(VTK_HEXAHEDRON, 8, ids.data());
      }
    }
    const Grid mesh = asPolyhedra ? MakePolyhedra(points, polyhedra) : turned;
    const Converted result = Convert(mesh, { VTK_TETRA }, UnsupportedCells::Convert);
    EXPECT_NEAR(result.GetVolume(), 60, 1e-9);
    std::map<std::set<vtkIdType>, int> uses;
    for (vtkIdType cell = 0; cell < result.Mesh.GetNumberOfCells(); ++cell)
    {
      const Ids t = result.Get(cell);
      for (int skip = 0; skip < 4; ++skip)
      {
        std::set<vtkIdType> face(t.begin(), t.end());
        face.erase(t[skip]);
        ++uses[face];
      }
    }
    int open = 0;
    for (const auto& use : uses)
    {
      ASSERT_LE(use.second, 2);
      open += use.second == 1;
    }
    EXPECT_EQ(open, 2 * 2 * (5 * 4 + 4 * 3 + 3 * 5));
  }
}

//------------------------------------------------------------------------------
// An inspector must still find them after a conversion.
TEST(CellCutting, WarnsOfInvertedTetrahedra)
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
                               { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } },
    { { VTK_HEXAHEDRON, { 4, 5, 6, 7, 0, 1, 2, 3 } } });
  const Converted result = Convert(grid, { VTK_TETRA }, UnsupportedCells::Convert);
  EXPECT_NEAR(result.GetVolume(), -1, 1e-12);
  EXPECT_NE(
    result.GetWarnings().find("of their tetrahedra, 6 have no positive volume"), std::string::npos)
    << result.GetWarnings();
}

//------------------------------------------------------------------------------
// Polyhedra whose faces contradict each other can only be judged by their volume.
TEST(CellCutting, CutsInconsistentPolyhedra)
{
  Faces faces = GetFaces(MakeStandardCell(VTK_HEXAHEDRON), 0);
  std::reverse(faces[1].begin(), faces[1].end());
  std::reverse(faces[4].begin(), faces[4].end());
  const Grid cube = MakeStandardCell(VTK_HEXAHEDRON);
  const Grid grid = MakePolyhedra(cube->GetPoints(), { faces });
  const Converted result = Convert(grid, { VTK_TETRA }, UnsupportedCells::Convert);
  EXPECT_NEAR(result.GetVolume(), 1, 1e-12);
  EXPECT_EQ(result.GetWarnings().find("positive volume"), std::string::npos);
}

//------------------------------------------------------------------------------
// Two cubes that meet at an edge contradict nothing: what lies behind the apex is negative, and
// told.
TEST(CellCutting, CutsPolyhedraThatMeetThemselves)
{
  Points points;
  for (const double x : { 0, 1, 2 })
  {
    for (const double y : { 0, 1, 2 })
    {
      points.push_back({ x, y, 0 });
      points.push_back({ x, y, 1 });
    }
  }
  const auto addCube = [](vtkIdType low, Faces& faces)
  {
    const vtkIdType z = 1, y = 2, x = 6; // steps
    faces.push_back({ low, low + y, low + x + y, low + x });
    faces.push_back({ low + z, low + x + z, low + x + y + z, low + y + z });
    faces.push_back({ low, low + x, low + x + z, low + z });
    faces.push_back({ low + y, low + y + z, low + x + y + z, low + x + y });
    faces.push_back({ low, low + z, low + y + z, low + y });
    faces.push_back({ low + x, low + x + y, low + x + y + z, low + x + z });
  };
  Faces faces;
  addCube(2, faces);
  addCube(6, faces);
  const Grid grid = MakePolyhedra(MakePoints(points), { faces });
  const Converted result = Convert(grid, { VTK_TETRA }, UnsupportedCells::Convert);
  EXPECT_NEAR(result.GetVolume(), 2, 1e-12);
  EXPECT_NE(result.GetWarnings().find("have no positive volume"), std::string::npos)
    << result.GetWarnings();
}
