// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// In which order programs and VTK have the nodes of wedges.
#include "TestMeshes.h"

#include "Base/Vector.h"
#include "Mesh/CellFacets.h"
#include "Mesh/CellShape.h"

#include <gtest/gtest.h>

using namespace camaron;
using namespace camaron::testing;

//------------------------------------------------------------------------------
// A prism of positive volume in a file must be one in VTK, whatever the version of VTK.
TEST(WedgeOrder, TurnsExtrusions)
{
  for (const int type : { VTK_WEDGE, VTK_QUADRATIC_WEDGE })
  {
    const int* order = GetExtrusionOrder(static_cast<unsigned char>(type));
    const Points extrusion = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
      { 0, 1, 1 } };
    // Edges of VTK's quadratic wedge (vtkQuadraticWedge.h): those of the triangles, those between.
    const int edges[9][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 5 }, { 5, 3 }, { 0, 3 },
      { 1, 4 }, { 2, 5 } };
    Points nodes = extrusion;
    for (const auto& edge : edges)
    {
      Point middle;
      for (int c = 0; c < 3; ++c)
      {
        middle[c] = (extrusion[edge[0]][c] + extrusion[edge[1]][c]) / 2;
      }
      nodes.push_back(middle);
    }
    const int size = type == VTK_WEDGE ? 6 : 15;
    Points inVTK;
    std::vector<vtkIdType> ids;
    for (int i = 0; i < size; ++i)
    {
      EXPECT_EQ(order[order[i]], i);
      inVTK.push_back(nodes[order[i]]);
      ids.push_back(i);
    }
    for (int e = 0; size == 15 && e < 9; ++e)
    {
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_EQ(2 * inVTK[6 + e][c], inVTK[edges[e][0]][c] + inVTK[edges[e][1]][c]);
      }
    }
    const Grid grid = MakeGrid(inVTK, { { type, ids } });
    const MeshView mesh(grid);
    double volume = 0; // by the divergence theorem, as faces run outward
    CellFacets(mesh).ForEach(0,
      [&](const vtkIdType* p, vtkIdType faceSize, vtkIdType)
      {
        const auto at = [&](vtkIdType i)
        { return Vector{ inVTK[p[i]][0], inVTK[p[i]][1], inVTK[p[i]][2] }; };
        for (vtkIdType i = 1; i + 1 < faceSize; ++i)
        {
          volume += Dot(at(0), Cross(at(i), at(i + 1))) / 6;
        }
      });
    EXPECT_NEAR(volume, 0.5, 1e-12);
  }
}
