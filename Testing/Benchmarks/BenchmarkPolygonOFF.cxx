// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Opening and saving OFF files of triangles, beside VTK's own reader of the same file in the same
// run. Usage: BenchmarkPolygonOFF [million triangles]
#include "BenchmarkCost.h"
#include "TemporaryFolder.h"

#include "vtkPolygonOFFReader.h"
#include "vtkPolygonOFFWriter.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkNew.h"
#include "vtkOFFReader.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

using camaron::MapAndTouch;
using camaron::Measure;
using camaron::Measurement;
namespace fs = std::filesystem;

namespace
{
constexpr double Mega = 1e6;

//------------------------------------------------------------------------------
void Print(const char* what, const fs::path& path, const Measurement& cost, double mesh = 0)
{
  const double bytes = static_cast<double>(fs::file_size(path));
  std::printf("%-34s %8.1f %8.3f %10.3f %9.0f %9.1f", what, bytes / Mega, cost.Wall, cost.Processor,
    bytes / Mega / cost.Processor, cost.Peak / Mega);
  if (mesh > 0)
  {
    std::printf(" %9.1f %9.2f", mesh / Mega, cost.Peak / mesh);
  }
  std::printf("\n");
  std::fflush(stdout);
}

//------------------------------------------------------------------------------
// Hills over a lattice, with coordinates of six digits as most files have.
void MakeSurface(vtkIdType triangles, vtkUnstructuredGrid* grid)
{
  const auto size = static_cast<vtkIdType>(std::sqrt(static_cast<double>(triangles) / 2));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto round = [](double x) { return std::round(x * Mega) / Mega; };
  for (vtkIdType y = 0; y <= size; ++y)
  {
    for (vtkIdType x = 0; x <= size; ++x)
    {
      points->InsertNextPoint(
        round(x / 77.), round(y / 55.), round(std::sin(x / 100.) * std::cos(y / 80.)));
    }
  }
  vtkNew<vtkCellArray> cells;
  for (vtkIdType y = 0; y < size; ++y)
  {
    for (vtkIdType x = 0; x < size; ++x)
    {
      const vtkIdType a = x + (size + 1) * y, b = a + size + 1;
      cells->InsertNextCell({ a, a + 1, b });
      cells->InsertNextCell({ a + 1, b + 1, b });
    }
  }
  grid->SetPoints(points);
  grid->SetCells(VTK_TRIANGLE, cells);
}

//------------------------------------------------------------------------------
template <typename Reader>
void Open(const char* what, const fs::path& path, const char* by = camaron::Ours)
{
  double mesh = 0, cells = 0;
  const Measurement cost = Measure(
    [&]
    {
      vtkNew<Reader> reader;
      reader->SetFileName(path.string().c_str());
      reader->Update();
      constexpr double Kilobyte = 1024;
      mesh = Kilobyte * static_cast<double>(reader->GetOutput()->GetActualMemorySize());
      cells = static_cast<double>(reader->GetOutput()->GetNumberOfCells());
    });
  Print(what, path, cost, mesh);
  camaron::Record(
    "open a file", "triangles, " + path.stem().string() + " OFF", by, cells, cost, mesh);
  Print("  map and touch", path, Measure([&] { MapAndTouch(path, mesh); }), mesh);
}

//------------------------------------------------------------------------------
void Save(const char* what, vtkUnstructuredGrid* grid, const fs::path& path, int encoding)
{
  const Measurement cost = Measure(
    [&]
    {
      vtkNew<vtkPolygonOFFWriter> writer;
      writer->SetInputData(grid);
      writer->SetFileName(path.string().c_str());
      writer->SetEncoding(encoding);
      writer->Write();
    });
  Print(what, path, cost);
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const double triangles = argc > 1 ? std::atof(argv[1]) : 1.65;
  std::printf("threads %d, SMP backend %s\n", vtkSMPTools::GetEstimatedNumberOfThreads(),
    vtkSMPTools::GetBackend());
  vtkNew<vtkUnstructuredGrid> grid;
  MakeSurface(static_cast<vtkIdType>(triangles * Mega), grid);
  std::printf("%lld triangles\n", static_cast<long long>(grid->GetNumberOfCells()));
  std::printf("%-34s %8s %8s %10s %9s %9s %9s %9s\n", "", "MB", "wall s", "core s", "MB/core s",
    "peak MB", "mesh MB", "peak/mesh");
  const camaron::TemporaryFolder temporary;
  const fs::path folder = temporary.Path;
  const fs::path text = folder / "text.off", binary = folder / "binary.off";
  Save("save OFF, text", grid, text, vtkPolygonOFFWriter::ASCII);
  Save("save OFF, binary", grid, binary, vtkPolygonOFFWriter::BINARY);
  grid->Initialize();
  Open<vtkPolygonOFFReader>("open OFF, text", text);
  Open<vtkPolygonOFFReader>("open OFF, binary", binary);
  Open<vtkOFFReader>("open OFF, text, vtkOFFReader", text, "vtkOFFReader");
  return 0;
}
