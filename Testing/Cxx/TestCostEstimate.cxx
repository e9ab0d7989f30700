// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// How long criteria are expected to take.
#include "Criteria/CostEstimate.h"

#include "CriteriaTesting.h"

using namespace camaron;
using namespace camaron::testing;

// The estimate knows which cells are dear and which criteria mean nothing for them.
TEST(CostEstimate, CellsAndCriteria)
{
  const auto estimate = [](const char* criterion, CostGroup group)
  {
    GroupCorners corners = {};
    corners[group] = 1e6;
    return EstimateSeconds({ FindCriterion(criterion) }, corners, 1);
  };
  EXPECT_GT(
    estimate("KernelRatio", CostOfPolyhedra), 2 * estimate("KernelRatio", CostOfTetrahedra));
  EXPECT_GT(
    estimate("KernelRatio", CostOfTetrahedra), 5 * estimate("SurfaceArea", CostOfTetrahedra));
  EXPECT_EQ(
    estimate("VemQuality", CostOfPolyhedra), estimate("FaceCount", CostOfPolyhedra)); // of polygons
  EXPECT_EQ(estimate("VemQuality", CostOfTetrahedra), estimate("MaxWarpage", CostOfTetrahedra));
  EXPECT_GT(
    estimate("MinSolidAngle", CostOfTetrahedra), 2 * estimate("FaceCount", CostOfTetrahedra));
  EXPECT_GT(estimate("VemQuality", CostOfPolygons), 2 * estimate("TetMeanRatio", CostOfPolygons));

  const Grid hexahedra = MakeHexahedra(2, 1, 1, false);
  EXPECT_EQ(CountCorners(hexahedra), (GroupCorners{ 0, 0, 16 }));
  EXPECT_EQ(CountCorners(ToPolyhedra(hexahedra)), (GroupCorners{ 0, 0, 16 }));
  Cells cells = { { VTK_TETRA, { 0, 1, 2, 3 } },
    { VTK_QUADRATIC_TETRA, { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 } }, { VTK_TRIANGLE, { 0, 1, 2 } },
    { VTK_LINE, { 0, 1 } }, { VTK_POLYGON, { 0, 1, 2, 3, 4 } } };
  const Grid mixed = MakeGrid({}, cells);
  EXPECT_EQ(CountCorners(mixed), (GroupCorners{ 8, 8, 0 }));
}
