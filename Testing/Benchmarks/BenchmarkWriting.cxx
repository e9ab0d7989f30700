// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What writers have in common: cells made to fit a format, and text. Files are written to the
// folder for temporary files. Usage: BenchmarkWriting [million cells]
#include "BenchmarkCost.h"
#include "BenchmarkMeshes.h"
#include "TemporaryFolder.h"

#include "Intake/CellMesh/CellConversion.h"
#include "Intake/CellMesh/OutputMesh.h"
#include "Intake/Write/RealFormat.h"
#include "Intake/Write/WriteRows.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

using namespace camaron;

namespace
{
//------------------------------------------------------------------------------
void MeasureConversion(
  const char* what, vtkUnstructuredGrid* grid, const CellTypeSet& held, SurfaceFaces surface)
{
  vtkIdType made = 0;
  const Measurement cost = Measure(
    [&]
    {
      CellConversion how{ "Foo", held };
      how.Others = UnsupportedCells::Convert;
      how.Surface = surface;
      OutputMesh output;
      Warnings warnings;
      ScanError error;
      ConvertCells(grid, how, "mesh.foo", output, warnings, error);
      made = output.GetNumberOfCells();
    });
  const double cells = static_cast<double>(grid->GetNumberOfCells());
  std::printf("%-44s %10lld %10lld %9.3f %9.0f\n", what,
    static_cast<long long>(grid->GetNumberOfCells()), static_cast<long long>(made), cost.Wall,
    1e9 * cost.Processor / cells);
}

//------------------------------------------------------------------------------
void MeasureText(const char* what, const OutputMesh& mesh, const RealFormat& format)
{
  const TemporaryFolder folder;
  const std::string path = (folder.Path / "points.txt").string();
  const Measurement cost = Measure(
    [&]
    {
      OutputFile file(path);
      WriteRows(file, mesh.GetNumberOfPoints(), Progress(),
        [&](vtkIdType point, std::string& text)
        {
          double x[3];
          mesh.GetPoint(point, x);
          format.AppendRow(text, x, 3);
        });
      file.Commit();
    });
  const double megabytes = 1e-6 * static_cast<double>(std::filesystem::file_size(path));
  std::printf(
    "%-44s %10.0f %20.3f %9.0f\n", what, megabytes, cost.Wall, megabytes / cost.Processor);
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const double million = argc > 1 ? std::atof(argv[1]) : 1;
  const auto count = static_cast<vtkIdType>(1e6 * million);
  std::printf("threads: %d, backend: %s\n\n", vtkSMPTools::GetEstimatedNumberOfThreads(),
    vtkSMPTools::GetBackend());

  const auto tetrahedra = MakeTetrahedra(count);
  const auto polyhedra = MakeTruncatedOctahedra(std::max<vtkIdType>(1, count / 10));
  std::printf("%-44s %10s %10s %9s %9s\n", "conversion", "cells", "become", "wall s", "ns/cell*");
  MeasureConversion("tetrahedra, as they are", tetrahedra, { VTK_TETRA }, SurfaceFaces::None);
  MeasureConversion(
    "truncated octahedra to tetrahedra", polyhedra, { VTK_TETRA }, SurfaceFaces::None);
  MeasureConversion("truncated octahedra, triangles of all faces", polyhedra, { VTK_TRIANGLE },
    SurfaceFaces::Every);
  MeasureConversion("truncated octahedra, boundary polygons", polyhedra,
    { VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON }, SurfaceFaces::Boundary);

  const OutputMesh mesh(tetrahedra);
  std::printf("\n%-44s %10s %20s %9s\n", "coordinates as text", "MB", "wall s", "MB/s*");
  MeasureText("shortest, double", mesh, RealFormat::Shortest());
  MeasureText("shortest, float", mesh, RealFormat::Shortest(true));
  MeasureText("9 digits", mesh, RealFormat::Significant(9));
  MeasureText("17 digits", mesh, RealFormat::Significant(17));
  MeasureText("fields of 21 columns", mesh, RealFormat::Field(21, 13, 3));
  std::printf("\n* of processor time, all threads together\n");
  return 0;
}
