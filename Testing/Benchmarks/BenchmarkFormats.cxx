// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Opening and saving surfaces, beside VTK's readers of the same files in the same run. Files are in
// the system's cache. A format is a row of the table in MakeRows. Usage: BenchmarkFormats [million
// cells]...; without, 1.65, and 10 for binary files
#include "BenchmarkCost.h"
#include "BenchmarkMeshes.h"
#include "TemporaryFolder.h"

#include "vtkPolygonPLYReader.h"
#include "vtkPolygonPLYWriter.h"
#include "vtkTRIReader.h"
#include "vtkTRIWriter.h"

#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkSMPTools.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

using namespace camaron;

namespace
{
constexpr double Mega = 1e6;

//------------------------------------------------------------------------------
/// What is measured of a format.
struct Row
{
  const char* Name;
  const char* Extension;
  bool IsMixed;  ///< polygons of three and four points, not triangles
  bool IsBinary; ///< worth the time for very large meshes
  std::function<void(vtkUnstructuredGrid*, const std::string&)> Save;
  std::function<double(const std::string&)> Open; ///< returns the bytes of the output
  std::function<double(const std::string&)> Peer; ///< or none
};

//------------------------------------------------------------------------------
template <typename Reader>
double OpenWith(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  constexpr double Kilobyte = 1024;
  return Kilobyte * static_cast<double>(reader->GetOutput()->GetActualMemorySize());
}

//------------------------------------------------------------------------------
template <typename Writer>
std::function<void(vtkUnstructuredGrid*, const std::string&)> SaveWith(
  const std::function<void(Writer*)>& configure = {})
{
  return [configure](vtkUnstructuredGrid* mesh, const std::string& path)
  {
    vtkNew<Writer> writer;
    writer->SetInputData(mesh);
    writer->SetFileName(path.c_str());
    if (configure)
    {
      configure(writer);
    }
    writer->Write();
  };
}

//------------------------------------------------------------------------------
std::vector<Row> MakeRows()
{
  const auto ply = [](int encoding)
  {
    return SaveWith<vtkPolygonPLYWriter>(
      [encoding](vtkPolygonPLYWriter* writer) { writer->SetEncoding(encoding); });
  };
  const auto little = ply(vtkPolygonPLYWriter::BINARY_LITTLE_ENDIAN);
  const auto big = ply(vtkPolygonPLYWriter::BINARY_BIG_ENDIAN);
  const auto text = ply(vtkPolygonPLYWriter::ASCII);
  const auto open = OpenWith<vtkPolygonPLYReader>;
  const auto peer = OpenWith<vtkPLYReader>;
  return {
    { "triangles, binary PLY", ".ply", false, true, little, open, peer },
    { "triangles, big-endian PLY", ".ply", false, true, big, open, peer },
    { "mixed, binary PLY", ".ply", true, true, little, open, peer },
    { "triangles, text PLY", ".ply", false, false, text, open, peer },
    { "mixed, text PLY", ".ply", true, false, text, open, peer },
    { "triangles, TRI", ".tri", false, false, SaveWith<vtkTRIWriter>(), OpenWith<vtkTRIReader>,
      nullptr },
  };
}

//------------------------------------------------------------------------------
void Run(const Row& row, double million)
{
  const auto mesh = MakeSurface(static_cast<vtkIdType>(million * Mega), row.IsMixed);
  const TemporaryFolder folder;
  const std::string path = (folder.Path / (std::string("mesh") + row.Extension)).string();
  const Measurement saving = Measure([&] { row.Save(mesh, path); });
  const double size = static_cast<double>(std::filesystem::file_size(path));
  double grid = 0;
  const Measurement opening = Measure([&] { grid = row.Open(path); });
  const Measurement floor = Measure([&] { camaron::MapAndTouch(path, grid); });
  std::printf("%-26s %9.2f %8.1f %9.3f %9.3f %9.3f %7.0f %9.3f %8.1f %6.2f", row.Name,
    static_cast<double>(mesh->GetNumberOfCells()) / Mega, size / Mega, saving.Wall, opening.Wall,
    opening.Processor, size / Mega / opening.Processor, floor.Wall, grid / Mega,
    opening.Peak / grid);
  const double cells = static_cast<double>(mesh->GetNumberOfCells());
  Record("open a file", row.Name, Ours, cells, opening, grid);
  if (row.Peer)
  {
    const Measurement peer = Measure([&] { grid = row.Peer(path); });
    Record("open a file", row.Name, "vtkPLYReader", cells, peer, grid);
    std::printf(" %9.3f %9.3f %8.1f %7.1f %7.1f", peer.Wall, peer.Processor, peer.Peak / Mega,
      peer.Wall / opening.Wall, peer.Processor / opening.Processor);
  }
  std::printf("\n");
  std::fflush(stdout);
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  std::printf("threads %d, SMP backend %s\n", vtkSMPTools::GetEstimatedNumberOfThreads(),
    vtkSMPTools::GetBackend());
  std::printf("%-26s %9s %8s %9s %9s %9s %7s %9s %8s %6s %9s %9s %8s %7s %7s\n", "", "M cells",
    "MB", "save s", "open s", "processor", "MB/s*", "floor s", "grid MB", "peak", "VTK s",
    "processor", "VTK MB", "times", "times*");
  std::vector<double> sizes;
  for (int i = 1; i < argc; ++i)
  {
    sizes.push_back(std::atof(argv[i]));
  }
  constexpr double Usual = 1.65, Large = 10; // million triangles
  for (const Row& row : MakeRows())
  {
    const std::vector<double> own =
      row.IsBinary ? std::vector<double>{ Usual, Large } : std::vector<double>{ Usual };
    for (const double million : sizes.empty() ? own : sizes)
    {
      Run(row, million);
    }
  }
  std::printf("\n* of processor time, all threads together; floor: mapping the file and touching "
              "as much fresh "
              "memory as the grid has; peak: of memory while opening, in grids\n");
  return 0;
}
