// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::BernsteinSpace
 * @brief Polynomials on a product of simplices, as coefficients of Bernstein polynomials.
 *
 * A line, triangle or tetrahedron is one factor, a quadrilateral two lines, a hexahedron three, a
 * wedge a triangle and a line. Each factor has its own degree. The index of a coefficient lists the
 * exponents of all barycentric coordinates, one per vertex of each factor.
 *
 * A polynomial is between its smallest and its greatest coefficient; coefficients at corners are
 * values.
 */
#ifndef camaron_BernsteinSpace_h
#define camaron_BernsteinSpace_h

#include <algorithm> // for copies
#include <array>     // for indices
#include <cstddef>   // for places
#include <map>       // for finding them
#include <vector>    // for tables

namespace camaron
{
class BernsteinSpace
{
public:
  struct Factor
  {
    int Dimension, Degree;
    int GetNumberOfVertices() const { return this->Dimension + 1; }
  };
  static constexpr int MaxVertices = 6; // of three lines
  using Index = std::array<signed char, MaxVertices>;
  using Barycentric = std::array<double, MaxVertices>;

  BernsteinSpace() = default;
  explicit BernsteinSpace(std::vector<Factor> factors);

  const std::vector<Factor>& GetFactors() const { return this->Factors; }
  int GetNumberOfVertices() const { return static_cast<int>(this->FactorOfVertex.size()); }
  /// The factor of a vertex.
  int GetFactor(int vertex) const { return this->FactorOfVertex[vertex]; }
  /// The number of coefficients.
  int GetSize() const { return static_cast<int>(this->Indices.size()); }
  const Index& GetIndex(int coefficient) const { return this->Indices[coefficient]; }
  int Find(const Index& index) const { return this->Places.at(index); }
  /// The coefficients at the corners of the domain.
  const std::vector<int>& GetCorners() const { return this->Corners; }
  /// The point of a regular lattice that belongs to a coefficient.
  Barycentric GetLatticePoint(int coefficient) const;
  /// The value of a Bernstein polynomial.
  double Evaluate(int coefficient, const Barycentric& place) const;

  /// The coefficients along lines between two vertices of a factor, one line after the other.
  /// De Casteljau's algorithm along them bisects the domain.
  struct Direction
  {
    std::vector<int> Ends;    ///< of each line, in Members
    std::vector<int> Members; ///< coefficients
  };
  const std::vector<Direction>& GetDirections() const { return this->Directions; }
  /// The direction in which a polynomial bends most.
  const Direction& FindBend(const double* coefficients) const;
  /// Bisects the domain; the coefficients become those of its first half, others those of the
  /// second one.
  template <typename Value>
  void Bisect(const Direction& direction, Value* coefficients, Value* others) const;

private:
  std::vector<Factor> Factors;
  std::vector<int> FactorOfVertex;
  std::vector<Index> Indices;
  std::map<Index, int> Places;
  std::vector<int> Corners;
  std::vector<Direction> Directions;
};

//------------------------------------------------------------------------------
template <typename Value>
void BernsteinSpace::Bisect(const Direction& direction, Value* coefficients, Value* others) const
{
  std::copy_n(coefficients, this->GetSize(), others);
  int begin = 0;
  for (const int end : direction.Ends)
  {
    const int* const line = direction.Members.data() + begin;
    const int last = end - begin - 1;
    for (int step = 1; step <= last; ++step)
    {
      others[line[last - step + 1]] = coefficients[line[last]];
      for (int i = last; i >= step; --i)
      {
        coefficients[line[i]] = 0.5 * (coefficients[line[i]] + coefficients[line[i - 1]]);
      }
    }
    others[line[0]] = coefficients[line[last]];
    begin = end;
  }
}

/// The product of two polynomials: c[C] += Weight * a[A] * b[B] for all terms.
struct BernsteinProduct
{
  struct Term
  {
    int A, B, C;
    double Weight;
  };
  std::vector<Term> Terms;
  BernsteinSpace Space; ///< of the product

  BernsteinProduct() = default;
  BernsteinProduct(const BernsteinSpace& a, const BernsteinSpace& b);
};

/// Bounds of a polynomial in its domain.
struct PolynomialBounds
{
  double Least = 0, Greatest = 0;           ///< guaranteed
  double LeastFound = 0, GreatestFound = 0; ///< values that it has
};

/**
 * @class camaron::BoundFinder
 * @brief Bounds a polynomial by its coefficients, bisecting its domain where they are far apart.
 *
 * After Johnen, Remacle and Geuzaine, Geometrical validity of curvilinear finite elements, J.
 * Comput. Phys. 233 (2013), 359-372. Reuses its memory.
 */
class BoundFinder
{
public:
  /// Numbers are zero if they are smaller than this fraction of the greatest coefficient.
  static constexpr double Zero = 1e-12;
  /// Stops when signs are certain and the bounds are off by at most this fraction of the greatest
  /// value.
  static constexpr double Gap = 1e-3;

  PolynomialBounds Find(const BernsteinSpace& space, const double* coefficients);

private:
  struct Part
  {
    double Least; ///< coefficient
    int Place;    ///< in Coefficients
  };
  void FindLeast(const BernsteinSpace& space, const double* coefficients, double sign, double zero,
    double& least, double& found);
  double* GetPart(int place, int size)
  {
    return this->Coefficients.data() + static_cast<std::ptrdiff_t>(place) * size;
  }

  std::vector<Part> Parts; // a heap
  std::vector<double> Coefficients;
};
}

#endif
