// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Criteria of cells of higher order that are written with coincident corners.
#include "CollapsedForms.h"
#include "CriteriaTesting.h"

#include <string>

namespace camaron
{
namespace testing
{
//------------------------------------------------------------------------------
// A cell written with coincident corners, as finite element programs do, equals the cell that
// remains in every criterion but its type.
TEST(CollapsedForms, DegenerateFormsAreWhatRemains)
{
  const std::vector<int> wedge = { 0, 1, 2, 2, 3, 4, 5, 5 },
                         tetrahedron = { 0, 1, 2, 2, 3, 3, 3, 3 },
                         turned = { 0, 3, 1, 1, 2, 2, 2, 2 };
  const Collapse examples[] = {
    // SOLID186 of Mechanical APDL, and its surface effect elements.
    { VTK_QUADRATIC_HEXAHEDRON, 20, tetrahedron, VTK_QUADRATIC_TETRA, 10 },
    { VTK_QUADRATIC_HEXAHEDRON, 20, { 0, 1, 2, 3, 4, 4, 4, 4 }, VTK_QUADRATIC_PYRAMID, 13 },
    { VTK_QUADRATIC_HEXAHEDRON, 20, wedge, VTK_QUADRATIC_WEDGE, 15 },
    { VTK_QUADRATIC_QUAD, 8, { 0, 1, 2, 2 }, VTK_QUADRATIC_TRIANGLE, 6 },
    // Other edges.
    { VTK_QUADRATIC_HEXAHEDRON, 20, { 0, 0, 1, 2, 3, 3, 4, 5 }, VTK_QUADRATIC_WEDGE, 15 },
    { VTK_QUADRATIC_HEXAHEDRON, 20, { 4, 4, 4, 4, 0, 3, 2, 1 }, VTK_QUADRATIC_PYRAMID, 13 },
    { VTK_QUADRATIC_QUAD, 8, { 0, 0, 1, 2 }, VTK_QUADRATIC_TRIANGLE, 6 },
    { VTK_QUADRATIC_WEDGE, 15, { 0, 1, 2, 3, 3, 3 }, VTK_QUADRATIC_TETRA, 10 },
    { VTK_QUADRATIC_WEDGE, 15, { 4, 0, 3, 4, 1, 2 }, VTK_QUADRATIC_PYRAMID, 13 },
    { VTK_QUADRATIC_PYRAMID, 13, { 0, 1, 2, 2, 3 }, VTK_QUADRATIC_TETRA, 10 },
    // With nodes inside of faces and the cell.
    { VTK_BIQUADRATIC_QUAD, 9, { 0, 1, 2, 2 }, VTK_QUADRATIC_TRIANGLE, 6 },
    { VTK_TRIQUADRATIC_HEXAHEDRON, 27, wedge, VTK_LAGRANGE_WEDGE, 18 },
    { VTK_TRIQUADRATIC_HEXAHEDRON, 27, turned, VTK_QUADRATIC_TETRA, 10 },
    { VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 24, wedge, VTK_LAGRANGE_WEDGE, 18 },
    { VTK_LAGRANGE_QUADRILATERAL, 25, { 0, 1, 2, 2 }, VTK_LAGRANGE_TRIANGLE, 15 },
    { VTK_LAGRANGE_HEXAHEDRON, 64, wedge, VTK_LAGRANGE_WEDGE, 40 },
    { VTK_LAGRANGE_HEXAHEDRON, 64, turned, VTK_LAGRANGE_TETRAHEDRON, 20 },
  };
  std::mt19937 random(6);
  for (const Collapse& example : examples)
  {
    for (const double noise : { 0.0, 0.03, 0.1 })
    {
      const auto [remaining, collapsed] = MakeCollapsed(example, noise, random);
      const std::string what = std::to_string(example.Type) + " of " +
        std::to_string(example.Size) + " as " + std::to_string(example.Remaining) + " by " +
        std::to_string(noise);
      ExpectSame(EvaluateAll(remaining), EvaluateAll(collapsed), 1e-12, what,
        { "CellTypeId", "VerdictMinAngle", "VerdictCollapseRatio" });
    }
  }
}

//------------------------------------------------------------------------------
// One whose nodes are not those of what remains is a defective cell.
TEST(CollapsedForms, OtherNodesOfCollapsedEdges)
{
  std::mt19937 random(8);
  const Collapse how = { VTK_QUADRATIC_HEXAHEDRON, 20, { 0, 1, 2, 2, 3, 4, 5, 5 },
    VTK_QUADRATIC_WEDGE, 15 };
  for (const auto& [node, coordinate] : { std::pair(10, 2), std::pair(18, 0) })
  {
    const Grid collapsed = MakeCollapsed(how, 0, random)[1];
    EXPECT_EQ(EvaluateAll(collapsed).at("CellStatus")[0], 0);
    Points points(collapsed->GetNumberOfPoints());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      collapsed->GetPoint(static_cast<vtkIdType>(i), points[i].data());
    }
    std::vector<vtkIdType> ids(20);
    for (int i = 0; i < 20; ++i)
    {
      ids[i] = collapsed->GetCell(0)->GetPointId(i);
    }
    Point moved = points[ids[node]];
    moved[coordinate] += 0.05;
    ids[node] = static_cast<vtkIdType>(points.size());
    points.push_back(moved);
    const Values values = EvaluateAll(MakeGrid(points, { { how.Type, ids } }));
    EXPECT_LE(values.at("MinJacobian")[0], 0) << node;
    EXPECT_EQ(values.at("IsValid")[0], 0) << node;
    EXPECT_EQ(values.at("MinEdgeLength")[0], 0) << node;
  }
}
}
}
