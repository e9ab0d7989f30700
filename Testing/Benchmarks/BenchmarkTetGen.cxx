// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Opening and saving files of TetGen. Files are in the system's cache; sizes are of all files that
// are read or written. Usage: BenchmarkTetGen [million tetrahedra]
#include "BenchmarkCost.h"
#include "BenchmarkMeshes.h"
#include "TemporaryFolder.h"

#include "vtkTetGenReader.h"
#include "vtkTetGenWriter.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>

namespace fs = std::filesystem;

namespace
{
constexpr double Mega = 1e6;

//------------------------------------------------------------------------------
void Print(const char* what, double bytes, const camaron::Measurement& cost, double grid)
{
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
double GetSize(const fs::path& base, std::initializer_list<const char*> extensions)
{
  double bytes = 0;
  for (const char* extension : extensions)
  {
    bytes += static_cast<double>(fs::file_size(base.string() + extension));
  }
  return bytes;
}

//------------------------------------------------------------------------------
void Open(const char* what, const fs::path& base, std::initializer_list<const char*> extensions,
  int pieces = 1)
{
  double grid = 0;
  const camaron::Measurement cost = camaron::Measure(
    [&]
    {
      vtkNew<vtkTetGenReader> reader;
      reader->SetFileName((base.string() + *extensions.begin()).c_str());
      reader->UpdatePiece(0, pieces, 0);
      constexpr double Kilobyte = 1024;
      grid = Kilobyte * static_cast<double>(reader->GetOutput()->GetActualMemorySize());
    });
  Print(what, GetSize(base, extensions), cost, grid);
}

//------------------------------------------------------------------------------
// One side of every tetrahedron as a face, and as a facet in both formats of these.
void MakeFacets(vtkUnstructuredGrid* mesh, const fs::path& base)
{
  std::string face, poly, smesh;
  const std::string count = std::to_string(mesh->GetNumberOfCells());
  face = count + " 1\n";
  poly = smesh = "0 3 0 0\n" + count + " 1\n";
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    const std::string corners = std::to_string(ids->GetId(0)) + "  " +
      std::to_string(ids->GetId(1)) + "  " + std::to_string(ids->GetId(2));
    face += std::to_string(cell) + "  " + corners + "  1\n";
    poly += "1  0  1\n3  " + corners + "\n";
    smesh += "3  " + corners + "  1\n";
  }
  std::ofstream(base.string() + ".face") << face;
  std::ofstream(base.string() + ".poly") << poly << "0\n0\n";
  std::ofstream(base.string() + ".smesh") << smesh << "0\n0\n";
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const double million = argc > 1 ? std::atof(argv[1]) : 1;
  const auto mesh = camaron::MakeTetrahedra(static_cast<vtkIdType>(million * Mega));
  // Coordinates with all digits, as TetGen writes.
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    const double* const x = mesh->GetPoint(point);
    points->SetPoint(point, x[0] / 3, x[1] / 3, x[2] / 3);
  }
  mesh->SetPoints(points);
  vtkNew<vtkIntArray> regions;
  regions->SetName("Region");
  regions->SetNumberOfTuples(mesh->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    constexpr int NumberOfRegions = 20;
    regions->SetValue(cell, static_cast<int>(cell % NumberOfRegions));
  }
  const camaron::TemporaryFolder temporary;
  const fs::path folder = temporary.Path;
  const fs::path plain = folder / "plain", attributes = folder / "attributes";
  std::printf("%lld tetrahedra, threads %d, SMP backend %s\n",
    static_cast<long long>(mesh->GetNumberOfCells()), vtkSMPTools::GetEstimatedNumberOfThreads(),
    vtkSMPTools::GetBackend());
  std::printf("%-34s %8s %8s %10s %9s %9s %9s %9s\n", "", "MB", "wall s", "processor", "MB/s*",
    "peak MB", "grid MB", "peak/grid");

  const auto save = [&](const fs::path& base, int firstId)
  {
    vtkNew<vtkTetGenWriter> writer;
    writer->SetInputData(mesh);
    writer->SetFileName((base.string() + ".ele").c_str());
    writer->SetFirstId(firstId);
    writer->Write();
  };
  camaron::Measurement cost = camaron::Measure([&] { save(plain, 0); });
  Print("save .node .ele", GetSize(plain, { ".node", ".ele" }), cost, 0);
  mesh->GetCellData()->AddArray(regions);
  save(attributes, 1);
  fs::create_directory(folder / "cloud");
  fs::copy_file(plain.string() + ".node", folder / "cloud" / "plain.node",
    fs::copy_options::overwrite_existing);

  Open("open .node .ele", plain, { ".ele", ".node" });
  Open("the same, with ids and regions", attributes, { ".ele", ".node" });
  Open("the same, first of 4 pieces", attributes, { ".ele", ".node" }, 4);
  Open("open .node alone", folder / "cloud" / "plain", { ".node" });
  MakeFacets(mesh, plain);
  Open("open .face", plain, { ".face", ".node" });
  Open("open .poly", plain, { ".poly", ".node" });
  Open("open .smesh", plain, { ".smesh", ".node" });
  std::printf("\n* of processor time, all threads together\n");
  return 0;
}
