// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Visf files read by several processes, by several threads and in several chunks.
#include "VisfSamples.h"

#include "VisfReading.h"
#include "Mesh/CellFacets.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <map>
#include <set>

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
// Bars with polygons of their own and points of no polygon.
VisfMesh MakeLargerMesh()
{
  VisfMesh mesh = MakeBar(3000, 1000);
  for (std::int32_t i = 0; i < 500; ++i)
  {
    mesh.Polygons.push_back({ i, i + 1, i + 2, i + 5, i + 9 });
    mesh.Points.push_back({ { 0, 0, static_cast<float>(i) } });
  }
  std::mt19937 random(5);
  for (auto& point : mesh.Points)
  {
    for (float& x : point)
    {
      x += static_cast<float>(random() % 1000) * 1e-4f;
    }
  }
  return mesh;
}

//------------------------------------------------------------------------------
// All lists of point ids that define a cell, in ids of the whole mesh.
std::vector<std::vector<vtkIdType>> Describe(
  vtkUnstructuredGrid* grid, vtkIdType cell, const std::vector<vtkIdType>& ids)
{
  const MeshView mesh(grid);
  std::vector<std::vector<vtkIdType>> lists(1);
  lists[0].push_back(grid->GetCellType(cell));
  for (vtkIdType i = 0; i < mesh.GetCellPoints(cell).Size; ++i)
  {
    lists[0].push_back(ids[mesh.GetCellPoints(cell)[i]]);
  }
  CellFacets(mesh).ForEach(cell,
    [&](const vtkIdType* points, vtkIdType size, vtkIdType)
    {
      lists.emplace_back();
      for (vtkIdType i = 0; i < size; ++i)
      {
        lists.back().push_back(ids[points[i]]);
      }
    });
  return lists;
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> GetIds(vtkDataSetAttributes* data, vtkIdType size)
{
  std::vector<vtkIdType> ids(size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    ids[i] = data->GetGlobalIds() ? static_cast<vtkIdType>(data->GetGlobalIds()->GetTuple1(i)) : i;
  }
  return ids;
}

//------------------------------------------------------------------------------
void ExpectPiecesMakeTheWhole(const std::string& path, int pieces, int ghostLevels)
{
  const Result whole = ReadFile(path);
  ASSERT_TRUE(whole.Errors.empty());
  EXPECT_EQ(whole.Grid->GetPointData()->GetGlobalIds(), nullptr);
  const auto allPoints = GetIds(whole.Grid->GetPointData(), whole.Grid->GetNumberOfPoints());
  std::set<vtkIdType> cells, points, ownedPoints;
  for (int piece = 0; piece < pieces; ++piece)
  {
    const Result part = ReadFile(path, piece, pieces, ghostLevels);
    ASSERT_TRUE(part.Errors.empty());
    EXPECT_EQ(part.Warnings.size(), piece == 0 ? whole.Warnings.size() : 0u);
    vtkUnstructuredGrid* grid = part.Grid;
    const auto pointIds = GetIds(grid->GetPointData(), grid->GetNumberOfPoints());
    const auto cellIds = GetIds(grid->GetCellData(), grid->GetNumberOfCells());
    vtkUnsignedCharArray* ghosts = grid->GetCellGhostArray();
    vtkUnsignedCharArray* ghostPoints = grid->GetPointGhostArray();
    EXPECT_EQ(ghosts != nullptr, ghostLevels > 0 && pieces > 1);
    vtkIdType owned = 0;
    std::set<vtkIdType> mine, touched;
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      EXPECT_EQ(Describe(grid, cell, pointIds), Describe(whole.Grid, cellIds[cell], allPoints));
      if (!ghosts || !ghosts->GetValue(cell))
      {
        EXPECT_TRUE(cells.insert(cellIds[cell]).second) << "cell twice";
        ++owned;
        for (vtkIdType i = 0; i < MeshView(grid).GetCellPoints(cell).Size; ++i)
        {
          touched.insert(pointIds[MeshView(grid).GetCellPoints(cell)[i]]);
        }
      }
      mine.insert(cellIds[cell]);
    }
    EXPECT_LE(std::abs(owned - whole.Grid->GetNumberOfCells() / pieces), 1);
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      double x[3], y[3];
      grid->GetPoint(i, x);
      whole.Grid->GetPoint(pointIds[i], y);
      EXPECT_TRUE(std::equal(x, x + 3, y));
      points.insert(pointIds[i]);
      if (ghostPoints && !ghostPoints->GetValue(i))
      {
        EXPECT_TRUE(ownedPoints.insert(pointIds[i]).second) << "point owned twice";
      }
    }
    if (ghostLevels > 0)
    {
      // Every cell that shares a point with an owned one must be there.
      for (vtkIdType cell = 0; cell < whole.Grid->GetNumberOfCells(); ++cell)
      {
        const IndexRange ids = MeshView(whole.Grid).GetCellPoints(cell);
        bool shares = false;
        for (vtkIdType i = 0; i < ids.Size; ++i)
        {
          shares = shares || touched.count(ids[i]);
        }
        EXPECT_TRUE(!shares || mine.count(cell)) << cell;
      }
    }
  }
  EXPECT_EQ(static_cast<vtkIdType>(cells.size()), whole.Grid->GetNumberOfCells());
  EXPECT_EQ(static_cast<vtkIdType>(points.size()), whole.Grid->GetNumberOfPoints());
  if (ghostLevels > 0 && pieces > 1)
  {
    EXPECT_EQ(static_cast<vtkIdType>(ownedPoints.size()), whole.Grid->GetNumberOfPoints());
  }
}
}

//------------------------------------------------------------------------------
// If this fails, processes together do not have what one has.
TEST(VisfPieces, MakeTheWhole)
{
  const VisfMesh mesh = MakeLargerMesh();
  VisfMesh surface = mesh;
  surface.Polyhedra.clear();
  surface.Polygons.resize(50);
  surface.Points.resize(400);
  for (const Encoding encoding : { Encoding::Little03, Encoding::Ascii })
  {
    const File file(Encode(mesh, encoding)), surfaceFile(Encode(surface, encoding));
    for (const int pieces : { 1, 2, 3, 7 })
    {
      ExpectPiecesMakeTheWhole(file.Path, pieces, 0);
      ExpectPiecesMakeTheWhole(surfaceFile.Path, pieces, 0);
    }
    ExpectPiecesMakeTheWhole(file.Path, 3, 1);
    ExpectPiecesMakeTheWhole(file.Path, 2, 2);
    ExpectPiecesMakeTheWhole(surfaceFile.Path, 3, 1);
    ExpectPiecesMakeTheWhole(surfaceFile.Path, 100, 0); // more pieces than cells
  }
  VisfMesh cloud;
  cloud.Points.resize(10);
  ExpectPiecesMakeTheWhole(File(Encode(cloud, Encoding::Ascii)).Path, 3, 0);
}

//------------------------------------------------------------------------------
// If this fails, the mesh depends on threads, or on where text is cut for them.
TEST(VisfPieces, ThreadsAndChunksChangeNothing)
{
  const VisfMesh mesh = MakeLargerMesh();
  VisfMesh withNeighbors = MakeBar(300, 100);
  withNeighbors.Neighbors.resize(withNeighbors.Polygons.size(), { 1, 2, 3 });
  std::string odd = Encode(mesh, Encoding::Ascii);
  for (std::size_t at = odd.find('\n', 500); at != std::string::npos; at = odd.find('\n', at + 997))
  {
    odd.insert(at, " # a comment\r\n  \t\r\n# another");
  }
  std::string split = odd;
  split[split.find(' ', 5000)] = '\n'; // one vertex on two lines
  std::string oldMac = odd;
  std::replace(oldMac.begin() + 8000, oldMac.begin() + 12000, '\n', '\r');
  const std::string files[] = { Encode(mesh, Encoding::Little03), Encode(mesh, Encoding::Big03),
    Encode(mesh, Encoding::Ascii), Encode(mesh, Encoding::Web),
    Encode(withNeighbors, Encoding::Ascii), odd, split, oldMac };
  for (const std::string& bytes : files)
  {
    const File file(bytes);
    vtkNew<vtkUnstructuredGrid> expected;
    Warnings warnings;
    ScanError error;
    vtkSMPTools::LocalScope(vtkSMPTools::Config(1),
      [&]
      {
        constexpr vtkIdType WholeFile = vtkIdType(1) << 40;
        EXPECT_TRUE(
          ReadVisf(file.Path, PieceRequest(), expected, warnings, error, Progress(), WholeFile));
      });
    EXPECT_GT(expected->GetNumberOfCells(), 0);
    for (const int threads : { 1, 2, 5 })
    {
      for (const vtkIdType chunk : { 64, 1000, 100000 })
      {
        vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
          [&]
          {
            vtkNew<vtkUnstructuredGrid> grid;
            Warnings others;
            EXPECT_TRUE(
              ReadVisf(file.Path, PieceRequest(), grid, others, error, Progress(), chunk));
            ExpectSameGrid(grid, expected);
            EXPECT_EQ(others.GetSentences(), warnings.GetSentences());
          });
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, an error in text that is read in parallel is lost, or named another place.
TEST(VisfPieces, ErrorsDoNotDependOnChunks)
{
  std::string text = Encode(MakeLargerMesh(), Encoding::Ascii);
  text[text.rfind('\n', text.size() - 30000) + 3] = 'x';
  const File file(text);
  std::set<std::string> messages;
  for (const vtkIdType chunk : { 64, 5000, 1 << 30 })
  {
    vtkNew<vtkUnstructuredGrid> grid;
    Warnings warnings;
    ScanError error;
    EXPECT_FALSE(ReadVisf(file.Path, PieceRequest(), grid, warnings, error, Progress(), chunk));
    EXPECT_EQ(error.Kind, ErrorKind::Syntax);
    EXPECT_EQ(grid->GetNumberOfPoints(), 0);
    messages.insert(error.Message);
  }
  EXPECT_EQ(messages.size(), 1u);
}
