// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Opening and saving M3D and TS files. Files are in the system's cache.
// Usage: BenchmarkM3DAndTS [million cells]
#include "BenchmarkCost.h"
#include "BenchmarkMeshes.h"
#include "TemporaryFolder.h"

#include "vtkM3DReader.h"
#include "vtkM3DWriter.h"
#include "vtkTSReader.h"
#include "vtkTSWriter.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <random>

namespace fs = std::filesystem;

namespace
{
constexpr double Mega = 1e6;

using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

//------------------------------------------------------------------------------
void Print(const char* what, const fs::path& path, const camaron::Measurement& cost, double grid)
{
  const double bytes = static_cast<double>(fs::file_size(path));
  std::printf("%-34s %8.1f %8.3f %10.3f %9.0f %9.1f", what, bytes / Mega, cost.Wall, cost.Processor,
    bytes / Mega / cost.Processor, cost.Peak / Mega);
  if (grid > 0)
  {
    std::printf(" %9.1f %9.2f", grid / Mega, cost.Peak / grid);
  }
  std::printf("\n");
  std::fflush(stdout);
}

//------------------------------------------------------------------------------
template <typename Reader>
void Open(const char* what, const fs::path& path, int pieces = 1)
{
  double grid = 0;
  const camaron::Measurement cost = camaron::Measure(
    [&]
    {
      vtkNew<Reader> reader;
      reader->SetFileName(path.c_str());
      reader->UpdatePiece(0, pieces, 0);
      constexpr double Kilobyte = 1024;
      grid = Kilobyte * static_cast<double>(reader->GetOutput()->GetActualMemorySize());
    });
  Print(what, path, cost, grid);
}

//------------------------------------------------------------------------------
template <typename Writer>
void Save(
  const char* what, const fs::path& path, vtkUnstructuredGrid* mesh,
  const std::function<void(Writer*)>& choose = [](Writer*) {})
{
  const camaron::Measurement cost = camaron::Measure(
    [&]
    {
      vtkNew<Writer> writer;
      writer->SetInputData(mesh);
      writer->SetFileName(path.c_str());
      choose(writer);
      writer->Write();
    });
  Print(what, path, cost, 0);
}

//------------------------------------------------------------------------------
// Points of a lattice with some noise, as no digits come for free.
vtkSmartPointer<vtkPoints> MakePoints(int x, int y, int z)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<> noise(-0.1, 0.1);
  auto points = vtkSmartPointer<vtkPoints>::New(VTK_DOUBLE);
  for (int k = 0; k < z; ++k)
  {
    for (int j = 0; j < y; ++j)
    {
      for (int i = 0; i < x; ++i)
      {
        points->InsertNextPoint(i + noise(random), j + noise(random), k + noise(random));
      }
    }
  }
  return points;
}

//------------------------------------------------------------------------------
// Boxes, every other one cut into two prisms.
Grid MakeBoxesAndPrisms(vtkIdType cells)
{
  const int size = std::max(1, static_cast<int>(std::cbrt(2 * static_cast<double>(cells) / 3)));
  const vtkIdType row = size + 1, layer = row * row;
  auto grid = Grid::New();
  grid->SetPoints(MakePoints(size + 1, size + 1, size + 1));
  grid->Allocate(cells);
  for (int box = 0; box < size * size * size; ++box)
  {
    const vtkIdType a = box % size + row * (box / size % size) + layer * (box / (size * size));
    const vtkIdType p[] = { a, a + 1, a + 1 + row, a + row, a + layer, a + 1 + layer,
      a + 1 + row + layer, a + row + layer };
    if (box % 2 == 0)
    {
      grid->InsertNextCell(VTK_HEXAHEDRON, 8, p);
      continue;
    }
    const vtkIdType first[] = { p[0], p[2], p[1], p[4], p[6], p[5] };
    const vtkIdType second[] = { p[0], p[3], p[2], p[4], p[7], p[6] };
    grid->InsertNextCell(VTK_WEDGE, 6, first);
    grid->InsertNextCell(VTK_WEDGE, 6, second);
  }
  return grid;
}

//------------------------------------------------------------------------------
// A surface with a property.
Grid MakeSurface(vtkIdType cells)
{
  const int size = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(cells) / 2)));
  auto grid = Grid::New();
  grid->SetPoints(MakePoints(size + 1, size + 1, 1));
  grid->Allocate(cells);
  for (int square = 0; square < size * size; ++square)
  {
    const vtkIdType a = square % size + (size + 1) * (square / size), b = a + size + 1;
    const vtkIdType first[] = { a, a + 1, b + 1 }, second[] = { a, b + 1, b };
    grid->InsertNextCell(VTK_TRIANGLE, 3, first);
    grid->InsertNextCell(VTK_TRIANGLE, 3, second);
  }
  vtkNew<vtkDoubleArray> depth;
  depth->SetName("Depth");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    depth->InsertNextValue(-1000 * grid->GetPoint(i)[2]);
  }
  grid->GetPointData()->AddArray(depth);
  return grid;
}

//------------------------------------------------------------------------------
void AddMaterials(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDoubleArray> materials;
  materials->SetName("Material");
  materials->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    materials->InsertNextTuple3(1000 + static_cast<double>(i % 10), 0.45, 1);
  }
  grid->GetCellData()->AddArray(materials);
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const auto cells = static_cast<vtkIdType>((argc > 1 ? std::atof(argv[1]) : 1) * Mega);
  const camaron::TemporaryFolder temporary;
  const fs::path folder = temporary.Path;
  std::printf("threads %d, SMP backend %s\n", vtkSMPTools::GetEstimatedNumberOfThreads(),
    vtkSMPTools::GetBackend());
  std::printf("%-34s %8s %8s %10s %9s %9s %9s %9s\n", "", "MB", "wall s", "processor", "MB/s*",
    "peak MB", "grid MB", "peak/grid");

  const Grid mixed = MakeBoxesAndPrisms(cells);
  Save<vtkM3DWriter>("save M3D, boxes and prisms", folder / "mixed.m3d", mixed);
  Open<vtkM3DReader>("open it", folder / "mixed.m3d");
  Open<vtkM3DReader>("open the first of 4 pieces", folder / "mixed.m3d", 4);
  AddMaterials(mixed);
  Save<vtkM3DWriter>("save with materials", folder / "materials.m3d", mixed);
  Open<vtkM3DReader>("open it", folder / "materials.m3d");

  Save<vtkTSWriter>(
    "save TS, tetrahedra", folder / "tetrahedra.ts", camaron::MakeTetrahedra(cells));
  Open<vtkTSReader>("open it", folder / "tetrahedra.ts");
  Open<vtkTSReader>("open the first of 4 pieces", folder / "tetrahedra.ts", 4);

  Save<vtkTSWriter>("save TSurf, a property", folder / "surface.ts", MakeSurface(cells),
    [](vtkTSWriter* writer) { writer->SetDialect(vtkTSWriter::GOCAD); });
  Open<vtkTSReader>("open it", folder / "surface.ts");
  Open<vtkTSReader>("open the first of 4 pieces", folder / "surface.ts", 4);
  std::printf("\n* of processor time, all threads together\n");
  return 0;
}
