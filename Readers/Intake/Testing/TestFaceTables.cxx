// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Grids from tables of points, faces and cells; the skeleton of formats by faces has more tests.
#include "Intake/FaceMesh/FaceTables.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <map>

using namespace camaron;

namespace
{
constexpr ValueType Real = ValueType::Double, Integer = ValueType::Int32;
const TableProperty List = { "ids", Integer, true, Integer };

/// Reads tables of so many rows of text: points with a weight, faces, cells with two values.
ScanError Read(const std::string& text, const vtkIdType (&counts)[3], FaceTables& tables,
  const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings)
{
  TextScanner scanner("tables", text.data(), text.data() + text.size());
  TableScanner rows{ scanner, nullptr, nullptr, {} };
  const bool good =
    rows.Locate(tables.Points,
      { "point", counts[0], { { "x", Real }, { "y", Real }, { "z", Real }, { "Weight", Real } } },
      {}) &&
    rows.Locate(tables.Faces, { "face", counts[1], { List } }, {}) &&
    rows.Locate(
      tables.Cells, { "cell", counts[2], { { "Zone", Integer }, List, { "Age", Real } } }, {}) &&
    rows.ReadEnd() && ReadFaceTables(tables, request, grid, warnings, rows.Error, {});
  EXPECT_EQ(good, !scanner.HasFailed() && !rows.Error);
  return scanner.HasFailed() ? scanner.GetError() : rows.Error;
}

// Two pyramids on both sides of a square, a face of no cell, and a face without points.
constexpr char Pyramids[] = "0 0 0 1\n1 0 0 2\n1 1 0 3\n0 1 0 4\n.5 .5 1 5\n.5 .5 -1 6\n"
                            "4 0 1 2 3\n3 0 4 1\n3 1 4 2\n3 2 4 3\n3 3 4 0\n3 0 5 1\n3 1 5 2\n"
                            "3 2 5 3\n3 3 5 0\n3 0 4 5\n0\n"
                            "8 5 0 1 2 3 4 0.5\n9 6 0 5 6 10 7 8 1.5\n";
}

//------------------------------------------------------------------------------
// Without signs, a face may be in any two cells. Values belong to their points and cells, also in
// pieces; faces without a cell have 0, and those without points are left out of their cell.
TEST(FaceTables, WithoutSigns)
{
  for (const int pieces : { 1, 2 })
  {
    std::map<int, int> typeOfZone;
    for (int i = 0; i < pieces; ++i)
    {
      FaceTables tables;
      PieceRequest piece;
      piece.Piece = i;
      piece.NumberOfPieces = pieces;
      vtkNew<vtkUnstructuredGrid> grid;
      Warnings warnings;
      const ScanError error = Read(Pyramids, { 6, 11, 2 }, tables, piece, grid, warnings);
      ASSERT_FALSE(error) << error.Message;
      vtkDataArray* const zones = grid->GetCellData()->GetArray("Zone");
      vtkDataArray* const ages = grid->GetCellData()->GetArray("Age");
      for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
      {
        const int zone = static_cast<int>(zones->GetTuple1(cell));
        EXPECT_TRUE(typeOfZone.emplace(zone, grid->GetCellType(cell)).second) << zone;
        EXPECT_EQ(ages->GetTuple1(cell), zone == 0 ? 0 : zone - 7.5);
        EXPECT_EQ(grid->GetCell(cell)->GetBounds()[4], zone == 8 ? 0 : -1); // the least z
      }
      vtkDataArray* const weights = grid->GetPointData()->GetArray("Weight");
      for (vtkIdType point = 0; point < grid->GetNumberOfPoints(); ++point)
      {
        const double z = grid->GetPoint(point)[2];
        EXPECT_EQ(z, weights->GetTuple1(point) == 5 ? 1 : weights->GetTuple1(point) == 6 ? -1 : 0);
      }
    }
    EXPECT_EQ(typeOfZone,
      (std::map<int, int>{ { 0, VTK_TRIANGLE }, { 8, VTK_PYRAMID }, { 9, VTK_POLYHEDRON } }));
  }
}

//------------------------------------------------------------------------------
// A face without points bounds nothing, also for cells whose faces have signs.
TEST(FaceTables, EmptyFaceWithSigns)
{
  const std::string text =
    "0 0 0 1\n1 0 0 1\n0 1 0 1\n0 0 1 1\n3 1 2 3\n3 1 2 4\n3 2 3 4\n3 3 1 4\n0\n"
    "3 5 5 -1 2 3 4 0.5\n";
  for (const int pieces : { 1, 2 })
  {
    vtkIdType cells = 0;
    for (int i = 0; i < pieces; ++i)
    {
      FaceTables tables;
      tables.PointsOfFaces.AreFromOne = true;
      tables.FacesOfCells.HaveSigns = true;
      PieceRequest piece;
      piece.Piece = i;
      piece.NumberOfPieces = pieces;
      vtkNew<vtkUnstructuredGrid> grid;
      Warnings warnings;
      const ScanError error = Read(text, { 4, 5, 1 }, tables, piece, grid, warnings);
      ASSERT_FALSE(error) << error.Message;
      for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
      {
        EXPECT_EQ(grid->GetCell(cell)->GetNumberOfFaces(), 4);
      }
      cells += grid->GetNumberOfCells();
    }
    EXPECT_EQ(cells, 1);
  }
}
