// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Values lie in the ranges that the registry gives, of cells however tangled, large or small.
#include "CriteriaTesting.h"
#include "ReferenceShapes.h"

#include <random>
#include <set>

using namespace camaron;
using namespace camaron::testing;

// The values of the reference shapes, also inverted, lie in the range of the registry.
TEST(CriteriaRanges, ValuesInRange)
{
  const auto expectInRange = [](const Values& values, const std::string& shape)
  {
    for (const Criterion& criterion : GetCriteria())
    {
      const double value = values.at(criterion.Name)[0];
      if (!std::isnan(value))
      {
        EXPECT_GE(value, criterion.Range[0] - 1e-12) << shape << ' ' << criterion.Name;
        EXPECT_LE(value, criterion.Range[1] + 1e-12) << shape << ' ' << criterion.Name;
      }
    }
  };
  for (const ReferenceShape& shape : GetReferenceShapes())
  {
    expectInRange(EvaluateAll(shape.Polyhedron), shape.Name);
    if (shape.Standard)
    {
      expectInRange(EvaluateAll(Transform(
                      shape.Standard, [](const Point& p) { return Point{ -p[0], p[1], p[2] }; })),
        std::string(shape.Name) + " inside out");
    }
  }
}

//------------------------------------------------------------------------------
// The same of cells of which no mesh should be made: any points in any order, on a grid where many
// coincide or lie in a plane or line. Undefined values have a reason.
TEST(CriteriaRanges, ValuesOfTangledCellsInRange)
{
  constexpr int NumberOfCells = 600, NumberOfKinds = 7;
  constexpr int Types[] = { VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON, VTK_QUAD };
  constexpr int Sizes[] = { 4, 5, 6, 8, 4 };
  std::mt19937 random(7);
  std::vector<Grid> meshes;
  for (int cell = 0; cell < NumberOfCells; ++cell)
  {
    const int kind = cell % NumberOfKinds, corners = 3 + cell / NumberOfKinds % 4;
    const int size = kind < 5 ? Sizes[kind] : kind == 5 ? corners + 2 : 2 * corners;
    const double steps = cell % 3 == 0 ? 2 : 1 << 20,
                 height = cell % 5 == 0 ? 1e-9
      : cell % 5 == 1                   ? 0
                                        : 1;
    Points points;
    std::vector<vtkIdType> ids;
    for (int i = 0; i < size; ++i)
    {
      const auto next = [&] { return std::round(steps * (random() / 4294967296.0)) / steps; };
      const double x = next(), y = next();
      points.push_back({ { x, y, height * next() } });
      ids.push_back(i);
    }
    if (kind < 6)
    {
      meshes.push_back(MakeGrid(points, { { kind < 5 ? Types[kind] : VTK_POLYGON, ids } }));
      continue;
    }
    Faces faces(2);
    for (vtkIdType i = 0; i < corners; ++i)
    {
      const vtkIdType after = (i + 1) % corners;
      faces[0].insert(faces[0].begin(), i);
      faces[1].push_back(corners + i);
      faces.push_back({ i, after, corners + after, corners + i });
    }
    meshes.push_back(MakePolyhedron(points, faces));
  }
  // A polygon that runs twice around has the area of two, and so the perimeter.
  meshes.push_back(MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } },
    { { VTK_POLYGON, { 0, 1, 2, 3, 0, 1, 2, 3 } } }));
  EXPECT_NEAR(EvaluateAll(meshes.back()).at("Perimeter")[0], 8, 1e-12);
  for (const Grid& mesh : meshes)
  {
    const Values values = EvaluateAll(mesh);
    for (const Criterion& criterion : GetCriteria())
    {
      const double value = values.at(criterion.Name)[0];
      const auto id = &mesh - meshes.data();
      if (std::isnan(value))
      {
        EXPECT_NE(GetNullReason(value), NullReason::Value) << criterion.Name << " of " << id;
        continue;
      }
      EXPECT_GE(value, criterion.Range[0] - 1e-12) << criterion.Name << " of " << id;
      EXPECT_LE(value, criterion.Range[1] + 1e-12) << criterion.Name << " of " << id;
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, powers of the size leave the range of numbers: a product of twelve lengths.
TEST(CriteriaRanges, IsotropyOfAnySize)
{
  for (const double size : { 1e-40, 1e40 })
  {
    const Grid hexahedron = Transform(FindReferenceShape("sheared hex").Standard,
      [size](const Point& p) { return Point{ size * p[0], size * p[1], size * p[2] }; });
    EXPECT_NEAR(EvaluateAll(hexahedron).at("CellIsotropy")[0], 0.421875, 1e-12) << size;
  }
}

//------------------------------------------------------------------------------
// Lengths whose products leave the range of numbers: what has no unit is the same as of usual size,
// what has one grows with it, and is undefined where that is not finite any more.
TEST(CriteriaRanges, ExtremeSizes)
{
  std::vector<std::pair<std::string, Grid>> meshes;
  for (const ReferenceShape& shape : GetReferenceShapes())
  {
    meshes.emplace_back(std::string(shape.Name) + " as polyhedron", shape.Polyhedron);
    if (shape.Standard)
    {
      meshes.emplace_back(shape.Name, shape.Standard);
    }
  }
  meshes.emplace_back("hexahedra", MakeHexahedra(3, 2, 2, false));
  meshes.emplace_back("polyhedra", MakeHexahedra(3, 2, 2, true));
  meshes.emplace_back("prisms", MakeHexagonalPrisms(3));
  meshes.emplace_back(
    "polygon", MakePolygon({ { 0, 0, 0 }, { 3, 0, 0 }, { 3, 2, 0.25 }, { 1, 1, 0 }, { 0, 2, 0 } }));
  // Those that compare sizes of cells are undefined where these are not finite; Verdict's have only
  // 11 digits of 1/3.
  const std::set<std::string> comparing = { "RelativeSize", "MinVolumeRatio", "MaxVolumeRatio",
    "CellVolumeRatio", "VerdictRelativeSizeSquared", "VerdictShapeAndSize", "VerdictShearAndSize" };
  for (const auto& mesh : meshes)
  {
    const auto scaled = [&mesh](int exponent) { return EvaluateAll(Scale(mesh.second, exponent)); };
    const Values usual = scaled(0);
    for (const int exponent : { 299, -332, 400, -400, 10, -10 }) // 1e90, 1e-100, 1e120, 1e-120
    {
      const Values values = scaled(exponent);
      for (const Criterion& criterion : GetCriteria())
      {
        for (std::size_t i = 0; i < values.at(criterion.Name).size(); ++i)
        {
          const double before = usual.at(criterion.Name)[i], value = values.at(criterion.Name)[i];
          const int dimension = criterion.Unit == Unit::Length ? 1
            : criterion.Unit == Unit::Area                     ? 2
            : criterion.Unit != Unit::Volume                   ? 0
            : mesh.first == "polygon"                          ? 2
                                                               : 3;
          const std::string what =
            mesh.first + " times 2^" + std::to_string(exponent) + ' ' + criterion.Name;
          const double expected = std::ldexp(before, dimension * exponent);
          const bool isComparing = comparing.count(criterion.Name) > 0;
          if (isComparing && std::abs(exponent) >= 400 && std::isnan(value))
          {
            EXPECT_TRUE(std::isnan(before) || GetNullReason(value) == NullReason::Degenerate)
              << what;
          }
          else if (std::isnan(before) ||
            (std::isfinite(expected) && (expected != 0) == (before != 0)))
          {
            EXPECT_EQ(GetNullReason(value), GetNullReason(before)) << what;
            ExpectSame(
              before, std::ldexp(value, -dimension * exponent), isComparing ? 1e-9 : 1e-12, what);
          }
          else if (std::isinf(before))
          {
            EXPECT_EQ(value, before) << what;
          }
          else
          {
            EXPECT_EQ(GetNullReason(value), NullReason::Degenerate) << what;
          }
        }
      }
    }
  }
}
