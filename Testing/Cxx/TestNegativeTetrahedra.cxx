// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Tetrahedra of cells that their first point does not see all of: which places are in such a cell.
#include "Base/Vector.h"
#include "Drawing/CellTetrahedra.h"
#include "Mesh/MeshView.h"

#include "CriteriaTesting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

using namespace camaron;
using namespace camaron::testing;

namespace
{
using Outline = std::vector<std::array<double, 2>>;

const std::map<std::string, Outline> Outlines = {
  { "convex", { { 0, 0 }, { 3, 0 }, { 4, 2 }, { 2, 3 }, { 0, 2 } } },
  { "keyhole",
    { { 0, 0 }, { 3, 0 }, { 3, 3 }, { 0, 3 }, { 0, 0 }, { 1, 1 }, { 1, 2 }, { 2, 2 }, { 2, 1 },
      { 1, 1 } } },
  { "two holes",
    { { 0, 0 }, { 7, 0 }, { 7, 3 }, { 0, 3 }, { 0, 0 }, { 1, 1 }, { 1, 2 }, { 2, 2 }, { 4, 2 },
      { 5, 2 }, { 5, 1 }, { 4, 1 }, { 4, 2 }, { 2, 2 }, { 2, 1 }, { 1, 1 } } },
  { "vertex", { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 2, 1 }, { 2, 2 }, { 1, 2 }, { 1, 1 }, { 0, 1 } } },
  { "C", { { 0, 0 }, { 4, 0 }, { 4, 1 }, { 1, 1 }, { 1, 3 }, { 4, 3 }, { 4, 4 }, { 0, 4 } } },
  { "spiral",
    { { 0, 0 }, { 6, 0 }, { 6, 6 }, { 1, 6 }, { 1, 2 }, { 4, 2 }, { 4, 4 }, { 3, 4 }, { 3, 3 },
      { 2, 3 }, { 2, 5 }, { 5, 5 }, { 5, 1 }, { 0, 1 } } },
};

//------------------------------------------------------------------------------
struct Prism
{
  Points Corners;
  Faces Walls;
};

// From z = 0 to 1, with a wall at each edge that is not a bridge.
Prism MakePrism(const Outline& outline)
{
  Prism prism;
  std::vector<vtkIdType> bottom;
  std::map<std::array<double, 2>, vtkIdType> numbers;
  for (const auto& corner : outline)
  {
    const auto number = static_cast<vtkIdType>(numbers.size());
    bottom.push_back(numbers.emplace(corner, number).first->second);
    if (bottom.back() == number)
    {
      prism.Corners.push_back({ corner[0], corner[1], 0 });
    }
  }
  const auto size = static_cast<vtkIdType>(numbers.size());
  for (vtkIdType i = 0; i < size; ++i)
  {
    prism.Corners.push_back({ prism.Corners[i][0], prism.Corners[i][1], 1 });
  }
  std::vector<std::pair<vtkIdType, vtkIdType>> edges;
  for (std::size_t i = 0; i < bottom.size(); ++i)
  {
    edges.emplace_back(bottom[i], bottom[(i + 1) % bottom.size()]);
  }
  for (const auto& [a, b] : edges)
  {
    if (a != b && std::find(edges.begin(), edges.end(), std::make_pair(b, a)) == edges.end())
    {
      prism.Walls.push_back({ a, b, b + size, a + size });
    }
  }
  std::vector<vtkIdType> top = bottom;
  for (vtkIdType& id : top)
  {
    id += size;
  }
  prism.Walls.insert(
    prism.Walls.begin(), { std::vector<vtkIdType>(bottom.rbegin(), bottom.rend()), top });
  return prism;
}

//------------------------------------------------------------------------------
Grid MakeTurnedPrism(const Prism& prism, double angle)
{
  const double x = std::cos(angle), y = std::sin(angle);
  return Transform(MakePolyhedron(prism.Corners, prism.Walls), [&](const Point& p)
    { return Point{ x * p[0] - y * p[1], y * p[0] + x * p[1], p[2] + 0.1 * p[0] }; });
}

bool IsInside(const Outline& outline, double x, double y)
{
  bool isInside = false;
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    const auto &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if ((a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
    {
      isInside = !isInside;
    }
  }
  return isInside;
}

//------------------------------------------------------------------------------
// Weights of the corners of a tetrahedron at a place.
std::array<double, 4> GetWeights(
  vtkUnstructuredGrid* grid, const std::array<std::uint32_t, 4>& points, const Vector& place)
{
  Vector x[4];
  for (int i = 0; i < 4; ++i)
  {
    double p[3];
    grid->GetPoint(points[i], p);
    x[i] = { p[0], p[1], p[2] };
  }
  const Vector a = x[1] - x[0], b = x[2] - x[0], c = x[3] - x[0], to = place - x[0];
  const double volume = Dot(a, Cross(b, c));
  const double ofA = Dot(to, Cross(b, c)) / volume, ofB = Dot(to, Cross(c, a)) / volume,
               ofC = Dot(to, Cross(a, b)) / volume;
  return { { 1 - ofA - ofB - ofC, ofA, ofB, ofC } };
}

// In how many tetrahedra a place is seen, as the shaders do it.
int CountVisible(vtkUnstructuredGrid* grid, const CellTetrahedra& tetrahedra, const Vector& place)
{
  const auto isIn = [](const std::array<double, 4>& weights)
  { return *std::min_element(weights.begin(), weights.end()) >= 0; };
  int count = 0;
  for (std::size_t t = 0; t < tetrahedra.Points.size(); ++t)
  {
    const std::array<double, 4> weights = GetWeights(grid, tetrahedra.Points[t], place);
    if (tetrahedra.Edges[t] & CellTetrahedra::Negative || !isIn(weights))
    {
      continue;
    }
    bool isHidden = false;
    for (std::size_t n = 0; n < tetrahedra.Points.size(); ++n)
    {
      const std::array<double, 4> other = GetWeights(grid, tetrahedra.Points[n], place);
      isHidden |= (tetrahedra.Edges[n] & CellTetrahedra::Negative) && isIn(other) &&
        other[0] < weights[0] - 1e-9;
    }
    count += !isHidden;
  }
  return count;
}
}

//------------------------------------------------------------------------------
// A place in the cell is seen once, others are not, whichever point is the first one and whichever
// way the faces run.
TEST(NegativeTetrahedra, ShowWhatIsInside)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const auto& [name, outline] : Outlines)
  {
    for (int turn = 0; turn < 18; ++turn)
    {
      const double angle = 0.3 + 0.35 * turn;
      Prism prism = MakePrism(outline);
      for (std::size_t i = 0; i < prism.Walls.size() && turn % 2; ++i)
      {
        if (turn == 5 || (turn % 4 == 3 ? i % 3 == 0 : uniform(random) < 0.5))
        {
          std::reverse(prism.Walls[i].begin(), prism.Walls[i].end());
        }
      }
      const Grid grid = MakeTurnedPrism(prism, angle);
      const CellTetrahedra tetrahedra = MakeCellTetrahedra(MeshView(grid));
      EXPECT_EQ(tetrahedra.FirstNegatives.empty(), name == "convex") << turn;
      int wrong = 0;
      for (int i = 0; i < 100; ++i)
      {
        const double x = 8 * uniform(random) - 0.5, y = 7 * uniform(random) - 0.5,
                     z = 1.4 * uniform(random) - 0.2;
        const Vector place = { std::cos(angle) * x - std::sin(angle) * y,
          std::sin(angle) * x + std::cos(angle) * y, z + 0.1 * x };
        const bool isInside = z > 0 && z < 1 && IsInside(outline, x, y);
        wrong += CountVisible(grid, tetrahedra, place) != int(isInside);
      }
      EXPECT_EQ(wrong, 0) << name << ' ' << turn;
    }
  }
}
