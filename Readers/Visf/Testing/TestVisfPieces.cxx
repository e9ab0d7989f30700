// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Visf files read by several processes, by several threads and in several chunks.
#include "VisfSamples.h"

#include "Sanitized.h"
#include "VisfReading.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <limits>

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
// Bars with additional polygons and unused points.
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
void ExpectPiecesMakeTheWhole(const std::string& path, int pieces, int ghostLevels)
{
  camaron::testing::ExpectPiecesMakeTheWhole<vtkVisfReader>(path, pieces, ghostLevels);
}

//------------------------------------------------------------------------------
void ExpectSameInChunks(const std::string& path, const PieceRequest& request)
{
  vtkNew<vtkUnstructuredGrid> expected;
  Warnings warnings;
  ScanError error;
  vtkSMPTools::LocalScope(vtkSMPTools::Config(1),
    [&]
    {
      constexpr vtkIdType WholeFile = vtkIdType(1) << 40;
      EXPECT_TRUE(ReadVisf(path, request, expected, warnings, error, Progress(), WholeFile));
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
          EXPECT_TRUE(ReadVisf(path, request, grid, others, error, Progress(), chunk));
          ExpectSameGrid(grid, expected);
          EXPECT_EQ(others.GetSentences(), warnings.GetSentences());
        });
    }
  }
}
}

//------------------------------------------------------------------------------
// If this fails, several processes together do not have the same mesh as one.
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
// If this fails, the mesh depends on threads, or on where text is split for them.
TEST(VisfPieces, ThreadsAndChunksChangeNothing)
{
  VisfMesh mesh = MakeLargerMesh();
  mesh.Points.back()[2] = std::numeric_limits<float>::infinity(); // the first piece reports it
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
  // Lines that are too far apart for offsets of two bytes.
  std::string wide = Encode(mesh, Encoding::Ascii);
  for (const std::size_t part : { 3, 5, 9 })
  {
    wide.insert(wide.find('\n', wide.size() / 10 * part), " # " + std::string(70000, '-'));
  }
  const std::string files[] = { Encode(mesh, Encoding::Little03), Encode(mesh, Encoding::Big03),
    Encode(mesh, Encoding::Ascii), Encode(mesh, Encoding::Web),
    Encode(withNeighbors, Encoding::Ascii), odd, split, oldMac, wide };
  const std::vector<PieceRequest> requests = { PieceRequest(), { 0, 3, 1 }, { 2, 3, 0 } };
  std::size_t next = 0; // under a sanitizer, one request per file
  for (const std::string& bytes : files)
  {
    const File file(bytes);
    for (std::size_t i = 0; i < (IsSanitized ? 1 : requests.size()); ++i)
    {
      ExpectSameInChunks(file.Path, requests[next++ % requests.size()]);
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, an error in text that is read in parallel is lost, or has another position.
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
