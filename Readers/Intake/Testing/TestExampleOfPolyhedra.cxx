// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The example of CONTRIBUTING: what Intake does for a format of polyhedra, in text and binary.
#include "ExampleOfPolyhedra.h"

#include "TemporaryFolder.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

using namespace camaron;

namespace
{
/// Boxes in a row, the last of which is inverted.
struct Boxes
{
  std::vector<std::array<double, 3>> Points;
  std::vector<std::vector<int>> Faces, Cells; ///< of cells with the material

  explicit Boxes(int count)
  {
    for (int i = 0; i <= count; ++i)
    {
      for (const auto& [y, z] : { std::pair{ 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } })
      {
        this->Points.push_back({ { 1. * i, 1. * y, 1. * z } });
      }
      const int p = 4 * i;
      this->Faces.push_back({ p + 1, p + 2, p + 3, p + 4 }); // normal along x
    }
    for (int i = 0; i < count; ++i)
    {
      std::vector<int> cell = { -(i + 1), i + 2 };
      for (int side = 0; side < 4; ++side)
      {
        const int a = 4 * i + side + 1, b = 4 * i + (side + 1) % 4 + 1;
        this->Faces.push_back({ a, a + 4, b + 4, b });
        cell.push_back(static_cast<int>(this->Faces.size()));
      }
      cell.push_back(100 + i);
      this->Cells.push_back(cell);
    }
  }

  std::string Write(const std::string& dialect) const
  {
    std::ostringstream out;
    const bool isText = dialect == "text", isBig = dialect == "big";
    const auto put = [&](const auto& number)
    {
      std::string bytes(reinterpret_cast<const char*>(&number), sizeof(number));
      if (isBig != (GetByteOrder() == ByteOrder::Big))
      {
        std::reverse(bytes.begin(), bytes.end());
      }
      isText ? out << number << ' ' : out << bytes;
    };
    const auto list = [&](const std::vector<int>& words, std::size_t more)
    {
      put(static_cast<std::int32_t>(words.size() - more));
      std::for_each(words.begin(), words.end(), put);
      out << (isText ? "\n" : "");
    };
    out << "poly 1 " << dialect << "\nPOINTS " << this->Points.size() << '\n';
    for (const auto& x : this->Points)
    {
      std::for_each(x.begin(), x.end(), put);
      out << (isText ? "\n" : "");
    }
    out << (isText ? "" : "\n") << "FACES " << this->Faces.size() << '\n';
    std::for_each(this->Faces.begin(), this->Faces.end(), [&](const auto& f) { list(f, 0); });
    out << (isText ? "" : "\n") << "CELLS " << this->Cells.size() << '\n';
    std::for_each(this->Cells.begin(), this->Cells.end(), [&](const auto& c) { list(c, 1); });
    out << '\n';
    return out.str();
  }
};

//------------------------------------------------------------------------------
class ExampleFile : public ::testing::Test
{
protected:
  ScanError Read(const std::string& bytes, vtkUnstructuredGrid* grid,
    const PieceRequest& piece = {}, vtkIdType chunk = 1 << 20)
  {
    const std::string path = this->Folder.Path.string() + "/boxes.poly";
    std::ofstream(path, std::ios::binary) << bytes;
    Warnings warnings;
    ScanError error;
    const bool good = ReadExampleOfPolyhedra(path, piece, grid, warnings, error, {}, chunk);
    EXPECT_EQ(good, !error) << error.Message;
    EXPECT_EQ(IsExampleOfPolyhedra(path), error.Kind != ErrorKind::NotThisFormat);
    return error;
  }

  const TemporaryFolder Folder;
};
}

//------------------------------------------------------------------------------
// All dialects, lines in parallel and pieces are the same mesh.
TEST_F(ExampleFile, SameInAllDialects)
{
  constexpr int count = 200;
  const Boxes boxes(count);
  for (const std::string dialect : { "text", "little", "big" })
  {
    for (const vtkIdType chunk : { 1 << 20, 100 })
    {
      for (const int pieces : { 1, 3 })
      {
        std::set<int> materials;
        for (int i = 0; i < pieces; ++i)
        {
          PieceRequest piece;
          piece.Piece = i;
          piece.NumberOfPieces = pieces;
          vtkNew<vtkUnstructuredGrid> grid;
          ASSERT_FALSE(this->Read(boxes.Write(dialect), grid, piece, chunk));
          vtkDataArray* const material = grid->GetCellData()->GetArray("Material");
          for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
          {
            EXPECT_EQ(grid->GetCell(cell)->GetNumberOfFaces(), 6);
            const int box = static_cast<int>(material->GetTuple1(cell)) - 100;
            EXPECT_EQ(grid->GetCell(cell)->GetBounds()[0], box);
            EXPECT_TRUE(materials.insert(box).second);
          }
        }
        EXPECT_EQ(materials.size(), count) << dialect << ", " << pieces << " pieces";
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST_F(ExampleFile, Damaged)
{
  const std::string good = Boxes(1).Write("text");
  const auto replace = [&](const std::string& text, const std::string& by)
  { return std::string(good).replace(good.find(text), text.size(), by); };
  const std::pair<std::string, const char*> cases[] = {
    { replace("poly 1", "poly 2"), "boxes.poly:1: expected \"poly 1 text\", little or big" },
    { replace("FACES", "SIDES"), "boxes.poly:11: expected FACES, found 'SIDES'" },
    { replace("4 1 2 3 4", "4 1 2 3 9"), "boxes.poly:12: expected a point of a face from 1 to 8" },
    { replace("4 1 2 3 4", "4 1 2 3 0"), "boxes.poly:12: expected a point of a face from 1 to 8" },
    { replace("6 -1 2", "6 -7 2"), "a face of a cell from 1 to 6, or the negative of one" },
    { replace("6 -1 2", "6 2 2"),
      "boxes.poly:19: expected at most one cell on each side of a face, found face 1 in cells 0 "
      "and 0 "
      "(counted from 0)" },
    { replace("6 -1 2", "5 -1 2"),
      "boxes.poly:19: expected rows of their declared length, found more in cell 0 (counted from "
      "0)" },
    { replace("0 1 1 \n", "0 1 1 7 \n"),
      "boxes.poly:5: expected rows of their declared length, found more in point 2 (counted from "
      "0)" },
    { replace("4 1 2 3 4 \n", "4 1 2 3 \n"),
      "boxes.poly:12: expected one of the points of a face, found the end of the line" },
    { replace("4 1 2 3 4 \n", "four 1 2 3 4 \n"),
      "boxes.poly:12: expected the number of points of a face, found 'four'" },
    { replace("100", "x"), "boxes.poly:19: expected material of a cell, found 'x'" },
    { replace("FACES 6", "FACES 6 7"), "boxes.poly:11: expected the end of the line, found '7'" },
    { replace("POINTS 8", "POINTS 800000000"), "boxes.poly:2: expected " },
    { good + "more", "expected the end of the file, found 'more'" },
  };
  for (const auto& [bytes, message] : cases)
  {
    vtkNew<vtkUnstructuredGrid> grid;
    const ScanError error = this->Read(bytes, grid);
    EXPECT_EQ(static_cast<bool>(error), *message != '\0') << message;
    EXPECT_NE(error.Message.find(message), std::string::npos) << error.Message;
  }
  for (const char* dialect : { "text", "little", "big" })
  {
    const std::string whole = Boxes(3).Write(dialect);
    for (std::size_t size = 0; size + 12 < whole.size(); size += 7)
    {
      vtkNew<vtkUnstructuredGrid> grid;
      EXPECT_TRUE(this->Read(whole.substr(0, size), grid)) << dialect << " " << size;
      EXPECT_EQ(grid->GetNumberOfCells(), 0);
    }
  }
}

//------------------------------------------------------------------------------
// A face without points bounds nothing, whether cells have it or not.
TEST_F(ExampleFile, EmptyFace)
{
  std::string bytes = Boxes(1).Write("text");
  const auto replace = [&](const std::string& text, const std::string& by)
  { bytes.replace(bytes.find(text), text.size(), by); };
  replace("FACES 6", "FACES 7");
  replace("CELLS", "0 \nCELLS");
  replace("6 -1 2", "7 7 -1 2");
  for (const int pieces : { 1, 2 })
  {
    vtkIdType cells = 0;
    for (int i = 0; i < pieces; ++i)
    {
      PieceRequest piece;
      piece.Piece = i;
      piece.NumberOfPieces = pieces;
      vtkNew<vtkUnstructuredGrid> grid;
      const ScanError error = this->Read(bytes, grid, piece);
      ASSERT_FALSE(error) << error.Message;
      for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
      {
        EXPECT_EQ(grid->GetCell(cell)->GetNumberOfFaces(), 6);
      }
      cells += grid->GetNumberOfCells();
    }
    EXPECT_EQ(cells, 1);
  }
}

//------------------------------------------------------------------------------
TEST_F(ExampleFile, Stopped)
{
  const std::string path = this->Folder.Path.string() + "/boxes.poly";
  for (const char* dialect : { "text", "big" })
  {
    std::ofstream(path, std::ios::binary) << Boxes(500).Write(dialect);
    vtkNew<vtkUnstructuredGrid> grid;
    Warnings warnings;
    ScanError error;
    const Progress stop([](double) { return false; });
    EXPECT_FALSE(ReadExampleOfPolyhedra(path, {}, grid, warnings, error, stop, 1000));
    EXPECT_FALSE(error) << error.Message;
  }
}

//------------------------------------------------------------------------------
// Lists of faces without signs: a face may be in any two cells.
TEST(FaceTables, WithoutSigns)
{
  const std::string lists = "4 0 1 2 3\n3 0 4 1\n3 1 4 2\n3 2 4 3\n3 3 4 0\n3 0 5 1\n3 1 5 2\n"
                            "3 2 5 3\n3 3 5 0\n5 1 2 3 4 5\n5 1 6 7 8 9\n";
  TextScanner scanner("pyramids", lists.data(), lists.data() + lists.size());
  const std::vector<TableProperty> list = { { "ids", ValueType::Int32, true, ValueType::Int32 } };
  const auto faces = MakeTextRows({ "face", 9, list }, scanner, nullptr, RowLayout::OneLine);
  ASSERT_TRUE(faces->Locate({}));
  const auto cells = MakeTextRows({ "cell", 2, list }, scanner, nullptr, RowLayout::OneLine);
  ASSERT_TRUE(cells->Locate({}));
  FaceMesh mesh;
  Warnings warnings;
  const ListIds ofCells = ListIds::FromOne("a face", 9);
  mesh.Doubles = Buffer<double>(18);
  const double points[] = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0.5, 1, 0.5, 0.5, -1 };
  std::copy_n(points, 18, mesh.Doubles.data());
  mesh.Points = PointSource(reinterpret_cast<const char*>(mesh.Doubles.data()), 6, true);
  ASSERT_TRUE(ReadFaces(*faces, 0, { "a point", 6 }, {}, mesh, warnings, {}));
  ASSERT_TRUE(ReadFacesOfCells(*cells, 0, ofCells, {}, mesh, warnings, {}));
  vtkNew<vtkUnstructuredGrid> grid;
  ScanError error;
  ASSERT_TRUE(BuildGrid(mesh, {}, grid, warnings, error, {})) << error.Message;
  EXPECT_EQ(grid->GetNumberOfCells(), 2);
  EXPECT_EQ(grid->GetCellType(0), VTK_PYRAMID);
  EXPECT_EQ(grid->GetCellType(1), VTK_PYRAMID);
}
