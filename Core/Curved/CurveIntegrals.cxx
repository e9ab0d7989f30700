// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curved/CurveIntegrals.h"

#include "Base/Number.h"
#include "Curved/ParametricShape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace camaron
{
namespace
{
constexpr double Precision = 1e-11;     // of the area of a face
constexpr double LinePrecision = 1e-12; // of lines, whose integral must be smooth across a face
constexpr int MaxDepth = 40;            // where bisecting ends at the latest
constexpr int FoldedDepth = 4;          // so often are faces bisected that may fold
// Of the normal of a face whose map has the greatest degree.
constexpr int MaxDegree = 2 * ParametricShape::MaxDegree - 1;
using Weights = std::array<double, MaxDegree + 1>; // of the coefficients on a line

//------------------------------------------------------------------------------
// The values of the Bernstein polynomials of a degree on a line.
Weights GetWeights(int degree, double at)
{
  Weights weights = { 1 };
  for (int n = 1; n <= degree; ++n)
  {
    for (int i = n; i > 0; --i)
    {
      weights[i] = (1 - at) * weights[i] + at * weights[i - 1];
    }
    weights[0] *= 1 - at;
  }
  return weights;
}

//------------------------------------------------------------------------------
// A quadrature on the line from 0 to 1.
struct Rule
{
  struct Point
  {
    double Place, Weight;
    std::array<Weights, MaxDegree + 1> OfDegree;
  };
  std::vector<Point> Points;

  /// On the line from -1 to 1.
  void Add(double x, double weight)
  {
    Point& point = this->Points.emplace_back();
    point.Place = (1 + x) / 2;
    point.Weight = weight / 2;
    for (int degree = 0; degree <= MaxDegree; ++degree)
    {
      point.OfDegree[degree] = GetWeights(degree, point.Place);
    }
  }
};

//------------------------------------------------------------------------------
// Gauss-Legendre quadrature, whose places are the zeros of a Legendre polynomial, by Newton's
// method.
Rule MakeGaussRule(int size)
{
  Rule rule;
  for (int i = 0; i < size; ++i)
  {
    double x = -std::cos(Pi * (i + 0.75) / (size + 0.5)), slope = 0;
    for (int step = 0; step < 8; ++step) // more than enough
    {
      double before = 1, value = x;
      for (int n = 2; n <= size; ++n)
      {
        const double next = ((2 * n - 1) * x * value - (n - 1) * before) / n;
        before = value;
        value = next;
      }
      slope = size * (before - x * value) / (1 - x * x);
      x -= value / slope;
    }
    rule.Add(x, 2 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

//------------------------------------------------------------------------------
// Gauss-Lobatto quadrature of 6 points, two of which are the ends. It differs from other rules if
// there is a kink near an end.
Rule MakeLobattoRule()
{
  const double root = std::sqrt(7.0);
  Rule rule;
  for (const double sign : { -1.0, 1.0 })
  {
    rule.Add(sign, 1.0 / 15);
    rule.Add(sign * std::sqrt((7 - 2 * root) / 21), (14 + root) / 30);
    rule.Add(sign * std::sqrt((7 + 2 * root) / 21), (14 - root) / 30);
  }
  return rule;
}

//------------------------------------------------------------------------------
// Each is tried if the two before do not agree.
const std::array<Rule, 5>& GetRules()
{
  static const std::array<Rule, 5> rules = { MakeGaussRule(4), MakeGaussRule(6), MakeGaussRule(10),
    MakeGaussRule(16), MakeGaussRule(24) };
  return rules;
}

///@{
/// What is bisected if these do not agree.
const Rule& GetCoarseRule()
{
  static const Rule rule = MakeLobattoRule();
  return rule;
}
const Rule& GetFineRule()
{
  return GetRules()[2];
}
///@}

//------------------------------------------------------------------------------
bool IsNear(double a, double b, double tolerance)
{
  return std::abs(a - b) <= tolerance;
}

//------------------------------------------------------------------------------
// Whether all are in the direction of their sum, and so is the polynomial everywhere: it does not
// turn back.
bool AreAlike(const Vector* coefficients, int size)
{
  Vector sum;
  for (int i = 0; i < size; ++i)
  {
    sum += coefficients[i];
  }
  return std::all_of(coefficients, coefficients + size,
    [&sum](const Vector& coefficient) { return Dot(coefficient, sum) >= 0; });
}

//------------------------------------------------------------------------------
// A polynomial on a line.
struct Line
{
  std::array<Vector, MaxDegree + 1> Coefficients = {};
  int Degree = 0;

  double GetMagnitude(const Weights& weights) const
  {
    Vector sum;
    for (int i = 0; i <= this->Degree; ++i)
    {
      sum += weights[i] * this->Coefficients[i];
    }
    return Norm(sum);
  }

  double Sum(const Rule& rule) const
  {
    // By differences from one value, so that it is exact if all are the same.
    const double first = this->GetMagnitude(rule.Points[0].OfDegree[this->Degree]);
    double sum = 0;
    for (const Rule::Point& point : rule.Points)
    {
      sum += point.Weight * (this->GetMagnitude(point.OfDegree[this->Degree]) - first);
    }
    return first + sum;
  }

  /// What the integral is at most.
  double GetMost() const
  {
    double most = 0;
    for (int i = 0; i <= this->Degree; ++i)
    {
      most += Norm(this->Coefficients[i]);
    }
    return most / (this->Degree + 1);
  }

  double Integrate() const { return this->Integrate(LinePrecision * this->GetMost(), 0); }

private:
  /// Bisects also where it may turn back, which rules do not see if it is between their points.
  double Integrate(double tolerance, int depth) const
  {
    const double sum = this->Sum(GetFineRule());
    if (depth == MaxDepth || !std::isfinite(sum) ||
      (IsNear(this->Sum(GetCoarseRule()), sum, tolerance) &&
        (AreAlike(this->Coefficients.data(), this->Degree + 1) || this->GetMost() < tolerance)))
    {
      return sum;
    }
    Line first = *this, second = *this;
    for (int step = 1; step <= this->Degree; ++step)
    {
      second.Coefficients[this->Degree - step + 1] = first.Coefficients[this->Degree];
      for (int i = this->Degree; i >= step; --i)
      {
        first.Coefficients[i] = 0.5 * (first.Coefficients[i] + first.Coefficients[i - 1]);
      }
    }
    second.Coefficients[0] = first.Coefficients[this->Degree];
    return (first.Integrate(2 * tolerance, depth + 1) +
             second.Integrate(2 * tolerance, depth + 1)) /
      2;
  }
};

//------------------------------------------------------------------------------
// A polynomial on a square, by lines across it. A triangle is a square with a collapsed edge.
class Face
{
public:
  Face(const BernsteinSpace& space, const Vector* coefficients)
    : IsTriangle(space.GetFactors().size() == 1)
    , Degree(space.GetFactors()[0].Degree)
    , MayFold(!AreAlike(coefficients, space.GetSize()))
  {
    for (int i = 0; i <= this->Degree; ++i)
    {
      this->Lines[i].Degree = space.GetFactors().back().Degree;
    }
    for (int i = 0; i < space.GetSize(); ++i)
    {
      const BernsteinSpace::Index& index = space.GetIndex(i);
      this->Lines[index[1]].Coefficients[index[this->IsTriangle ? 2 : 3]] = coefficients[i];
    }
    // Those of a triangle have lower degrees, which are raised.
    for (int line = 1; this->IsTriangle && line <= this->Degree; ++line)
    {
      auto& raised = this->Lines[line].Coefficients;
      for (int degree = this->Degree - line + 1; degree <= this->Degree; ++degree)
      {
        raised[degree] = raised[degree - 1];
        for (int i = degree - 1; i > 0; --i)
        {
          const double part = static_cast<double>(i) / degree;
          raised[i] = part * raised[i - 1] + (1 - part) * raised[i];
        }
      }
    }
  }

  double Integrate() const
  {
    double sum = NaN;
    for (const Rule& rule : GetRules())
    {
      const double before = sum;
      sum = this->Sum(rule);
      if (!std::isfinite(sum) || (!this->MayFold && IsNear(before, sum, Precision * sum)))
      {
        return sum;
      }
    }
    return this->IntegrateLines(Precision * sum, 0, 1, 0);
  }

private:
  /// With its width.
  Line GetLine(double at, const Weights& weights) const
  {
    const double width = this->IsTriangle ? 1 - at : 1;
    Line line;
    line.Degree = this->Lines[0].Degree;
    for (int i = 0; i <= this->Degree; ++i)
    {
      for (int j = 0; j <= line.Degree; ++j)
      {
        line.Coefficients[j] += width * weights[i] * this->Lines[i].Coefficients[j];
      }
    }
    return line;
  }

  double Sum(const Rule& rule) const
  {
    double sum = 0;
    for (const Rule::Point& point : rule.Points)
    {
      sum += point.Weight * this->GetLine(point.Place, point.OfDegree[this->Degree]).Sum(rule);
    }
    return sum;
  }

  /// Of the lines at 3 t² - 2 t³, which are the closer together the nearer they are to an end.
  double IntegrateLines(double tolerance, double from, double to, int depth) const
  {
    const auto sum = [&](const Rule& rule)
    {
      double result = 0;
      for (const Rule::Point& point : rule.Points)
      {
        const double t = from + (to - from) * point.Place, at = t * t * (3 - 2 * t);
        result += point.Weight * 6 * t * (1 - t) *
          this->GetLine(at, GetWeights(this->Degree, at)).Integrate();
      }
      return (to - from) * result;
    };
    const double fine = sum(GetFineRule());
    if (depth == MaxDepth ||
      (depth >= (this->MayFold ? FoldedDepth : 0) && IsNear(sum(GetCoarseRule()), fine, tolerance)))
    {
      return fine;
    }
    const double middle = (from + to) / 2;
    return this->IntegrateLines(tolerance, from, middle, depth + 1) +
      this->IntegrateLines(tolerance, middle, to, depth + 1);
  }

  bool IsTriangle;
  int Degree;
  bool MayFold;
  std::array<Line, MaxDegree + 1> Lines;
};
}

//------------------------------------------------------------------------------
double IntegrateMagnitude(const BernsteinSpace& space, const Vector* coefficients)
{
  if (space.GetNumberOfVertices() == 2)
  {
    Line line;
    line.Degree = space.GetSize() - 1;
    std::copy_n(coefficients, space.GetSize(), line.Coefficients.begin());
    return line.Integrate();
  }
  return Face(space, coefficients).Integrate();
}
}
