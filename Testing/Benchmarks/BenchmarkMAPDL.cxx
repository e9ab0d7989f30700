// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Opening and saving decks of Mechanical APDL, in the folder for temporary files, which are in the
// system's cache. Memory is the peak of the process without mapped files, compared with the grid.
// Usage: BenchmarkMAPDL [million elements]
#include "BenchmarkCost.h"
#include "BenchmarkMeshes.h"
#include "TemporaryFolder.h"

#include "MAPDLReading.h"
#include "vtkMAPDLWriter.h"

#include "vtkCellType.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>

using namespace camaron;

namespace
{
constexpr double Mega = 1e6;

//------------------------------------------------------------------------------
// A cube of jittered hexahedra.
vtkSmartPointer<vtkUnstructuredGrid> MakeHexahedra(vtkIdType numberOfCells)
{
  const auto n = static_cast<vtkIdType>(std::cbrt(static_cast<double>(numberOfCells)) + 0.5);
  const vtkIdType m = n + 1;
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(m * m * m);
  vtkNew<vtkMinimalStandardRandomSequence> random;
  const auto next = [&random]
  {
    random->Next();
    return 0.1 * random->GetValue();
  };
  for (vtkIdType i = 0; i < m * m * m; ++i)
  {
    points->SetPoint(i, i % m + next(), i / m % m + next(), i / (m * m) + next());
  }
  grid->SetPoints(points);
  grid->Allocate(n * n * n);
  for (vtkIdType i = 0; i < n * n * n; ++i)
  {
    const vtkIdType a = i % n + m * (i / n % n) + m * m * (i / (n * n)), b = a + m * m;
    const vtkIdType ids[] = { a, a + 1, a + m + 1, a + m, b, b + 1, b + m + 1, b + m };
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
  }
  return grid;
}

//------------------------------------------------------------------------------
Measurement MeasureAndPrint(
  const char* what, const std::string& path, const std::function<void()>& work)
{
  const Measurement cost = Measure(work);
  const double megabytes = static_cast<double>(std::filesystem::file_size(path)) / Mega;
  std::printf("  %-6s %8.1f MB  %7.3f s  %8.1f MB/s  processor %7.3f s, %8.1f MB/s per core\n",
    what, megabytes, cost.Wall, megabytes / cost.Wall, cost.Processor, megabytes / cost.Processor);
  std::fflush(stdout);
  return cost;
}

//------------------------------------------------------------------------------
void OpenAndSave(const char* kind, vtkUnstructuredGrid* mesh)
{
  const TemporaryFolder folder;
  const std::string path = (folder.Path / "mesh.cdb").string();
  std::printf("%lld %s\n", static_cast<long long>(mesh->GetNumberOfCells()), kind);
  MeasureAndPrint("save", path,
    [&]
    {
      vtkNew<vtkMAPDLWriter> writer;
      writer->SetInputData(mesh);
      writer->SetFileName(path.c_str());
      if (!writer->Write())
      {
        std::exit(1); // with a message
      }
    });
  vtkNew<vtkUnstructuredGrid> grid;
  const auto open = [&]
  {
    Warnings warnings;
    ScanError error;
    if (!ReadMAPDL(path, {}, {}, grid, warnings, error) ||
      grid->GetNumberOfCells() != mesh->GetNumberOfCells())
    {
      std::printf("%s\n", error.Message.c_str());
      std::exit(1);
    }
  };
  const double peak = MeasureAndPrint("open", path, open).Peak;
  const double size = 1024. * static_cast<double>(grid->GetActualMemorySize());
  std::printf("  memory: the grid %.1f MB, peak %.1f MB, %.2f times\n", size / Mega, peak / Mega,
    peak / size);
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const auto cells = static_cast<vtkIdType>(Mega * (argc > 1 ? std::atof(argv[1]) : 1));
  std::printf("%d threads\n", vtkSMPTools::GetEstimatedNumberOfThreads());
  OpenAndSave("hexahedra", MakeHexahedra(cells));
  OpenAndSave("tetrahedra, shuffled", MakeTetrahedra(cells));
  return 0;
}
