// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curved/CurveIntegrals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace camaron
{
namespace
{
constexpr double Precision = 1e-10; // of the whole
constexpr int MaxDepth = 30;
constexpr int MaxPoints = 4000; // about; where a surface folds, it converges slowly
constexpr int PointsPerLine = 6;
// Gauss-Legendre quadrature of 6 points on the line from -1 to 1.
constexpr double Places[] = { 0.2386191860831969, 0.6612093864662645, 0.9324695142031521 };
constexpr double Weights[] = { 0.4679139345726910, 0.3607615730481386, 0.1713244923791704 };

//------------------------------------------------------------------------------
// The points of a domain, with the values of all Bernstein polynomials.
struct Rule
{
  std::vector<double> Weights;
  std::vector<double> Values; // for every point, of every polynomial
};

//------------------------------------------------------------------------------
Rule MakeRule(const BernsteinSpace& space)
{
  const auto getPoint = [](int i)
  { return 0.5 + (i < 3 ? -0.5 : 0.5) * Places[i < 3 ? 2 - i : i - 3]; };
  const auto getWeight = [](int i) { return Weights[i < 3 ? 2 - i : i - 3] / 2; };
  const bool isLine = space.GetNumberOfVertices() == 2;
  const bool isTriangle = space.GetNumberOfVertices() == 3;
  Rule rule;
  for (int i = 0; i < PointsPerLine; ++i)
  {
    for (int j = 0; j < (isLine ? 1 : PointsPerLine); ++j)
    {
      const double u = getPoint(i);
      const double v = isLine ? 0 : getPoint(j) * (isTriangle ? 1 - u : 1);
      rule.Weights.push_back(getWeight(i) * (isLine ? 1 : getWeight(j) * (isTriangle ? 1 - u : 1)));
      const BernsteinSpace::Barycentric place = isTriangle
        ? BernsteinSpace::Barycentric{ 1 - u - v, u, v }
        : BernsteinSpace::Barycentric{ 1 - u, u, 1 - v, v };
      for (int k = 0; k < space.GetSize(); ++k)
      {
        rule.Values.push_back(space.Evaluate(k, place));
      }
    }
  }
  return rule;
}

//------------------------------------------------------------------------------
class Integration
{
public:
  explicit Integration(const BernsteinSpace& space)
    : Space(space)
    , Points(MakeRule(space))
  {
  }
  const BernsteinSpace& GetSpace() const { return this->Space; }

  double Integrate(const Vector* coefficients)
  {
    this->NumberOfPoints = 0;
    double most = 0; // that the integral can be
    for (int i = 0; i < this->Space.GetSize(); ++i)
    {
      most += Norm(coefficients[i]) / this->Space.GetSize();
    }
    return this->Refine(0, coefficients, this->Sum(coefficients), Precision * most);
  }

private:
  double Sum(const Vector* coefficients) const
  {
    double sum = 0;
    const double* value = this->Points.Values.data();
    for (const double weight : this->Points.Weights)
    {
      Vector at;
      for (int i = 0; i < this->Space.GetSize(); ++i)
      {
        at += *value++ * coefficients[i];
      }
      sum += weight * Norm(at);
    }
    return sum;
  }

  /// Bisects in two directions, on a line in one; an integrand that changes in only one of them
  /// would else seem to be integrated well.
  double Refine(int depth, const Vector* coefficients, double whole, double tolerance)
  {
    const auto& directions = this->Space.GetDirections();
    if (depth == MaxDepth || this->NumberOfPoints > MaxPoints || directions.empty())
    {
      return whole;
    }
    const int size = this->Space.GetSize();
    const std::size_t bisections = std::min<std::size_t>(directions.size(), 2);
    const int count = 1 << bisections;
    this->NumberOfPoints += count * static_cast<int>(this->Points.Weights.size());
    this->Parts.resize(std::max(this->Parts.size(), static_cast<std::size_t>(depth) + 1));
    // Deeper calls do not touch these, although they may move the vector.
    std::vector<Vector> parts = std::move(this->Parts[static_cast<std::size_t>(depth)]);
    parts.resize(static_cast<std::size_t>(count * size));
    std::copy_n(coefficients, size, parts.begin());
    for (std::size_t i = 0; i < bisections; ++i)
    {
      const auto& direction = directions[(static_cast<std::size_t>(depth) + i) % directions.size()];
      const int known = 1 << i;
      for (int part = 0; part < known; ++part)
      {
        this->Space.Bisect(
          direction, parts.data() + part * size, parts.data() + (known + part) * size);
      }
    }
    double sums[4] = {}, all = 0;
    for (int part = 0; part < count; ++part)
    {
      sums[part] = this->Sum(parts.data() + part * size);
      all += sums[part] / count;
    }
    if (std::abs(all - whole) > tolerance)
    {
      all = 0;
      for (int part = 0; part < count; ++part)
      {
        all += this->Refine(depth + 1, parts.data() + part * size, sums[part], count * tolerance) /
          count;
      }
    }
    this->Parts[static_cast<std::size_t>(depth)] = std::move(parts);
    return all;
  }

  BernsteinSpace Space;
  Rule Points;
  int NumberOfPoints = 0;
  std::vector<std::vector<Vector>> Parts; // of every depth
};
}

//------------------------------------------------------------------------------
double IntegrateMagnitude(const BernsteinSpace& space, const Vector* coefficients)
{
  thread_local std::vector<Integration> known; // few: one per shape of faces and degree
  for (Integration& integration : known)
  {
    const auto& a = integration.GetSpace().GetFactors();
    const auto& b = space.GetFactors();
    bool isSame = a.size() == b.size();
    for (std::size_t i = 0; isSame && i < a.size(); ++i)
    {
      isSame = a[i].Dimension == b[i].Dimension && a[i].Degree == b[i].Degree;
    }
    if (isSame)
    {
      return integration.Integrate(coefficients);
    }
  }
  return known.emplace_back(space).Integrate(coefficients);
}
}
