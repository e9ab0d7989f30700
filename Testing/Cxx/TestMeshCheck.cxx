// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes whose cells cannot be read are refused before anything reads them. Built with sanitizers,
// the check itself must not read beyond any array.
#include "TestMeshes.h"

#include "Mesh/MeshCheck.h"
#include "Mesh/MeshView.h"
#include "vtkCamaronCompat.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <stdexcept>
#include <string>

using namespace camaron;
using namespace camaron::testing;

namespace
{
using Ids = std::vector<vtkIdType>;

constexpr vtkIdType NumberOfPoints = 40;

// From the figures of VTK's file formats.
const std::map<int, vtkIdType> FixedSizes = { { VTK_VERTEX, 1 }, { VTK_LINE, 2 },
  { VTK_TRIANGLE, 3 }, { VTK_PIXEL, 4 }, { VTK_QUAD, 4 }, { VTK_TETRA, 4 }, { VTK_VOXEL, 8 },
  { VTK_HEXAHEDRON, 8 }, { VTK_WEDGE, 6 }, { VTK_PYRAMID, 5 }, { VTK_PENTAGONAL_PRISM, 10 },
  { VTK_HEXAGONAL_PRISM, 12 }, { VTK_QUADRATIC_EDGE, 3 }, { VTK_CUBIC_LINE, 4 },
  { VTK_QUADRATIC_TRIANGLE, 6 }, { VTK_BIQUADRATIC_TRIANGLE, 7 }, { VTK_QUADRATIC_QUAD, 8 },
  { VTK_BIQUADRATIC_QUAD, 9 }, { VTK_QUADRATIC_LINEAR_QUAD, 6 }, { VTK_QUADRATIC_TETRA, 10 },
  { VTK_QUADRATIC_HEXAHEDRON, 20 }, { VTK_TRIQUADRATIC_HEXAHEDRON, 27 },
  { VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 24 }, { VTK_QUADRATIC_PYRAMID, 13 },
  { VTK_TRIQUADRATIC_PYRAMID, 19 }, { VTK_QUADRATIC_WEDGE, 15 }, { VTK_QUADRATIC_LINEAR_WEDGE, 12 },
  { VTK_BIQUADRATIC_QUADRATIC_WEDGE, 18 } };

//------------------------------------------------------------------------------
std::string Check(vtkDataSet* mesh)
{
  try
  {
    CheckCells(mesh);
    return "";
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPoints> MakeManyPoints(vtkIdType size = NumberOfPoints)
{
  Points points;
  for (vtkIdType i = 0; i < size; ++i)
  {
    points.push_back({ double(i), double(i * i), double(i % 3) });
  }
  return MakePoints(points);
}

//------------------------------------------------------------------------------
template <typename Array>
vtkSmartPointer<Array> MakeArray(const Ids& values)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), static_cast<typename Array::ValueType>(values[i]));
  }
  return array;
}

//------------------------------------------------------------------------------
// With arrays that are as long as these, and no longer.
template <typename Array = vtkTypeInt64Array>
vtkSmartPointer<vtkCellArray> MakeLists(const Ids& offsets, const Ids& values)
{
  auto lists = vtkSmartPointer<vtkCellArray>::New();
  lists->SetData(MakeArray<Array>(offsets).Get(), MakeArray<Array>(values).Get());
  return lists;
}

//------------------------------------------------------------------------------
Grid MakeStored(const Ids& types, vtkCellArray* cells, vtkCellArray* locations = nullptr,
  vtkCellArray* faces = nullptr)
{
  auto grid = Grid::New();
  grid->SetPoints(MakeManyPoints());
  const auto bytes = MakeArray<vtkUnsignedCharArray>(types);
  grid->SetPolyhedralCells(bytes, cells, locations, faces);
  return grid;
}

//------------------------------------------------------------------------------
// Good triangles, and then one cell of a type with so many points.
Grid MakeLast(int type, vtkIdType size, vtkIdType before = 2)
{
  Ids types(before, VTK_TRIANGLE), offsets{ 0 }, ids;
  types.push_back(type);
  for (vtkIdType cell = 0; cell < before; ++cell)
  {
    ids.insert(ids.end(), { 0, 1, 2 });
    offsets.push_back(static_cast<vtkIdType>(ids.size()));
  }
  for (vtkIdType i = 0; i < size; ++i)
  {
    ids.push_back(i % NumberOfPoints);
  }
  offsets.push_back(static_cast<vtkIdType>(ids.size()));
  return MakeStored(types, MakeLists(offsets, ids));
}

//------------------------------------------------------------------------------
Grid WithDegrees(Grid grid, const std::vector<std::array<double, 3>>& degrees)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("degrees");
  array->SetNumberOfComponents(3);
  for (const auto& three : degrees)
  {
    array->InsertNextTuple(three.data());
  }
  grid->GetCellData()->SetHigherOrderDegrees(array);
  return grid;
}
}

//------------------------------------------------------------------------------
// A hexahedron of 6 points was read with two ids of the next cell, or beyond the array.
TEST(MeshCheck, FixedSizes)
{
  for (const auto& [type, size] : FixedSizes)
  {
    EXPECT_EQ(Check(MakeLast(type, size)), "") << type;
    for (const vtkIdType wrong : { vtkIdType(0), size - 1, size + 1 })
    {
      const std::string text = Check(MakeLast(type, wrong));
      EXPECT_EQ(text.rfind("cell 2 (", 0), 0u) << type << ' ' << text;
      const std::string end = ") has " + std::to_string(wrong) +
        (wrong == 1 ? " point, expected " : " points, expected ") + std::to_string(size);
      EXPECT_EQ(text.substr(text.find(')')), end) << type;
    }
  }
  EXPECT_EQ(Check(MakeLast(VTK_HEXAHEDRON, 6)), "cell 2 (hexahedron) has 6 points, expected 8");
  EXPECT_EQ(Check(MakeLast(VTK_QUADRATIC_TETRA, 11)),
    "cell 2 (quadratic tetrahedron) has 11 points, expected 10");
}

//------------------------------------------------------------------------------
// Too few points for a polygon are a defect, which CellStatus reports; types that VTK does not know
// have no vertices.
TEST(MeshCheck, AnySize)
{
  constexpr int types[] = { VTK_EMPTY_CELL, VTK_POLY_VERTEX, VTK_POLY_LINE, VTK_TRIANGLE_STRIP,
    VTK_POLYGON, VTK_CONVEX_POINT_SET, VTK_POLYHEDRON, VTK_PARAMETRIC_CURVE, VTK_HIGHER_ORDER_EDGE,
    VTK_HIGHER_ORDER_PYRAMID, 200 };
  for (const int type : types)
  {
    for (vtkIdType size = 0; size < 8; ++size)
    {
      EXPECT_EQ(Check(MakeLast(type, size)), "") << type << ' ' << size;
    }
  }
  for (vtkIdType size = 0; size < 10; ++size)
  {
    EXPECT_EQ(Check(MakeLast(VTK_QUADRATIC_POLYGON, size)),
      size % 2 ? "cell 2 (quadratic polygon) has " + std::to_string(size) +
          (size == 1 ? " point" : " points") + ", expected an even number"
               : "");
  }
}

//------------------------------------------------------------------------------
// In each class of cells of variable order: a cell of every order from 1 to 5, and VTK's quadratic
// cells with centers of faces.
TEST(MeshCheck, SizesOfOrders)
{
  const std::vector<std::pair<std::vector<int>, Ids>> known = {
    { { VTK_LAGRANGE_CURVE, VTK_BEZIER_CURVE }, { 2, 3, 4, 5, 6 } },
    { { VTK_LAGRANGE_TRIANGLE, VTK_BEZIER_TRIANGLE }, { 3, 6, 7, 10, 15, 21 } },
    { { VTK_LAGRANGE_QUADRILATERAL, VTK_BEZIER_QUADRILATERAL }, { 4, 9, 16, 25, 36 } },
    { { VTK_LAGRANGE_TETRAHEDRON, VTK_BEZIER_TETRAHEDRON }, { 4, 10, 15, 20, 35, 56 } },
    { { VTK_LAGRANGE_HEXAHEDRON, VTK_BEZIER_HEXAHEDRON }, { 8, 27, 64, 125, 216 } },
    { { VTK_LAGRANGE_WEDGE, VTK_BEZIER_WEDGE }, { 6, 18, 21, 40, 75, 126 } },
    { { VTK_LAGRANGE_PYRAMID, VTK_BEZIER_PYRAMID }, { 5, 14, 30, 55, 91 } }
  };
  for (const auto& [types, sizes] : known)
  {
    std::string expected;
    for (const vtkIdType size : sizes)
    {
      expected += std::to_string(size) + ", ";
    }
    for (const int type : types)
    {
      for (vtkIdType size = 0; size <= sizes.back(); ++size)
      {
        const bool isGood = std::find(sizes.begin(), sizes.end(), size) != sizes.end();
        const std::string text = Check(MakeLast(type, size));
        EXPECT_EQ(text.empty(), isGood) << type << ' ' << size;
        EXPECT_TRUE(isGood || text.find(", expected " + expected + "...") != std::string::npos)
          << text;
      }
    }
  }
  EXPECT_EQ(Check(MakeLast(VTK_LAGRANGE_TETRAHEDRON, 9)),
    "cell 2 (lagrange tetrahedron) has 9 points, expected 4, 10, 15, 20, 35, 56, ...");
}

//------------------------------------------------------------------------------
// VTK reads three numbers per cell without a look at the size of the array.
TEST(MeshCheck, Degrees)
{
  const std::array<double, 3> any = { 0, 0, 0 }; // of triangles, which need none
  const auto check = [&](int type, vtkIdType size, const std::array<double, 3>& degrees)
  { return Check(WithDegrees(MakeLast(type, size), { any, any, degrees })); };
  EXPECT_EQ(check(VTK_LAGRANGE_HEXAHEDRON, 12, { 1, 2, 1 }), "");
  EXPECT_EQ(check(VTK_LAGRANGE_HEXAHEDRON, 27, { 1, 2, 1 }),
    "cell 2 (lagrange hexahedron) has 27 points, expected 12 for its degrees 1, 2 and 1");
  EXPECT_EQ(check(VTK_BEZIER_QUADRILATERAL, 6, { 2, 1, 0 }), "");
  EXPECT_EQ(check(VTK_BEZIER_QUADRILATERAL, 4, { 2, 1, 0 }),
    "cell 2 (bezier quadrilateral) has 4 points, expected 6 for its degrees 2 and 1");
  EXPECT_EQ(check(VTK_LAGRANGE_WEDGE, 12, { 2, 2, 1 }), "");
  EXPECT_EQ(check(VTK_LAGRANGE_WEDGE, 21, { 2, 2, 2 }), "");
  EXPECT_EQ(check(VTK_LAGRANGE_WEDGE, 18, { 2, 2, 2 }), "");
  EXPECT_NE(check(VTK_LAGRANGE_WEDGE, 21, { 1, 1, 2 }), "");
  EXPECT_EQ(check(VTK_LAGRANGE_WEDGE, 6, { 1, 2, 1 }),
    "cell 2 (lagrange wedge) has 6 points, expected equal degrees in its triangles, not 1 and 2");
  const std::string none = "expected three degrees of at least 1 for it in HigherOrderDegrees";
  for (const double bad : { 0.0, -1.0, 1e30, std::nan("") })
  {
    EXPECT_EQ(check(VTK_LAGRANGE_HEXAHEDRON, 8, { 1, bad, 1 }),
      "cell 2 (lagrange hexahedron) has 8 points, " + none);
  }
  EXPECT_EQ(Check(WithDegrees(MakeLast(VTK_LAGRANGE_HEXAHEDRON, 8), { any, any })),
    "cell 2 (lagrange hexahedron) has 8 points, " + none);
  // Triangles and tetrahedra have the same order in all directions; others have none.
  EXPECT_EQ(Check(WithDegrees(MakeLast(VTK_LAGRANGE_TRIANGLE, 6), { any })), "");
  EXPECT_EQ(Check(WithDegrees(MakeLast(VTK_HEXAHEDRON, 8), { any })), "");
}

//------------------------------------------------------------------------------
// The first invalid cell is found in any chunk, with any number of threads.
TEST(MeshCheck, FirstOfMany)
{
  constexpr vtkIdType size = 100000;
  EXPECT_EQ(Check(MakeLast(VTK_TETRA, 4, size)), "");
  EXPECT_EQ(
    Check(MakeLast(VTK_TETRA, 3, size)), "cell 100000 (tetrahedron) has 3 points, expected 4");
  const Grid grid = MakeLast(VTK_TETRA, 3, size);
  auto* const types = vtkUnsignedCharArray::SafeDownCast(GetCellTypes(grid));
  types->SetValue(70000, VTK_QUAD);
  types->SetValue(99999, VTK_LINE);
  EXPECT_EQ(Check(grid), "cell 70000 (quadrangle) has 3 points, expected 4");
}

//------------------------------------------------------------------------------
TEST(MeshCheck, PointIds)
{
  for (const vtkIdType bad : { vtkIdType(-1), NumberOfPoints, vtkIdType(1) << 31 })
  {
    const auto cells = MakeLists({ 0, 3, 6 }, { 0, 1, 2, 3, bad, 4 });
    EXPECT_EQ(Check(MakeStored({ VTK_TRIANGLE, VTK_TRIANGLE }, cells)),
      "cell 1 uses point " + std::to_string(bad) + ", but the mesh has 40 points");
  }
  const Grid empty = MakeLast(VTK_TRIANGLE, 3);
  empty->SetPoints(nullptr);
  EXPECT_EQ(Check(empty), "cell 0 uses point 0, but the mesh has 0 points");
}

//------------------------------------------------------------------------------
template <typename Array>
void CheckOffsets()
{
  const Ids ids = { 0, 1, 2, 3, 4, 5 }, types = { VTK_TRIANGLE, VTK_TRIANGLE };
  const auto check = [&](const Ids& offsets)
  { return Check(MakeStored(types, MakeLists<Array>(offsets, ids))); };
  EXPECT_EQ(check({ 0, 3, 6 }), "");
  EXPECT_EQ(check({ 0, 3, 7 }),
    "the points of cell 1 have the offsets 3 and 7, expected ascending numbers from 0 to 6");
  EXPECT_EQ(check({ 0, 3, 2000000000 }),
    "the points of cell 1 have the offsets 3 and 2000000000, expected ascending numbers from 0 to "
    "6");
  EXPECT_EQ(check({ 0, 30, 6 }),
    "the points of cell 0 have the offsets 0 and 30, expected ascending numbers from 0 to 6");
  EXPECT_EQ(check({ 0, 3, 0 }),
    "the points of cell 1 have the offsets 3 and 0, expected ascending numbers from 0 to 6");
  EXPECT_EQ(check({ -3, 0, 3 }),
    "the points of cell 0 have the offsets -3 and 0, expected ascending numbers from 0 to 6");
}

//------------------------------------------------------------------------------
TEST(MeshCheck, Offsets)
{
  CheckOffsets<vtkTypeInt32Array>();
  CheckOffsets<vtkTypeInt64Array>();
}

//------------------------------------------------------------------------------
TEST(MeshCheck, Types)
{
  const auto cells = MakeLists({ 0, 3, 6 }, { 0, 1, 2, 3, 4, 5 });
  EXPECT_EQ(Check(MakeStored({ VTK_TRIANGLE }, cells)), "the mesh has 2 cells, but the types of 1");
  EXPECT_EQ(Check(MakeStored({}, cells)), "the mesh has 2 cells, but the types of 0");
  EXPECT_EQ(Check(Grid::New()), "");
}

//------------------------------------------------------------------------------
TEST(MeshCheck, Faces)
{
  const Ids types = { VTK_POLYHEDRON, VTK_TRIANGLE };
  const auto cells = MakeLists({ 0, 4, 7 }, { 0, 1, 2, 3, 0, 1, 2 });
  const Ids corners = { 0, 1, 2, 0, 3, 1, 1, 3, 2, 0, 2, 3, 7, 8, 9 };
  const Ids ends = { 0, 3, 6, 9, 12, 15 };
  const auto faces = MakeLists(ends, corners);
  const auto locations = MakeLists({ 0, 4, 4 }, { 0, 1, 2, 3 });
  EXPECT_EQ(Check(MakeStored(types, cells, locations, faces)), "");

  EXPECT_EQ(Check(MakeStored(types, cells, MakeLists({ 0, 4 }, { 0, 1, 2, 3 }), faces)),
    "the mesh has 2 cells, but lists of faces of 1");
  for (const int bad : { -1, 5 })
  {
    EXPECT_EQ(Check(MakeStored(types, cells, MakeLists({ 0, 4, 4 }, { 0, 1, bad, 3 }), faces)),
      "cell 0 uses face " + std::to_string(bad) + ", but the mesh has 5 faces");
  }
  EXPECT_EQ(Check(MakeStored(types, cells, MakeLists({ 0, 4, 5 }, { 0, 1, 2, 3 }), faces)),
    "the faces of cell 1 have the offsets 4 and 5, expected ascending numbers from 0 to 4");
  EXPECT_EQ(Check(MakeStored(types, cells, locations, MakeLists({ 0, 3, 6, 5, 12, 15 }, corners))),
    "the points of face 2 have the offsets 6 and 5, expected ascending numbers from 0 to 15");
  EXPECT_EQ(Check(MakeStored(types, cells, locations, MakeLists({ 0, 3, 6, 9, 12, 16 }, corners))),
    "the points of face 4 have the offsets 12 and 16, expected ascending numbers from 0 to 15");

  Ids bad = corners;
  bad[14] = 99; // of no cell
  EXPECT_EQ(Check(MakeStored(types, cells, locations, MakeLists(ends, bad))), "");
  bad[4] = 99;
  EXPECT_EQ(Check(MakeStored(types, cells, locations, MakeLists(ends, bad))),
    "cell 0 uses point 99, but the mesh has 40 points");
  // Faces of fewer than three points are a defect of the cell.
  EXPECT_EQ(
    Check(MakeStored(types, cells, locations, MakeLists({ 0, 0, 2, 9, 12, 15 }, corners))), "");
}

//------------------------------------------------------------------------------
// The type of a polygonal cell follows from its size, so any size can be read.
TEST(MeshCheck, PolyData)
{
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(MakeManyPoints());
  mesh->SetVerts(MakeLists({ 0, 0, 1, 3 }, { 0, 1, 2 }));
  mesh->SetLines(MakeLists({ 0, 0, 1, 3, 6 }, { 0, 1, 2, 3, 4, 5 }));
  mesh->SetPolys(MakeLists({ 0, 0, 2, 5, 9 }, { 0, 1, 2, 3, 4, 5, 6, 7, 8 }));
  mesh->SetStrips(MakeLists({ 0, 0, 2, 5 }, { 0, 1, 2, 3, 4 }));
  EXPECT_EQ(Check(mesh), "");
  const MeshView view(mesh);
  Ids types;
  for (vtkIdType cell = 0; cell < view.GetNumberOfCells(); ++cell)
  {
    types.push_back(view.GetCellType(cell));
  }
  EXPECT_EQ(types,
    Ids({ VTK_EMPTY_CELL, VTK_VERTEX, VTK_POLY_VERTEX, VTK_EMPTY_CELL, VTK_EMPTY_CELL, VTK_LINE,
      VTK_POLY_LINE, VTK_POLYGON, VTK_POLYGON, VTK_TRIANGLE, VTK_QUAD, VTK_TRIANGLE_STRIP,
      VTK_TRIANGLE_STRIP, VTK_TRIANGLE_STRIP }));
  mesh->SetPolys(MakeLists({ 0, 3, 7 }, { 0, 1, 2, 3, 4, 5 }));
  EXPECT_EQ(Check(mesh),
    "the points of cell 8 have the offsets 3 and 7, expected ascending numbers from 0 to 6");
  mesh->SetPolys(MakeLists({ 0, 3, 6 }, { 0, 1, 2, 3, 40, 5 }));
  EXPECT_EQ(Check(mesh), "cell 8 uses point 40, but the mesh has 40 points");
}
