// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Topology, boundary and evaluation against VTK's filters on the same meshes in the same run.
// Usage: BenchmarkCore [million tetrahedra [million polyhedra]]
#include "BenchmarkCost.h"
#include "BenchmarkMeshes.h"

#include "Base/Buffer.h"
#include "Base/Parallel.h"
#include "Criteria/Evaluation.h"
#include "Mesh/BoundarySurface.h"
#include "Mesh/MeshTopology.h"

#include "vtkCellArray.h"
#include "vtkCellQuality.h"
#include "vtkCellSizeFilter.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkGeometryFilter.h"
#include "vtkMeshQuality.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

using camaron::Ours;

namespace
{
// Filters of VTK that take minutes for a million polyhedra get at most as many cells as this.
constexpr vtkIdType CellsForSlowPeers = 100000;

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
// A new mesh as far as the cache of topologies is concerned, which releases what it stored.
void Touch(vtkUnstructuredGrid* grid)
{
  grid->GetCells()->GetConnectivityArray()->Modified();
  camaron::MeshTopology{ grid };
}

//------------------------------------------------------------------------------
// Measures a piece of work on a mesh: ours, then that of peers.
class Bench
{
public:
  Bench(const char* mesh, vtkUnstructuredGrid* grid)
    : Mesh(mesh)
    , Grid(grid)
  {
  }
  void Measure(const std::string& work, const std::function<void()>& ours)
  {
    Touch(this->Grid); // memory is that of the topology, too
    this->Work = work;
    this->OurTime = this->Print(Ours, this->Grid, ours);
  }
  template <typename Filter>
  void Compare(
    vtkUnstructuredGrid* grid, const std::function<void(Filter*)>& configure = [](Filter*) {})
  {
    vtkNew<Filter> name;
    const double time = this->Print(name->GetClassName(), grid,
      [&]
      {
        vtkNew<Filter> filter;
        filter->SetInputData(grid);
        configure(filter);
        filter->Update();
      });
    std::printf("  %.1f times as long\n", time / this->OurTime);
  }

private:
  // Returns seconds per cell.
  double Print(const char* by, vtkUnstructuredGrid* grid, const std::function<void()>& work) const
  {
    const camaron::Measurement cost = camaron::Measure(work);
    const double cells = static_cast<double>(grid->GetNumberOfCells());
    camaron::Record(this->Work, this->Mesh, by, cells, cost);
    std::printf("%-11s %-28s %-24s %8.0f cells %7.3f s %9.1f ns/cell, processor %9.1f, peak %5.0f "
                "bytes/cell\n",
      this->Mesh.c_str(), this->Work.c_str(), by, cells, cost.Wall, 1e9 * cost.Wall / cells,
      1e9 * cost.Processor / cells, cost.Peak / cells);
    std::fflush(stdout);
    return cost.Wall / cells;
  }

  std::string Mesh, Work;
  vtkUnstructuredGrid* Grid;
  double OurTime = 0;
};

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
// The faces of a mesh whose topology is not in the cache.
void FindFaces(vtkUnstructuredGrid* grid)
{
  Touch(grid);
  camaron::MeshTopology(grid).GetFaces();
}

//------------------------------------------------------------------------------
void FindBoundary(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkPolyData> surface;
  camaron::MakeBoundarySurface(grid, surface);
}

//------------------------------------------------------------------------------
std::string GetName(const std::vector<std::string>& names, const char* what)
{
  return std::to_string(names.size()) + ' ' + what;
}

//------------------------------------------------------------------------------
void OnTetrahedra(vtkIdType size)
{
  const auto grid = camaron::MakeTetrahedra(size);
  Bench bench("tetrahedra", grid);
  bench.Measure("unique faces and neighbors", [&] { FindFaces(grid); });
  bench.Compare<vtkGeometryFilter>(grid);
  bench.Compare<vtkDataSetSurfaceFilter>(grid);
  bench.Measure("boundary, faces known", [&] { FindBoundary(grid); });
  bench.Measure("EdgeLengthRatio", [&] { EvaluateOn(grid, { "EdgeLengthRatio" }); });
  bench.Compare<vtkMeshQuality>(
    grid, [](vtkMeshQuality* quality) { quality->SetTetQualityMeasureToEdgeRatio(); });
  bench.Measure("TetRadiusRatio", [&] { EvaluateOn(grid, { "TetRadiusRatio" }); });
  bench.Compare<vtkMeshQuality>(
    grid, [](vtkMeshQuality* quality) { quality->SetTetQualityMeasureToRadiusRatio(); });
  bench.Compare<vtkCellQuality>(
    grid, [](vtkCellQuality* quality) { quality->SetQualityMeasureToRadiusRatio(); });
  for (const char* name : { "Volume", "TetRadiusEdgeRatio", "TetMeanRatio", "MinSolidAngle" })
  {
    bench.Measure(name, [&] { EvaluateOn(grid, { name }); });
  }
  bench.Measure(
    GetName(CoreOfTetrahedra, "core criteria"), [&] { EvaluateOn(grid, CoreOfTetrahedra); });
  bench.Measure(GetName(AllOfCells, "criteria, all"), [&] { EvaluateOn(grid, AllOfCells); });
}

//------------------------------------------------------------------------------
void OnPolyhedra(vtkIdType size)
{
  const auto grid = camaron::MakeTruncatedOctahedra(size);
  const auto sample = camaron::MakeTruncatedOctahedra(std::min(size, CellsForSlowPeers));
  Bench bench("polyhedra", grid);
  bench.Measure("unique faces and neighbors", [&] { FindFaces(grid); });
  bench.Measure("boundary, faces not known", [&] { Touch(grid), FindBoundary(grid); });
  bench.Compare<vtkDataSetSurfaceFilter>(sample);
  bench.Compare<vtkGeometryFilter>(sample);
  bench.Measure("boundary, faces known", [&] { FindBoundary(grid); });
  bench.Measure("Volume and SurfaceArea", [&] { EvaluateOn(grid, { "Volume", "SurfaceArea" }); });
  bench.Compare<vtkCellSizeFilter>(sample);
  for (const char* name :
    { "Volume", "EdgeLengthRatio", "MinFaceAngle", "MinDihedralAngle", "MinSolidAngle" })
  {
    bench.Measure(name, [&] { EvaluateOn(grid, { name }); });
  }
  bench.Measure(GetName(Paper, "criteria of the paper"), [&] { EvaluateOn(grid, Paper); });
  bench.Measure(GetName(AllOfCells, "criteria, all"), [&] { EvaluateOn(grid, AllOfCells); });
  bench.Measure(GetName(FiniteVolume, "finite-volume criteria"),
    [&] { Touch(grid), EvaluateOn(grid, FiniteVolume); });
  bench.Measure(GetName(Core, "core criteria"), [&] { Touch(grid), EvaluateOn(grid, Core); });
}

//------------------------------------------------------------------------------
double ProcessorTime(const std::function<void()>& work)
{
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
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
        one += ProcessorTime([&] { Touch(grid), EvaluateOn(grid, { criterion.Name }); });
      }
    }
    if (!names.empty())
    {
      const double number = static_cast<double>(names.size());
      const double all = ProcessorTime([&] { Touch(grid), EvaluateOn(grid, names); });
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
      std::printf("SMP backend %s, %d threads\n", vtkSMPTools::GetBackend(),
        vtkSMPTools::GetEstimatedNumberOfThreads());
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
