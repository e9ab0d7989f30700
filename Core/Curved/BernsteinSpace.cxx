// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curved/BernsteinSpace.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
double Choose(int n, int k)
{
  double result = 1;
  for (int i = 1; i <= k; ++i)
  {
    result = result * (n - k + i) / i;
  }
  return result;
}

//------------------------------------------------------------------------------
// Whether a lower bound is near enough to a value, and the sign of the minimum is certain.
bool IsTight(double least, double found, double zero, double greatest)
{
  const double gap = found - least;
  const bool isCertain = least > 0 || found <= 0;
  return gap <= zero || (gap <= BoundFinder::Gap * greatest && isCertain);
}
}

//------------------------------------------------------------------------------
BernsteinSpace::BernsteinSpace(std::vector<Factor> factors)
  : Factors(std::move(factors))
{
  this->Indices.push_back({});
  for (const Factor& factor : this->Factors)
  {
    const auto first = this->FactorOfVertex.size();
    const std::size_t last = first + static_cast<std::size_t>(factor.Dimension);
    const auto number = static_cast<int>(&factor - this->Factors.data());
    // Exponents of the factor's last vertices in all ways, and of its first one what remains.
    for (std::size_t vertex = first; vertex <= last; ++vertex)
    {
      this->FactorOfVertex.push_back(number);
    }
    std::vector<Index> next;
    for (Index index : this->Indices)
    {
      index[first] = static_cast<signed char>(factor.Degree);
      std::vector<Index> some = { index };
      for (std::size_t vertex = first + 1; vertex <= last; ++vertex)
      {
        std::vector<Index> more;
        for (Index one : some)
        {
          for (; one[first] >= 0; --one[first], ++one[vertex])
          {
            more.push_back(one);
          }
        }
        some = std::move(more);
      }
      next.insert(next.end(), some.begin(), some.end());
    }
    this->Indices = std::move(next);
  }
  for (int i = 0; i < this->GetSize(); ++i)
  {
    this->Places[this->Indices[i]] = i;
  }
  for (int i = 0; i < this->GetSize(); ++i)
  {
    bool isCorner = true;
    for (int vertex = 0; vertex < this->GetNumberOfVertices(); ++vertex)
    {
      const int exponent = this->Indices[i][vertex];
      isCorner &= exponent == 0 || exponent == this->Factors[this->GetFactor(vertex)].Degree;
    }
    if (isCorner)
    {
      this->Corners.push_back(i);
    }
  }
  for (int from = 0; from < this->GetNumberOfVertices(); ++from)
  {
    for (int to = from + 1; to < this->GetNumberOfVertices(); ++to)
    {
      if (this->GetFactor(from) != this->GetFactor(to))
      {
        continue;
      }
      Direction direction;
      for (const Index& begin : this->Indices)
      {
        if (begin[to] == 0 && begin[from] > 0)
        {
          Index index = begin;
          for (; index[from] >= 0; --index[from], ++index[to])
          {
            direction.Members.push_back(this->Find(index));
          }
          direction.Ends.push_back(static_cast<int>(direction.Members.size()));
        }
      }
      if (!direction.Ends.empty())
      {
        this->Directions.push_back(std::move(direction));
      }
    }
  }
}

//------------------------------------------------------------------------------
BernsteinSpace::Barycentric BernsteinSpace::GetLatticePoint(int coefficient) const
{
  Barycentric place = {};
  for (int vertex = 0; vertex < this->GetNumberOfVertices(); ++vertex)
  {
    const Factor& factor = this->Factors[this->GetFactor(vertex)];
    // A constant is as good at any point, such as the center.
    place[vertex] = factor.Degree > 0
      ? static_cast<double>(this->Indices[coefficient][vertex]) / factor.Degree
      : 1.0 / factor.GetNumberOfVertices();
  }
  return place;
}

//------------------------------------------------------------------------------
double BernsteinSpace::Evaluate(int coefficient, const Barycentric& place) const
{
  const Index& index = this->Indices[coefficient];
  double value = 1;
  int vertex = 0;
  for (const Factor& factor : this->Factors)
  {
    int rest = factor.Degree;
    for (int i = 0; i < factor.GetNumberOfVertices(); ++i, ++vertex)
    {
      value *= Choose(rest, index[vertex]) * std::pow(place[vertex], index[vertex]);
      rest -= index[vertex];
    }
  }
  return value;
}

//------------------------------------------------------------------------------
const BernsteinSpace::Direction& BernsteinSpace::FindBend(const double* coefficients) const
{
  const Direction* best = &this->Directions.front();
  double most = 0;
  for (const Direction& direction : this->Directions)
  {
    int begin = 0;
    for (const int end : direction.Ends)
    {
      for (int i = begin + 2; i < end; ++i)
      {
        const int* const at = direction.Members.data() + i;
        const double bend =
          std::abs(coefficients[at[0]] - 2 * coefficients[at[-1]] + coefficients[at[-2]]);
        if (bend > most)
        {
          most = bend;
          best = &direction;
        }
      }
      begin = end;
    }
  }
  return *best;
}

//------------------------------------------------------------------------------
BernsteinProduct::BernsteinProduct(const BernsteinSpace& a, const BernsteinSpace& b)
{
  std::vector<BernsteinSpace::Factor> factors = a.GetFactors();
  double all = 1;
  for (std::size_t i = 0; i < factors.size(); ++i)
  {
    factors[i].Degree += b.GetFactors()[i].Degree;
    all *= Choose(factors[i].Degree, b.GetFactors()[i].Degree);
  }
  this->Space = BernsteinSpace(factors);
  for (int i = 0; i < a.GetSize(); ++i)
  {
    for (int j = 0; j < b.GetSize(); ++j)
    {
      BernsteinSpace::Index sum = a.GetIndex(i);
      double weight = 1;
      for (std::size_t vertex = 0; vertex < sum.size(); ++vertex)
      {
        const int own = sum[vertex];
        sum[vertex] = static_cast<signed char>(own + b.GetIndex(j)[vertex]);
        weight *= Choose(sum[vertex], own);
      }
      this->Terms.push_back({ i, j, this->Space.Find(sum), weight / all });
    }
  }
}

//------------------------------------------------------------------------------
PolynomialBounds BoundFinder::Find(const BernsteinSpace& space, const double* coefficients)
{
  const auto [least, greatest] = std::minmax_element(coefficients, coefficients + space.GetSize());
  PolynomialBounds bounds{ *least, *greatest, HUGE_VAL, -HUGE_VAL };
  for (const int corner : space.GetCorners())
  {
    bounds.LeastFound = std::min(bounds.LeastFound, coefficients[corner]);
    bounds.GreatestFound = std::max(bounds.GreatestFound, coefficients[corner]);
  }
  const double zero = Zero * std::max(std::abs(*least), std::abs(*greatest));
  const double largest = std::max(std::abs(bounds.LeastFound), std::abs(bounds.GreatestFound));
  if (!IsTight(bounds.Least, bounds.LeastFound, zero, largest))
  {
    this->FindLeast(space, coefficients, 1, zero, bounds.Least, bounds.LeastFound);
  }
  if (!IsTight(-bounds.Greatest, -bounds.GreatestFound, zero, largest))
  {
    this->FindLeast(space, coefficients, -1, zero, bounds.Greatest, bounds.GreatestFound);
    bounds.Greatest = -bounds.Greatest;
    bounds.GreatestFound = -bounds.GreatestFound;
  }
  // What could not be decided is zero.
  constexpr double Undecided = 1e-9;
  const bool isLeastOpen = bounds.Least < 0 && bounds.LeastFound >= 0;
  const bool isGreatestOpen = bounds.Greatest > 0 && bounds.GreatestFound <= 0;
  bounds.Least = isLeastOpen && -bounds.Least <= Undecided * largest ? 0 : bounds.Least;
  bounds.Greatest = isGreatestOpen && bounds.Greatest <= Undecided * largest ? 0 : bounds.Greatest;
  for (double* bound :
    { &bounds.Least, &bounds.Greatest, &bounds.LeastFound, &bounds.GreatestFound })
  {
    *bound = std::abs(*bound) <= zero ? 0 : *bound;
  }
  return bounds;
}

//------------------------------------------------------------------------------
// Bounds the polynomial times a sign from below.
void BoundFinder::FindLeast(const BernsteinSpace& space, const double* coefficients, double sign,
  double zero, double& least, double& found)
{
  constexpr int MaxBisections = 2000;
  const int size = space.GetSize();
  double greatest = 0; // magnitude of a value
  found = HUGE_VAL;
  const auto visitCorners = [&](const double* part)
  {
    for (const int corner : space.GetCorners())
    {
      found = std::min(found, part[corner]);
      greatest = std::max(greatest, std::abs(part[corner]));
    }
  };
  this->Coefficients.resize(std::max<std::size_t>(this->Coefficients.size(), size));
  std::transform(coefficients, coefficients + size, this->Coefficients.begin(),
    [sign](double value) { return sign * value; });
  const auto findLeast = [&](int place)
  {
    const double* part = this->GetPart(place, size);
    return *std::min_element(part, part + size);
  };
  const auto isWorse = [](const Part& a, const Part& b) { return a.Least > b.Least; };
  this->Parts.assign(1, { findLeast(0), 0 });
  visitCorners(this->GetPart(0, size));
  for (int i = 1; i < MaxBisections; ++i)
  {
    least = this->Parts.front().Least;
    if (IsTight(least, found, zero, greatest))
    {
      return;
    }
    this->Coefficients.resize(std::max(
      this->Coefficients.size(), static_cast<std::size_t>(i + 1) * static_cast<std::size_t>(size)));
    std::pop_heap(this->Parts.begin(), this->Parts.end(), isWorse);
    const int place = this->Parts.back().Place;
    this->Parts.pop_back();
    double* const part = this->GetPart(place, size);
    space.Bisect(space.FindBend(part), part, this->GetPart(i, size));
    for (const int half : { place, i })
    {
      visitCorners(this->GetPart(half, size));
      this->Parts.push_back({ findLeast(half), half });
      std::push_heap(this->Parts.begin(), this->Parts.end(), isWorse);
    }
  }
  least = this->Parts.front().Least;
}
}
