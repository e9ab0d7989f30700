// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Fluent files with refined cells, or with non-conformal interfaces.
#include "FluentMeshSamples.h"

using namespace camaron;
using namespace camaron::testing;

//------------------------------------------------------------------------------
// If this fails, a cell at hanging nodes is not read as a hexahedron, or parents are shown.
TEST(FluentMeshRefinement, ReadsHangingNodes)
{
  const Result joined = ReadBytes(MakeHanging(true, 4));
  ASSERT_TRUE(joined.Errors.empty()) << joined.Errors[0];
  ASSERT_EQ(joined.Warnings.size(), 1u); // that the cell is not connected to the others
  EXPECT_EQ(Count(joined.Grid, VTK_HEXAHEDRON), 5);
  EXPECT_EQ(joined.Grid->GetNumberOfCells(), 5);
  EXPECT_NEAR(GetMeasure(joined.Grid, 0), 1, 1e-12);
  EXPECT_EQ(joined.Grid->GetCellData()->GetArray("OriginalCellId"), nullptr);

  for (const FluentEncoding& how : GetEncodings())
  {
    const Result encoded = ReadBytes(MakeHanging(true, 4, how));
    ASSERT_TRUE(encoded.Errors.empty()) << encoded.Errors[0];
    EXPECT_EQ(Count(encoded.Grid, VTK_HEXAHEDRON), 5);
  }

  const Result open = ReadBytes(MakeHanging(false, 4));
  ASSERT_TRUE(open.Errors.empty()) << open.Errors[0];
  EXPECT_EQ(open.Warnings.size(), 1u);
  EXPECT_EQ(open.Grid->GetCellType(0), VTK_POLYHEDRON);
  EXPECT_EQ(Count(open.Grid, VTK_HEXAHEDRON), 4);
  EXPECT_NEAR(GetMeasure(open.Grid, 0), 1, 1e-12);

  const Result polyhedron = ReadBytes(MakeHanging(true, 7));
  ASSERT_TRUE(polyhedron.Errors.empty());
  EXPECT_EQ(polyhedron.Grid->GetCellType(0), VTK_POLYHEDRON);
  EXPECT_EQ(GetFaceSet(polyhedron.Grid, 0).size(), 9u);

  // Parents among the other cells: ids have a gap.
  std::string bytes = MakeHanging(true, 4);
  const std::string cells = "(12 (2 1 5 1 4))\n(12 (9 6 6 20 4))";
  ASSERT_NE(bytes.find(cells), std::string::npos);
  bytes.replace(bytes.find(cells), cells.size(), "(12 (9 1 1 20 4))\n(12 (2 2 6 1 4))");
  const Result shifted = ReadBytes(bytes);
  ASSERT_TRUE(shifted.Errors.empty());
  ASSERT_NE(shifted.Grid->GetCellData()->GetArray("OriginalCellId"), nullptr);
  EXPECT_EQ(shifted.Grid->GetCellData()->GetArray("OriginalCellId")->GetTuple1(0), 2);
}

//------------------------------------------------------------------------------
// Two triangles above a quadrilateral whose upper edge is split.
TEST(FluentMeshRefinement, ReadsHangingNodesOfFlatMeshes)
{
  const std::string head = "(2 2)\n(10 (0 1 6 0))\n(12 (0 1 4 0))\n(13 (0 1 9 0))\n(10 (1 1 6 1)(\n"
                           "0 0\n2 0\n2 1\n0 1\n1 1\n1 2\n))\n(12 (2 1 1 1 3))\n(12 (2 2 3 1 1))\n"
                           "(12 (3 4 4 20 1))\n";
  const std::string faces = "(13 (4 1 8 3 2)(\n1 2 1 0\n2 3 1 0\n3 5 1 2\n5 4 1 3\n4 1 1 0\n"
                            "3 6 2 0\n6 5 2 3\n6 4 3 0\n))\n(13 (5 9 9 1f 2)(\n3 4 1 4\n))\n";
  const Result joined = ReadBytes(head + faces + "(59 (9 9 5 4)(2 3 4))");
  ASSERT_TRUE(joined.Errors.empty()) << joined.Errors[0];
  EXPECT_EQ(joined.Warnings.size(), 1u);
  EXPECT_EQ(joined.Grid->GetCellType(0), VTK_QUAD);
  EXPECT_EQ(GetSortedPoints(joined.Grid, 0), (std::vector<vtkIdType>{ 0, 1, 2, 3 }));
  EXPECT_NEAR(GetMeasure(joined.Grid, 0), 2, 1e-12);
  EXPECT_EQ(Count(joined.Grid, VTK_TRIANGLE), 2);
  const Result open = ReadBytes(head + faces);
  ASSERT_TRUE(open.Errors.empty());
  EXPECT_EQ(open.Grid->GetCellType(0), VTK_POLYGON);
  EXPECT_NEAR(GetMeasure(open.Grid, 0), 2, 1e-12);
}

//------------------------------------------------------------------------------
// If this fails, faces of non-conformal interfaces become faces of cells.
TEST(FluentMeshRefinement, LeavesOutNonconformalFaces)
{
  FluentSample mesh = MakeMixed(1);
  const auto count = static_cast<vtkIdType>(mesh.Faces.size());
  mesh.BoundaryTypes[20] = 1012;
  mesh.Faces.push_back({ {}, { 0, -1 }, 20 });
  mesh.Faces.push_back({ { 0, 1, 4 }, { 0, 1 }, 20 });
  for (const FluentEncoding& how : GetEncodings())
  {
    const Result result = ReadBytes(Encode(mesh, how));
    if (how.Uniform && how.RealSize >= 0)
    {
      // A section of faces without nodes does not declare this in its header.
      continue;
    }
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_EQ(result.Grid->GetCellType(0), VTK_HEXAHEDRON);
    EXPECT_EQ(result.Grid->GetNumberOfCells(), static_cast<vtkIdType>(mesh.Cells.size()));
  }
  // The same through section 61, whatever the type of the faces.
  mesh.BoundaryTypes[20] = 3;
  std::string range;
  AppendHex(range, static_cast<std::uint64_t>(count + 1));
  range += " ";
  AppendHex(range, static_cast<std::uint64_t>(count + 2));
  const Result result = ReadBytes(Encode(mesh) + "(61 (" + range + ")(1 2 1 2))\n");
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  EXPECT_EQ(result.Grid->GetCellType(0), VTK_HEXAHEDRON);
}
