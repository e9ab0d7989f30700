// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Opening and saving Fluent files, text and binary. The floor of opening is to map the file and to
// touch as much fresh memory as the mesh has; the file lists cells at faces, so that whoever makes
// faces of cells of them must besides put a word for every side of a face to its cell, which is the
// other floor. It is measured without anything that follows from a face.
// Usage: BenchmarkFluentMesh [million cells]
#include "BenchmarkCost.h"
#include "BenchmarkMeshes.h"
#include "TemporaryFolder.h"

#include "vtkFluentMeshReader.h"
#include "vtkFluentMeshWriter.h"

#include "Mesh/MeshTopology.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <vector>

using camaron::MapAndTouch;
using camaron::Measure;
using camaron::Measurement;
namespace fs = std::filesystem;

namespace
{
constexpr double Mega = 1e6;
constexpr double Kilobyte = 1024;

//------------------------------------------------------------------------------
void Print(const char* what, const fs::path& path, const Measurement& cost, double mesh = 0)
{
  const double bytes = static_cast<double>(fs::file_size(path));
  std::printf("  %-26s %8.1f %8.3f %8.3f %9.0f %9.1f", what, bytes / Mega, cost.Wall,
    cost.Processor, bytes / Mega / cost.Processor, cost.Peak / Mega);
  if (mesh > 0)
  {
    std::printf(" %9.1f %9.2f", mesh / Mega, cost.Peak / mesh);
  }
  std::printf("\n");
  std::fflush(stdout);
}

//------------------------------------------------------------------------------
// A lattice of hexahedra with coordinates of six digits.
vtkSmartPointer<vtkUnstructuredGrid> MakeHexahedra(vtkIdType cells)
{
  const auto n = static_cast<vtkIdType>(std::cbrt(static_cast<double>(cells)));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < (n + 1) * (n + 1) * (n + 1); ++i)
  {
    const auto round = [](double x) { return std::round(x * Mega) / Mega; };
    const auto place = [n](vtkIdType j) { return static_cast<double>(j) / static_cast<double>(n); };
    points->InsertNextPoint(round(place(i % (n + 1))), round(place(i / (n + 1) % (n + 1))),
      round(place(i / ((n + 1) * (n + 1)))));
  }
  vtkNew<vtkCellArray> list;
  for (vtkIdType i = 0; i < n * n * n; ++i)
  {
    const vtkIdType a = i % n + (n + 1) * (i / n % n + (n + 1) * (i / (n * n))), b = a + n + 1;
    const vtkIdType up = (n + 1) * (n + 1);
    list->InsertNextCell({ a, a + 1, b + 1, b, a + up, a + 1 + up, b + 1 + up, b + up });
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->SetCells(VTK_HEXAHEDRON, list);
  return grid;
}

//------------------------------------------------------------------------------
// The cells on both sides of the faces of a mesh, as a file lists them, to be put into lists of the
// faces of cells by one thread.
class FacesToCells
{
public:
  explicit FacesToCells(vtkUnstructuredGrid* grid)
  {
    camaron::MeshTopology topology(grid);
    const camaron::FacetTable& faces = topology.GetFaces();
    this->Begins.assign(static_cast<std::size_t>(grid->GetNumberOfCells()) + 1, 0);
    for (camaron::Index face = 0; face < faces.GetNumberOfFacets(); ++face)
    {
      this->Sides.push_back(faces.GetCells(face));
    }
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      this->Begins[static_cast<std::size_t>(cell) + 1] =
        this->Begins[static_cast<std::size_t>(cell)] + faces.GetCellFacets(cell).size();
    }
    this->Lists.resize(static_cast<std::size_t>(this->Begins.back()));
  }
  void Sort()
  {
    this->Next.assign(this->Begins.begin(), this->Begins.end());
    camaron::Index number = 0;
    for (const auto& face : this->Sides)
    {
      for (const camaron::Index cell : { face.First, face.Second })
      {
        if (cell >= 0)
        {
          this->Lists[static_cast<std::size_t>(this->Next[static_cast<std::size_t>(cell)]++)] =
            number;
        }
      }
      ++number;
    }
  }

private:
  std::vector<camaron::FacetTable::CellPair> Sides;
  std::vector<camaron::Index> Begins, Next, Lists;
};

//------------------------------------------------------------------------------
void OpenAndSave(
  const char* kind, vtkSmartPointer<vtkUnstructuredGrid> grid, const fs::path& folder)
{
  std::printf("%lld %s\n", static_cast<long long>(grid->GetNumberOfCells()), kind);
  const struct
  {
    const char* Save;
    const char* Open;
    int Encoding;
  } rows[] = { { "save, text", "open, text", vtkFluentMeshWriter::ASCII },
    { "save, binary double", "open, binary double", vtkFluentMeshWriter::BINARY_DOUBLE },
    { "save, binary single", "open, binary single", vtkFluentMeshWriter::BINARY_SINGLE } };
  for (const auto& row : rows)
  {
    const fs::path path = folder / (std::to_string(row.Encoding) + ".msh");
    const Measurement cost = Measure(
      [&]
      {
        vtkNew<vtkFluentMeshWriter> writer;
        writer->SetInputData(grid);
        writer->SetFileName(path.string().c_str());
        writer->SetEncoding(row.Encoding);
        writer->Write();
      });
    Print(row.Save, path, cost);
  }
  FacesToCells faces(grid);
  grid = nullptr;
  for (const auto& row : rows)
  {
    const fs::path path = folder / (std::to_string(row.Encoding) + ".msh");
    double mesh = 0;
    Measurement cost = Measure(
      [&]
      {
        vtkNew<vtkFluentMeshReader> reader;
        reader->SetFileName(path.string().c_str());
        reader->Update();
        mesh = Kilobyte * static_cast<double>(reader->GetOutput()->GetActualMemorySize());
      });
    Print(row.Open, path, cost, mesh);
    Print("  map and touch", path, Measure([&] { MapAndTouch(path, mesh); }), mesh);
    const auto floor = [&]
    {
      MapAndTouch(path, mesh);
      faces.Sort();
    };
    Print("  and faces to cells", path, Measure(floor), mesh);
  }
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const auto cells = static_cast<vtkIdType>((argc > 1 ? std::atof(argv[1]) : 1) * Mega);
  std::printf("threads %d, SMP backend %s\n", vtkSMPTools::GetEstimatedNumberOfThreads(),
    vtkSMPTools::GetBackend());
  std::printf("  %-26s %8s %8s %8s %9s %9s %9s %9s\n", "", "MB", "wall s", "core s", "MB/core s",
    "peak MB", "mesh MB", "peak/mesh");
  const camaron::TemporaryFolder temporary;
  const fs::path folder = temporary.Path;
  OpenAndSave("hexahedra", MakeHexahedra(cells), folder);
  OpenAndSave("tetrahedra", camaron::MakeTetrahedra(4 * cells), folder);
  OpenAndSave("truncated octahedra", camaron::MakeTruncatedOctahedra(cells / 3), folder);
  return 0;
}
