// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Two threads beside one, and many polyhedra beside 1 % of them: parsing a text file, finding faces
// and evaluating; and what memory and files of this machine allow. Usage: BenchmarkScaling [million
// polyhedra]
#include "BenchmarkCost.h"
#include "BenchmarkMeshes.h"
#include "TemporaryFolder.h"

#include "Mesh/MeshTopology.h"
#include "vtkElementQuality.h"
#include "vtkVisfReader.h"
#include "vtkVisfWriter.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

using camaron::Measure;
using camaron::Measurement;
using camaron::Ours;
using camaron::Record;
using camaron::TemporaryFolder;
namespace fs = std::filesystem;

namespace
{
struct Work
{
  const char* Name;
  std::function<void()> Do;
};

//------------------------------------------------------------------------------
std::vector<Work> MakeWorks(const std::string& file, vtkUnstructuredGrid* grid)
{
  const auto touch = [grid] { grid->GetCells()->GetConnectivityArray()->Modified(); };
  return { { "open a text Visf file",
             [=]
             {
               vtkNew<vtkVisfReader> reader;
               reader->SetFileName(file.c_str());
               reader->Update();
             } },
    { "find faces",
      [=]
      {
        touch();
        camaron::MeshTopology(grid).GetFaces();
      } },
    { "evaluate General", [=]
      {
        touch();
        vtkNew<vtkElementQuality> quality;
        quality->SetInputData(grid);
        quality->SetPreset("General");
        quality->Update();
      } } };
}

//------------------------------------------------------------------------------
Measurement MeasureOn(int threads, const std::function<void()>& work)
{
  Measurement cost;
  vtkSMPTools::LocalScope(vtkSMPTools::Config(threads), [&] { cost = Measure(work); });
  return cost;
}

//------------------------------------------------------------------------------
void OnThreadsAndSizes(vtkIdType size, const fs::path& folder)
{
  const auto large = camaron::MakeTruncatedOctahedra(size);
  const auto small = camaron::MakeTruncatedOctahedra(size / 100);
  const auto save = [&](vtkUnstructuredGrid* grid, const char* name)
  {
    const std::string path = (folder / name).string();
    vtkNew<vtkVisfWriter> writer;
    writer->SetInputData(grid);
    writer->SetFileName(path.c_str());
    writer->SetEncoding(vtkVisfWriter::ASCII);
    writer->Write();
    return path;
  };
  const std::vector<Work> works = MakeWorks(save(large, "large.visf"), large);
  const std::vector<Work> smallWorks = MakeWorks(save(small, "small.visf"), small);
  for (std::size_t i = 0; i < works.size(); ++i)
  {
    const std::string name = works[i].Name;
    const double cells = static_cast<double>(large->GetNumberOfCells());
    const double fewer = static_cast<double>(small->GetNumberOfCells());
    const Measurement two = MeasureOn(2, works[i].Do), one = MeasureOn(1, works[i].Do);
    const Measurement less = MeasureOn(1, smallWorks[i].Do);
    Record(name + ", 2 threads", "polyhedra", Ours, cells, two);
    Record(name + ", 2 threads", "polyhedra", "1 thread", cells, one);
    Record(name + ", 1 thread", "polyhedra", Ours, cells, one);
    Record(name + ", 1 thread", "polyhedra", "1 % of the cells", fewer, less);
    std::printf("%-22s %8.0f cells, 2 threads %7.3f s, 1 thread %7.3f s, %.2f times as long, peak "
                "%5.0f bytes/cell; %6.0f cells %7.3f s, %.2f times as long per cell, peak %5.0f "
                "bytes/cell\n",
      name.c_str(), cells, two.Wall, one.Wall, one.Wall / two.Wall, one.Peak / cells, fewer,
      less.Wall, less.Wall / fewer * cells / one.Wall, less.Peak / fewer);
    std::fflush(stdout);
  }
}

//------------------------------------------------------------------------------
// Compilers leave out what writes to memory that nobody sees.
void Keep(const void* memory)
{
  asm volatile("" : : "g"(memory) : "memory");
}

//------------------------------------------------------------------------------
// Bytes are recorded as cells.
void OnMachine(const fs::path& folder)
{
  constexpr std::size_t Size = std::size_t(1) << 28;
  std::vector<char> from(Size, 1), to(Size, 2);
  const fs::path path = folder / "bytes";
  std::ofstream(path, std::ios::binary).write(from.data(), Size);
  std::ptrdiff_t ones = 0;
  const Work works[] = { { "copy memory", [&] { std::memcpy(to.data(), from.data(), Size); } },
    { "write to new memory", [] { Keep(std::vector<char>(Size, 1).data()); } },
    { "write to new memory, huge pages", [] { Keep(camaron::LargeVector<char>(Size, 1).data()); } },
    { "read a mapped file", [&]
      {
        camaron::MappedFile file;
        camaron::ScanError error;
        file.Open(path.string(), error);
        ones = std::count(file.begin(), file.begin() + file.size(), char(1));
      } } };
  for (const Work& work : works)
  {
    const Measurement cost = Measure(work.Do);
    Record(work.Name, "machine", "machine", Size, cost);
    std::printf("%-32s %6.1f GB/s\n", work.Name, 1e-9 * Size / cost.Wall);
  }
  std::printf("%s bytes\n", ones == static_cast<std::ptrdiff_t>(Size) ? "all" : "not all");
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const double million = argc > 1 ? std::atof(argv[1]) : 1;
  const TemporaryFolder folder;
  OnMachine(folder.Path);
  OnThreadsAndSizes(static_cast<vtkIdType>(1e6 * million), folder.Path);
  return 0;
}
