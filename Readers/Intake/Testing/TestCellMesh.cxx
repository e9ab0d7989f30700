// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes given by cells: read from text in parallel and as a stream, in pieces with ghosts.
#include "Intake/CellMesh/CellGrid.h"
#include "Intake/CellMesh/CellRows.h"
#include "Intake/CellMesh/PieceRows.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace camaron;

namespace
{
//------------------------------------------------------------------------------
// Lines "k id...", triangles and quadrilaterals of a strip of points.
std::string MakeText(int cells, const char* separator = "\n")
{
  std::string text;
  for (int i = 0; i < cells; ++i)
  {
    const int size = i % 3 == 0 ? 4 : 3;
    text += std::to_string(size);
    for (int j = 0; j < size; ++j)
    {
      text += " " + std::to_string(i + j);
    }
    text += separator;
  }
  return text;
}

//------------------------------------------------------------------------------
bool ReadPolygons(TextScanner& scanner, const TextLines* lines, int cells, CellMesh& mesh)
{
  mesh.NumberOfPoints = cells + 4;
  return ReadCells(RowSequence(scanner, lines, cells), mesh, Progress(),
    [&](vtkIdType, TextRow& row, CellSink& sink)
    {
      std::int64_t size;
      if (!row.ReadInteger(size, "the number of points"))
      {
        return false;
      }
      sink.BeginCell(size == 3 ? VTK_TRIANGLE : VTK_QUAD);
      for (std::int64_t i = 0; i < size; ++i)
      {
        std::int32_t point;
        if (!row.ReadId(point, 0, mesh.NumberOfPoints - 1, "a point"))
        {
          return false;
        }
        sink.AddPoint(point);
      }
      return true;
    });
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> MakePiece(int cells, const PieceRequest& request)
{
  const std::string text = MakeText(cells);
  TextScanner scanner("t", text.data(), text.data() + text.size());
  CellMesh mesh;
  EXPECT_TRUE(ReadPolygons(scanner, nullptr, cells, mesh));
  mesh.NumberOfPoints += 1; // one that no cell has
  CellMeshPiece piece;
  EXPECT_TRUE(piece.Select(mesh, request, Progress()));
  auto points = vtkSmartPointer<vtkDoubleArray>::New();
  points->SetNumberOfComponents(3);
  points->SetNumberOfTuples(piece.GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh.NumberOfPoints; ++i)
  {
    if (piece.FindPoint(i) >= 0)
    {
      points->SetTuple3(piece.FindPoint(i), static_cast<double>(i), 0, 0);
    }
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  KeepPiece(mesh, piece);
  FillGrid(mesh, piece, points, grid);
  return grid;
}
}

//------------------------------------------------------------------------------
TEST(CellMesh, LinesAndStreamGiveTheSame)
{
  constexpr int Cells = 5000;
  const std::string regular = MakeText(Cells), oneLine = MakeText(Cells, " ");
  CellMesh meshes[3];
  TextScanner stream("t", regular.data(), regular.data() + regular.size());
  ASSERT_TRUE(ReadPolygons(stream, nullptr, Cells, meshes[0]));
  for (const std::string* text : { &regular, &oneLine })
  {
    TextScanner scanner("t", text->data(), text->data() + text->size());
    const TextLines lines(scanner, Progress(), 100);
    CellMesh& mesh = meshes[text == &regular ? 1 : 2];
    if (text == &oneLine)
    {
      // All records are in one line, of which only the first is read.
      TextScanner attempt = scanner;
      EXPECT_FALSE(ReadPolygons(attempt, &lines, Cells, mesh));
      EXPECT_FALSE(ReadPolygons(scanner, nullptr, Cells, mesh));
      EXPECT_EQ(scanner.GetError().Kind, ErrorKind::Truncated);
      continue;
    }
    ASSERT_TRUE(ReadPolygons(scanner, &lines, Cells, mesh));
    EXPECT_FALSE(scanner.SkipSpace());
    ASSERT_EQ(mesh.NumberOfCells, Cells);
    for (int i = 0; i < Cells; ++i)
    {
      ASSERT_EQ(mesh.GetType(i), i % 3 == 0 ? VTK_QUAD : VTK_TRIANGLE);
      ASSERT_EQ(mesh.GetSize(i), i % 3 == 0 ? 4 : 3);
      for (int j = 0; j < mesh.GetSize(i); ++j)
      {
        ASSERT_EQ(mesh.GetPoints(i)[j], i + j);
        ASSERT_EQ(meshes[0].GetPoints(i)[j], i + j);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(CellMesh, AWrongIdNamesItsLine)
{
  std::string text = MakeText(1000);
  text.replace(text.find("3 700 701 702"), 13, "3 700 99999 702");
  TextScanner scanner("name", text.data(), text.data() + text.size());
  const TextLines lines(scanner, Progress(), 64);
  CellMesh mesh;
  TextScanner attempt = scanner;
  EXPECT_FALSE(ReadPolygons(attempt, &lines, 1000, mesh));
  EXPECT_FALSE(ReadPolygons(scanner, nullptr, 1000, mesh));
  EXPECT_EQ(scanner.GetError().Kind, ErrorKind::Index);
  EXPECT_EQ(scanner.GetError().Message, "name:701: expected a point from 0 to 1003, found 99999");
}

//------------------------------------------------------------------------------
TEST(CellMesh, PiecesMakeTheWhole)
{
  constexpr int Cells = 1000;
  for (const int ghostLevels : { 0, 1, 2 })
  {
    for (const int pieces : { 1, 3, 7 })
    {
      std::multiset<vtkIdType> owned;
      std::set<vtkIdType> points;
      for (int p = 0; p < pieces; ++p)
      {
        const auto grid = MakePiece(Cells, { p, pieces, ghostLevels });
        vtkDataArray* cellIds = grid->GetCellData()->GetGlobalIds();
        vtkDataArray* pointIds = grid->GetPointData()->GetGlobalIds();
        ASSERT_EQ(cellIds != nullptr, pieces > 1);
        ASSERT_EQ(grid->GetCellGhostArray() != nullptr, pieces > 1 && ghostLevels > 0);
        vtkIdType first = Cells, last = -1;
        for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
        {
          const auto id = cellIds ? static_cast<vtkIdType>(cellIds->GetTuple1(i)) : i;
          ASSERT_EQ(grid->GetCellSize(i), id % 3 == 0 ? 4 : 3);
          vtkIdType size;
          const vtkIdType* corners;
          vtkNew<vtkIdList> list;
          grid->GetCellPoints(i, size, corners, list);
          ASSERT_EQ(grid->GetPoint(corners[1])[0], static_cast<double>(id + 1));
          const bool ghost = grid->GetCellGhostArray() && grid->GetCellGhostArray()->GetValue(i);
          if (!ghost)
          {
            owned.insert(id);
            first = std::min(first, id);
            last = id;
          }
        }
        for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
        {
          const auto id = pointIds ? static_cast<vtkIdType>(pointIds->GetTuple1(i)) : i;
          ASSERT_EQ(grid->GetPoint(i)[0], static_cast<double>(id));
          if (!grid->GetPointGhostArray() || !grid->GetPointGhostArray()->GetValue(i))
          {
            points.insert(id);
          }
        }
        if (ghostLevels == 1 && pieces == 3 && p == 1)
        {
          // Cells i and j meet if their runs of ids overlap: 3 cells before (a triangle or a
          // quadrilateral), and as many after as the last cells have points.
          std::set<vtkIdType> expected;
          for (vtkIdType id = 0; id < Cells; ++id)
          {
            const vtkIdType end = id + (id % 3 == 0 ? 4 : 3);
            bool meets = false;
            for (vtkIdType other = first; other <= last; ++other)
            {
              meets = meets || (id < other + (other % 3 == 0 ? 4 : 3) && other < end);
            }
            if (meets)
            {
              expected.insert(id);
            }
          }
          EXPECT_EQ(grid->GetNumberOfCells(), static_cast<vtkIdType>(expected.size()));
        }
      }
      EXPECT_EQ(owned.size(), std::size_t(Cells));
      EXPECT_EQ(std::set<vtkIdType>(owned.begin(), owned.end()).size(), std::size_t(Cells));
      EXPECT_EQ(points.size(), std::size_t(Cells + 5));
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, what a rank has of a mesh depends on whether all cells were kept while it was
// found.
TEST(CellMesh, APieceOfRowsIsThatOfTheWhole)
{
  constexpr vtkIdType Cells = 600;
  CellMesh whole(Cells + 4, Cells, VTK_TRIANGLE, 3); // the last two points are in no cell
  std::string text = "# comment\n\n";
  for (vtkIdType i = 0; i < Cells; ++i)
  {
    // Neighbors in the file meet, and some that are far apart.
    const vtkIdType ids[3] = { i, i + 1, i % 50 == 0 ? (7 * i + 300) % Cells : i + 1 };
    for (int j = 0; j < 3; ++j)
    {
      whole.Connectivity[3 * i + j] = static_cast<std::int32_t>(ids[j]);
      text += std::to_string(ids[j]) + (j < 2 ? " " : i % 9 == 0 ? " more\n# comment\n" : "\n");
    }
  }
  const PieceRows::Table shape = { whole.NumberOfPoints, Cells, VTK_TRIANGLE, 3 };
  const auto read = [&](vtkIdType, TextRow& row, std::int32_t* points, vtkIdType = 0)
  {
    return row.ReadId(points[0], 0, Cells + 3, "a point") &&
      row.ReadId(points[1], 0, Cells + 3, "a point") &&
      row.ReadId(points[2], 0, Cells + 3, "a point");
  };
  for (const bool inParallel : { false, true })
  {
    for (const PieceRequest request : { PieceRequest{ 0, 1, 0 }, PieceRequest{ 0, 4, 0 },
           PieceRequest{ 2, 4, 0 }, PieceRequest{ 0, 4, 1 }, PieceRequest{ 3, 4, 2 },
           PieceRequest{ 5, 700, 1 }, PieceRequest{ 699, 700, 1 } })
    {
      TextScanner scanner("t", text.data(), text.data() + text.size(), '#');
      const TextLines lines(scanner, Progress(), 200);
      const PieceRows rows(scanner, inParallel ? &lines : nullptr, shape);
      CellMeshPiece piece, expectedPiece;
      CellMesh mesh, expected(whole.NumberOfPoints, Cells, VTK_TRIANGLE, 3);
      std::copy(whole.Connectivity.data(), whole.Connectivity.data() + 3 * Cells,
        expected.Connectivity.data());
      ASSERT_TRUE(rows.Find(request, piece, Progress(), read));
      ASSERT_TRUE(rows.Read(piece, mesh, Progress(), read));
      EXPECT_FALSE(scanner.SkipSpace());
      ASSERT_TRUE(expectedPiece.Select(expected, request, Progress()));
      Warnings warnings, expectedWarnings;
      piece.WarnOfRepeatedPoints(mesh, warnings, Progress());
      expectedPiece.WarnOfRepeatedPoints(expected, expectedWarnings, Progress());
      EXPECT_EQ(warnings.GetSentences(), expectedWarnings.GetSentences());
      EXPECT_EQ(warnings.GetSentences().size(), request.Piece == 0 ? 1u : 0u);
      KeepPiece(expected, expectedPiece);
      ASSERT_EQ(mesh.NumberOfCells, expected.NumberOfCells);
      ASSERT_EQ(mesh.NumberOfPoints, expected.NumberOfPoints);
      for (vtkIdType cell = 0; cell < mesh.NumberOfCells; ++cell)
      {
        ASSERT_TRUE(
          std::equal(mesh.GetPoints(cell), mesh.GetPoints(cell) + 3, expected.GetPoints(cell)));
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, whether a file is wrong depends on the piece that is read.
TEST(CellMesh, APieceHasTheErrorOfTheWhole)
{
  const std::string text = "0 1\n1 2\n2 3\n3 4\n4 99\n5 6\n";
  const PieceRows::Table shape = { 7, 6, VTK_LINE, 2 };
  for (const PieceRequest request :
    { PieceRequest{ 0, 1, 0 }, PieceRequest{ 0, 3, 0 }, PieceRequest{ 2, 3, 1 } })
  {
    TextScanner scanner("t", text.data(), text.data() + text.size());
    const PieceRows rows(scanner, nullptr, shape);
    CellMeshPiece piece;
    CellMesh mesh;
    const auto read = [](vtkIdType, TextRow& row, std::int32_t* points, vtkIdType = 0)
    { return row.ReadId(points[0], 0, 6, "a point") && row.ReadId(points[1], 0, 6, "a point"); };
    EXPECT_FALSE(
      rows.Find(request, piece, Progress(), read) && rows.Read(piece, mesh, Progress(), read));
    EXPECT_EQ(scanner.GetError().Message, "t:5: expected a point from 0 to 6, found 99");
  }
}

//------------------------------------------------------------------------------
TEST(CellMesh, OddThingsAreCounted)
{
  CellMesh mesh(10, 3, VTK_TETRA, 4);
  const std::int32_t ids[] = { 0, 1, 2, 3, 0, 1, 1, 3, 4, 5, 6, 4 };
  std::copy(ids, ids + 12, mesh.Connectivity.data());
  Warnings warnings;
  CellMeshPiece piece;
  ASSERT_TRUE(piece.Select(mesh, PieceRequest(), Progress()));
  piece.WarnOfRepeatedPoints(mesh, warnings, Progress(), "tetrahedron", "tetrahedra");
  ASSERT_EQ(warnings.GetSentences().size(), 1u);
  EXPECT_NE(warnings.GetSentences()[0].find("2 tetrahedra"), std::string::npos);
}
