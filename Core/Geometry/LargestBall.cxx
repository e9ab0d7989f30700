// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/HalfSpace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace camaron
{
namespace
{
constexpr double RelativeTolerance = 1e-13; // of a distance, relative to the size of the cell
constexpr double SmallestPivot = 1e-11;
constexpr int StepsBeforeBland = 60; // more than a cell needs; then Bland's rule prevents cycles
constexpr int MaxSteps = 2000;
constexpr double FarAway = 8; // distance of the initial half-spaces, in radii
constexpr double Half = 0.5, RootOfThreeQuarters = 0.8660254037844386, Third = 1.0 / 3;
constexpr double RootOfEightNinths = 0.9428090415820634, RootOfTwoNinths = 0.4714045207910317;
constexpr double RootOfTwoThirds = 0.816496580927726;

/// Solves a system of Size equations; false if the solution is not unique.
template <int Size>
bool Solve(std::array<std::array<double, Size>, Size> matrix, std::array<double, Size>& x)
{
  for (int column = 0; column < Size; ++column)
  {
    int pivot = column;
    for (int row = column + 1; row < Size; ++row)
    {
      if (std::abs(matrix[row][column]) > std::abs(matrix[pivot][column]))
      {
        pivot = row;
      }
    }
    if (matrix[pivot][column] == 0)
    {
      return false;
    }
    std::swap(matrix[pivot], matrix[column]);
    std::swap(x[pivot], x[column]);
    for (int row = column + 1; row < Size; ++row)
    {
      const double factor = matrix[row][column] / matrix[column][column];
      for (int k = column; k < Size; ++k)
      {
        matrix[row][k] -= factor * matrix[column][k];
      }
      x[row] -= factor * x[column];
    }
  }
  for (int row = Size; row-- > 0;)
  {
    for (int k = row + 1; k < Size; ++k)
    {
      x[row] -= matrix[row][k] * x[k];
    }
    x[row] /= matrix[row][row];
  }
  return true;
}

/**
 * Maximizes r subject to Normal . x + r <= Offset. A basis is Dimension + 1 half-spaces that the
 * ball touches; its nonnegative weights combine their normals to zero, which proves that no larger
 * ball fits between them.
 */
template <int Dimension>
class BallProgram
{
public:
  static constexpr int Size = Dimension + 1;
  using Row = std::array<double, Size>;

  BallProgram(const std::vector<HalfSpace>& halfSpaces, const Ball& around)
    : HalfSpaces(halfSpaces)
    , Scale(around.Radius)
  {
    static const Vector triangle[] = { { 1, 0, 0 }, { -Half, RootOfThreeQuarters, 0 },
      { -Half, -RootOfThreeQuarters, 0 } };
    static const Vector tetrahedron[] = { { 0, 0, 1 }, { RootOfEightNinths, 0, -Third },
      { -RootOfTwoNinths, RootOfTwoThirds, -Third },
      { -RootOfTwoNinths, -RootOfTwoThirds, -Third } };
    for (int i = 0; i < Size; ++i)
    {
      const Vector& normal = Dimension == 2 ? triangle[i] : tetrahedron[i];
      this->Basis[i] = { normal, Dot(normal, around.Center) + FarAway * around.Radius };
      this->Weights[i] = 1.0 / Size;
    }
    this->Touching.fill(-1);
    this->Optimum = { around.Center, FarAway * around.Radius };
  }

  Ball Run()
  {
    for (int step = 0; step < MaxSteps; ++step)
    {
      const std::ptrdiff_t entering = this->FindViolated(step >= StepsBeforeBland);
      if (entering < 0 || !this->Exchange(entering, step >= StepsBeforeBland))
      {
        break;
      }
    }
    return this->Optimum;
  }

private:
  static Row GetRow(const HalfSpace& halfSpace)
  {
    const double values[] = { halfSpace.Normal.X, halfSpace.Normal.Y, halfSpace.Normal.Z };
    Row row;
    std::copy(values, values + Dimension, row.begin());
    row[Dimension] = 1;
    return row;
  }

  std::ptrdiff_t FindViolated(bool takeFirst) const
  {
    double largest = RelativeTolerance * this->Scale;
    std::ptrdiff_t found = -1;
    for (std::size_t i = 0; i < this->HalfSpaces.size(); ++i)
    {
      const double violation =
        this->HalfSpaces[i].GetDistance(this->Optimum.Center) + this->Optimum.Radius;
      if (violation > largest && !this->IsTouching(static_cast<std::ptrdiff_t>(i)))
      {
        found = static_cast<std::ptrdiff_t>(i);
        if (takeFirst)
        {
          break;
        }
        largest = violation;
      }
    }
    return found;
  }

  bool IsTouching(std::ptrdiff_t halfSpace) const
  {
    return std::find(this->Touching.begin(), this->Touching.end(), halfSpace) !=
      this->Touching.end();
  }

  /// Replaces the half-space of the basis whose weight reaches zero first.
  bool Exchange(std::ptrdiff_t entering, bool takeSmallest)
  {
    std::array<Row, Size> columns;
    for (int i = 0; i < Size; ++i)
    {
      const Row row = GetRow(this->Basis[i]);
      for (int k = 0; k < Size; ++k)
      {
        columns[k][i] = row[k];
      }
    }
    Row change = GetRow(this->HalfSpaces[entering]);
    if (!Solve<Size>(columns, change))
    {
      return false;
    }
    int leaving = -1;
    for (int i = 0; i < Size; ++i)
    {
      if (change[i] > SmallestPivot &&
        (leaving < 0 || this->Precedes(i, leaving, change, takeSmallest)))
      {
        leaving = i;
      }
    }
    if (leaving < 0)
    {
      return false;
    }
    const std::array<HalfSpace, Size> oldBasis = this->Basis;
    const double step = this->Weights[leaving] / change[leaving];
    this->Basis[leaving] = this->HalfSpaces[entering];
    if (!this->ComputeOptimum())
    {
      this->Basis = oldBasis;
      return false;
    }
    for (int i = 0; i < Size; ++i)
    {
      this->Weights[i] = std::max(0.0, this->Weights[i] - step * change[i]);
    }
    this->Weights[leaving] = step;
    this->Touching[leaving] = entering;
    return true;
  }

  bool Precedes(int a, int b, const Row& change, bool takeSmallest) const
  {
    const double ratioA = this->Weights[a] / change[a], ratioB = this->Weights[b] / change[b];
    if (std::abs(ratioA - ratioB) > RelativeTolerance)
    {
      return ratioA < ratioB;
    }
    return takeSmallest ? this->Touching[a] < this->Touching[b] : change[a] > change[b];
  }

  bool ComputeOptimum()
  {
    std::array<Row, Size> rows;
    Row solution;
    for (int i = 0; i < Size; ++i)
    {
      rows[i] = GetRow(this->Basis[i]);
      solution[i] = this->Basis[i].Offset;
    }
    if (!Solve<Size>(rows, solution))
    {
      return false;
    }
    this->Optimum.Center = { solution[0], solution[1], Dimension == 3 ? solution[2] : 0 };
    this->Optimum.Radius = solution[Dimension];
    return true;
  }

  const std::vector<HalfSpace>& HalfSpaces;
  double Scale;
  std::array<HalfSpace, Size> Basis;
  std::array<std::ptrdiff_t, Size> Touching; // their indices; -1 for the initial ones
  Row Weights;
  Ball Optimum;
};
}

//------------------------------------------------------------------------------
Ball FindLargestBall(const std::vector<HalfSpace>& halfSpaces, int dimension, const Ball& around)
{
  return dimension == 2 ? BallProgram<2>(halfSpaces, around).Run()
                        : BallProgram<3>(halfSpaces, around).Run();
}
}
