// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Opening and saving Visf files, beside the same meshes as raw .vtu files in the same run. Files
// are in the system's cache. Memory is the peak that the process has to itself, without mapped
// files. Usage: BenchmarkVisf [million tetrahedra [million polyhedra]]
#include "BenchmarkCost.h"
#include "BenchmarkMeshes.h"
#include "TemporaryFolder.h"

#include "vtkVisfReader.h"
#include "vtkVisfWriter.h"

#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkXMLUnstructuredGridReader.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

using camaron::MapAndTouch;
using camaron::Measure;
using camaron::Measurement;
using camaron::Ours;
using camaron::Record;

namespace
{
constexpr double Mega = 1e6;

//------------------------------------------------------------------------------
void Print(const char* what, vtkIdType cells, const std::string& path, const Measurement& cost)
{
  const double bytes = static_cast<double>(std::filesystem::file_size(path));
  std::printf(
    "  %-28s %7.1f MB  %7.3f s  processor %7.3f s  %8.1f ns/cell  %8.1f MB/s  peak %7.1f MB\n",
    what, bytes / Mega, cost.Wall, cost.Processor, 1e9 * cost.Wall / cells,
    bytes / Mega / cost.Wall, cost.Peak / Mega);
  std::fflush(stdout);
}

//------------------------------------------------------------------------------
void OpenAndSave(const char* kind, vtkUnstructuredGrid* mesh)
{
  const vtkIdType cells = mesh->GetNumberOfCells();
  const camaron::TemporaryFolder folder;
  const std::string binary = (folder.Path / "binary.visf").string();
  const std::string text = (folder.Path / "text.visf").string();
  const std::string vtu = (folder.Path / "raw.vtu").string();
  std::printf("%lld %s\n", static_cast<long long>(cells), kind);

  const auto write = [&](const std::string& path, int encoding)
  {
    vtkNew<vtkVisfWriter> writer;
    writer->SetInputData(mesh);
    writer->SetFileName(path.c_str());
    writer->SetEncoding(encoding);
    writer->Write();
  };
  Measurement cost = Measure([&] { write(binary, vtkVisfWriter::BINARY_LITTLE_ENDIAN); });
  Print("save Visf, binary", cells, binary, cost);
  cost = Measure([&] { write(text, vtkVisfWriter::ASCII); });
  Print("save Visf, text", cells, text, cost);

  unsigned long gridSize = 0;
  for (const std::string& path : { binary, text })
  {
    cost = Measure(
      [&]
      {
        vtkNew<vtkVisfReader> reader;
        reader->SetFileName(path.c_str());
        reader->Update();
        gridSize = reader->GetOutput()->GetActualMemorySize();
      });
    Print(path == binary ? "open Visf, binary" : "open Visf, text", cells, path, cost);
    if (path == binary)
    {
      Record("open a binary Visf file", kind, Ours, cells, cost, gridSize * 1024.);
    }
    std::printf("    peak of memory: %.2f grids; %.1f MB/s of processor time\n",
      cost.Peak / (gridSize * 1024.),
      static_cast<double>(std::filesystem::file_size(path)) / Mega / cost.Processor);
    Print("  map and touch", cells, path, Measure([&] { MapAndTouch(path, gridSize * 1024.); }));
  }
  std::printf("  the grid itself: %.1f MB, %.0f bytes per cell\n", gridSize * 1024. / Mega,
    gridSize * 1024. / cells);
  for (const std::string& path : { binary, text })
  {
    constexpr int Pieces = 4;
    cost = Measure(
      [&]
      {
        vtkNew<vtkVisfReader> reader;
        reader->SetFileName(path.c_str());
        reader->UpdatePiece(0, Pieces, 0);
        gridSize = reader->GetOutput()->GetActualMemorySize();
      });
    Print(
      path == binary ? "first of 4 pieces, binary" : "first of 4 pieces, text", cells, path, cost);
    std::printf("    peak of memory: %.2f times the piece\n", cost.Peak / (gridSize * 1024.));
  }

  vtkNew<vtkXMLUnstructuredGridWriter> vtuWriter;
  vtuWriter->SetInputData(mesh);
  vtuWriter->SetFileName(vtu.c_str());
  vtuWriter->SetDataModeToAppended();
  vtuWriter->EncodeAppendedDataOff();
  vtuWriter->SetCompressorTypeToNone();
  vtuWriter->Write();
  cost = Measure(
    [&]
    {
      vtkNew<vtkXMLUnstructuredGridReader> reader;
      reader->SetFileName(vtu.c_str());
      reader->Update();
      gridSize = reader->GetOutput()->GetActualMemorySize();
    });
  Print("open raw .vtu", cells, vtu, cost);
  Record("open a binary Visf file", kind, "vtkXMLUnstructuredGridReader, raw .vtu", cells, cost,
    gridSize * 1024.);
  std::printf("  the grid itself: %.1f MB, %.0f bytes per cell\n", gridSize * 1024. / Mega,
    gridSize * 1024. / cells);
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const double tetrahedra = argc > 1 ? std::atof(argv[1]) : 3.5;
  const double polyhedra = argc > 2 ? std::atof(argv[2]) : 1;
  std::printf("threads %d, SMP backend %s\n", vtkSMPTools::GetEstimatedNumberOfThreads(),
    vtkSMPTools::GetBackend());
  if (tetrahedra > 0)
  {
    OpenAndSave("tetrahedra", camaron::MakeTetrahedra(static_cast<vtkIdType>(tetrahedra * Mega)));
  }
  if (polyhedra > 0)
  {
    OpenAndSave(
      "polyhedra", camaron::MakeTruncatedOctahedra(static_cast<vtkIdType>(polyhedra * Mega)));
  }
  return 0;
}
