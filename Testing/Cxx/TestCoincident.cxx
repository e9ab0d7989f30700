// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Points and faces of a mesh that lie in one place.
#include "MeshElementsTesting.h"

#include "vtkIdTypeArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace camaron;
using namespace camaron::testing;

//------------------------------------------------------------------------------
// Two cubes that should share a face but have points of their own there.
TEST(Coincident, PointsAndFacesInOnePlace)
{
  const auto make = [](double gap)
  {
    Points points;
    for (const double x : { 0.0, 1.0, 1.0 + gap, 2.0 })
    {
      points.insert(points.end(), { { x, 0, 0 }, { x, 1, 0 }, { x, 1, 1 }, { x, 0, 1 } });
    }
    return MakeGrid(points,
      { { VTK_HEXAHEDRON, { 0, 4, 5, 1, 3, 7, 6, 2 } },
        { VTK_HEXAHEDRON, { 8, 12, 13, 9, 11, 15, 14, 10 } } });
  };
  const auto expectDoubled = [](const Elements& elements, bool isDoubled)
  {
    EXPECT_EQ(Sum(elements.Faces, "FaceMismatch"), isDoubled ? 2 : 0);
    for (vtkIdType i = 0; i < 16; ++i)
    {
      const bool isBetween = isDoubled && i >= 4 && i < 12;
      EXPECT_EQ(Get(elements.Vertices, "DuplicatePoint", i), isBetween ? 4 + i % 4 : -1) << i;
    }
  };
  expectDoubled(Elements(make(0)), true);
  expectDoubled(Elements(make(1e-15)), true);
  expectDoubled(Elements(make(1e-12)), false);
  expectDoubled(Elements(make(1e-12), 1e-6), true);
  expectDoubled(Elements(make(1e-3), 1e-6), false);

  // Two of four points merged: the faces still lie in one place and are not connected.
  Grid zipped = make(1e-12);
  const vtkIdType second[] = { 4, 12, 13, 5, 11, 15, 14, 10 };
  zipped->GetCells()->ReplaceCellAtId(1, 8, second);
  const Elements merged(zipped, 1e-6);
  EXPECT_EQ(Sum(merged.Faces, "FaceMismatch"), 2);
  EXPECT_EQ(Get(merged.Vertices, "DuplicatePoint", 6), 6);

  // The lowest id within reach: what is near to a point need not be near to what is near to it.
  Points chain;
  for (const double x : { 0.0, 3.0, 0.75, 1.5, 2.25, 3.0 })
  {
    chain.push_back({ x, -x, 1e3 });
  }
  chain.push_back({ std::numeric_limits<double>::quiet_NaN(), 0, 0 });
  chain.push_back({ std::numeric_limits<double>::infinity(), 0, 0 });
  const Elements links(MakeGrid(chain, { { VTK_TRIANGLE, { 0, 1, 2 } } }), 1.1);
  const double expected[] = { 0, 1, 0, 2, 1, 1, -1, -1 };
  for (vtkIdType i = 0; i < 8; ++i)
  {
    EXPECT_EQ(Get(links.Vertices, "DuplicatePoint", i), expected[i]) << i;
  }
  EXPECT_EQ(Get(links.Vertices, "UnusedPoint", 2), 0);
  EXPECT_EQ(Get(links.Vertices, "UnusedPoint", 3), 1);

  // All points in one place must not take all day.
  const Elements many(MakeGrid(Points(200000, { 1, 2, 3 }), { { VTK_TRIANGLE, { 0, 1, 2 } } }));
  EXPECT_EQ(Sum(many.Vertices, "DuplicatePoint"), 0);
}

//------------------------------------------------------------------------------
// By brute force, on points that often lie close together.
TEST(Coincident, CoincidentPointsAsByBruteForce)
{
  std::mt19937 random(9);
  std::uniform_real_distribution<double> place(-1, 1);
  Points points;
  for (int i = 0; i < 600; ++i)
  {
    points.push_back({ place(random), place(random), 0.1 * place(random) });
  }
  const Grid grid = MakeGrid(points, { { VTK_TRIANGLE, { 0, 1, 2 } } });
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("GlobalPointIds");
  for (vtkIdType i = 0; i < 600; ++i)
  {
    ids->InsertNextValue((i * 7 + 13) % 600);
  }
  grid->GetPointData()->SetGlobalIds(ids);
  for (const double tolerance : { 0.001, 0.02, 0.3, 10.0 })
  {
    const Elements elements(grid, tolerance);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      vtkIdType lowest = ids->GetValue(i);
      bool hasOther = false;
      for (std::size_t j = 0; j < points.size(); ++j)
      {
        const double distance = std::hypot(
          points[i][0] - points[j][0], points[i][1] - points[j][1], points[i][2] - points[j][2]);
        if (i != j && distance <= tolerance)
        {
          hasOther = true;
          lowest = std::min(lowest, ids->GetValue(j));
        }
      }
      EXPECT_EQ(Get(elements.Vertices, "DuplicatePoint", i), hasOther ? lowest : -1);
    }
  }
}
