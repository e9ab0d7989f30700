// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Pieces that are merged to one mesh, which is written to one file.
#include "BlockZones.h"
#include "Scan/ScanError.h"
#include "TestMeshes.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
void SetIds(vtkDataSetAttributes* data, const std::vector<vtkIdType>& ids)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName("Ids");
  for (const vtkIdType id : ids)
  {
    array->InsertNextValue(id);
  }
  data->SetGlobalIds(array);
}

//------------------------------------------------------------------------------
// A row of three squares in the given columns, with x of each in a cell array.
Grid MakeColumns(const std::vector<int>& columns)
{
  Points points;
  Cells cells;
  vtkNew<vtkDoubleArray> places;
  places->SetName("place");
  for (const int column : columns)
  {
    const double x = column;
    const auto first = static_cast<vtkIdType>(points.size());
    points.insert(points.end(), { { x, 0, 0 }, { x + 1, 0, 0 }, { x + 1, 1, 0 }, { x, 1, 0 } });
    cells.push_back({ VTK_QUAD, { first, first + 1, first + 2, first + 3 } });
    places->InsertNextValue(x);
  }
  Grid grid = MakeGrid(points, cells);
  grid->GetCellData()->AddArray(places);
  return grid;
}
}

//------------------------------------------------------------------------------
// If this fails, a file depends on the number of processes that wrote it.
TEST(GatheredMesh, KeepsTheOrderAndTheRoleOfArrays)
{
  std::vector<Grid> grids;
  std::vector<MeshPart> pieces;
  for (int p = 0; p < 2; ++p)
  {
    grids.push_back(
      MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { VTK_TRIANGLE, { 0, 1, 2 } } }));
    for (const char* name : { "zeta", "alpha", "mid" })
    {
      vtkNew<vtkDoubleArray> ofPoints, ofCells;
      ofPoints->SetName(name);
      ofPoints->SetNumberOfComponents(3);
      ofPoints->SetNumberOfTuples(3);
      ofPoints->Fill(p);
      ofCells->SetName(name);
      ofCells->InsertNextValue(p);
      grids[p]->GetPointData()->AddArray(ofPoints);
      grids[p]->GetCellData()->AddArray(ofCells);
    }
    grids[p]->GetPointData()->SetActiveNormals("mid");
    pieces.push_back({ grids[p].Get(), p });
  }
  Warnings warnings;
  const auto merged = MergeParts(pieces, warnings);
  ASSERT_EQ(merged->GetPointData()->GetNumberOfArrays(), 3);
  ASSERT_EQ(merged->GetCellData()->GetNumberOfArrays(), 3);
  const char* const expected[] = { "zeta", "alpha", "mid" };
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_STREQ(merged->GetPointData()->GetArrayName(i), expected[i]);
    EXPECT_STREQ(merged->GetCellData()->GetArrayName(i), expected[i]);
    EXPECT_EQ(merged->GetCellData()->GetArray(i)->GetTuple1(1), 1);
  }
  ASSERT_NE(merged->GetPointData()->GetNormals(), nullptr);
  EXPECT_STREQ(merged->GetPointData()->GetNormals()->GetName(), "mid");
}

//------------------------------------------------------------------------------
// If this fails, files of pieces without common points have another order than those of the whole
// mesh.
TEST(GatheredMesh, SortsByGlobalIds)
{
  const Grid first = MakeColumns({ 4 });
  const Grid second = MakeColumns({ 0, 2 });
  SetIds(first->GetPointData(), { 8, 9, 10, 11 });
  SetIds(second->GetPointData(), { 3, 2, 1, 0, 7, 6, 5, 4 });
  SetIds(first->GetCellData(), { 2 });
  SetIds(second->GetCellData(), { 1, 0 });
  EXPECT_TRUE(HasSeams(second));
  EXPECT_FALSE(HasSeams(first));
  Warnings warnings;
  const auto merged = MergeParts({ { first }, { second } }, warnings);
  EXPECT_TRUE(warnings.GetSentences().empty());
  ASSERT_EQ(merged->GetNumberOfPoints(), 12);
  for (vtkIdType i = 0; i < 12; ++i)
  {
    EXPECT_EQ(merged->GetPointData()->GetGlobalIds()->GetTuple1(i), i);
  }
  vtkDataArray* const places = merged->GetCellData()->GetArray("place");
  for (vtkIdType i = 0; i < 3; ++i)
  {
    const double place = places->GetTuple1(i);
    EXPECT_EQ(place, std::vector<double>({ 2, 0, 4 })[static_cast<std::size_t>(i)]);
    EXPECT_EQ(merged->GetCell(i)->GetBounds()[0], place);
  }
}

//------------------------------------------------------------------------------
// If this fails, meshes without ids are disconnected between processes, or connected where they
// should be open.
TEST(GatheredMesh, MergesPiecesByPlace)
{
  Warnings warnings;
  const auto count = [&warnings](const std::vector<MeshPart>& parts)
  {
    warnings = Warnings();
    return MergeParts(parts, warnings)->GetNumberOfPoints();
  };
  const Grid left = MakeColumns({ 0 }), middle = MakeColumns({ 1 }), right = MakeColumns({ 2 });
  EXPECT_EQ(count({ { left }, { middle }, { right } }), 8);
  ASSERT_EQ(warnings.GetSentences().size(), 1u);
  EXPECT_NE(warnings.GetSentences()[0].find("4 points"), std::string::npos);

  const auto merged = MergeParts({ { left }, { middle }, { right } }, warnings);
  for (vtkIdType i = 0; i < 3; ++i)
  {
    EXPECT_EQ(merged->GetCell(i)->GetBounds()[0], i);
    EXPECT_EQ(merged->GetCell(i)->GetBounds()[1], i + 1);
  }

  // Blocks remain separate, and so do points of one piece.
  EXPECT_EQ(count({ { left, 0 }, { middle, 1 } }), 8);
  EXPECT_TRUE(warnings.GetSentences().empty());
  const Grid open = MakeColumns({ 0, 1 });
  EXPECT_EQ(count({ { open } }), 8);
  EXPECT_TRUE(warnings.GetSentences().empty());

  // It is ambiguous which of the two points at x = 1 the other piece has.
  Grid crossing = MakeColumns({ 1 });
  crossing->GetPoints()->SetPoint(1, 1.5, 0, 0);
  crossing->GetPoints()->SetPoint(2, 1.5, 1, 0);
  EXPECT_EQ(count({ { open }, { crossing } }), 12);
  ASSERT_EQ(warnings.GetSentences().size(), 1u);
  EXPECT_NE(warnings.GetSentences()[0].find("2 positions"), std::string::npos);
}

//------------------------------------------------------------------------------
// If this fails, a block without ids prevents those of the others from being used.
TEST(GatheredMesh, MergesEveryBlockByItself)
{
  const Grid left = MakeColumns({ 0 }), right = MakeColumns({ 1 }), other = MakeColumns({ 0 });
  SetIds(left->GetPointData(), { 0, 1, 2, 3 });
  SetIds(right->GetPointData(), { 1, 4, 5, 2 });
  Warnings warnings;
  const auto merged = MergeParts({ { left, 0 }, { right, 0 }, { other, 1 } }, warnings);
  EXPECT_EQ(merged->GetNumberOfPoints(), 6 + 4);
  EXPECT_TRUE(warnings.GetSentences().empty());
  EXPECT_EQ(merged->GetCell(2)->GetPointId(0), 6);
}

//------------------------------------------------------------------------------
// If this fails, arrays that only some blocks have are lost, or lost without a warning.
TEST(GatheredMesh, KeepsArraysOfSomeBlocks)
{
  const Grid left = MakeColumns({ 0 }), right = MakeColumns({ 1, 2 });
  const auto add = [](vtkDataSetAttributes* data, vtkAbstractArray* array, const char* name,
                     vtkIdType size, int components = 1)
  {
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(size);
    data->AddArray(array);
    if (auto* const numbers = vtkDataArray::SafeDownCast(array))
    {
      numbers->Fill(7);
    }
  };
  vtkNew<vtkIntArray> zone, number, one;
  vtkNew<vtkDoubleArray> real, number2, three;
  vtkNew<vtkStringArray> text;
  add(right->GetCellData(), zone, "zone", 2);
  add(left->GetPointData(), real, "real", 4);
  add(left->GetCellData(), number, "number", 1);
  add(right->GetCellData(), number2, "number", 2);
  add(left->GetCellData(), one, "sizes", 1);
  add(right->GetCellData(), three, "sizes", 2, 3);
  add(left->GetCellData(), text, "text", 1);
  Warnings warnings;
  const auto merged = MergeParts({ { left, 0 }, { right, 1 } }, warnings);
  vtkDataArray* const zones = merged->GetCellData()->GetArray("zone");
  ASSERT_NE(vtkIntArray::SafeDownCast(zones), nullptr);
  EXPECT_EQ(zones->GetComponent(0, 0), 0);
  EXPECT_EQ(zones->GetComponent(2, 0), 7);
  vtkDataArray* const reals = merged->GetPointData()->GetArray("real");
  ASSERT_NE(reals, nullptr);
  EXPECT_EQ(reals->GetComponent(3, 0), 7);
  EXPECT_TRUE(std::isnan(reals->GetComponent(4, 0)));
  vtkDataArray* const numbers = merged->GetCellData()->GetArray("number");
  ASSERT_NE(vtkDoubleArray::SafeDownCast(numbers), nullptr);
  EXPECT_EQ(numbers->GetComponent(0, 0), 7);
  ASSERT_EQ(warnings.GetSentences().size(), 1u);
  EXPECT_NE(warnings.GetSentences()[0].find("sizes, text"), std::string::npos);
}

//------------------------------------------------------------------------------
// If this fails, an empty mesh of several processes loses arrays that it keeps on one.
TEST(GatheredMesh, EmptyPiecesKeepArrays)
{
  std::vector<MeshPart> parts;
  for (int i = 0; i < 2; ++i)
  {
    const Grid grid = MakeGrid({}, {});
    vtkNew<vtkDoubleArray> normals;
    normals->SetName("normals");
    normals->SetNumberOfComponents(3);
    grid->GetPointData()->SetNormals(normals);
    parts.push_back({ grid });
  }
  Warnings warnings;
  const auto merged = MergeParts(parts, warnings);
  EXPECT_EQ(merged->GetNumberOfPoints(), 0);
  EXPECT_NE(merged->GetPointData()->GetNormals(), nullptr);
}

//------------------------------------------------------------------------------
// If this fails, the patches of an OpenFOAM case lose their names in files of Fluent, or zones that
// a mesh has already are replaced.
TEST(GatheredMesh, NamesZonesOfBlocks)
{
  const Grid patch = MakeColumns({ 0, 1 });
  const Grid solid = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { { VTK_TETRA, { 0, 1, 2, 3 } } });
  const std::vector<std::string> names = { "mesh", "inlet", "", "wall" };
  const auto name = [&names](std::vector<MeshPart> parts)
  {
    NameZones(parts, names);
    std::string zones;
    for (const MeshPart& part : parts)
    {
      vtkDataArray* const values = part.Mesh->GetCellData()->GetArray("Zone");
      zones += values ? std::to_string(static_cast<int>(values->GetRange()[0])) +
          (values->GetRange()[0] == values->GetRange()[1] ? " " : "? ")
                      : "- ";
    }
    auto* const list = vtkStringArray::SafeDownCast(
      parts.back().Mesh->GetFieldData()->GetAbstractArray("ZoneNames"));
    for (vtkIdType i = 0; list && i < list->GetNumberOfValues(); ++i)
    {
      zones += list->GetValue(i) + " ";
    }
    return zones;
  };
  // Block 1 has two pieces, block 2 no name.
  EXPECT_EQ(name({ { solid, 0 }, { patch, 1 }, { patch, 1 }, { patch, 2 }, { patch, 3 } }),
    "- 2 2 - 3 inlet wall ");
  EXPECT_EQ(name({ { patch, 1 }, { patch, 3 } }), "- - ") << "without 3D cells";
  EXPECT_EQ(name({ { solid, 0 }, { solid, 3 } }), "- - ");
  EXPECT_EQ(patch->GetCellData()->GetArray("Zone"), nullptr) << "the input is not changed";
  const Grid zoned = MakeColumns({ 2 });
  vtkNew<vtkIntArray> zone;
  zone->SetName("Zone");
  zone->InsertNextValue(7);
  zoned->GetCellData()->AddArray(zone);
  EXPECT_EQ(name({ { solid, 0 }, { patch, 1 }, { zoned, 3 } }), "- - 7 ");
}
