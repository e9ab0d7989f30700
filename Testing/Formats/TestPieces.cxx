// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Memory of a process that reads one of several pieces of a mesh of the chosen format.
#include "AllocationMeter.h"
#include "FormatUnderTest.h"
#include "MeshFiles.h"

#include "vtkMeshFileReader.h"
#include "vtkMeshFileWriter.h"

#include "vtkCellType.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

using namespace camaron;
using namespace camaron::testing;

namespace
{
#if defined(__SANITIZE_ADDRESS__)
constexpr bool MapsFiles = false; // files are read into memory, which this test would count
#else
constexpr bool MapsFiles = true;
#endif

//------------------------------------------------------------------------------
// A row of cubes of six tetrahedra each, or of squares of two triangles each, along x, in random
// order, like the meshes of some generators.
vtkSmartPointer<vtkUnstructuredGrid> MakeBar(bool isSurface)
{
  constexpr vtkIdType Across = 12;
  const vtkIdType usual = GetFormat().IsOfLibrary ? 400 : 100; // much more than a library needs
  const vtkIdType length = isSurface ? 5000 : usual, layers = isSurface ? 1 : Across;
  const vtkIdType height = isSurface ? 1 : Across + 1;
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; i <= length; ++i)
  {
    for (vtkIdType j = 0; j <= Across; ++j)
    {
      for (vtkIdType k = 0; k < height; ++k)
      {
        points->InsertNextPoint(
          static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
      }
    }
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  std::vector<std::vector<vtkIdType>> cells;
  for (vtkIdType i = 0; i < length; ++i)
  {
    for (vtkIdType j = 0; j < Across; ++j)
    {
      for (vtkIdType k = 0; k < layers; ++k)
      {
        const auto at = [&](int corner)
        {
          return ((i + (corner & 1)) * (Across + 1) + j + (corner >> 1 & 1)) * height + k +
            (corner >> 2);
        };
        if (isSurface)
        {
          const vtkIdType triangles[2][3] = { { at(0), at(1), at(3) }, { at(0), at(3), at(2) } };
          cells.push_back({ triangles[0][0], triangles[0][1], triangles[0][2] });
          cells.push_back({ triangles[1][0], triangles[1][1], triangles[1][2] });
          continue;
        }
        // Around the diagonal from vertex 0 to vertex 7.
        constexpr int Around[7] = { 1, 3, 2, 6, 4, 5, 1 };
        for (int t = 0; t < 6; ++t)
        {
          cells.push_back({ at(0), at(Around[t]), at(Around[t + 1]), at(7) });
        }
      }
    }
  }
  std::shuffle(cells.begin(), cells.end(), std::mt19937(3));
  for (const std::vector<vtkIdType>& cell : cells)
  {
    grid->InsertNextCell(
      isSurface ? VTK_TRIANGLE : VTK_TETRA, static_cast<vtkIdType>(cell.size()), cell.data());
  }
  return grid;
}

//------------------------------------------------------------------------------
/// The peak of memory while a piece was read.
std::size_t MeasureReading(
  const std::string& path, int piece, int pieces, int ghostLevels, vtkIdType& cells)
{
  const AllocationMeter meter;
  const vtkSmartPointer<vtkMeshFileReader> reader = MakeReader();
  reader->SetFileName(path.c_str());
  reader->UpdatePiece(piece, pieces, ghostLevels);
  cells = vtkUnstructuredGrid::SafeDownCast(reader->GetOutputDataObject(0))->GetNumberOfCells();
  return meter.GetPeak();
}
}

//------------------------------------------------------------------------------
// If this fails, a process needs memory for the whole mesh to read its piece, or has ghosts
// everywhere, so many processes cannot read a mesh that is too large for one machine.
TEST(Pieces, NeedMemoryForTheirShareOnly)
{
  const vtkSmartPointer<vtkMeshFileWriter> writer = MakeWriter();
  if (!writer || !AllocationMeter::IsAvailable() || !MapsFiles)
  {
    GTEST_SKIP() << "there is no writer, or no way to measure";
  }
  const std::string name = GetFormat().Name;
  const Folder folder;
  const std::string path = (folder.GetPath() / ("mesh." + GetFormat().Extensions[0])).string();
  writer->SetController(nullptr);
  writer->SetInputData(MakeBar(name == "PolygonOFF" || name == "PolygonPLY" || name == "TRI"));
  writer->SetFileName(path.c_str());
  ASSERT_TRUE(writer->Write());

  constexpr int NumberOfPieces = 8;
  vtkIdType wholeCells = 0;
  MeasureReading(path, 0, 1, 0, wholeCells); // one-time initialization
  const std::size_t whole = MeasureReading(path, 0, 1, 0, wholeCells);
  for (const int ghostLevels : { 0, 1 })
  {
    for (const int piece : { 0, 4, NumberOfPieces - 1 })
    {
      vtkIdType cells = 0;
      const std::size_t peak = MeasureReading(path, piece, NumberOfPieces, ghostLevels, cells);
      EXPECT_LT(cells, wholeCells / 4);
      EXPECT_LT(peak, whole / 2) << "piece " << piece << ", ghost levels " << ghostLevels;
    }
  }
}
