// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Kernels of cells against the published tables, against trying everything, and on cells
// that are not what they should be.
#include "Base/Number.h"
#include "Cell/CellDefects.h"
#include "Criteria/Evaluation.h"
#include "Elements/KernelCells.h"

#include "CriteriaTesting.h"
#include "HalfSpaceTesting.h"
#include "ReferenceShapes.h"
#include "Sanitized.h"
#include "TestMeshes.h"

#include "vtkCellData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>

using namespace camaron;
using namespace camaron::testing;

namespace
{
const std::vector<std::string> Names = { "KernelRatio", "IsStarShaped", "KernelInradiusRatio",
  "ShapeRegularity", "InradiusCircumradiusRatio", "NormalizedRadiusRatio", "VemRho1", "VemRho2",
  "VemRho3", "VemQuality", "PolyhedronRho1", "PolyhedronRho2", "PolyhedronRho3",
  "PolyhedronQuality" };

//------------------------------------------------------------------------------
Values EvaluateNames(vtkDataSet* mesh, const std::vector<std::string>& names = Names)
{
  Values values;
  std::vector<CriterionValues> rows;
  for (const std::string& name : names)
  {
    values[name].resize(mesh->GetNumberOfCells());
    rows.push_back({ FindCriterion(name), values[name].data() });
  }
  EXPECT_TRUE(Evaluate(MeshTopology(mesh), {}, rows, [](double) { return true; }));
  return values;
}

//------------------------------------------------------------------------------
double GetValue(vtkDataSet* mesh, const std::string& name)
{
  return EvaluateNames(mesh, { name })[name][0];
}

//------------------------------------------------------------------------------
const Points LHexagon = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 },
  { 0, 2, 0 } };

//------------------------------------------------------------------------------
// A ball of 32 triangles with random radii: star-shaped about the origin, unless its corners are
// also moved to the sides.
struct SpikyBall
{
  Points Corners;
  Faces Triangles;

  SpikyBall(std::mt19937& random, double smallest, double shift = 0)
  {
    std::uniform_real_distribution<double> radius(smallest, 1), side(-shift, shift);
    std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> middles;
    this->Corners = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 },
      { 0, 0, -1 } };
    const auto middle = [&](vtkIdType a, vtkIdType b)
    {
      const auto found =
        middles.emplace(std::minmax(a, b), static_cast<vtkIdType>(this->Corners.size()));
      if (found.second)
      {
        Point p;
        for (int k = 0; k < 3; ++k)
        {
          p[k] = (this->Corners[a][k] + this->Corners[b][k]) * std::sqrt(0.5);
        }
        this->Corners.push_back(p);
      }
      return found.first->second;
    };
    for (int i = 0; i < 8; ++i)
    {
      vtkIdType a = i & 1, b = 2 + (i >> 1 & 1), c = 4 + (i >> 2);
      if ((i & 1) ^ (i >> 1 & 1) ^ (i >> 2))
      {
        std::swap(a, b);
      }
      const vtkIdType ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const auto& triangle :
        Faces{ { a, ab, ca }, { ab, b, bc }, { ca, bc, c }, { ab, bc, ca } })
      {
        this->Triangles.push_back(triangle);
      }
    }
    for (Point& p : this->Corners)
    {
      const double r = radius(random);
      p = { r * p[0] + side(random), r * p[1] + side(random), r * p[2] + side(random) };
    }
  }

  std::vector<HalfSpace> GetHalfSpaces() const
  {
    std::vector<HalfSpace> result;
    for (const auto& t : this->Triangles)
    {
      const auto at = [&](int i) -> Vector
      { return { this->Corners[t[i]][0], this->Corners[t[i]][1], this->Corners[t[i]][2] }; };
      const Vector normal = Unit(Cross(at(1) - at(0), at(2) - at(0)));
      result.push_back({ normal, Dot(normal, at(0)) });
    }
    return result;
  }
};

//------------------------------------------------------------------------------
// All corners that three planes make within the others.
Points FindCorners(const std::vector<HalfSpace>& halfSpaces)
{
  Points corners;
  const std::size_t n = halfSpaces.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      for (std::size_t k = 0; k < j; ++k)
      {
        Vector p;
        if (!Intersect(halfSpaces[i], halfSpaces[j], halfSpaces[k], p) ||
          std::any_of(halfSpaces.begin(), halfSpaces.end(),
            [&](const HalfSpace& h) { return h.GetDistance(p) > 1e-9; }) ||
          std::any_of(corners.begin(), corners.end(),
            [&](const Point& q) { return Norm(p - Vector{ q[0], q[1], q[2] }) < 1e-8; }))
        {
          continue;
        }
        corners.push_back({ p.X, p.Y, p.Z });
      }
    }
  }
  return corners;
}

//------------------------------------------------------------------------------
// If this fails, kernels of very large or small cells are lost or out of place.
TEST(Kernel, MeshesOfExtremeSizes)
{
  const Grid prism = FindReferenceShape("L-prism").Polyhedron;
  const Grid polygon = MakeGrid({ { 0, 0, 0 }, { 3, 0, 0 }, { 3, 2, 0 }, { 1, 1, 0 }, { 0, 2, 0 } },
    { { VTK_POLYGON, { 0, 1, 2, 3, 4 } } });
  for (const Grid& mesh : { prism, polygon })
  {
    const auto makeKernel = [&mesh](int exponent)
    {
      const Grid grid = Scale(mesh, exponent, 1);
      auto kernel = Grid::New();
      EXPECT_TRUE(MakeKernelCells(grid, {}, nullptr, [](double) { return true; }, kernel));
      return kernel;
    };
    const Grid usual = makeKernel(0);
    ASSERT_EQ(usual->GetNumberOfCells(), 1);
    for (const int exponent : { 500, -500 })
    {
      const Grid extreme = makeKernel(exponent);
      ASSERT_EQ(extreme->GetNumberOfCells(), 1) << exponent;
      ASSERT_EQ(extreme->GetNumberOfPoints(), usual->GetNumberOfPoints());
      EXPECT_NEAR(extreme->GetCellData()->GetArray("KernelRatio")->GetComponent(0, 0),
        usual->GetCellData()->GetArray("KernelRatio")->GetComponent(0, 0), 1e-12);
      for (vtkIdType i = 0; i < usual->GetNumberOfPoints(); ++i)
      {
        for (int k = 0; k < 3; ++k)
        {
          EXPECT_NEAR(std::ldexp(extreme->GetPoint(i)[k], -exponent), usual->GetPoint(i)[k], 1e-12);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// Volume of the polyhedron with these corners, as pyramids from the origin over its faces.
double GetKernelVolume(const std::vector<HalfSpace>& halfSpaces, const Points& corners)
{
  double sum = 0;
  for (const HalfSpace& h : halfSpaces)
  {
    std::vector<Vector> face;
    Vector mean;
    for (const Point& corner : corners)
    {
      const Vector p = { corner[0], corner[1], corner[2] };
      if (std::abs(h.GetDistance(p)) < 1e-8)
      {
        face.push_back(p);
        mean += p;
      }
    }
    if (face.size() < 3)
    {
      continue;
    }
    mean = (1.0 / face.size()) * mean;
    const Vector u = Unit(face[0] - mean), v = Cross(h.Normal, u);
    const auto angle = [&](const Vector& p)
    { return std::atan2(Dot(p - mean, v), Dot(p - mean, u)); };
    std::sort(face.begin(), face.end(),
      [&](const Vector& p, const Vector& q) { return angle(p) < angle(q); });
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      sum += h.Offset * Norm(Cross(face[i] - mean, face[(i + 1) % face.size()] - mean)) / 6;
    }
  }
  return sum;
}

}

// The published tables of polyhedra.
TEST(Kernel, ReferencePolyhedra)
{
  // InradiusCircumradiusRatio, KernelRatio, and the three measures and the quality of virtual
  // elements.
  const std::map<std::string, std::vector<double>> table = {
    { "unit cube", { 0.5773502692, 1, 1, 0.6422285252, 0.7083333333, 0.8217547866 } },
    { "regular tetrahedron", { 0.3333333333, 1, 1, 0.5741587327, 1, 0.8871749356 } },
    { "right-corner tetrahedron", { 0.2588190451, 1, 1, 0.4643225549, 1, 0.8556642317 } },
    { "square pyramid", { 0.3660254038, 1, 1, 0.5523205969, 0.875, 0.8447841727 } },
    { "right triangular prism", { 0.377964473, 1, 1, 0.6112177341, 0.825, 0.847413044 } },
    { "regular octahedron", { 0.5773502692, 1, 1, 0.6041791073, 0.75, 0.8228545155 } },
    { "regular dodecahedron", { 0.7946544723, 1, 1, 0.597692129, 0.4666666667, 0.7295062699 } },
    { "truncated octahedron", { 0.7745966692, 1, 1, 0.5179868223, 0.4464285714, 0.6944117632 } },
    { "sheared hex", { 0.2886751346, 1, 1, 0.4927359195, 0.7083333333, 0.7749416923 } },
    { "box", { 0.2182178902, 1, 1, 0.4077116929, 0.7083333333, 0.7470090449 } },
    { "flat sliver", { 0.009997500737, 1, 1, 0.3093065513, 1, 0.8091064674 } },
    { "hexagonal prism", { 0.4472135955, 1, 1, 0.6350639348, 0.59375, 0.7838411621 } },
    { "L-prism", { 1.0 / 3, 1.0 / 3, 0.2222222222, 0.512574829, 0.59375, 0.3506065901 } },
    { "warped hex",
      { 0.4850712501, 0.9258751032, 0.9629375516, 0.5770294986, 0.7083333333, 0.7866778687 } },
  };
  const char* names[] = { "InradiusCircumradiusRatio", "KernelRatio", "PolyhedronRho1",
    "PolyhedronRho2", "PolyhedronRho3", "PolyhedronQuality" };
  for (const auto& row : table)
  {
    const ReferenceShape& shape = FindReferenceShape(row.first);
    for (vtkUnstructuredGrid* grid : { shape.Standard.Get(), shape.Polyhedron.Get() })
    {
      if (grid)
      {
        Values values = EvaluateNames(grid);
        for (int i = 0; i < 6; ++i)
        {
          // The table has ten digits.
          ExpectNear(
            row.second[i], values[names[i]][0], 5e-10, row.first + std::string(" ") + names[i]);
        }
        EXPECT_EQ(values["IsStarShaped"][0], 1) << row.first;
        if (row.second[1] == 1)
        {
          EXPECT_EQ(values["KernelRatio"][0], 1) << row.first; // not nearly
        }
      }
    }
  }
  // Half a cube's edge; the L-prism's ball lies in the cube at its corner, of diameter 3.
  const Grid cube = FindReferenceShape("unit cube").Standard;
  EXPECT_NEAR(GetValue(cube, "KernelInradiusRatio"), 0.5 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(GetValue(cube, "ShapeRegularity"), 1 / std::sqrt(3.0), 1e-12);
  const Grid prism = FindReferenceShape("L-prism").Polyhedron;
  EXPECT_NEAR(GetValue(prism, "KernelInradiusRatio"), 1.0 / 6, 1e-12);
  EXPECT_NEAR(GetValue(prism, "ShapeRegularity"), 1.0 / 3, 1e-12);
}

// The published table of polygons.
TEST(Kernel, ReferencePolygons)
{
  const double h = std::sqrt(3.0) / 2;
  const struct
  {
    const char* Name;
    Points Polygon;
    double RadiusRatio, KernelRatio;
  } rows[] = {
    { "square", { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, 0.7071067812, 1 },
    { "rectangle", { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 0, 1, 0 } }, 0.4472135955, 1 },
    { "rhombus", { { 0, 0, 0 }, { 1, 0, 0 }, { 1.5, h, 0 }, { .5, h, 0 } }, 0.5, 1 },
    { "pentagon", MakeRegularPolygon(5, 0), 0.8090169944, 1 },
    { "hexagon", MakeRegularPolygon(6, 0), 0.8660254038, 1 },
    { "equilateral", { { 0, 0, 0 }, { 1, 0, 0 }, { .5, h, 0 } }, 0.5, 1 },
    { "right isosceles", { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, 0.4142135624, 1 },
    { "3-4-5", { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 3, 0 } }, 0.4, 1 },
    // By hand: the circle about (r, r) touches the reflex corner; that around has the diagonal.
    { "L hexagon", LHexagon, std::sqrt(2.0) - 1, 1.0 / 3 },
    // By an independent program, from all triples of edges in the plane along the vector area. (The
    // published table has 0.6655837944, which axes give that are not perpendicular.)
    { "warped quad", { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, .5 }, { 0, 1, 0 } }, 0.684938162840, 1 },
  };
  for (const auto& row : rows)
  {
    const Grid grid = MakePolygon(row.Polygon);
    ExpectNear(row.RadiusRatio, GetValue(grid, "InradiusCircumradiusRatio"), 5e-10, row.Name);
    ExpectNear(row.KernelRatio, GetValue(grid, "KernelRatio"), 1e-10, row.Name);
    EXPECT_EQ(GetValue(grid, "VemRho1"), GetValue(grid, "KernelRatio")) << row.Name;
  }
  for (int n = 3; n < 12; ++n)
  {
    EXPECT_NEAR(GetValue(MakePolygon(MakeRegularPolygon(n, 0)), "NormalizedRadiusRatio"), 1, 1e-12)
      << n;
  }
  // By hand: a square has sides and root of the area 1, diameter root of 2.
  Values square = EvaluateNames(MakePolygon(rows[0].Polygon));
  EXPECT_NEAR(square["VemRho2"][0], std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(square["VemRho3"][0], 0.75, 1e-12);
  EXPECT_NEAR(square["VemQuality"][0], std::sqrt((std::sqrt(0.5) + 0.75) / 2), 1e-12);
  Values hexagon = EvaluateNames(MakePolygon(LHexagon));
  EXPECT_NEAR(hexagon["VemRho2"][0], 1 / std::sqrt(8.0), 1e-12);
  EXPECT_NEAR(hexagon["VemQuality"][0], std::sqrt((1 / std::sqrt(8.0) + 0.5) / 6), 1e-12);
  EXPECT_NEAR(hexagon["KernelInradiusRatio"][0], 0.5 / std::sqrt(8.0), 1e-12);
}

// Random cells that are not convex against the corners that all triples of planes make,
// against the balls that all quadruples of planes make.
TEST(Kernel, TryEverything)
{
  std::mt19937 random(3);
  int empty = 0, full = 0;
  for (int trial = 0; trial < 90; ++trial)
  {
    const SpikyBall ball(random, trial % 2 ? 0.3 : 0.55, trial % 3 ? 0 : 0.3);
    const Grid grid = MakePolyhedron(ball.Corners, ball.Triangles);
    const double volume = GetValue(grid, "Volume"), ratio = GetValue(grid, "KernelRatio");
    const std::vector<HalfSpace> halfSpaces = ball.GetHalfSpaces();
    const Points corners = FindCorners(halfSpaces);
    if (corners.size() < 4)
    {
      EXPECT_EQ(ratio, 0) << trial;
      EXPECT_EQ(GetValue(grid, "IsStarShaped"), 0) << trial;
      EXPECT_EQ(
        GetNullReason(GetValue(grid, "InradiusCircumradiusRatio")), NullReason::NotApplicable);
      ++empty;
      continue;
    }
    full += ratio < 1;
    EXPECT_NEAR(ratio, GetKernelVolume(halfSpaces, corners) / volume, 1e-8) << trial;
    EXPECT_EQ(GetValue(grid, "IsStarShaped"), 1) << trial;
    if (trial >= 10)
    {
      continue;
    }
    // The largest ball touches four planes (random ones are never parallel).
    double largest = 0;
    const std::size_t n = halfSpaces.size();
    for (std::size_t i = 0; i < n; ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        for (std::size_t k = 0; k < j; ++k)
        {
          for (std::size_t l = 0; l < k; ++l)
          {
            // Less the fourth: planes through points as far from it as from each of the others.
            HalfSpace bisectors[3] = { halfSpaces[i], halfSpaces[j], halfSpaces[k] };
            for (HalfSpace& bisector : bisectors)
            {
              bisector.Normal = bisector.Normal - halfSpaces[l].Normal;
              bisector.Offset -= halfSpaces[l].Offset;
            }
            Vector center;
            if (!Intersect(bisectors[0], bisectors[1], bisectors[2], center))
            {
              continue;
            }
            const double radius = -halfSpaces[l].GetDistance(center);
            if (radius > largest &&
              std::all_of(halfSpaces.begin(), halfSpaces.end(),
                [&](const HalfSpace& h) { return h.GetDistance(center) <= -radius + 1e-10; }))
            {
              largest = radius;
            }
          }
        }
      }
    }
    EXPECT_NEAR(GetValue(grid, "KernelInradiusRatio") * GetValue(grid, "Diameter"), largest, 1e-8)
      << trial;
  }
  EXPECT_GT(empty, 5);
  EXPECT_GT(full, 20);
}

// Turned, moved far away and scaled, cells that are not convex keep their values.
TEST(Kernel, Invariance)
{
  std::mt19937 random(13);
  std::vector<std::pair<Points, Faces>> cells;
  for (int i = 0; i < 5; ++i)
  {
    const SpikyBall ball(random, 0.55);
    cells.emplace_back(ball.Corners, ball.Triangles);
  }
  cells.emplace_back(LHexagon, Faces());
  Points star;
  for (int i = 0; i < 10; ++i)
  {
    const double r = i % 2 ? 0.5 : 1, angle = Pi / 5 * i;
    star.push_back({ r * std::cos(angle), r * std::sin(angle), 0 });
  }
  cells.emplace_back(star, Faces());
  const double c = std::cos(0.7), s = std::sin(0.7);
  const struct
  {
    std::function<Point(const Point&)> Map;
    double Tolerance;
  } changes[] = {
    { [=](const Point& p)
      {
        const Point q = { c * p[0] - s * p[1], s * p[0] + c * p[1], p[2] };
        return Point{ q[0], c * q[1] - s * q[2], s * q[1] + c * q[2] };
      },
      1e-9 },
    { [](const Point& p) { return Point{ p[0] + 1e6, p[1] - 1e6, p[2] + 1e6 }; }, 1e-7 },
    { [](const Point& p) { return Point{ 1e-6 * p[0], 1e-6 * p[1], 1e-6 * p[2] }; }, 1e-9 },
    { [](const Point& p) { return Point{ 1e9 * p[0], 1e9 * p[1], 1e9 * p[2] }; }, 1e-9 },
  };
  for (const auto& cell : cells)
  {
    const auto make = [&](const Points& points)
    { return cell.second.empty() ? MakePolygon(points) : MakePolyhedron(points, cell.second); };
    Values expected = EvaluateNames(make(cell.first));
    EXPECT_GT(expected["KernelRatio"][0], 0);
    EXPECT_LT(expected["KernelRatio"][0], 1);
    for (const auto& change : changes)
    {
      Points points;
      std::transform(cell.first.begin(), cell.first.end(), std::back_inserter(points), change.Map);
      Values values = EvaluateNames(make(points));
      for (const std::string& name : Names)
      {
        if (!std::isnan(expected[name][0]))
        {
          EXPECT_NEAR(values[name][0], expected[name][0], change.Tolerance) << name;
        }
      }
    }
  }
}

// Cells that are flat, collapsed, open or without coordinates: a value or a reason for having none.
TEST(Kernel, Degenerate)
{
  const auto reason = [](const Grid& grid, const char* name)
  { return GetNullReason(GetValue(grid, name)); };
  const Grid flat = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, { { VTK_TETRA, { 0, 1, 2, 3 } } });
  const Grid line = MakePolygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 1, 0, 0 } });
  for (const Grid& grid : { flat, line })
  {
    EXPECT_EQ(reason(grid, "KernelRatio"), NullReason::Degenerate);
    EXPECT_EQ(reason(grid, "IsStarShaped"), NullReason::Degenerate);
    EXPECT_EQ(GetValue(grid, "InradiusCircumradiusRatio"), 0);
    EXPECT_EQ(GetValue(grid, "ShapeRegularity"), 0);
    EXPECT_EQ(GetValue(grid, "KernelInradiusRatio"), 0);
  }
  const Grid point = MakeGrid(Points(8), { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } } });
  for (const char* name : { "KernelRatio", "InradiusCircumradiusRatio", "PolyhedronRho2" })
  {
    EXPECT_EQ(reason(point, name), NullReason::Degenerate) << name;
  }
  const ReferenceShape& cube = FindReferenceShape("unit cube");
  Faces faces = GetFaces(cube.Polyhedron, 0);
  faces.pop_back();
  const Grid open = MakePolyhedra(cube.Polyhedron->GetPoints(), { faces });
  for (const std::string& name : Names)
  {
    if (FindCriterion(name)->AppliesTo & Polyhedra)
    {
      EXPECT_EQ(reason(open, name.c_str()), NullReason::InvalidTopology) << name;
    }
  }
  // A collapsed edge changes neither kernel nor balls.
  const Grid collapsed =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { .5, .5, 1 }, { .5, .5, 1 } },
      { { VTK_WEDGE, { 0, 4, 3, 1, 5, 2 } } });
  EXPECT_EQ(GetValue(collapsed, "KernelRatio"), 1);
  EXPECT_EQ(GetValue(collapsed, "PolyhedronRho2") > 0, true);
  // Inverted, like the mirrored cell.
  const Grid inverted = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { { VTK_TETRA, { 0, 2, 1, 3 } } });
  EXPECT_EQ(GetValue(inverted, "KernelRatio"), 1);
  EXPECT_NEAR(GetValue(inverted, "InradiusCircumradiusRatio"), 0.2588190451, 1e-9);
  // Bow tie: no area.
  EXPECT_EQ(
    reason(MakePolygon({ { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }), "KernelRatio"),
    NullReason::Degenerate);
}

// CellStatus tells of cells without a kernel if IsStarShaped is evaluated, too, and not otherwise.
TEST(Kernel, CellStatus)
{
  // A U of three boxes.
  const Points u = { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 3, 0 }, { 2, 3, 0 }, { 2, 1, 0 }, { 1, 1, 0 },
    { 1, 3, 0 }, { 0, 3, 0 } };
  const Grid grid = MakePolygon(u);
  EXPECT_EQ(GetValue(grid, "KernelRatio"), 0);
  Values both = EvaluateNames(grid, { "CellStatus", "IsStarShaped" });
  EXPECT_EQ(both["IsStarShaped"][0], 0);
  EXPECT_EQ(both["CellStatus"][0], Nonconvex | NotStarShaped);
  EXPECT_EQ(GetValue(grid, "CellStatus"), Nonconvex);
  both = EvaluateNames(MakePolygon(LHexagon), { "CellStatus", "IsStarShaped" });
  EXPECT_EQ(both["CellStatus"][0], Nonconvex);
}

// Many cells of points thrown anywhere: every value lies in its range or has a
// reason.
TEST(Kernel, Soup)
{
  std::mt19937 random(17);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::uniform_int_distribution<int> coarse(-1, 1);
  Points points;
  Cells cells;
  const int types[] = { VTK_HEXAHEDRON, VTK_POLYGON, VTK_TETRA, VTK_WEDGE, VTK_QUAD };
  const int sizes[] = { 8, 9, 4, 6, 4 };
  for (int cell = 0; cell < Often(100000); ++cell)
  {
    const int kind = cell % 5;
    cells.push_back({ types[kind], {} });
    for (int i = 0; i < sizes[kind]; ++i)
    {
      cells.back().second.push_back(static_cast<vtkIdType>(points.size()));
      const auto any = [&] { return cell % 3 ? coordinate(random) : double(coarse(random)); };
      points.push_back({ any(), any(), any() });
    }
  }
  points[1000] = { NaN, 0, 0 };
  const Grid grid = MakeGrid(points, cells);
  Values values = EvaluateNames(grid);
  for (const auto& row : values)
  {
    const Criterion* criterion = FindCriterion(row.first);
    for (std::size_t i = 0; i < row.second.size(); ++i)
    {
      const double value = row.second[i];
      if (std::isnan(value))
      {
        ASSERT_NE(GetNullReason(value), NullReason::Value) << row.first << ' ' << i;
        continue;
      }
      ASSERT_GE(value, criterion->Range[0]) << row.first << ' ' << i;
      ASSERT_LE(value, criterion->Range[1] + 1e-9) << row.first << ' ' << i;
    }
  }
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    if (!std::isnan(values["KernelRatio"][i]))
    {
      ASSERT_EQ(values["KernelRatio"][i] > 0, values["IsStarShaped"][i] == 1) << i;
    }
  }
}
