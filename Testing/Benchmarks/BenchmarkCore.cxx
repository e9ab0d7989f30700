// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Topology, boundary and evaluation against VTK's filters on the same meshes in the same run.
// Usage: BenchmarkCore [million tetrahedra [million polyhedra]]
#include "BenchmarkMeshes.h"

#include "Base/Buffer.h"
#include "Base/Parallel.h"
#include "Criteria/Evaluation.h"
#include "Mesh/BoundarySurface.h"
#include "Mesh/MeshTopology.h"

#include "vtkCellArray.h"
#include "vtkCellSizeFilter.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkGeometryFilter.h"
#include "vtkMeshQuality.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace
{
constexpr int Repetitions = 3;

//------------------------------------------------------------------------------
struct Seconds
{
  double Wall;
  double Processor; // of all threads together: what other programs on the machine disturb least
  bool operator<(const Seconds& other) const { return this->Wall < other.Wall; }
};

//------------------------------------------------------------------------------
Seconds Measure(const std::function<void()>& work, int repetitions = Repetitions)
{
  std::vector<Seconds> all;
  for (int i = 0; i < repetitions; ++i)
  {
    const double start = vtkTimerLog::GetUniversalTime();
    const std::clock_t processor = std::clock();
    work();
    all.push_back({ vtkTimerLog::GetUniversalTime() - start,
      static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC });
  }
  std::sort(all.begin(), all.end());
  return all[all.size() / 2];
}

//------------------------------------------------------------------------------
void Print(const std::string& what, vtkIdType cells, const Seconds& seconds,
  const char* peer = nullptr, double peerSecondsPerCell = 0)
{
  std::printf("%-44s %8lld cells %7.3f s %8.1f ns/cell, processor %8.1f", what.c_str(),
    static_cast<long long>(cells), seconds.Wall, 1e9 * seconds.Wall / cells,
    1e9 * seconds.Processor / cells);
  if (peer)
  {
    std::printf("   %s %.1f ns/cell, %.1fx", peer, 1e9 * peerSecondsPerCell,
      peerSecondsPerCell * cells / seconds.Wall);
  }
  std::printf("\n");
  std::fflush(stdout);
}

//------------------------------------------------------------------------------
void EvaluateOn(vtkUnstructuredGrid* grid, const std::vector<std::string>& names)
{
  std::vector<camaron::Buffer<double>> values; // as Element Quality has them
  std::vector<camaron::CriterionValues> rows;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    values.emplace_back(grid->GetNumberOfCells());
    rows.push_back({ camaron::FindCriterion(names[i]), values[i].data() });
  }
  camaron::Evaluate(camaron::MeshTopology(grid), {}, rows, [](double) { return true; });
}

//------------------------------------------------------------------------------
// A new mesh as far as the cache of topologies is concerned.
void Touch(vtkUnstructuredGrid* grid)
{
  grid->GetCells()->GetConnectivityArray()->Modified();
}

//------------------------------------------------------------------------------
template <typename Filter>
double SecondsPerCell(vtkUnstructuredGrid* grid, int repetitions = Repetitions)
{
  return Measure(
           [&]
           {
             vtkNew<Filter> filter;
             filter->SetInputData(grid);
             filter->Update();
           },
           repetitions)
           .Wall /
    static_cast<double>(grid->GetNumberOfCells());
}

const std::vector<std::string> AllOfCells = []
{
  std::vector<std::string> names;
  for (const camaron::Criterion& criterion : camaron::GetCriteria())
  {
    if (criterion.CellFunction &&
      (criterion.AppliesTo & (camaron::Polyhedra | camaron::Tetrahedra)))
    {
      names.push_back(criterion.Name);
    }
  }
  return names;
}();

const std::vector<std::string> FiniteVolume = { "MaxNonOrthogonality", "MaxFaceSkewness",
  "MinFaceWeight", "MinVolumeRatio", "OrthogonalQuality", "CellDeterminant" };

// What Canepa et al. 2016 evaluate on polyhedra.
const std::vector<std::string> Paper = { "Volume", "SurfaceArea", "VertexCount", "FaceCount",
  "EdgeLengthRatio", "MinDihedralAngle", "MaxDihedralAngle", "MinSolidAngle", "MaxSolidAngle" };

// What the specification calls core of tetrahedra by themselves.
const std::vector<std::string> CoreOfTetrahedra = { "Volume", "SurfaceArea", "VertexCount",
  "EdgeCount", "FaceCount", "MinEdgeLength", "MaxEdgeLength", "MeanEdgeLength", "Diameter",
  "MinFaceAngle", "MaxFaceAngle", "MinDihedralAngle", "MaxDihedralAngle", "MinSolidAngle",
  "MaxSolidAngle", "EquiangleSkewness", "EdgeLengthRatio", "IsoperimetricQuotient",
  "TetRadiusEdgeRatio", "TetRadiusRatio", "TetMeanRatio" };

// Criteria that users evaluate for polyhedra.
const std::vector<std::string> Core = { "Volume", "SurfaceArea", "VertexCount", "EdgeCount",
  "FaceCount", "MinEdgeLength", "MaxEdgeLength", "MeanEdgeLength", "Diameter", "MinFaceAngle",
  "MaxFaceAngle", "MinDihedralAngle", "MaxDihedralAngle", "MinSolidAngle", "MaxSolidAngle",
  "EquiangleSkewness", "EdgeLengthRatio", "IsoperimetricQuotient", "CellAspectRatio",
  "MinFaceFlatness", "MaxWarpage", "MaxFaceConcavity", "CellConcavity", "Openness",
  "MinFacePyramidVolume", "MinTetMeanRatio", "MaxNonOrthogonality", "MaxFaceSkewness",
  "MinVolumeRatio", "OrthogonalQuality" };

//------------------------------------------------------------------------------
// A number of /proc/self/status in bytes; 0 where the system has none.
double ReadStatus(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.compare(0, key.size() + 1, key + ':') == 0)
    {
      return 1024 * std::atof(line.c_str() + key.size() + 1);
    }
  }
  return 0;
}

//------------------------------------------------------------------------------
// Memory at its highest above what was there before, of topology and values.
void PrintPeak(
  const std::string& what, vtkUnstructuredGrid* grid, const std::vector<std::string>& names)
{
  Touch(grid);
  EvaluateOn(camaron::MakeTruncatedOctahedra(1), names); // lets go of the topology of the grid
#if defined(__GLIBC__)
  malloc_trim(0); // what was freed goes back to the system
#endif
  std::ofstream("/proc/self/clear_refs") << "5"; // starts the peak anew
  const double before = ReadStatus("VmRSS");
  EvaluateOn(grid, names);
  const double cells = static_cast<double>(grid->GetNumberOfCells());
  std::printf("%-44s %8.0f cells, peak %.0f bytes/cell, values %zu\n", what.c_str(), cells,
    (ReadStatus("VmHWM") - before) / cells, sizeof(double) * names.size());
}

//------------------------------------------------------------------------------
void OnTetrahedra(vtkIdType size)
{
  const auto grid = camaron::MakeTetrahedra(size);
  const vtkIdType cells = grid->GetNumberOfCells();
  Seconds seconds = Measure(
    [&]
    {
      Touch(grid);
      camaron::MeshTopology(grid).GetFaces();
    });
  Print("tetrahedra: unique faces and neighbors", cells, seconds, "vtkGeometryFilter",
    SecondsPerCell<vtkGeometryFilter>(grid));
  Print(
    "", cells, seconds, "vtkDataSetSurfaceFilter", SecondsPerCell<vtkDataSetSurfaceFilter>(grid));
  seconds = Measure(
    [&]
    {
      vtkNew<vtkPolyData> surface;
      camaron::MakeBoundarySurface(grid, surface);
    });
  Print("tetrahedra: boundary from the topology", cells, seconds);
  seconds = Measure([&] { EvaluateOn(grid, { "EdgeLengthRatio" }); });
  const double peer = Measure(
                        [&]
                        {
                          vtkNew<vtkMeshQuality> quality;
                          quality->SetInputData(grid);
                          quality->SetTetQualityMeasureToEdgeRatio();
                          quality->Update();
                        })
                        .Wall /
    static_cast<double>(cells);
  Print("tetrahedra: EdgeLengthRatio", cells, seconds, "vtkMeshQuality", peer);
  for (const char* name : { "Volume", "TetRadiusEdgeRatio", "TetMeanRatio", "MinSolidAngle" })
  {
    Print(std::string("tetrahedra: ") + name, cells, Measure([&] { EvaluateOn(grid, { name }); }));
  }
  Print("tetrahedra: " + std::to_string(CoreOfTetrahedra.size()) + " core criteria", cells,
    Measure([&] { EvaluateOn(grid, CoreOfTetrahedra); }));
  Print("tetrahedra: all " + std::to_string(AllOfCells.size()) + " criteria", cells,
    Measure([&] { EvaluateOn(grid, AllOfCells); }, 1));
}

//------------------------------------------------------------------------------
void OnPolyhedra(vtkIdType size)
{
  const auto grid = camaron::MakeTruncatedOctahedra(size);
  const vtkIdType cells = grid->GetNumberOfCells();
  // VTK's filters take minutes for a million polyhedra: their time per cell is taken on fewer.
  const auto sample = camaron::MakeTruncatedOctahedra(2000);
  Seconds seconds = Measure(
    [&]
    {
      Touch(grid);
      camaron::MeshTopology(grid).GetFaces();
    });
  Print("polyhedra: unique faces and neighbors", cells, seconds);
  seconds = Measure(
    [&]
    {
      Touch(grid);
      vtkNew<vtkPolyData> surface;
      camaron::MakeBoundarySurface(grid, surface);
    });
  Print("polyhedra: boundary, faces not known", cells, seconds, "vtkDataSetSurfaceFilter",
    SecondsPerCell<vtkDataSetSurfaceFilter>(sample));
  seconds = Measure(
    [&]
    {
      vtkNew<vtkPolyData> surface;
      camaron::MakeBoundarySurface(grid, surface);
    });
  Print("polyhedra: boundary, faces known", cells, seconds, "vtkGeometryFilter",
    SecondsPerCell<vtkGeometryFilter>(sample, 1));
  Print("polyhedra: Volume and SurfaceArea", cells,
    Measure([&] { EvaluateOn(grid, { "Volume", "SurfaceArea" }); }), "vtkCellSizeFilter",
    SecondsPerCell<vtkCellSizeFilter>(sample, 1));
  for (const char* name :
    { "Volume", "EdgeLengthRatio", "MinFaceAngle", "MinDihedralAngle", "MinSolidAngle" })
  {
    Print(std::string("polyhedra: ") + name, cells, Measure([&] { EvaluateOn(grid, { name }); }));
  }
  Print("polyhedra: " + std::to_string(Paper.size()) + " criteria of the paper", cells,
    Measure([&] { EvaluateOn(grid, Paper); }));
  Print("polyhedra: all " + std::to_string(AllOfCells.size()) + " criteria", cells,
    Measure([&] { EvaluateOn(grid, AllOfCells); }, 1)); // minutes for a million
  for (const std::vector<std::string>& names : { FiniteVolume, Core })
  {
    const std::string what = "polyhedra: " + std::to_string(names.size()) +
      (names == Core ? " core criteria" : " of finite volumes");
    Print(what, cells, Measure([&] { Touch(grid), EvaluateOn(grid, names); }));
    PrintPeak(what, grid, names);
  }
}

//------------------------------------------------------------------------------
// What the constants of Core/Criteria/CostEstimate.cxx are taken from: processor time for each
// corner of a cell, of one criterion of a class that is defined for one of the shapes and of each
// that is added.
void OnClasses(const char* mesh, unsigned shapes, vtkUnstructuredGrid* grid)
{
  const double corners = static_cast<double>(grid->GetCells()->GetNumberOfConnectivityIds());
  const std::pair<camaron::Cost, const char*> classes[] = { { camaron::Cost::Faces, "faces" },
    { camaron::Cost::Edges, "edges" }, { camaron::Cost::Neighbors, "neighbors" },
    { camaron::Cost::Iterative, "iterative" }, { camaron::Cost::Clipping, "clipping" } };
  for (const auto& [cost, name] : classes)
  {
    std::vector<std::string> names;
    double one = 0;
    for (const camaron::Criterion& criterion : camaron::GetCriteria())
    {
      if (criterion.Cost == cost && (criterion.AppliesTo & shapes))
      {
        names.push_back(criterion.Name);
        one += Measure([&] { Touch(grid), EvaluateOn(grid, { criterion.Name }); }, 1).Processor;
      }
    }
    if (!names.empty())
    {
      const double number = static_cast<double>(names.size());
      const double all = Measure([&] { Touch(grid), EvaluateOn(grid, names); }, 1).Processor;
      const double added = number > 1 ? (all - one / number) / (number - 1) : 0;
      std::printf("%s, class %-10s %3.0f criteria: %7.1f ns/corner for one, %6.1f for another\n",
        mesh, name, number, 1e9 * one / number / corners, 1e9 * added / corners);
      std::fflush(stdout);
    }
  }
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const double tetrahedra = argc > 1 ? std::atof(argv[1]) : 3.5;
  const double polyhedra = argc > 2 ? std::atof(argv[2]) : 1;
  camaron::WithThreads(
    [&]
    {
      std::printf("SMP backend %s, %d threads; median of %d\n", vtkSMPTools::GetBackend(),
        vtkSMPTools::GetEstimatedNumberOfThreads(), Repetitions);
      OnTetrahedra(static_cast<vtkIdType>(1e6 * tetrahedra));
      OnPolyhedra(static_cast<vtkIdType>(1e6 * polyhedra));
      OnClasses("polygons", camaron::Polygons | camaron::Triangles,
        camaron::MakeSurface(static_cast<vtkIdType>(1e5 * tetrahedra)));
      OnClasses("tetrahedra", camaron::Polyhedra | camaron::Tetrahedra,
        camaron::MakeTetrahedra(static_cast<vtkIdType>(1e5 * tetrahedra)));
      OnClasses("polyhedra", camaron::Polyhedra,
        camaron::MakeTruncatedOctahedra(static_cast<vtkIdType>(1e5 * polyhedra)));
    });
  return 0;
}
