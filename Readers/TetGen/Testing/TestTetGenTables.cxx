// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Faces, edges and facets of TetGen and Triangle: their columns and forms.
#include "TetGenSamples.h"

using namespace camaron;
using namespace camaron::testing;

namespace
{
using Ids = std::vector<vtkIdType>;
using Values = std::vector<double>;

// The vertices of a tetrahedron and the middles of edges 01 12 20 03, ids from 1.
const std::string Nodes =
  "8 3 0 0\n1 0 0 0\n2 2 0 0\n3 0 2 0\n4 0 0 2\n5 1 0 0\n6 1 1 0\n7 0 1 0\n8 0 0 1\n";

Result ReadTable(const std::string& extension, const std::string& table)
{
  return Mesh({ { "node", Nodes }, { extension, table } }).Read(extension);
}
}

//------------------------------------------------------------------------------
// Only the number of columns determines their meaning. If this fails, midside nodes become markers
// or vice versa.
TEST(TetGenTables, FacesOfEveryForm)
{
  const Ids linear{ VTK_TRIANGLE, 0, 1, 2 }, quadratic{ VTK_QUADRATIC_TRIANGLE, 0, 1, 2, 4, 5, 6 };
  const struct
  {
    const char* Table;
    Ids Cell;
    Values Markers, Tetrahedra;
  } forms[] = { { "1 0\n1 1 2 3\n", linear, {}, {} }, { "1 1\n1 1 2 3\n", linear, {}, {} },
    { "1\n1 1 2 3\n", linear, {}, {} }, { "1 1\n1 1 2 3 -4\n", linear, { -4 }, {} },
    { "1 1\n1 1 2 3 9 17 -1\n", linear, { 9 }, { 17, -1 } },
    { "1 0\n1 1 2 3 17 -1\n", linear, {}, { 17, -1 } },
    { "1 0\n1 1 2 3 6 7 5\n", quadratic, {}, {} },
    { "1 1\n1 1 2 3 6 7 5 9 # end\n", quadratic, { 9 }, {} },
    { "1 1\n1 1 2 3 6 7 5 9 17 -1", quadratic, { 9 }, { 17, -1 } },
    { "1 0\n1 1 2 3 6 7 5 17 -1", quadratic, {}, { 17, -1 } } };
  for (const auto& form : forms)
  {
    const Result result = ReadTable("face", form.Table);
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_TRUE(result.Warnings.empty()) << result.Warnings[0];
    EXPECT_EQ(GetCell(result, 0), form.Cell) << form.Table;
    vtkCellData* const cells = result.Grid->GetCellData();
    EXPECT_EQ(GetValues(cells, "BoundaryMarker"), form.Markers) << form.Table;
    EXPECT_EQ(GetValues(cells, "Tetrahedra"), form.Tetrahedra) << form.Table;
    EXPECT_EQ(GetValues(cells, "OriginalCellId"), (Values{ 1 }));
  }
}

//------------------------------------------------------------------------------
TEST(TetGenTables, EdgesOfEveryForm)
{
  const Ids linear{ VTK_LINE, 0, 1 }, quadratic{ VTK_QUADRATIC_EDGE, 0, 1, 4 };
  const struct
  {
    const char* Table;
    Ids Cell;
    Values Markers, Tetrahedra;
  } forms[] = { { "2 0\n1 1 2\n2 2 3\n", linear, {}, {} },
    { "2 1\n1 1 2 8\n2 2 3 8\n", linear, { 8, 8 }, {} },
    { "2 1\n1 1 2 5\n2 2 3 6\n", linear, { 5, 6 }, {} }, // one column is the marker
    { "2 1\n1 1 2 8 31\n2 2 3 8 32\n", linear, { 8, 8 }, { 31, 32 } },
    { "2 0\n1 1 2 31\n2 2 3 32\n", linear, {}, { 31, 32 } },
    { "2 1\n1 1 2 5 8\n2 2 3 6 8\n", quadratic, { 8, 8 }, {} },
    { "2 1\n1 1 2 5 8 31\n2 2 3 6 8 32\n", quadratic, { 8, 8 }, { 31, 32 } },
    { "2 0\n1 1 2 5\n2 2 3 6\n", quadratic, {}, {} } };
  for (const auto& form : forms)
  {
    const Result result = ReadTable("edge", form.Table);
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_EQ(GetCell(result, 0), form.Cell) << form.Table;
    vtkCellData* const cells = result.Grid->GetCellData();
    EXPECT_EQ(GetValues(cells, "BoundaryMarker"), form.Markers) << form.Table;
    EXPECT_EQ(GetValues(cells, "Tetrahedra"), form.Tetrahedra) << form.Table;
  }
}

//------------------------------------------------------------------------------
// Facets with several polygons, lists over several lines, polygons of any size, holes and regions.
TEST(TetGenTables, FacetsOfPoly)
{
  const std::string text = "# PLC\n6 3 1 1\n" // nodes from 0
                           "0 0 0 0 .5 1\n1 4 0 0 .5 1\n2 4 4 0 .5 1\n3 0 4 0 .5 1\n4 1 1 0 .5 1\n"
                           "5 2 1 0 .5 1\n"
                           "4 1\n"
                           "3 1 7 # polygons, holes, marker\n"
                           "6 0 1 2\n 3\n\n 4 # the list goes on\n 5\n"
                           "2 4 5\n"
                           "1 3\n"
                           "1 1.5 1 0\n"
                           "1\n3 0 1 4\n"
                           "1 0 -2\n4 0 1 2 3\n"
                           "0 0 3\n"
                           "1\n1 1 2 3\n"
                           "2\n1 0 0 1 10 0.5\n2 9 9 9 -3\n";
  const Result result = Mesh({ { "poly", text } }).Read("poly");
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  ASSERT_EQ(result.Warnings.size(), 2u);
  EXPECT_NE(result.Warnings[0].find("1 facet without the boundary marker"), std::string::npos);
  EXPECT_NE(result.Warnings[1].find("1 facet with holes"), std::string::npos);
  ASSERT_EQ(result.Grid->GetNumberOfCells(), 5);
  EXPECT_EQ(GetCell(result, 0), (Ids{ VTK_POLYGON, 0, 1, 2, 3, 4, 5 }));
  EXPECT_EQ(GetCell(result, 1), (Ids{ VTK_LINE, 4, 5 }));
  EXPECT_EQ(GetCell(result, 2), (Ids{ VTK_VERTEX, 3 }));
  EXPECT_EQ(GetCell(result, 3), (Ids{ VTK_TRIANGLE, 0, 1, 4 }));
  EXPECT_EQ(GetCell(result, 4), (Ids{ VTK_QUAD, 0, 1, 2, 3 }));
  EXPECT_EQ(GetValues(result.Grid->GetCellData(), "Facet"), (Values{ 0, 0, 0, 1, 2 }));
  EXPECT_EQ(GetValues(result.Grid->GetCellData(), "BoundaryMarker"), (Values{ 7, 7, 7, 0, -2 }));
  EXPECT_EQ(GetValues(result.Grid->GetPointData(), "attr_0").size(), 6u);
  vtkFieldData* const fields = result.Grid->GetFieldData();
  EXPECT_EQ(GetValues(fields, "FacetHoles"), (Values{ 1.5, 1, 0 }));
  EXPECT_EQ(GetValues(fields, "FacetOfHole"), (Values{ 0 }));
  EXPECT_EQ(GetValues(fields, "Holes"), (Values{ 1, 2, 3 }));
  EXPECT_EQ(GetValues(fields, "Regions"), (Values{ 0, 0, 1, 10, 0.5, 9, 9, 9, -3, -1 }));
}

//------------------------------------------------------------------------------
TEST(TetGenTables, SegmentsOfPolyInTwoDimensions)
{
  const std::string rest = "3 1\n0 1 2 5\n1 2 3 6\n2 3 1 7\n1\n0 0.2 0.3\n1\n0 0.5 0.5 4 0.01\n";
  const std::string nodes = "3 2 0 1\n1 0 0 9\n2 1 0 9\n3 0 1 9\n";
  for (const bool isOwn : { true, false })
  {
    const Result result = isOwn
      ? Mesh({ { "poly", nodes + rest } }).Read("poly")
      : Mesh({ { "poly", "0 2 0 1\n" + rest }, { "node", nodes } }).Read("poly");
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_TRUE(result.Warnings.empty());
    EXPECT_EQ(result.Grid->GetNumberOfPoints(), 3);
    EXPECT_EQ(Count(result.Grid, VTK_LINE), 3);
    EXPECT_EQ(GetCell(result, 2), (Ids{ VTK_LINE, 2, 0 }));
    EXPECT_EQ(GetValues(result.Grid->GetCellData(), "BoundaryMarker"), (Values{ 5, 6, 7 }));
    EXPECT_EQ(GetValues(result.Grid->GetPointData(), "BoundaryMarker"), (Values{ 9, 9, 9 }));
    EXPECT_EQ(GetValues(result.Grid->GetFieldData(), "Holes"), (Values{ 0.2, 0.3, 0 }));
    EXPECT_EQ(GetValues(result.Grid->GetFieldData(), "Regions"), (Values{ 0.5, 0.5, 0, 4, 0.01 }));
  }
}

//------------------------------------------------------------------------------
TEST(TetGenTables, FacetsOfSmesh)
{
  for (const bool isOwn : { true, false })
  {
    const std::string facets = "3 1\n3 1 2 3 11\n4 1 2 3\n 4 12\n2 1 2\n0\n0\n";
    const Result result = isOwn
      ? Mesh({ { "smesh", Nodes + facets } }).Read("smesh")
      : Mesh({ { "smesh", "0 3 0 0\n" + facets }, { "node", Nodes } }).Read("smesh");
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    ASSERT_EQ(result.Warnings.size(), 1u);
    EXPECT_NE(result.Warnings[0].find("1 facet without the boundary marker"), std::string::npos);
    EXPECT_EQ(GetCell(result, 0), (Ids{ VTK_TRIANGLE, 0, 1, 2 }));
    EXPECT_EQ(GetCell(result, 1), (Ids{ VTK_QUAD, 0, 1, 2, 3 }));
    EXPECT_EQ(GetCell(result, 2), (Ids{ VTK_LINE, 0, 1 }));
    EXPECT_EQ(GetValues(result.Grid->GetCellData(), "Facet"), (Values{ 0, 1, 2 }));
    EXPECT_EQ(GetValues(result.Grid->GetCellData(), "BoundaryMarker"), (Values{ 11, 12, 0 }));
    EXPECT_EQ(result.Grid->GetFieldData()->GetNumberOfArrays(), 0);
  }
}

//------------------------------------------------------------------------------
// Lists of holes and regions may be left out, and facets may have no markers.
TEST(TetGenTables, WhatMayBeMissing)
{
  const Result result = Mesh({ { "poly", Nodes + "1\n1\n3 1 2 3\n" } }).Read("poly");
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  EXPECT_EQ(result.Grid->GetCellData()->GetArray("BoundaryMarker"), nullptr);
  EXPECT_EQ(result.Grid->GetNumberOfCells(), 1);
  const Result none = ReadTable("face", "0 1\n");
  EXPECT_TRUE(none.Errors.empty());
  EXPECT_EQ(none.Grid->GetNumberOfPoints(), 8);
  EXPECT_EQ(none.Grid->GetNumberOfCells(), 0);
}
