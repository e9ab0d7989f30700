// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What writers make of cells that a format cannot hold.
#include "CellConversionTesting.h"

#include "Mesh/CellFacets.h"
#include "Mesh/CellShape.h"

#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <map>
#include <set>

using namespace camaron;
using namespace camaron::testing;

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
    "mesh.foo: Foo files cannot store 2 cells of type quadrangle (the first is cell 1) and 1 cell "
    "of type pyramid (cell 2); set Unsupported Cells to Convert to cut them into triangles, or to "
    "Skip to omit them");
  result = Convert(grid, { VTK_QUAD, VTK_PYRAMID });
  EXPECT_EQ(result.Error.Message,
    "mesh.foo: Foo files cannot store 1 cell of type triangle (cell 0); set Unsupported Cells to "
    "Skip to omit them");

  // A file of surfaces holds neither the others nor what they could be cut into.
  const Grid polyhedron =
    MakePolyhedra(MakePoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }),
      { { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } } });
  result = Convert(polyhedron, { VTK_TRIANGLE, VTK_QUAD });
  EXPECT_EQ(result.Error.Message,
    "mesh.foo: Foo files cannot store 1 cell of type polyhedron (cell 0); choose another format, "
    "such as ParaView's .vtu, which stores all cell types");
}

//------------------------------------------------------------------------------
// Omitted cells are reported, and arrays can follow the others.
TEST(CellConversion, SkipsOnRequest)
{
  const Grid grid =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 9, 9, 9 }, { 8, 8, 8 } },
      { { VTK_LINE, { 4, 0 } }, { VTK_TETRA, { 0, 1, 2, 3 } } });
  const Converted result = Convert(grid, { VTK_TETRA }, UnsupportedCells::Skip);
  ASSERT_TRUE(result.Success);
  ASSERT_EQ(result.Mesh.GetNumberOfCells(), 1);
  EXPECT_EQ(result.Mesh.GetInputCell(0), 1);
  EXPECT_EQ(result.GetWarnings(),
    "1 cell of type line omitted because Foo files cannot store this type: cell 0\n");
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
    "mesh.foo: Foo files cannot store 1 cell of type polygon (cell 0); choose another format, "
    "such as ParaView's .vtu, which stores all cell types");
  result = Convert(grid, { VTK_TRIANGLE }, UnsupportedCells::Skip);
  EXPECT_EQ(result.Error.Message,
    "mesh.foo: Foo files cannot store 1 cell of type polygon (cell 0); set Unsupported Cells to "
    "Convert to cut them into triangles");
  // Where cutting was asked for, it is no advice.
  const Grid line = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 } }, { { VTK_LINE, { 0, 1 } } });
  result = Convert(line, { VTK_TRIANGLE }, UnsupportedCells::Convert);
  EXPECT_EQ(result.Error.Message,
    "mesh.foo: Foo files cannot store 1 cell of type line (cell 0); choose another format, such as "
    "ParaView's .vtu, which stores all cell types");
  const Grid strip = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 } }, { { VTK_TRIANGLE_STRIP, { 0, 1 } } });
  result = Convert(strip, { VTK_TRIANGLE });
  EXPECT_EQ(result.Error.Message,
    "mesh.foo: Foo files can store none of the 1 cells because they have too few points");
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
// If this fails, an omitted cell is reported as written, too.
TEST(CellConversion, TellsOnceOfCellsThatAreLeftOut)
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { .5, 0, 0 },
                               { .5, .5, 0 }, { 0, .5, 0 } },
    { { VTK_QUADRATIC_TRIANGLE, { 0, 1, 2, 4, 5, 6 } }, { VTK_TETRA, { 0, 1, 2, 3 } } });
  for (const UnsupportedCells others : { UnsupportedCells::Skip, UnsupportedCells::Convert })
  {
    EXPECT_EQ(Convert(grid, { VTK_TETRA }, others).GetWarnings(),
      "1 cell of type quadratic triangle omitted because Foo files cannot store this type: "
      "cell 0\n");
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
  EXPECT_EQ(GetCellTypeName(VTK_LAGRANGE_TETRAHEDRON), "lagrange tetrahedron");
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
    EXPECT_NE(result.GetWarnings().find("without their higher-order nodes"), std::string::npos);
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
// Formats of primitives can hold most meshes of polyhedra, inverted ones included.
TEST(CellConversion, RecognizesPolyhedra)
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
    "27 cells of dimension 3 written as their boundary faces, 54 polygons, without 8 of the "
    "points, the first is cell 0\n");
  for (vtkIdType cell = 0; cell < 54; ++cell)
  {
    const Ids ids = result.Get(cell);
    const Vector center = .5 * (result.Place(ids[0]) + result.Place(ids[2]));
    const Vector normal = Cross(
      result.Place(ids[1]) - result.Place(ids[0]), result.Place(ids[2]) - result.Place(ids[0]));
    EXPECT_GT(Dot(normal, center - Vector{ 1.5, 1.5, 1.5 }), 0);
    double bounds[6];
    grid->GetCell(result.Mesh.GetInputCell(cell))->GetBounds(bounds);
    EXPECT_TRUE(bounds[0] <= center.X && center.X <= bounds[1]);
    EXPECT_TRUE(bounds[2] <= center.Y && center.Y <= bounds[3]);
    EXPECT_TRUE(bounds[4] <= center.Z && center.Z <= bounds[5]);
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
