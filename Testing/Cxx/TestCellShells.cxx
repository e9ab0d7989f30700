// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells whose faces make several closed surfaces: voids are subtracted, separate parts added,
// whichever way the faces are given.
#include "CriteriaTesting.h"

#include "Cell/CellDefects.h"

#include <algorithm>
#include <functional>

using namespace camaron;
using namespace camaron::testing;

namespace
{
struct Solid
{
  Points Corners;
  Faces Sides;

  /// Adds a box with faces that point outward.
  void AddBox(const Point& low, const Point& high)
  {
    const vtkIdType p = static_cast<vtkIdType>(this->Corners.size());
    for (int i = 0; i < 8; ++i)
    {
      this->Corners.push_back(
        { i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2] });
    }
    this->AddFaces({ { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 2, 3, 1 },
                     { 4, 5, 7, 6 } },
      p);
  }

  /// Adds faces, with ids from @a first on.
  void AddFaces(const Faces& faces, vtkIdType first)
  {
    for (auto face : faces)
    {
      for (vtkIdType& id : face)
      {
        id += first;
      }
      this->Sides.push_back(face);
    }
  }

  /// Adds a square frame of outer side 3, inner side 1 and height 1 about the axis z: a torus.
  void AddFrame()
  {
    const vtkIdType p = static_cast<vtkIdType>(this->Corners.size());
    for (const double z : { 0.0, 1.0 })
    {
      for (const double r : { 1.5, 0.5 })
      {
        this->Corners.insert(
          this->Corners.end(), { { -r, -r, z }, { r, -r, z }, { r, r, z }, { -r, r, z } });
      }
    }
    for (vtkIdType i = 0; i < 4; ++i)
    {
      const vtkIdType j = (i + 1) % 4;
      this->AddFaces({ { i, j, j + 8, i + 8 }, { j + 4, i + 4, i + 12, j + 12 },
                       { j, i, i + 4, j + 4 }, { i + 8, j + 8, j + 12, i + 12 } },
        p);
    }
  }

  void Reverse(std::size_t begin, std::size_t end)
  {
    for (std::size_t f = begin; f < end; ++f)
    {
      std::reverse(this->Sides[f].begin(), this->Sides[f].end());
    }
  }

  Grid Make() const { return MakePolyhedron(this->Corners, this->Sides); }
};

/// A cube of side 3 with a cubic void of side 1 off its center; all faces point out of their cube.
Solid MakeHollowCube()
{
  Solid solid;
  solid.AddBox({ 0, 0, 0 }, { 3, 3, 3 });
  solid.AddBox({ 0.5, 1, 1 }, { 1.5, 2, 2 });
  return solid;
}

unsigned GetStatus(const Values& values)
{
  return static_cast<unsigned>(values.at("CellStatus")[0]) &
    ~NotStarShaped; // which none of them is
}

/// Expects the same for the faces as given, and for many other ways to turn and order them.
void ExpectHoweverGiven(const Solid& given, const std::function<void(const Values&)>& expect)
{
  const std::size_t size = given.Sides.size();
  for (unsigned way = 0; way < 64; ++way)
  {
    Solid solid = given;
    for (std::size_t f = 0; f < size; ++f)
    {
      // The first ways turn whole cubes, the others faces without a pattern.
      const unsigned bits = way < 8 ? (f < 6       ? way & 1
                                          : f < 12 ? way & 2
                                                   : way & 4)
                                    : (way * 2654435761u) >> (f % 31) & 1;
      if (bits)
      {
        solid.Reverse(f, f + 1);
      }
    }
    std::rotate(solid.Sides.begin(), solid.Sides.begin() + way % size, solid.Sides.end());
    expect(EvaluateAll(solid.Make()));
  }
}
}

//------------------------------------------------------------------------------
// If this fails, a cell with a void has the volume of cube and void together, or not, as its faces
// are given.
TEST(CellShells, Void)
{
  ExpectHoweverGiven(MakeHollowCube(),
    [](const Values& values)
    {
      EXPECT_NEAR(values.at("Volume")[0], 26, 1e-12);
      EXPECT_NEAR(values.at("SurfaceArea")[0], 60, 1e-12);
      EXPECT_NEAR(values.at("MinDihedralAngle")[0], 90, 1e-12);
      EXPECT_NEAR(values.at("MaxDihedralAngle")[0], 270, 1e-12);
      EXPECT_NEAR(values.at("MinSolidAngle")[0], Pi / 2, 1e-12);
      EXPECT_NEAR(values.at("MaxSolidAngle")[0], 7 * Pi / 2, 1e-12);
      EXPECT_EQ(values.at("KernelRatio")[0], 0);
      EXPECT_EQ(values.at("IsConvex")[0], 0);
      EXPECT_EQ(values.at("IsValid")[0], 1);
      EXPECT_EQ(GetStatus(values) & ~FacesAreOrientedIncorrectly, Nonconvex);
      // Seen from the centroid, at x = (27 3/2 - 1) / 26, the wall of the void at x = 1/2 faces
      // away.
      EXPECT_NEAR(values.at("MinFacePyramidVolume")[0], (0.5 - 79.0 / 52) / 3, 1e-12);
      EXPECT_NEAR(values.at("MaxFacePyramidVolume")[0], 9 * 79.0 / 52 / 3, 1e-12);
    });
}

//------------------------------------------------------------------------------
// Whether the faces of a void point into it is what the status tells.
TEST(CellShells, Orientation)
{
  const auto evaluate = [](const Solid& solid, bool trust)
  {
    EvaluationOptions options;
    options.TrustFaceOrientation = trust;
    return EvaluateAll(solid.Make(), options);
  };
  Solid solid = MakeHollowCube();
  EXPECT_EQ(evaluate(solid, false).at("FaceOrientationStatus")[0], 2);
  EXPECT_EQ(GetStatus(evaluate(solid, false)), Nonconvex | FacesAreOrientedIncorrectly);
  EXPECT_NEAR(evaluate(solid, true).at("Volume")[0], 28, 1e-12);
  solid.Reverse(6, 12);
  EXPECT_EQ(evaluate(solid, false).at("FaceOrientationStatus")[0], 0);
  EXPECT_EQ(GetStatus(evaluate(solid, false)), Nonconvex);
  EXPECT_NEAR(evaluate(solid, true).at("Volume")[0], 26, 1e-12);
  solid.Reverse(0, 12);
  EXPECT_EQ(evaluate(solid, false).at("FaceOrientationStatus")[0], 1);
  EXPECT_NEAR(evaluate(solid, true).at("Volume")[0], -26, 1e-12);
}

//------------------------------------------------------------------------------
// A part within a void is a part again.
TEST(CellShells, PartWithinVoid)
{
  Solid solid;
  solid.AddBox({ 0, 0, 0 }, { 5, 5, 5 });
  solid.AddBox({ 1, 1, 1 }, { 4, 4, 4 });
  solid.AddBox({ 2, 2, 2 }, { 3, 3, 3 });
  ExpectHoweverGiven(
    solid, [](const Values& values) { EXPECT_NEAR(values.at("Volume")[0], 125 - 27 + 1, 1e-11); });
}

//------------------------------------------------------------------------------
// Parts beside each other are added, also where one has a hole, so that Euler's formula does not
// tell them apart.
TEST(CellShells, PartsBesideEachOther)
{
  Solid boxes;
  boxes.AddBox({ 0, 0, 0 }, { 1, 1, 1 });
  boxes.AddBox({ 3, 0, 0 }, { 5, 1, 1 });
  ExpectHoweverGiven(boxes,
    [](const Values& values)
    {
      EXPECT_NEAR(values.at("Volume")[0], 3, 1e-12);
      EXPECT_EQ(values.at("IsConvex")[0], 0);
    });

  Solid inHole;
  inHole.AddBox({ -0.25, -0.25, 0.25 }, { 0.25, 0.25, 0.75 });
  inHole.AddFrame();
  ExpectHoweverGiven(inHole,
    [](const Values& values)
    {
      EXPECT_NEAR(values.at("Volume")[0], 8 + 0.125, 1e-12);
      EXPECT_EQ(values.at("IsConvex")[0], 0);
    });
  Solid inFrame;
  inFrame.AddBox({ 0.75, -0.25, 0.25 }, { 1.25, 0.25, 0.75 });
  inFrame.AddFrame();
  ExpectHoweverGiven(
    inFrame, [](const Values& values) { EXPECT_NEAR(values.at("Volume")[0], 8 - 0.125, 1e-12); });
}

//------------------------------------------------------------------------------
// Shells may touch: in points, as the tetrahedron in the diagonals of a cube, and along an edge.
TEST(CellShells, Touching)
{
  Solid inscribed;
  inscribed.AddBox({ 0, 0, 0 }, { 1, 1, 1 });
  inscribed.AddFaces({ { 0, 5, 3 }, { 0, 3, 6 }, { 0, 6, 5 }, { 3, 5, 6 } }, 0);
  ExpectHoweverGiven(inscribed,
    [](const Values& values) { EXPECT_NEAR(values.at("Volume")[0], 1 - 1.0 / 3, 1e-12); });

  Solid atEdge;
  atEdge.AddBox({ 0, 0, 0 }, { 1, 1, 1 });
  atEdge.AddBox({ 1, 1, 0 }, { 2, 3, 1 });
  for (auto& face : atEdge.Sides)
  {
    std::replace(face.begin(), face.end(), vtkIdType(8), vtkIdType(3));
    std::replace(face.begin(), face.end(), vtkIdType(12), vtkIdType(7));
  }
  ExpectHoweverGiven(atEdge,
    [](const Values& values)
    {
      EXPECT_NEAR(values.at("Volume")[0], 3, 1e-12);
      EXPECT_NE(GetStatus(values) & NonManifoldEdge, 0u);
      EXPECT_EQ(values.at("IsConvex")[0], 0);
    });
}

//------------------------------------------------------------------------------
// If this fails, parts of one shell that end at an edge of four faces are taken for shells of their
// own: here the two halves of a box and a wall between them, given once for each half.
TEST(CellShells, WallInside)
{
  Solid solid;
  solid.Corners = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 2, 1, 0 },
    { 0, 0, 1 }, { 1, 0, 1 }, { 2, 0, 1 }, { 0, 1, 1 }, { 1, 1, 1 }, { 2, 1, 1 } };
  for (const vtkIdType i : { 0, 1 })
  {
    solid.AddFaces({ { 0, 3, 4, 1 }, { 6, 7, 10, 9 }, { 0, 1, 7, 6 }, { 3, 9, 10, 4 } }, i);
  }
  solid.AddFaces({ { 0, 6, 9, 3 }, { 2, 5, 11, 8 }, { 1, 4, 10, 7 }, { 1, 7, 10, 4 } }, 0);
  EXPECT_NEAR(EvaluateAll(solid.Make()).at("Volume")[0], 2, 1e-12);
  solid.Reverse(0, solid.Sides.size());
  EXPECT_NEAR(EvaluateAll(solid.Make()).at("Volume")[0], 2, 1e-12);
}

//------------------------------------------------------------------------------
// If this fails, a cell of two pieces, none of which bends inward, is called convex.
TEST(CellShells, SeveralSurfacesAreNotConvex)
{
  Points points;
  Faces faces;
  for (const double x : { 0.0, 5.0 })
  {
    const vtkIdType first = static_cast<vtkIdType>(points.size());
    points.insert(points.end(), { { x, 0, 0 }, { x + 1, 0, 0 }, { x, 1, 0 }, { x, 0, 1 } });
    for (const auto& face : Faces{ { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } })
    {
      faces.push_back({ face[0] + first, face[1] + first, face[2] + first });
    }
  }
  const Values apart = EvaluateAll(MakePolyhedron(points, faces));
  EXPECT_EQ(apart.at("IsConvex")[0], 0);
  EXPECT_EQ(apart.at("KernelRatio")[0], 0);
  EXPECT_NEAR(apart.at("Volume")[0], 2.0 / 6, 1e-12);

  // The second one mirrored, so that both share the point 0.
  for (std::size_t i = 4; i < 8; ++i)
  {
    const Point& p = points[i - 4];
    points[i] = { -p[0], -p[1], -p[2] };
  }
  for (std::size_t f = 4; f < 8; ++f)
  {
    std::replace(faces[f].begin(), faces[f].end(), vtkIdType(4), vtkIdType(0));
    std::reverse(faces[f].begin(), faces[f].end());
  }
  const Values touching = EvaluateAll(MakePolyhedron(points, faces));
  EXPECT_EQ(touching.at("IsConvex")[0], 0);
  EXPECT_NEAR(touching.at("Volume")[0], 2.0 / 6, 1e-12);
}
