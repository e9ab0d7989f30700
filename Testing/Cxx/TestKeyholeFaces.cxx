// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Polyhedra with faces that have a bridge to a hole: a block with a hole through it, whose top and
// bottom are keyholes.
#include "Cell/CellDefects.h"
#include "Drawing/PolygonTriangles.h"
#include "Intake/CellMesh/CellCutter.h"
#include "Mesh/BoundarySurface.h"

#include "CriteriaTesting.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

using namespace camaron;
using namespace camaron::testing;

namespace
{
using Ring = std::vector<std::array<double, 2>>;

const Ring Square = { { 0, 0 }, { 3, 0 }, { 3, 3 }, { 0, 3 } };
const Ring Angle = { { 0, 0 }, { 5, 0 }, { 5, 3 }, { 3, 3 }, { 3, 5 }, { 0, 5 } };

struct Body
{
  Points Corners;
  Faces Walls;
};

//------------------------------------------------------------------------------
// Counter-clockwise, from 0 to 1 upward; the upper end of the hole may have other corners.
Body MakeBlock(const Ring& outside, const Ring& hole, const Ring& upperHole)
{
  Body body;
  for (const double z : { 0.0, 1.0 })
  {
    for (const auto& corner : outside)
    {
      body.Corners.push_back({ corner[0], corner[1], z });
    }
    for (const auto& corner : z > 0 ? upperHole : hole)
    {
      body.Corners.push_back({ corner[0], corner[1], z });
    }
  }
  const auto outer = static_cast<vtkIdType>(outside.size()),
             inner = static_cast<vtkIdType>(hole.size());
  const vtkIdType all = outer + inner;
  std::vector<vtkIdType> top;
  for (vtkIdType i = 0; i <= outer; ++i)
  {
    top.push_back(all + i % outer);
  }
  for (vtkIdType i = 0; i <= inner; ++i)
  {
    top.push_back(all + outer + (inner - i) % inner);
  }
  std::vector<vtkIdType> bottom(top.rbegin(), top.rend());
  for (vtkIdType& id : bottom)
  {
    id -= all;
  }
  body.Walls = { bottom, top };
  for (vtkIdType i = 0; i < outer; ++i)
  {
    const vtkIdType next = (i + 1) % outer;
    body.Walls.push_back({ i, next, next + all, i + all });
  }
  for (vtkIdType i = 0; i < inner; ++i)
  {
    const vtkIdType here = outer + i, next = outer + (i + 1) % inner;
    body.Walls.push_back({ next, here, here + all, next + all });
  }
  return body;
}

//------------------------------------------------------------------------------
Ring MakeHole(double x, double y, double side)
{
  return { { x, y }, { x + side, y }, { x + side, y + side }, { x, y + side } };
}

//------------------------------------------------------------------------------
// And a rod of -1 to 2 that touches nothing but what is in its way, as one cell.
Body AddRod(Body body, double x, double y, double side)
{
  const auto first = static_cast<vtkIdType>(body.Corners.size());
  for (const double z : { -1.0, 2.0 })
  {
    for (const auto& corner : MakeHole(x, y, side))
    {
      body.Corners.push_back({ corner[0], corner[1], z });
    }
  }
  for (const std::vector<vtkIdType>& face : Faces{ { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 },
         { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 } })
  {
    body.Walls.push_back(face);
    for (vtkIdType& id : body.Walls.back())
    {
      id += first;
    }
  }
  return body;
}

//------------------------------------------------------------------------------
// In any direction, far from the axes.
Grid MakeTurned(const Body& body, int turn)
{
  const double a = 0.7 * turn, b = 0.4 * turn;
  return Transform(MakePolyhedron(body.Corners, body.Walls),
    [&](const Point& p)
    {
      const double x = std::cos(a) * p[0] - std::sin(a) * p[1],
                   y = std::sin(a) * p[0] + std::cos(a) * p[1];
      return Point{ x + turn, std::cos(b) * y - std::sin(b) * p[2],
        std::sin(b) * y + std::cos(b) * p[2] };
    });
}

unsigned GetStatus(const Values& values)
{
  return static_cast<unsigned>(values.at("CellStatus")[0]);
}
}

//------------------------------------------------------------------------------
// The bridge has two uses in one face, which is closed and manifold. If this fails, blocks with
// holes are reported as defective, or their volume, area or angles are wrong.
TEST(KeyholeFaces, AreClosed)
{
  const struct
  {
    Body Shape;
    double Volume, Area;
    int Faces, Edges;
  } blocks[] = { { MakeBlock(Square, MakeHole(1, 1, 1), MakeHole(1, 1, 1)), 8, 32, 10, 26 },
    { MakeBlock(Angle, MakeHole(1, 1, 1), MakeHole(1, 1, 1)), 20, 64, 12, 32 } };
  for (const auto& block : blocks)
  {
    for (int turn = 0; turn < 10; ++turn)
    {
      const Values values = EvaluateAll(MakeTurned(block.Shape, turn));
      EXPECT_NEAR(values.at("Volume")[0], block.Volume, 1e-12);
      EXPECT_NEAR(values.at("SurfaceArea")[0], block.Area, 1e-12);
      EXPECT_EQ(values.at("FaceCount")[0], block.Faces);
      EXPECT_EQ(values.at("EdgeCount")[0], block.Edges);
      EXPECT_NEAR(values.at("MinDihedralAngle")[0], 90, 1e-6);
      EXPECT_NEAR(values.at("MaxDihedralAngle")[0], 270, 1e-6);
      EXPECT_NEAR(values.at("MinSolidAngle")[0], Pi / 2, 1e-9);
      EXPECT_EQ(values.at("IsWatertight")[0], 1);
      EXPECT_EQ(values.at("FaceOrientationStatus")[0], 0);
      EXPECT_EQ(values.at("KernelRatio")[0], 0);
      EXPECT_EQ(GetStatus(values), unsigned(NoncontiguousEdges | Nonconvex | NotStarShaped))
        << turn;
    }
  }
}

//------------------------------------------------------------------------------
// The hole of a face is no part of it. If this fails, what passes through a hole is said to cross
// the face, or what crosses the face is not found.
TEST(KeyholeFaces, IntersectWhereTheyAre)
{
  for (const Ring& outside : { Square, Angle })
  {
    const Ring hole = MakeHole(1, 1, 1);
    const Body block = MakeBlock(outside, hole, hole);
    for (int turn = 0; turn < 10; ++turn)
    {
      const auto intersect = [&](const Body& body)
      { return (GetStatus(EvaluateAll(MakeTurned(body, turn))) & IntersectingFaces) != 0; };
      EXPECT_FALSE(intersect(block)) << turn;
      EXPECT_FALSE(intersect(AddRod(block, 1.25, 1.25, 0.5))) << turn << ": through the hole";
      EXPECT_TRUE(intersect(AddRod(block, 0.25, 0.25, 0.5))) << turn << ": across the bridge";
      EXPECT_TRUE(intersect(AddRod(block, 2.25, 2.25, 0.5)))
        << turn << ": through the top and the bottom";
      EXPECT_TRUE(intersect(AddRod(block, 0.5, 0.5, 2))) << turn << ": around the hole";
      EXPECT_FALSE(intersect(AddRod(block, 3.5, 3.5, 0.5))) << turn << ": beside it";
      // A hole that leaves the block between its ends.
      EXPECT_TRUE(intersect(MakeBlock(outside, hole, MakeHole(-1, 1, 3)))) << turn;
    }
  }
}

//------------------------------------------------------------------------------
// A square on a cube as a face of its own: a convex body of which one face is a keyhole.
TEST(KeyholeFaces, OfAConvexBody)
{
  const Points corners = { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 3, 0 }, { 0, 3, 0 }, { 0, 0, 3 },
    { 3, 0, 3 }, { 3, 3, 3 }, { 0, 3, 3 }, { 1, 1, 3 }, { 2, 1, 3 }, { 2, 2, 3 }, { 1, 2, 3 } };
  const Faces faces = { { 0, 3, 2, 1 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 },
    { 3, 0, 4, 7 }, { 4, 5, 6, 7, 4, 8, 11, 10, 9, 8 }, { 8, 9, 10, 11 } };
  for (int turn = 0; turn < 10; ++turn)
  {
    const Values values = EvaluateAll(MakeTurned({ corners, faces }, turn));
    EXPECT_NEAR(values.at("Volume")[0], 27, 1e-11);
    EXPECT_NEAR(values.at("SurfaceArea")[0], 54, 1e-11);
    EXPECT_NEAR(values.at("KernelRatio")[0], 1, 1e-9);
    EXPECT_NEAR(values.at("MaxDihedralAngle")[0], 180, 1e-4);
    // A face with a hole is not convex, whatever the body.
    EXPECT_EQ(GetStatus(values), unsigned(NoncontiguousEdges | Nonconvex)) << turn;
  }
}

//------------------------------------------------------------------------------
// The outside has the area of the criterion, and the tetrahedra have the volume; those that run the
// other way have to be told of.
TEST(KeyholeFaces, AreCutRight)
{
  for (const Ring& outside : { Square, Angle })
  {
    const Grid grid = MakeTurned(MakeBlock(outside, MakeHole(1, 1, 1), MakeHole(1, 1, 1)), 1);
    const double volume = outside == Square ? 8 : 20, area = outside == Square ? 32 : 64;
    const MeshView mesh(grid);
    CellCutter cutter(mesh);
    cutter.CutCell(0);
    double sum = 0, smallest = 1;
    for (const CellCutter::Tetrahedron& t : cutter.GetTetrahedra())
    {
      sum += cutter.GetVolume(t) / 6;
      smallest = std::min(smallest, cutter.GetVolume(t));
    }
    EXPECT_NEAR(sum, volume, 1e-12);
    EXPECT_LE(smallest, 0);

    vtkNew<vtkPolyData> surface;
    MakeBoundarySurface(grid, surface);
    EXPECT_EQ(surface->GetNumberOfCells(), static_cast<vtkIdType>(outside.size() + 6));
    CutIntoTriangles(surface);
    double triangles = 0;
    const Values values = EvaluateAll(surface);
    for (const double each : values.at("Area"))
    {
      triangles += each;
    }
    EXPECT_NEAR(triangles, area, 1e-12);
  }
}
