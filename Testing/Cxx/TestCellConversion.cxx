// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What writers make of cells that a format cannot hold.
#include "TestMeshes.h"

#include "CellMesh/CellConversion.h"
#include "CellMesh/OutputMesh.h"
#include "Mesh/CellFacets.h"
#include "Mesh/Vector.h"

#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

using namespace camaron;
using namespace camaron::testing;

namespace
{
using Ids = std::vector<vtkIdType>;

//------------------------------------------------------------------------------
struct Converted
{
  OutputMesh Mesh;
  bool Success = false;
  ScanError Error;
  Warnings Warned;

  Ids Get(vtkIdType cell) const
  {
    const IndexRange points = this->Mesh.GetCellPoints(cell);
    Ids ids;
    for (vtkIdType i = 0; i < points.Size; ++i)
    {
      ids.push_back(points[i]);
    }
    return ids;
  }
  Vector Place(vtkIdType point) const
  {
    double x[3];
    this->Mesh.GetPoint(point, x);
    return { x[0], x[1], x[2] };
  }
  double GetVolume(vtkIdType tetrahedron) const
  {
    const Ids t = this->Get(tetrahedron);
    const Vector o = this->Place(t[0]);
    return Dot(Cross(this->Place(t[1]) - o, this->Place(t[2]) - o), this->Place(t[3]) - o) / 6;
  }
  double GetVolume() const
  {
    double volume = 0;
    for (vtkIdType cell = 0; cell < this->Mesh.GetNumberOfCells(); ++cell)
    {
      volume += this->GetVolume(cell);
    }
    return volume;
  }
  std::string GetWarnings() const
  {
    std::string text;
    for (const std::string& sentence : this->Warned.GetSentences())
    {
      text += sentence + "\n";
    }
    return text;
  }
};

//------------------------------------------------------------------------------
Converted Convert(vtkDataSet* mesh, CellTypeSet held,
  UnsupportedCells others = UnsupportedCells::Refuse, SurfaceFaces surface = SurfaceFaces::None)
{
  Converted result;
  CellConversion how{ "Foo", held };
  how.Others = others;
  how.Surface = surface;
  result.Success =
    ConvertCells(mesh, how, "some/where/mesh.foo", result.Mesh, result.Warned, result.Error);
  EXPECT_EQ(result.Success, result.Error.Kind == ErrorKind::None);
  return result;
}

//------------------------------------------------------------------------------
// A concave polygon in the plane z = 0, counter-clockwise: a comb with two teeth.
Grid MakeComb()
{
  return MakeGrid({ { 0, 0, 0 }, { 5, 0, 0 }, { 5, 4, 0 }, { 4, 1, 0 }, { 2, 1, 0 }, { 1, 4, 0 } },
    { { VTK_POLYGON, { 0, 1, 2, 3, 4, 5 } } });
}

//------------------------------------------------------------------------------
Grid MakeAllStandardCells()
{
  Points points;
  Cells cells;
  for (const int type : StandardTypes3D)
  {
    const Grid one = MakeStandardCell(type);
    const auto first = static_cast<vtkIdType>(points.size());
    cells.push_back({ type, {} });
    for (vtkIdType i = 0; i < one->GetNumberOfPoints(); ++i)
    {
      double x[3];
      one->GetPoint(i, x);
      points.push_back({ x[0] + 10.0 * cells.size(), x[1], x[2] });
      cells.back().second.push_back(first + i);
    }
  }
  return MakeGrid(points, cells);
}
}

//------------------------------------------------------------------------------
// Writers of meshes that fit must not pay for a copy.
TEST(CellConversion, IsAViewIfAllCellsAreHeld)
{
  const Grid grid = MakeHexahedra(2, 2, 2, false);
  const Converted result = Convert(grid, { VTK_HEXAHEDRON });
  ASSERT_TRUE(result.Success);
  EXPECT_TRUE(result.Mesh.HasInputCells());
  EXPECT_TRUE(result.Mesh.HasInputPoints());
  EXPECT_EQ(result.Mesh.GetNumberOfCells(), 8);
  EXPECT_EQ(result.Mesh.Count(VTK_HEXAHEDRON), 8);
  EXPECT_EQ(result.Mesh.Count(VTK_TETRA), 0);
  const IndexRange mine = result.Mesh.GetCellPoints(3), theirs = MeshView(grid).GetCellPoints(3);
  EXPECT_EQ(mine.Values.Values32, theirs.Values.Values32);
  EXPECT_EQ(mine.Values.Values64, theirs.Values.Values64);
  EXPECT_TRUE(result.Warned.GetSentences().empty());
}

//------------------------------------------------------------------------------
// A user must learn which cells are in the way and which option helps.
TEST(CellConversion, RefusesByDefault)
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_QUAD, { 0, 1, 2, 3 } },
      { VTK_PYRAMID, { 0, 1, 2, 3, 4 } }, { VTK_QUAD, { 3, 2, 1, 0 } } });
  Converted result = Convert(grid, { VTK_TRIANGLE });
  EXPECT_EQ(result.Error.Kind, ErrorKind::Unsupported);
  EXPECT_EQ(result.Error.Message,
    "mesh.foo: Foo files cannot hold 2 cells of type quad (the first is cell 1) and 1 cell of type "
    "pyramid (cell 2); set Unsupported Cells to Convert to cut them into triangles, or to Skip to "
    "leave them out");
  result = Convert(grid, { VTK_QUAD, VTK_PYRAMID });
  EXPECT_EQ(result.Error.Message,
    "mesh.foo: Foo files cannot hold 1 cell of type triangle (cell 0); set Unsupported Cells to "
    "Skip to leave them out");

  // A file of surfaces holds neither the others nor what they could be cut into.
  const Grid polyhedron =
    MakePolyhedra(MakePoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }),
      { { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } } });
  result = Convert(polyhedron, { VTK_TRIANGLE, VTK_QUAD });
  EXPECT_EQ(result.Error.Message,
    "mesh.foo: Foo files cannot hold 1 cell of type polyhedron (cell 0); write another format, "
    "such "
    "as ParaView's own .vtu, which holds all cells");
}

//------------------------------------------------------------------------------
// What is left out is told, and arrays can follow the rest.
TEST(CellConversion, SkipsOnRequest)
{
  const Grid grid =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 9, 9, 9 }, { 8, 8, 8 } },
      { { VTK_LINE, { 4, 0 } }, { VTK_TETRA, { 0, 1, 2, 3 } } });
  const Converted result = Convert(grid, { VTK_TETRA }, UnsupportedCells::Skip);
  ASSERT_TRUE(result.Success);
  ASSERT_EQ(result.Mesh.GetNumberOfCells(), 1);
  EXPECT_EQ(result.Mesh.GetInputCell(0), 1);
  EXPECT_EQ(
    result.GetWarnings(), "1 cell of type line left out, as Foo files cannot hold them: cell 0\n");
  // Point 4 lost its only cell; point 5 never had one.
  ASSERT_EQ(result.Mesh.GetNumberOfPoints(), 5);
  EXPECT_EQ(result.Mesh.GetInputPoint(4), 5);
  EXPECT_EQ(result.Mesh.GetPointOf(5), 4);
  EXPECT_EQ(result.Get(0), (Ids{ 0, 1, 2, 3 }));
}

//------------------------------------------------------------------------------
// A file without anything in it would be a silent loss.
TEST(CellConversion, DoesNotSkipEverything)
{
  const Grid grid = MakeComb();
  Converted result = Convert(grid, { VTK_TETRA }, UnsupportedCells::Skip);
  EXPECT_EQ(result.Error.Kind, ErrorKind::Unsupported);
  EXPECT_EQ(result.Error.Message,
    "mesh.foo: Foo files cannot hold 1 cell of type polygon (cell 0); write another format, such "
    "as "
    "ParaView's own .vtu, which holds all cells");
  result = Convert(grid, { VTK_TRIANGLE }, UnsupportedCells::Skip);
  EXPECT_EQ(result.Error.Message,
    "mesh.foo: Foo files cannot hold 1 cell of type polygon (cell 0); set Unsupported Cells to "
    "Convert to cut them into triangles");
  // Where cutting was asked for, it is no advice.
  const Grid line = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 } }, { { VTK_LINE, { 0, 1 } } });
  result = Convert(line, { VTK_TRIANGLE }, UnsupportedCells::Convert);
  EXPECT_EQ(result.Error.Message,
    "mesh.foo: Foo files cannot hold 1 cell of type line (cell 0); write another format, such as "
    "ParaView's own .vtu, which holds all cells");
  const Grid strip = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 } }, { { VTK_TRIANGLE_STRIP, { 0, 1 } } });
  result = Convert(strip, { VTK_TRIANGLE });
  EXPECT_EQ(result.Error.Message,
    "mesh.foo: Foo files can hold none of the 1 cells, as these have too few points");
}

//------------------------------------------------------------------------------
// These say the same in another way, so nobody needs to be asked.
TEST(CellConversion, RewritesWithoutLoss)
{
  const Grid voxel = MakeStandardCell(VTK_VOXEL);
  EXPECT_EQ(Convert(voxel, { VTK_HEXAHEDRON }).Get(0), (Ids{ 0, 1, 3, 2, 4, 5, 7, 6 }));

  const Points points = MakeRegularPolygon(6, 0);
  const Grid flat = MakeGrid(points,
    { { VTK_PIXEL, { 0, 1, 2, 3 } }, { VTK_POLYGON, { 0, 1, 2 } }, { VTK_POLYGON, { 0, 1, 2, 3 } },
      { VTK_TRIANGLE_STRIP, { 0, 1, 2, 3, 4 } } });
  const Converted cells = Convert(flat, { VTK_TRIANGLE, VTK_QUAD });
  ASSERT_EQ(cells.Mesh.GetNumberOfCells(), 6);
  EXPECT_EQ(cells.Get(0), (Ids{ 0, 1, 3, 2 }));
  EXPECT_EQ(cells.Mesh.GetCellType(1), VTK_TRIANGLE);
  EXPECT_EQ(cells.Mesh.GetCellType(2), VTK_QUAD);
  // The triangles of a strip run alternately; all must come out running the same way.
  EXPECT_EQ(cells.Get(3), (Ids{ 0, 1, 2 }));
  EXPECT_EQ(cells.Get(4), (Ids{ 1, 3, 2 }));
  EXPECT_EQ(cells.Get(5), (Ids{ 2, 3, 4 }));
  EXPECT_EQ(cells.Mesh.GetInputCell(5), 3);
  EXPECT_TRUE(cells.Warned.GetSentences().empty());

  const Converted polygons = Convert(flat, { VTK_POLYGON });
  EXPECT_EQ(polygons.Mesh.Count(VTK_POLYGON), 6);

  const Grid thin = MakeGrid(points,
    { { VTK_POLY_LINE, { 0, 1, 2 } }, { VTK_POLY_VERTEX, { 3, 4 } }, { VTK_LINE, { 4, 5 } } });
  const Converted lines = Convert(thin, { VTK_LINE, VTK_VERTEX });
  ASSERT_EQ(lines.Mesh.GetNumberOfCells(), 5);
  EXPECT_EQ(lines.Get(1), (Ids{ 1, 2 }));
  EXPECT_EQ(lines.Get(3), (Ids{ 4 }));
  EXPECT_EQ(lines.Mesh.GetInputCell(4), 2);

  const Grid prism = MakeStandardCell(VTK_HEXAGONAL_PRISM);
  const Converted polyhedron = Convert(prism, { VTK_POLYHEDRON });
  EXPECT_EQ(polyhedron.Mesh.GetCellType(0), VTK_POLYHEDRON);
  EXPECT_EQ(polyhedron.Get(0).size(), 12u);
}

//------------------------------------------------------------------------------
// If this fails, a point in the middle of an edge of a polyhedron is lost without a word.
TEST(CellConversion, TellsOfPointsThatCuttingLoses)
{
  const Grid grid =
    MakePolyhedra(MakePoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.5, 0, 0 } }),
      { { { 0, 2, 1, 4 }, { 0, 4, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } } });
  const Converted result = Convert(grid, { VTK_TETRA }, UnsupportedCells::Convert);
  ASSERT_TRUE(result.Success);
  EXPECT_EQ(result.Mesh.GetNumberOfCells(), 1);
  EXPECT_EQ(result.Mesh.GetNumberOfPoints(), 4);
  const std::vector<std::string>& sentences = result.Warned.GetSentences();
  EXPECT_EQ(std::count(sentences.begin(), sentences.end(),
              "1 point left out, which no cell that is written has"),
    1);
}

//------------------------------------------------------------------------------
// If this fails, a cell that is left out is said to be written, too.
TEST(CellConversion, TellsOnceOfCellsThatAreLeftOut)
{
  const Grid grid = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { .5, 0, 0 }, { .5, .5, 0 }, { 0, .5, 0 } },
    { { VTK_QUADRATIC_TRIANGLE, { 0, 1, 2, 4, 5, 6 } }, { VTK_TETRA, { 0, 1, 2, 3 } } });
  for (const UnsupportedCells others : { UnsupportedCells::Skip, UnsupportedCells::Convert })
  {
    EXPECT_EQ(Convert(grid, { VTK_TETRA }, others).GetWarnings(),
      "1 cell of type quadratic triangle left out, as Foo files cannot hold them: cell 0\n");
  }
}

//------------------------------------------------------------------------------
// If this fails, cells have the names of others, as in VTK's own table.
TEST(CellConversion, NamesOfCellTypes)
{
  EXPECT_EQ(GetCellTypeName(VTK_LAGRANGE_TRIANGLE), "lagrange triangle");
  EXPECT_EQ(GetCellTypeName(VTK_LAGRANGE_QUADRILATERAL), "lagrange quadrilateral");
  EXPECT_EQ(GetCellTypeName(VTK_BEZIER_TRIANGLE), "bezier triangle");
  EXPECT_EQ(GetCellTypeName(VTK_BEZIER_QUADRILATERAL), "bezier quadrilateral");
  EXPECT_EQ(GetCellTypeName(VTK_LAGRANGE_TETRAHEDRON), "lagrange tetra");
}

//------------------------------------------------------------------------------
// The corners of a quadratic cell must make a linear cell of the same orientation.
TEST(CellConversion, ReducesHigherOrderToCorners)
{
  const std::map<int, std::pair<int, int>> types = { { VTK_QUADRATIC_TETRA, { VTK_TETRA, 10 } },
    { VTK_QUADRATIC_HEXAHEDRON, { VTK_HEXAHEDRON, 20 } },
    { VTK_QUADRATIC_WEDGE, { VTK_WEDGE, 15 } }, { VTK_QUADRATIC_PYRAMID, { VTK_PYRAMID, 13 } } };
  for (const auto& type : types)
  {
    Points points;
    const Grid linear = MakeStandardCell(type.second.first);
    Ids ids;
    for (int i = 0; i < type.second.second; ++i)
    {
      double x[3] = { 0, 0, 0 };
      linear->GetPoint(i < linear->GetNumberOfPoints() ? i : 0, x);
      points.push_back({ x[0], x[1], x[2] });
      ids.push_back(i);
    }
    const Grid quadratic = MakeGrid(points, { { type.first, ids } });
    const Converted result = Convert(quadratic, { type.second.first });
    ASSERT_TRUE(result.Success);
    EXPECT_EQ(result.Mesh.GetCellType(0), type.second.first);
    // Middle nodes would be new points without cells.
    EXPECT_EQ(result.Mesh.GetNumberOfPoints(), linear->GetNumberOfPoints());
    EXPECT_NE(result.GetWarnings().find("without their nodes of higher order"), std::string::npos);
    // The faces of both run the same way.
    const auto getFaces = [](vtkUnstructuredGrid* grid)
    {
      const MeshView mesh(grid);
      std::set<Ids> faces;
      CellFacets(mesh).ForEach(0,
        [&faces](const vtkIdType* p, vtkIdType size, vtkIdType)
        {
          Ids face(p, p + size);
          std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
          faces.insert(face);
        });
      return faces;
    };
    const Grid corners = MakeGrid(points, { { type.second.first, result.Get(0) } });
    EXPECT_EQ(getFaces(corners), getFaces(quadratic)) << type.first;
  }
  const Grid grid =
    MakeGrid(MakeRegularPolygon(9, 0), { { VTK_BIQUADRATIC_QUAD, { 0, 1, 2, 3, 4, 5, 6, 7, 8 } } });
  EXPECT_EQ(Convert(grid, { VTK_QUADRATIC_QUAD }).Get(0), (Ids{ 0, 1, 2, 3, 4, 5, 6, 7 }));
  EXPECT_EQ(Convert(grid, { VTK_POLYGON }).Get(0), (Ids{ 0, 1, 2, 3 }));
}

//------------------------------------------------------------------------------
// A fan would cover the gap between the teeth and turn triangles over.
TEST(CellConversion, CutsConcavePolygons)
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
TEST(CellConversion, CutsOddPolygons)
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
  EXPECT_NE(result.GetWarnings().find("whose triangles are arbitrary"), std::string::npos);
}

//------------------------------------------------------------------------------
// Volumes tell that nothing is missing, doubled or inside out.
TEST(CellConversion, CutsCellsIntoTetrahedra)
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
// Neighbours must cut their common faces in the same way, whatever their types.
TEST(CellConversion, CutsFacesOnce)
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
TEST(CellConversion, WarnsOfInvertedTetrahedra)
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
                               { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } },
    { { VTK_HEXAHEDRON, { 4, 5, 6, 7, 0, 1, 2, 3 } } });
  const Converted result = Convert(grid, { VTK_TETRA }, UnsupportedCells::Convert);
  EXPECT_NEAR(result.GetVolume(), -1, 1e-12);
  EXPECT_NE(result.GetWarnings().find("of whose tetrahedra 6 have no positive volume"), std::string::npos)
    << result.GetWarnings();
}

//------------------------------------------------------------------------------
// Polyhedra whose faces contradict each other can only be judged by their volume.
TEST(CellConversion, CutsInconsistentPolyhedra)
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
// Two cubes that meet at an edge contradict nothing: what lies behind the apex is negative, and told.
TEST(CellConversion, CutsPolyhedraThatMeetThemselves)
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
  EXPECT_NE(result.GetWarnings().find("have no positive volume"), std::string::npos) << result.GetWarnings();
}

//------------------------------------------------------------------------------
// Formats of primitives can hold most meshes of polyhedra, inverted ones included.
TEST(CellConversion, RecognisesPolyhedra)
{
  const Grid grid = MakeAllStandardCells();
  const Grid polyhedra = ToPolyhedra(grid);
  const CellTypeSet primitives = { VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON };
  EXPECT_FALSE(Convert(polyhedra, primitives).Success);
  for (const bool inward : { false, true })
  {
    std::vector<Faces> cells;
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      cells.push_back(GetFaces(grid, cell));
      for (Ids& face : cells.back())
      {
        if (inward)
        {
          std::reverse(face.begin(), face.end());
        }
      }
    }
    const Grid mesh = MakePolyhedra(grid->GetPoints(), cells);
    const Converted result = Convert(mesh, primitives, UnsupportedCells::Convert);
    EXPECT_EQ(result.Mesh.Count(VTK_HEXAHEDRON), 2); // one was a voxel
    EXPECT_EQ(result.Mesh.Count(VTK_WEDGE), 1);
    EXPECT_EQ(result.Mesh.Count(VTK_PYRAMID), 1);
    EXPECT_GT(result.Mesh.Count(VTK_TETRA), 1); // the prisms
    for (vtkIdType cell = 0; cell < result.Mesh.GetNumberOfCells(); ++cell)
    {
      const vtkIdType input = result.Mesh.GetInputCell(cell);
      if (result.Mesh.GetCellType(cell) == VTK_TETRA)
      {
        EXPECT_EQ(result.GetVolume(cell) > 0, !inward);
        continue;
      }
      // The faces of the primitive run as those of the polyhedron.
      const Grid one =
        MakeGrid(Points(static_cast<std::size_t>(grid->GetNumberOfPoints()), Point{ 0, 0, 0 }),
          { { result.Mesh.GetCellType(cell), result.Get(cell) } });
      std::set<Ids> expected, found;
      const auto normal = [](Ids face)
      {
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
        return face;
      };
      for (const Ids& face : cells[input])
      {
        expected.insert(normal(face));
      }
      for (const Ids& face : GetFaces(one, 0))
      {
        found.insert(normal(face));
      }
      EXPECT_EQ(found, expected) << GetCellTypeName(result.Mesh.GetCellType(cell)) << inward;
    }
  }
}

//------------------------------------------------------------------------------
// The outside of a mesh, once and outward, with the cells that the polygons are from.
TEST(CellConversion, TakesSurfaces)
{
  const Grid grid = MakeHexahedra(3, 3, 3, false);
  const CellTypeSet held = { VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON };
  Converted result = Convert(grid, held, UnsupportedCells::Refuse, SurfaceFaces::Boundary);
  ASSERT_EQ(result.Mesh.GetNumberOfCells(), 54);
  EXPECT_EQ(result.Mesh.GetNumberOfPoints(), 56); // without the 8 inner ones
  EXPECT_EQ(result.GetWarnings(),
    "27 cells of three dimensions written by the faces of their boundary, 54 polygons, which lack 8 "
    "of the points, the first is cell 0\n");
  for (vtkIdType cell = 0; cell < 54; ++cell)
  {
    const Ids ids = result.Get(cell);
    const Vector centre = .5 * (result.Place(ids[0]) + result.Place(ids[2]));
    const Vector normal = Cross(
      result.Place(ids[1]) - result.Place(ids[0]), result.Place(ids[2]) - result.Place(ids[0]));
    EXPECT_GT(Dot(normal, centre - Vector{ 1.5, 1.5, 1.5 }), 0);
    double bounds[6];
    grid->GetCell(result.Mesh.GetInputCell(cell))->GetBounds(bounds);
    EXPECT_TRUE(bounds[0] <= centre.X && centre.X <= bounds[1]);
    EXPECT_TRUE(bounds[2] <= centre.Y && centre.Y <= bounds[3]);
    EXPECT_TRUE(bounds[4] <= centre.Z && centre.Z <= bounds[5]);
  }
  result = Convert(grid, held, UnsupportedCells::Refuse, SurfaceFaces::Every);
  EXPECT_EQ(result.Mesh.GetNumberOfCells(), 108);
  EXPECT_EQ(result.Mesh.GetNumberOfPoints(), 64);

  result = Convert(grid, { VTK_TRIANGLE }, UnsupportedCells::Refuse, SurfaceFaces::Boundary);
  EXPECT_NE(result.Error.Message.find("Convert to cut them into triangles"), std::string::npos);
  result = Convert(grid, { VTK_TRIANGLE }, UnsupportedCells::Convert, SurfaceFaces::Boundary);
  EXPECT_EQ(result.Mesh.Count(VTK_TRIANGLE), 108);
}

//------------------------------------------------------------------------------
// Files of points have no cells for them, and none are missed.
TEST(CellConversion, KeepsClouds)
{
  const Grid grid =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 } }, { { VTK_VERTEX, { 0 } }, { VTK_VERTEX, { 1 } } });
  Converted result = Convert(grid, { VTK_TRIANGLE });
  ASSERT_TRUE(result.Success);
  EXPECT_EQ(result.Mesh.GetNumberOfCells(), 0);
  EXPECT_EQ(result.Mesh.GetNumberOfPoints(), 2);
  EXPECT_TRUE(result.Warned.GetSentences().empty());
  const Grid some = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 } }, { { VTK_VERTEX, { 0 } } });
  result = Convert(some, { VTK_TRIANGLE });
  ASSERT_EQ(result.Warned.GetSentences().size(), 1u);
  EXPECT_NE(result.Warned.GetSentences()[0].find("1 point without a cell"), std::string::npos);
  const Grid none = MakeGrid({ { 0, 0, 0 } }, {});
  EXPECT_TRUE(Convert(none, { VTK_TRIANGLE }).Success);
  const auto empty = vtkSmartPointer<vtkPolyData>::New();
  EXPECT_TRUE(Convert(empty, { VTK_TRIANGLE }).Success);
}

//------------------------------------------------------------------------------
// The same result for any number of threads, also for meshes of many chunks.
TEST(CellConversion, DoesNotDependOnThreads)
{
  const Grid grid = MakeHexahedra(40, 30, 20, true);
  std::vector<Converted> results;
  for (const int threads : { 1, 2, 5 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
      [&]
      {
        results.push_back(
          Convert(grid, { VTK_TETRA, VTK_PYRAMID }, UnsupportedCells::Convert, SurfaceFaces::None));
      });
  }
  ASSERT_GE(results[0].Mesh.GetNumberOfCells(), 5 * 24000);
  for (const Converted& other : results)
  {
    ASSERT_EQ(other.Mesh.GetNumberOfCells(), results[0].Mesh.GetNumberOfCells());
    for (vtkIdType cell = 0; cell < other.Mesh.GetNumberOfCells(); ++cell)
    {
      ASSERT_EQ(other.Get(cell), results[0].Get(cell));
      ASSERT_EQ(other.Mesh.GetInputCell(cell), results[0].Mesh.GetInputCell(cell));
    }
  }
}

//------------------------------------------------------------------------------
TEST(CellConversion, StopsOnRequest)
{
  const Grid grid = MakeHexahedra(70, 70, 70, false); // of more chunks than slices of progress
  OutputMesh output;
  Warnings warnings;
  ScanError error;
  CellConversion how{ "Foo", { VTK_TETRA } };
  how.Others = UnsupportedCells::Convert;
  EXPECT_FALSE(ConvertCells(grid, how, "mesh.foo", output, warnings, error,
    Progress([](double fraction) { return fraction < 0.2; })));
  EXPECT_FALSE(static_cast<bool>(error));
}
