// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Criteria of cells of higher order, by examples with known values and by VTK's own interpolation.
#include "CriteriaTesting.h"
#include "Curved/CellMap.h"
#include "Sanitized.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <random>

namespace camaron
{
namespace testing
{
namespace
{
using Pairs = std::vector<std::array<int, 2>>;

constexpr double Folded = 0x100000, ZeroJacobian = 0x200000;

//------------------------------------------------------------------------------
struct Shape
{
  Points Corners;
  Pairs Edges;    // whose middles follow the corners
  double Measure; // by which the tables of examples divide determinants
};

// clang-format off
const std::map<int, Shape> Shapes = {
  { VTK_QUADRATIC_TRIANGLE, { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } },
    { { 0, 1 }, { 1, 2 }, { 2, 0 } }, 0.5 } },
  { VTK_QUADRATIC_QUAD, { { { -1, -1, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { -1, 1, 0 } },
    { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } }, 4 } },
  { VTK_QUADRATIC_TETRA, { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 }, { 2, 3 } }, 1.0 / 6 } },
  { VTK_QUADRATIC_HEXAHEDRON, { { { -1, -1, -1 }, { 1, -1, -1 }, { 1, 1, -1 }, { -1, 1, -1 },
      { -1, -1, 1 }, { 1, -1, 1 }, { 1, 1, 1 }, { -1, 1, 1 } },
    { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 4, 5 }, { 5, 6 }, { 6, 7 }, { 7, 4 },
      { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } }, 8 } },
  { VTK_QUADRATIC_WEDGE, { { { 0, 0, -1 }, { 1, 0, -1 }, { 0, 1, -1 }, { 0, 0, 1 }, { 1, 0, 1 },
      { 0, 1, 1 } },
    { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 5 }, { 5, 3 }, { 0, 3 }, { 1, 4 }, { 2, 5 } },
    1 } },
  { VTK_QUADRATIC_PYRAMID, { { { -1, -1, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { -1, 1, 0 },
      { 0, 0, 1 } },
    { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 0, 4 }, { 1, 4 }, { 2, 4 }, { 3, 4 } },
    4.0 / 3 } },
};
// clang-format on

//------------------------------------------------------------------------------
Point Average(const Point& a, const Point& b)
{
  return { (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2 };
}

//------------------------------------------------------------------------------
// The nodes of a cell with straight edges, some of them moved.
Points MakeNodes(int type, const std::map<int, Point>& moved)
{
  const Shape& shape = Shapes.at(type);
  Points nodes = shape.Corners;
  for (const auto& edge : shape.Edges)
  {
    nodes.push_back(Average(shape.Corners[edge[0]], shape.Corners[edge[1]]));
  }
  for (const auto& [node, place] : moved)
  {
    nodes[node] = place;
  }
  return nodes;
}

//------------------------------------------------------------------------------
Point OnCircle(double radius, double degrees, double z = 0)
{
  const double angle = degrees * Pi / 180;
  return { radius * std::cos(angle), radius * std::sin(angle), z };
}

//------------------------------------------------------------------------------
// A sector of a ring between radii 1 and 2: a quadrilateral, or a hexahedron of height 1.
Points MakeSector(double degrees, bool isSolid)
{
  Points nodes;
  const auto addCorners = [&](double z)
  {
    for (const auto& [radius, part] :
      { std::pair(1, 0), std::pair(2, 0), std::pair(2, 1), std::pair(1, 1) })
    {
      nodes.push_back(OnCircle(radius, part * degrees, z));
    }
  };
  const auto addMiddles = [&](double z)
  {
    for (const auto& [radius, part] :
      { std::pair(1.5, 0.0), std::pair(2.0, 0.5), std::pair(1.5, 1.0), std::pair(1.0, 0.5) })
    {
      nodes.push_back(OnCircle(radius, part * degrees, z));
    }
  };
  addCorners(0);
  if (!isSolid)
  {
    addMiddles(0);
    return nodes;
  }
  addCorners(1);
  addMiddles(0);
  addMiddles(1);
  addCorners(0.5);
  return nodes;
}

//------------------------------------------------------------------------------
// A determinant by VTK's interpolation, times the measure of the parametric domain. Central
// differences of functions of degree 2 are exact.
double GetDeterminant(vtkCell* cell, const std::array<double, 3>& at, double measure)
{
  std::vector<double> weights(cell->GetNumberOfPoints());
  Vector columns[3];
  for (int d = 0; d < cell->GetCellDimension(); ++d)
  {
    for (const int sign : { -1, 1 })
    {
      std::array<double, 3> place = at;
      place[d] += 0.25 * sign;
      cell->InterpolateFunctions(place.data(), weights.data());
      for (std::size_t i = 0; i < weights.size(); ++i)
      {
        double p[3];
        cell->GetPoints()->GetPoint(static_cast<vtkIdType>(i), p);
        columns[d] += 2 * sign * weights[i] * Vector{ p[0], p[1], p[2] };
      }
    }
  }
  const Vector cross = Cross(columns[0], columns[1]);
  return measure * (cell->GetCellDimension() == 2 ? cross.Z : Dot(cross, columns[2]));
}

//------------------------------------------------------------------------------
struct Domain
{
  double Measure;
  bool IsSimplex, IsWedge;
};
Domain GetDomain(int type)
{
  const bool isTriangle = type == VTK_QUADRATIC_TRIANGLE;
  const bool isTetra = type == VTK_QUADRATIC_TETRA;
  const bool isWedge = type == VTK_QUADRATIC_WEDGE || type == VTK_BIQUADRATIC_QUADRATIC_WEDGE;
  return { isTetra ? 1.0 / 6 : isTriangle || isWedge ? 0.5 : 1, isTriangle || isTetra, isWedge };
}

//------------------------------------------------------------------------------
bool IsInside(const std::array<double, 3>& at, int dimension, const Domain& domain)
{
  double sum = 0;
  for (int d = 0; d < (domain.IsWedge ? 2 : dimension); ++d)
  {
    sum += at[d];
  }
  return !(domain.IsSimplex || domain.IsWedge) || sum <= 1;
}

//------------------------------------------------------------------------------
// The integral of the determinant by Gauss quadrature, on simplices with collapsed coordinates.
double Integrate(vtkCell* cell, const Domain& domain)
{
  constexpr double Places[] = { 0.06943184420297371, 0.33000947820757187, 0.6699905217924281,
    0.9305681557970262 };
  constexpr double Weights[] = { 0.17392742256872692, 0.32607257743127307, 0.32607257743127307,
    0.17392742256872692 };
  const int dimension = cell->GetCellDimension();
  double sum = 0;
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      for (int k = 0; k < (dimension == 3 ? 4 : 1); ++k)
      {
        double weight = Weights[i] * Weights[j] * (dimension == 3 ? Weights[k] : 1);
        std::array<double, 3> at = { Places[i], Places[j], dimension == 3 ? Places[k] : 0 };
        if (domain.IsSimplex || domain.IsWedge)
        {
          weight *= 1 - at[0];
          at[1] *= 1 - at[0];
        }
        if (domain.IsSimplex && dimension == 3)
        {
          const double rest = 1 - at[0] - at[1];
          weight *= rest;
          at[2] *= rest;
        }
        sum += weight * GetDeterminant(cell, at, 1);
      }
    }
  }
  return sum;
}

//------------------------------------------------------------------------------
// The nodes of a cell of any type where those of the linear cell with these corners would be.
Grid MakeStraight(int type, int size, const Points& corners, int linearType)
{
  const Grid linear = MakeCell(linearType, corners);
  Points nodes(size);
  std::vector<vtkIdType> ids(size);
  std::iota(ids.begin(), ids.end(), 0);
  const Grid grid = MakeGrid(nodes, { { type, ids } });
  vtkCell* const cell = grid->GetCell(0);
  const double* parametric = cell->GetParametricCoords();
  std::vector<double> weights(corners.size());
  for (int node = 0; node < size; ++node)
  {
    std::array<double, 3> at = { parametric[3 * node], parametric[3 * node + 1],
      parametric[3 * node + 2] };
    if (type == VTK_TRIQUADRATIC_PYRAMID) // whose coordinates do not collapse
    {
      const double q = 2 - 2 * at[2];
      at = { q > 0 ? 0.5 + (at[0] - 0.5) / q : 0, q > 0 ? 0.5 + (at[1] - 0.5) / q : 0, 1 - q };
    }
    linear->GetCell(0)->InterpolateFunctions(at.data(), weights.data());
    Point place = {};
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        place[k] += weights[i] * corners[i][k];
      }
    }
    nodes[node] = place;
  }
  return MakeGrid(nodes, { { type, ids } });
}
}

//------------------------------------------------------------------------------
TEST(CurvedCells, KnownValues)
{
  struct Example
  {
    const char* Name;
    int Type;
    std::map<int, Point> Moved;
    double Size, Least, Greatest, Status;
    double InverseCondition = NAN;
  };
  // The bounds of the last four are exact to the third digit of the greatest value.
  const Example examples[] = {
    { "A1", VTK_QUADRATIC_TRIANGLE, { { 3, { .5, .1, 0 } } }, 13.0 / 30, .6, 1, 0, .59047 },
    { "A2", VTK_QUADRATIC_TRIANGLE, { { 3, { .5, .3, 0 } } }, .3, -.2, 1, Folded },
    { "A3", VTK_QUADRATIC_TRIANGLE, { { 3, { .3, 0, 0 } } }, .5, .2, 1.8, 0, .33309 },
    { "A4", VTK_QUADRATIC_TRIANGLE, { { 3, { .25, 0, 0 } }, { 5, { 0, .25, 0 } } }, .5, 0, 2,
      ZeroJacobian },
    { "B1", VTK_QUADRATIC_TETRA, { { 4, { .5, .1, 0 } } }, .15, .6, 1, 0, .54429 },
    { "B2", VTK_QUADRATIC_TETRA, { { 4, { .2, 0, 0 } } }, 1.0 / 6, -.2, 2.2, Folded },
    { "B3", VTK_QUADRATIC_TETRA,
      { { 4, { .5, .2, 0 } }, { 6, { 0, .5, .2 } }, { 7, { .2, 0, .5 } } }, .0826666666666667, .2,
      1.512, 0 },
    { "C1", VTK_QUADRATIC_QUAD, { { 4, { 0, -.5, 0 } } }, 10.0 / 3, .75, 1, 0 },
    { "D1", VTK_QUADRATIC_HEXAHEDRON,
      { { 8, { 0, -1.4, -1 } }, { 17, { 1.4, -1, 0 } }, { 14, { 0, 1, 1.4 } } }, 9.67111111111111,
      .84, 1.44, 0 },
    { "E1", VTK_QUADRATIC_WEDGE, { { 6, { .5, .2, -1 } } }, 13.0 / 15, .2, 1, 0, .17365 },
    { "E3", VTK_QUADRATIC_WEDGE, { { 12, { 0, 0, -.6 } } }, 1, -.2, 2.2, Folded },
    { "P1", VTK_QUADRATIC_PYRAMID, { { 5, { 0, -.5, 0 } } }, 7.0 / 6, .75, 1, 0 },
    { "P2", VTK_QUADRATIC_PYRAMID, { { 9, { -.2, -.2, .8 } } }, 4.0 / 3, -.2, 2.2, Folded },
    { "H1", VTK_QUADRATIC_TRIANGLE,
      { { 3, { .85, .55, 0 } }, { 4, { .85, .75, 0 } }, { 5, { -.35, .35, 0 } } }, .766666666666667,
      -.400051, 4.04, Folded },
    { "H2", VTK_QUADRATIC_TETRA, { { 5, { 1, .95, .05 } }, { 6, { .5, .3, .25 } } }, .157,
      -.4011364, 4.4, Folded, .06568 },
    { "H3", VTK_QUADRATIC_QUAD, { { 5, { 1.9, .4, 0 } }, { 6, { -.3, 0, 0 } } }, 58.0 / 15,
      -.2759223, 3.92, Folded },
    { "H4", VTK_QUADRATIC_HEXAHEDRON, { { 10, { 0, 1.9, -.3 } }, { 11, { 0, -.4, -.3 } } },
      5.90666666666667, -.3694276, 5.4, Folded },
  };
  for (const Example& example : examples)
  {
    const Values values =
      EvaluateAll(MakeCell(example.Type, MakeNodes(example.Type, example.Moved)));
    const double measure = Shapes.at(example.Type).Measure;
    const auto get = [&](const char* name) { return values.at(name)[0]; };
    const bool isSurface =
      example.Type == VTK_QUADRATIC_TRIANGLE || example.Type == VTK_QUADRATIC_QUAD;
    EXPECT_NEAR(get(isSurface ? "Area" : "Volume"), example.Size, 1e-12) << example.Name;
    const double least = get("MinJacobian") / measure, greatest = get("MaxJacobian") / measure;
    EXPECT_LE(least, example.Least + 1e-7) << example.Name;
    EXPECT_GE(least, example.Least - 1e-3 * example.Greatest) << example.Name;
    EXPECT_GE(greatest, example.Greatest - 1e-7) << example.Name;
    EXPECT_LE(greatest, example.Greatest * (1 + 1e-3)) << example.Name;
    EXPECT_NEAR(get("JacobianRatio"), least / greatest, 1e-14) << example.Name;
    EXPECT_EQ(
      static_cast<int>(get("CellStatus")) & static_cast<int>(Folded + ZeroJacobian), example.Status)
      << example.Name;
    if (example.Status != 0)
    {
      EXPECT_EQ(get("IsValid"), example.Status == ZeroJacobian) << example.Name;
    }
    if (!std::isnan(example.InverseCondition))
    {
      EXPECT_NEAR(get("MinInverseConditionNumber"), example.InverseCondition, 1e-5) << example.Name;
    }
  }
}

//------------------------------------------------------------------------------
TEST(CurvedCells, SectorsOfRings)
{
  for (const auto& [angle, area, ratio] : { std::tuple(90, 2.3284271247, .386730),
         std::tuple(45, 1.1771803389, .464632), std::tuple(30, .7852761804, .483524) })
  {
    for (const bool isSolid : { false, true })
    {
      const Values values = EvaluateAll(MakeCell(
        isSolid ? VTK_QUADRATIC_HEXAHEDRON : VTK_QUADRATIC_QUAD, MakeSector(angle, isSolid)));
      EXPECT_NEAR(values.at(isSolid ? "Volume" : "Area")[0], area, 1e-10);
      EXPECT_NEAR(values.at("JacobianRatio")[0], ratio, 1e-6);
      EXPECT_NEAR(values.at("MidsideNodeOffsetFromEdge")[0], std::tan(angle * Pi / 720) / 2, 1e-12);
      EXPECT_NEAR(values.at("MidsideNodeOffsetAlongEdge")[0], 0, 1e-12);
      EXPECT_EQ(values.at("IsValid")[0], 1);
    }
  }
  const Values quarter = EvaluateAll(MakeCell(VTK_QUADRATIC_QUAD, MakeSector(90, false)));
  EXPECT_NEAR(quarter.at("MaxEdgeLength")[0], 2 * 1.5624171253, 2e-10);
  EXPECT_NEAR(quarter.at("MinEdgeLength")[0], 1, 1e-14);
  EXPECT_NEAR(quarter.at("Perimeter")[0], 2 + 3 * 1.5624171253, 3e-10);
  EXPECT_NEAR(quarter.at("MinInverseConditionNumber")[0], .50473, 1e-5);
  const Values folded = EvaluateAll(
    MakeCell(VTK_QUADRATIC_TRIANGLE, MakeNodes(VTK_QUADRATIC_TRIANGLE, { { 3, { .2, 0, 0 } } })));
  EXPECT_NEAR(folded.at("MinEdgeLength")[0], 1, 1e-14);
  EXPECT_NEAR(folded.at("Perimeter")[0], 61.0 / 60 + 1 + std::sqrt(2.0), 1e-10);
}

//------------------------------------------------------------------------------
// Bounds are never on the wrong side of a sample, nor far from the smallest one; sizes are those of
// a quadrature.
TEST(CurvedCells, RandomCellsAgainstVTK)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  const std::pair<int, int> types[] = { { VTK_QUADRATIC_TRIANGLE, 6 }, { VTK_QUADRATIC_QUAD, 8 },
    { VTK_BIQUADRATIC_QUAD, 9 }, { VTK_QUADRATIC_TETRA, 10 }, { VTK_QUADRATIC_HEXAHEDRON, 20 },
    { VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 24 }, { VTK_TRIQUADRATIC_HEXAHEDRON, 27 },
    { VTK_QUADRATIC_WEDGE, 15 }, { VTK_BIQUADRATIC_QUADRATIC_WEDGE, 18 } };
  for (const auto& [type, size] : types)
  {
    for (int trial = 0; trial < 12; ++trial)
    {
      const Domain domain = GetDomain(type);
      const Grid grid = MakeCell(type, Points(size));
      vtkCell* const parametric = grid->GetCell(0);
      const double noise = 0.04 * trial;
      const bool isSurface = parametric->GetCellDimension() == 2;
      Points nodes(size);
      for (int i = 0; i < size; ++i)
      {
        for (int k = 0; k < (isSurface ? 2 : 3); ++k)
        {
          nodes[i][k] = parametric->GetParametricCoords()[3 * i + k] + noise * (unit(random) - 0.5);
        }
      }
      const Grid mesh = MakeCell(type, nodes);
      const Values values = EvaluateAll(mesh);
      vtkCell* const cell = mesh->GetCell(0);
      const double volume = values.at(isSurface ? "Area" : "Volume")[0];
      EXPECT_NEAR(volume, std::abs(Integrate(cell, domain)), 1e-10) << type;
      const double least = values.at("MinJacobian")[0], greatest = values.at("MaxJacobian")[0];
      double smallest = HUGE_VAL, largest = -HUGE_VAL;
      for (int i = 0; i < (IsSanitized ? 200 : 2000); ++i)
      {
        // Half of the points are on the boundary or at corners, where extremes usually are.
        std::array<double, 3> at = { unit(random), unit(random), isSurface ? 0 : unit(random) };
        if (i % 4 == 0)
        {
          at[i / 4 % (isSurface ? 2 : 3)] = i / 12 % 2;
        }
        else if (i % 4 == 2)
        {
          for (double& coordinate : at)
          {
            coordinate = std::round(coordinate);
          }
        }
        if (IsInside(at, isSurface ? 2 : 3, domain))
        {
          const double determinant = GetDeterminant(cell, at, domain.Measure);
          smallest = std::min(smallest, determinant);
          largest = std::max(largest, determinant);
        }
      }
      EXPECT_LE(least, smallest + 1e-12) << type;
      EXPECT_GE(greatest, largest - 1e-12) << type;
      if (!IsSanitized) // which has few samples
      {
        const double scale = std::max(std::abs(smallest), std::abs(largest));
        EXPECT_GE(least, smallest - 0.25 * scale) << type;
        EXPECT_LE(greatest, largest + 0.25 * scale) << type;
      }
    }
  }
}

//------------------------------------------------------------------------------
// Cells of any order with straight edges equal the linear cell in every criterion.
TEST(CurvedCells, StraightCellsAreLinear)
{
  struct Type
  {
    int HigherOrder, Size, Linear;
  };
  const Type types[] = { { VTK_QUADRATIC_TRIANGLE, 6, VTK_TRIANGLE },
    { VTK_BIQUADRATIC_TRIANGLE, 7, VTK_TRIANGLE }, { VTK_LAGRANGE_TRIANGLE, 10, VTK_TRIANGLE },
    { VTK_LAGRANGE_TRIANGLE, 15, VTK_TRIANGLE }, { VTK_BEZIER_TRIANGLE, 6, VTK_TRIANGLE },
    { VTK_QUADRATIC_QUAD, 8, VTK_QUAD }, { VTK_BIQUADRATIC_QUAD, 9, VTK_QUAD },
    { VTK_QUADRATIC_LINEAR_QUAD, 6, VTK_QUAD }, { VTK_LAGRANGE_QUADRILATERAL, 16, VTK_QUAD },
    { VTK_BEZIER_QUADRILATERAL, 9, VTK_QUAD }, { VTK_QUADRATIC_TETRA, 10, VTK_TETRA },
    { VTK_LAGRANGE_TETRAHEDRON, 20, VTK_TETRA }, { VTK_LAGRANGE_TETRAHEDRON, 35, VTK_TETRA },
    { VTK_BEZIER_TETRAHEDRON, 10, VTK_TETRA }, { VTK_QUADRATIC_HEXAHEDRON, 20, VTK_HEXAHEDRON },
    { VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 24, VTK_HEXAHEDRON },
    { VTK_TRIQUADRATIC_HEXAHEDRON, 27, VTK_HEXAHEDRON },
    { VTK_LAGRANGE_HEXAHEDRON, 64, VTK_HEXAHEDRON },
    { VTK_LAGRANGE_HEXAHEDRON, 125, VTK_HEXAHEDRON }, { VTK_BEZIER_HEXAHEDRON, 27, VTK_HEXAHEDRON },
    { VTK_QUADRATIC_PYRAMID, 13, VTK_PYRAMID }, { VTK_TRIQUADRATIC_PYRAMID, 19, VTK_PYRAMID } };
  std::mt19937 random(2);
  std::uniform_real_distribution<double> noise(-0.15, 0.15);
  for (const Type& type : types)
  {
    for (int trial = 0; trial < 3; ++trial)
    {
      const Grid ideal = MakeStandardCell(type.Linear);
      Points corners(ideal->GetNumberOfPoints());
      for (std::size_t i = 0; i < corners.size(); ++i)
      {
        ideal->GetPoint(static_cast<vtkIdType>(i), corners[i].data());
        for (double& coordinate : corners[i])
        {
          coordinate += noise(random);
        }
      }
      const Grid linear = MakeCell(type.Linear, corners);
      const Grid straight = MakeStraight(type.HigherOrder, type.Size, corners, type.Linear);
      ExpectSame(EvaluateAll(linear), EvaluateAll(straight), 1e-12,
        std::to_string(type.HigherOrder) + " of " + std::to_string(type.Size), { "CellTypeId" });
    }
  }
}

//------------------------------------------------------------------------------
// Lagrange cells of order 2 are VTK's complete quadratic ones; those of Bezier with the control
// points of the same map as well.
TEST(CurvedCells, LagrangeAndBezier)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> noise(-0.1, 0.1);
  const std::array<int, 4> types[] = {
    { VTK_QUADRATIC_TRIANGLE, VTK_LAGRANGE_TRIANGLE, VTK_BEZIER_TRIANGLE, 6 },
    { VTK_BIQUADRATIC_QUAD, VTK_LAGRANGE_QUADRILATERAL, VTK_BEZIER_QUADRILATERAL, 9 },
    { VTK_QUADRATIC_TETRA, VTK_LAGRANGE_TETRAHEDRON, VTK_BEZIER_TETRAHEDRON, 10 },
  };
  for (const auto& [quadratic, lagrange, bezier, size] : types)
  {
    const Grid parametric = MakeCell(quadratic, Points(size));
    Points nodes(size);
    for (int i = 0; i < size; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        nodes[i][k] = parametric->GetCell(0)->GetParametricCoords()[3 * i + k] + noise(random);
      }
    }
    const Values values = EvaluateAll(MakeCell(quadratic, nodes));
    ExpectSame(values, EvaluateAll(MakeCell(lagrange, nodes)), 1e-12, "Lagrange", { "CellTypeId" });
    if (quadratic != VTK_BIQUADRATIC_QUAD)
    {
      Points controls = nodes;
      for (std::size_t i = 0; i < Shapes.at(quadratic).Edges.size(); ++i)
      {
        const auto& edge = Shapes.at(quadratic).Edges[i];
        const std::size_t node = Shapes.at(quadratic).Corners.size() + i;
        for (int k = 0; k < 3; ++k)
        {
          controls[node][k] = 2 * nodes[node][k] - (nodes[edge[0]][k] + nodes[edge[1]][k]) / 2;
        }
      }
      const Grid grid = MakeCell(bezier, controls);
      ExpectSame(values, EvaluateAll(grid), 1e-12, "Bezier", { "CellTypeId" });
      // The same weights everywhere change nothing; a rational cell is that of its corners.
      vtkNew<vtkDoubleArray> weights;
      weights->SetName("Weights");
      weights->SetNumberOfTuples(size);
      weights->Fill(2);
      grid->GetPointData()->SetRationalWeights(weights);
      ExpectSame(values, EvaluateAll(grid), 1e-12, "Bezier", { "CellTypeId" });
      weights->SetValue(size - 1, 1);
      nodes.resize(Shapes.at(quadratic).Corners.size());
      ExpectSame(EvaluateAll(MakeCell(size == 6 ? VTK_TRIANGLE : VTK_TETRA, nodes)),
        EvaluateAll(grid), 1e-12, "rational", { "CellTypeId" });
    }
  }
}

//------------------------------------------------------------------------------
// VTK has no functions for these: they are judged by their vertices.
TEST(CurvedCells, LagrangePyramids)
{
  const Points nodes = MakeNodes(VTK_QUADRATIC_PYRAMID, { { 9, { -.2, -.2, .8 } } });
  Points all = nodes; // and the center of the base
  all.push_back({ 0, 0, 0.1 });
  const Values expected = EvaluateAll(MakeCell(VTK_PYRAMID, { nodes.begin(), nodes.begin() + 5 }));
  for (const int type : { VTK_LAGRANGE_PYRAMID, VTK_BEZIER_PYRAMID })
  {
    ExpectSame(
      expected, EvaluateAll(MakeCell(type, all)), 0, std::to_string(type), { "CellTypeId" });
  }
}

//------------------------------------------------------------------------------
// A quadrilateral and a hexahedron whose degrees differ by direction.
TEST(CurvedCells, DegreesByDirection)
{
  const Points nodes = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { .5, .1, 0 },
    { .5, 1.2, 0 } };
  const Grid grid = MakeCell(VTK_LAGRANGE_QUADRILATERAL, nodes);
  vtkNew<vtkDoubleArray> degrees;
  degrees->SetName("Degrees");
  degrees->SetNumberOfComponents(3);
  degrees->InsertNextTuple3(2, 1, 1);
  grid->GetCellData()->SetHigherOrderDegrees(degrees);
  const Values values = EvaluateAll(grid);
  EXPECT_NEAR(values.at("Area")[0], 1 + (0.2 - 0.1) * 2 / 3, 1e-12);
  ExpectSame(values, EvaluateAll(MakeCell(VTK_QUADRATIC_LINEAR_QUAD, nodes)), 1e-12, "linear",
    { "CellTypeId" });
}

//------------------------------------------------------------------------------
// The map of a linear cell can fold as well; inverted cells do not fold.
TEST(CurvedCells, LinearCells)
{
  const auto getStatus = [](const Values& values)
  {
    return static_cast<int>(values.at("CellStatus")[0]) & static_cast<int>(Folded + ZeroJacobian);
  };
  const Values cube = EvaluateAll(MakeStandardCell(VTK_HEXAHEDRON));
  EXPECT_EQ(cube.at("MinJacobian")[0], cube.at("Volume")[0]);
  EXPECT_EQ(cube.at("JacobianRatio")[0], 1);
  EXPECT_NEAR(cube.at("MinInverseConditionNumber")[0], 1, 1e-15);
  EXPECT_NEAR(cube.at("MinScaledJacobian")[0], 1, 1e-15);
  const Values arrow =
    EvaluateAll(MakePolygon({ { 0, 0, 0 }, { 1, 0, 0 }, { .2, .2, 0 }, { 0, 1, 0 } }));
  EXPECT_LT(arrow.at("MinJacobian")[0], 0);
  EXPECT_EQ(getStatus(arrow), Folded);
  const Values triangular =
    EvaluateAll(MakePolygon({ { 0, 0, 0 }, { 1, 0, 0 }, { .5, .5, 0 }, { 0, 1, 0 } }));
  EXPECT_EQ(triangular.at("MinJacobian")[0], 0);
  EXPECT_EQ(getStatus(triangular), ZeroJacobian);
  // A hexahedron equals its polyhedron.
  for (const bool asPolyhedron : { false, true })
  {
    const Grid pushed = Transform(MakeHexahedra(1, 1, 1, asPolyhedron),
      [](const Point& p) { return p[0] + p[1] + p[2] == 3 ? Point{ .3, .3, .3 } : p; });
    const Values values = EvaluateAll(pushed);
    EXPECT_NEAR(values.at("MinJacobian")[0], -1.1, 1e-12);
    EXPECT_EQ(getStatus(values), Folded);
    EXPECT_EQ(values.at("IsValid")[0], 0);
  }
  for (const int type : { VTK_TETRA, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID, VTK_VOXEL })
  {
    const Grid cell = MakeStandardCell(type);
    const Values values = EvaluateAll(cell);
    EXPECT_GT(values.at("MinJacobian")[0], 0) << type;
    EXPECT_NEAR(values.at("MinJacobian")[0], values.at("Volume")[0], 1e-12) << type;
    const Values mirrored =
      EvaluateAll(Transform(cell, [](const Point& p) { return Point{ -p[0], p[1], p[2] }; }));
    EXPECT_NEAR(mirrored.at("MaxJacobian")[0], -values.at("MinJacobian")[0], 1e-14) << type;
    EXPECT_NEAR(mirrored.at("JacobianRatio")[0], -1, 1e-12) << type;
    EXPECT_NEAR(mirrored.at("MinInverseConditionNumber")[0],
      -values.at("MinInverseConditionNumber")[0], 1e-12)
      << type;
    EXPECT_EQ(getStatus(mirrored), 0) << type;
  }
}

//------------------------------------------------------------------------------
TEST(CurvedCells, ScalesWithItsSize)
{
  const Points nodes =
    MakeNodes(VTK_QUADRATIC_TETRA, { { 4, { .5, .2, 0 } }, { 6, { 0, .5, .2 } } });
  const Grid cell = MakeCell(VTK_QUADRATIC_TETRA, nodes);
  const Values values = EvaluateAll(cell);
  for (const double scale : { 1e-60, 1e-6, 1e6, 1e60 })
  {
    const Values scaled = EvaluateAll(Transform(
      cell, [scale](const Point& p) { return Point{ scale * p[0], scale * p[1], scale * p[2] }; }));
    const std::map<std::string, double> powers = { { "Volume", 3 }, { "MinJacobian", 3 },
      { "MaxJacobian", 3 }, { "SurfaceArea", 2 }, { "MaxEdgeLength", 1 }, { "JacobianRatio", 0 },
      { "MinInverseConditionNumber", 0 }, { "MinScaledJacobian", 0 },
      { "MidsideNodeOffsetFromEdge", 0 }, { "IsValid", 0 } };
    for (const auto& [name, power] : powers)
    {
      ExpectNear(values.at(name)[0] * std::pow(scale, power), scaled.at(name)[0], 1e-12, name);
    }
  }
}

//------------------------------------------------------------------------------
// Centers of volume and area, by closed forms and by the centroids of VTK's interpolation.
TEST(CurvedCells, Centroids)
{
  const auto getCentroid = [](vtkUnstructuredGrid* grid)
  {
    const MeshView mesh(grid);
    CellMap map;
    EXPECT_TRUE(map.Load(mesh, 0, 0));
    return mesh.GetPoint(mesh.GetCellPoints(0)[0]) + map.GetCentroid({ 0, 0, 1 }).value();
  };
  const auto expectNear = [](const Vector& expected, const Vector& found, double tolerance)
  { EXPECT_LT(GetLargestComponent(expected - found), tolerance); };
  const auto make = [](int type, const std::map<int, Point>& moved)
  { return MakeCell(type, MakeNodes(type, moved)); };
  expectNear({ 4.0 / 13, .3784615384615385, 0 },
    getCentroid(make(VTK_QUADRATIC_TRIANGLE, { { 3, { .5, .1, 0 } } })), 1e-7);
  expectNear({ .2333333, .2748148, .2555556 },
    getCentroid(make(VTK_QUADRATIC_TETRA, { { 4, { .5, .1, 0 } } })), 1e-7);
  expectNear({ .9849136, .9849136, .5 },
    getCentroid(MakeCell(VTK_QUADRATIC_HEXAHEDRON, MakeSector(90, true))), 1e-7);
  const double volume = 9.67111111111111;
  expectNear({ .6727111 / volume, -.66816 / volume, .3982222 / volume },
    getCentroid(make(VTK_QUADRATIC_HEXAHEDRON,
      { { 8, { 0, -1.4, -1 } }, { 17, { 1.4, -1, 0 } }, { 14, { 0, 1, 1.4 } } })),
    1e-7);
  // A pyramid and a wedge of straight edges: those of the linear cells.
  expectNear({ 0, 0, 0.25 }, getCentroid(make(VTK_QUADRATIC_PYRAMID, {})), 1e-14);
  expectNear({ 1.0 / 3, 1.0 / 3, 0 }, getCentroid(make(VTK_QUADRATIC_WEDGE, {})), 1e-14);
  const Grid flat = MakeCell(VTK_QUADRATIC_TRIANGLE, Points(6));
  CellMap map;
  ASSERT_TRUE(map.Load(MeshView(flat), 0, 0));
  EXPECT_FALSE(map.GetCentroid({ 0, 0, 1 }).has_value());
}
}
}
