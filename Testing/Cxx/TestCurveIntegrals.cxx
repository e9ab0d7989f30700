// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Areas and lengths of curves and curved faces, by closed forms and by VTK's interpolation.
#include "Base/Number.h"
#include "Curved/CurveIntegrals.h"

#include "CriteriaTesting.h"
#include "Sanitized.h"

#include "vtkCell.h"

#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <tuple>
#include <vector>

namespace camaron
{
namespace testing
{
namespace
{
constexpr double Precision = 1e-10;

//------------------------------------------------------------------------------
std::vector<Vector> MakeCoefficients(
  const BernsteinSpace& space, const std::function<Vector(const BernsteinSpace::Barycentric&)>& at)
{
  std::vector<Vector> coefficients;
  for (int i = 0; i < space.GetSize(); ++i)
  {
    coefficients.push_back(at(space.GetLatticePoint(i)));
  }
  return coefficients;
}

//------------------------------------------------------------------------------
// The magnitude of (t, width), and the functions whose first and second derivative it is.
struct Kink
{
  double Width;
  double operator()(double t) const { return std::hypot(t, this->Width); }
  double Antiderivative(double t) const
  {
    return (t * (*this)(t) + this->Width * this->Width * std::asinh(t / this->Width)) / 2;
  }
  double SecondAntiderivative(double t) const
  {
    const double value = (*this)(t), square = this->Width * this->Width;
    return value * value * value / 6 + square * (t * std::asinh(t / this->Width) - value) / 2;
  }
};

//------------------------------------------------------------------------------
// The integral of the distance from a corner of a rectangle.
double IntegrateDistance(double a, double b)
{
  a = std::abs(a);
  b = std::abs(b);
  const double diagonal = std::hypot(a, b);
  return (2 * a * b * diagonal + a * a * a * std::log((b + diagonal) / a) +
           b * b * b * std::log((a + diagonal) / b)) /
    6;
}

//------------------------------------------------------------------------------
// The area of a cell of dimension 2 by quadrature on many parts.
double GetArea(vtkCell* cell, bool isTriangle, int parts)
{
  constexpr double Places[] = { 0.06943184420297371, 0.33000947820757187, 0.6699905217924281,
    0.9305681557970262 };
  constexpr double Weights[] = { 0.17392742256872692, 0.32607257743127307, 0.32607257743127307,
    0.17392742256872692 };
  const auto size = static_cast<std::size_t>(cell->GetNumberOfPoints());
  Points nodes(size);
  for (std::size_t node = 0; node < size; ++node)
  {
    cell->GetPoints()->GetPoint(static_cast<vtkIdType>(node), nodes[node].data());
  }
  // Differences that are exact for the degrees of these cells.
  constexpr std::array<double, 2> Differences[] = { { -2, 1.0 / 12 }, { -1, -2.0 / 3 },
    { 1, 2.0 / 3 }, { 2, -1.0 / 12 } };
  constexpr double Step = 0.125;
  std::vector<double> weights(size);
  double sum = 0;
  for (int i = 0; i < 4 * parts; ++i)
  {
    const double u = (i / 4 + Places[i % 4]) / parts, width = isTriangle ? 1 - u : 1;
    for (int j = 0; j < 4 * parts; ++j)
    {
      const std::array<double, 3> at = { u, width * (j / 4 + Places[j % 4]) / parts, 0 };
      Vector tangents[2];
      for (int d = 0; d < 2; ++d)
      {
        for (const auto& [offset, factor] : Differences)
        {
          std::array<double, 3> place = at;
          place[d] += offset * Step;
          cell->InterpolateFunctions(place.data(), weights.data());
          for (std::size_t node = 0; node < size; ++node)
          {
            tangents[d] += factor / Step * weights[node] *
              Vector{ nodes[node][0], nodes[node][1], nodes[node][2] };
          }
        }
      }
      sum += width * Weights[i % 4] * Weights[j % 4] * Norm(Cross(tangents[0], tangents[1]));
    }
  }
  return sum / (parts * parts);
}
}

//------------------------------------------------------------------------------
// An edge that turns back, exactly or nearly, anywhere.
TEST(CurveIntegrals, EdgesThatTurnBack)
{
  for (const double width : { 1e-12, 1e-6, 1e-3, 0.1, 1.0 })
  {
    for (const double place : { 0.0, 1e-5, 0.3, 0.5, 0.77 })
    {
      const Kink kink = { width };
      const double expected = kink.Antiderivative(1 - place) - kink.Antiderivative(-place);
      for (const int degree : { 1, 2, 3 })
      {
        const BernsteinSpace line({ { 1, degree } });
        const std::vector<Vector> tangents =
          MakeCoefficients(line, [&](const auto& at) { return Vector{ at[1] - place, 0, width }; });
        ExpectNear(expected, IntegrateMagnitude(line, tangents.data()), Precision,
          std::to_string(width) + " at " + std::to_string(place));
      }
    }
  }
}

//------------------------------------------------------------------------------
// A face whose normal is nearly zero along a line across it, and turns there.
TEST(CurveIntegrals, FacesThatFold)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const double width : { 1e-9, 1e-5, 1e-3, 1e-2, 0.1, 1.0 })
  {
    for (int trial = 0; trial < 4; ++trial)
    {
      const double a = 0.2 + unit(random), b = 0.5 + unit(random), c = unit(random);
      const Kink kink = { width };
      const auto f = [&](double t) { return kink.SecondAntiderivative(t - c); };
      const std::string what = std::to_string(width) + " for " + std::to_string(trial);
      for (const int degree : { 1, 3, 7 })
      {
        const BernsteinSpace square({ { 1, degree }, { 1, degree } });
        const std::vector<Vector> normals = MakeCoefficients(
          square, [&](const auto& at) { return Vector{ a * at[1] + b * at[3] - c, width, 0 }; });
        ExpectNear((f(a + b) - f(a) - f(b) + f(0)) / (a * b),
          IntegrateMagnitude(square, normals.data()), Precision, "square " + what);
      }
      for (const int degree : { 1, 2, 6 })
      {
        const BernsteinSpace triangle({ { 2, degree } });
        const std::vector<Vector> normals = MakeCoefficients(
          triangle, [&](const auto& at) { return Vector{ a * at[1] + b * at[2] - c, width, 0 }; });
        ExpectNear(((f(b) - f(0)) / b - (f(a) - f(0)) / a) / (b - a),
          IntegrateMagnitude(triangle, normals.data()), Precision, "triangle " + what);
      }
    }
  }
}

//------------------------------------------------------------------------------
// A small part of an edge or a face that is folded over, between and near the places where others
// would look.
TEST(CurveIntegrals, SmallFolds)
{
  for (const double middle : { 0.5, 0.3, 0.99 })
  {
    for (const double half : { 0.05, 0.01 })
    {
      // (t - a) (t - b), which is negative between
      const double a = middle - half, b = middle + half;
      const BernsteinSpace line({ { 1, 2 } });
      const Vector tangents[] = { { a * b, 0, 0 }, { a * b - (a + b) / 2, 0, 0 },
        { (1 - a) * (1 - b), 0, 0 } };
      const auto antiderivative = [&](double t)
      { return t * t * t / 3 - (a + b) * t * t / 2 + a * b * t; };
      const double end = std::min(b, 1.0);
      ExpectNear(antiderivative(a) - (antiderivative(end) - antiderivative(a)) +
          (antiderivative(1) - antiderivative(end)),
        IntegrateMagnitude(line, tangents), Precision, "edge");
    }
  }
  // (x - u)² + (y - v)² - r², nearly in a plane
  const BernsteinSpace square({ { 1, 2 }, { 1, 2 } });
  for (const auto& [u, v, r] : { std::tuple(0.5, 0.5, 0.06), std::tuple(0.5, 0.5, 0.02),
         std::tuple(0.73, 0.41, 0.03), std::tuple(0.031, 0.47, 0.03) })
  {
    std::vector<Vector> normals;
    const auto square1 = [](double at, int i) // coefficients of (t - at)²
    {
      return i == 0 ? at * at : i == 1 ? at * at - at : (1 - at) * (1 - at);
    };
    for (int i = 0; i < square.GetSize(); ++i)
    {
      const BernsteinSpace::Index& index = square.GetIndex(i);
      normals.push_back({ square1(u, index[1]) + square1(v, index[3]) - r * r, 1e-9, 0 });
    }
    const auto third = [](double at) { return (at * at * at + std::pow(1 - at, 3)) / 3; };
    const double inside = Pi * r * r * r * r / 2; // the integral is -1 times this in the circle
    ExpectNear(third(u) + third(v) - r * r + 2 * inside, IntegrateMagnitude(square, normals.data()),
      Precision, "circle of " + std::to_string(r));
  }
}

//------------------------------------------------------------------------------
// A face whose normal is zero at a point: inside, at a corner, and on an edge.
TEST(CurveIntegrals, FacesWithZeroNormal)
{
  const BernsteinSpace square({ { 1, 3 }, { 1, 3 } });
  for (const auto& [x, y] : { std::pair(0.3, 0.6), std::pair(0.5, 0.5), std::pair(1e-4, 0.7) })
  {
    const std::vector<Vector> normals = MakeCoefficients(
      square, [x = x, y = y](const auto& at) { return Vector{ at[1] - x, at[3] - y, 0 }; });
    const double expected = IntegrateDistance(x, y) + IntegrateDistance(1 - x, y) +
      IntegrateDistance(x, 1 - y) + IntegrateDistance(1 - x, 1 - y);
    ExpectNear(expected, IntegrateMagnitude(square, normals.data()), Precision, "inside");
  }
  const std::vector<Vector> normals =
    MakeCoefficients(square, [](const auto& at) { return Vector{ at[1], at[3], 0 }; });
  ExpectNear(
    IntegrateDistance(1, 1), IntegrateMagnitude(square, normals.data()), Precision, "corner");
  // Half of the integral over the square.
  const BernsteinSpace triangle({ { 2, 2 } });
  const std::vector<Vector> ofTriangle = MakeCoefficients(
    triangle, [](const auto& at) { return Vector{ at[1] + at[2] - 1, at[1] - at[2], 0 }; });
  EXPECT_GT(IntegrateMagnitude(triangle, ofTriangle.data()), 0);
}

//------------------------------------------------------------------------------
TEST(CurveIntegrals, NumbersThatAreNotFinite)
{
  const BernsteinSpace square({ { 1, 3 }, { 1, 3 } });
  std::vector<Vector> normals(16, Vector{ 0, 0, 1 });
  normals[5].X = NaN;
  EXPECT_TRUE(std::isnan(IntegrateMagnitude(square, normals.data())));
  normals[5].X = Infinity;
  EXPECT_FALSE(std::isfinite(IntegrateMagnitude(square, normals.data())));
  normals.assign(16, Vector{ 0, 0, 0 });
  EXPECT_EQ(IntegrateMagnitude(square, normals.data()), 0);
}

//------------------------------------------------------------------------------
TEST(CurveIntegrals, RandomCellsAgainstVTK)
{
  std::mt19937 random(9);
  std::uniform_real_distribution<double> offset(-1, 1);
  const std::pair<int, int> types[] = { { VTK_QUADRATIC_TRIANGLE, 6 },
    { VTK_BIQUADRATIC_TRIANGLE, 7 }, { VTK_LAGRANGE_TRIANGLE, 10 }, { VTK_LAGRANGE_TRIANGLE, 15 },
    { VTK_QUADRATIC_QUAD, 8 }, { VTK_BIQUADRATIC_QUAD, 9 }, { VTK_LAGRANGE_QUADRILATERAL, 16 },
    { VTK_LAGRANGE_QUADRILATERAL, 25 }, { VTK_QUADRATIC_TETRA, 10 },
    { VTK_QUADRATIC_HEXAHEDRON, 20 }, { VTK_TRIQUADRATIC_HEXAHEDRON, 27 },
    { VTK_QUADRATIC_WEDGE, 15 }, { VTK_QUADRATIC_PYRAMID, 13 } };
  for (const auto& [type, size] : types)
  {
    const double strength = type == VTK_LAGRANGE_TRIANGLE || type == VTK_LAGRANGE_QUADRILATERAL
      ? 0.2 // for the quadrature
      : 1;
    for (const double noise : { 0.02 * strength, 0.1 * strength })
    {
      const Grid parametric = MakeCell(type, Points(size));
      Points nodes(size);
      for (int i = 0; i < size; ++i)
      {
        for (int k = 0; k < 3; ++k)
        {
          nodes[i][k] =
            parametric->GetCell(0)->GetParametricCoords()[3 * i + k] + noise * offset(random);
        }
      }
      const Grid mesh = MakeCell(type, nodes);
      vtkCell* const cell = mesh->GetCell(0);
      const auto getArea = [](vtkCell* face)
      { return GetArea(face, face->GetNumberOfEdges() == 3, IsSanitized ? 8 : 24); };
      const bool isSurface = cell->GetCellDimension() == 2;
      double expected = isSurface ? getArea(cell) : 0;
      for (int f = 0; f < cell->GetNumberOfFaces(); ++f)
      {
        expected += getArea(cell->GetFace(f));
      }
      const double found = EvaluateAll(mesh).at(isSurface ? "Area" : "SurfaceArea")[0];
      ExpectNear(expected, found, IsSanitized ? 1e-3 : Precision,
        std::to_string(type) + " of " + std::to_string(size) + " by " + std::to_string(noise));
    }
  }
}
}
}
