// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Selections of many cells: what lies in a sphere, beside VTK's vtkExtractGeometry; layers of
// neighbors, beside VTK's vtkExtractSelection with connected layers, which knows neighbors over
// points only; changes of the element type. Usage: BenchmarkSelection [millions of tetrahedra]
// [millions of polyhedra]
#include "BenchmarkCost.h"
#include "BenchmarkMeshes.h"

#include "vtkMeshElements.h"
#include "vtkSelectElements.h"

#include "vtkCellData.h"
#include "vtkExtractGeometry.h"
#include "vtkExtractSelection.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSphere.h"
#include "vtkUnstructuredGrid.h"

#include <cstdio>
#include <cstdlib>
#include <string>

namespace
{
constexpr int NumberOfLayers = 20;

//------------------------------------------------------------------------------
class Bench
{
public:
  Bench(const char* name, vtkUnstructuredGrid* mesh)
    : Name(name)
    , Mesh(mesh)
    , Cells(static_cast<double>(mesh->GetNumberOfCells()))
  {
    this->Sphere->SetCenter(mesh->GetCenter());
    this->Sphere->SetRadius(0.2 * mesh->GetLength());
    std::printf("%s: %.0f cells, %d threads, %s\n", name, this->Cells,
      vtkSMPTools::GetEstimatedNumberOfThreads(), vtkSMPTools::GetBackend());
  }

  void Print(const std::string& what, const char* by, const std::function<double()>& work) const
  {
    double found = 0;
    const camaron::Measurement cost = camaron::Measure([&] { found = work(); });
    camaron::Record(what, this->Name, by, this->Cells, cost);
    std::printf("  %-36s %-20s %8.3f s %9.1f ns/cell, processor %9.1f, peak %7.1f MB, found %.0f\n",
      what.c_str(), by, cost.Wall, 1e9 * cost.Wall / this->Cells,
      1e9 * cost.Processor / this->Cells, cost.Peak / 1e6, found);
    std::fflush(stdout);
  }

  void PrintPlacements() const
  {
    for (const char* placement : { "Any vertex inside", "All vertices inside", "Centroid inside",
           "Intersects", "Cut by boundary" })
    {
      this->Print(placement, camaron::Ours,
        [&]
        {
          vtkNew<vtkSelectElements> select;
          select->SetInputData(this->Mesh);
          select->SetStrategy("Shape");
          select->SetShape(this->Sphere);
          select->SetPlacement(placement);
          select->Update();
          return static_cast<double>(select->GetNumberOfSelectedElements());
        });
    }
    this->Print("Any vertex inside", "vtkExtractGeometry",
      [&]
      {
        vtkNew<vtkExtractGeometry> extract;
        extract->SetInputData(this->Mesh);
        extract->SetImplicitFunction(this->Sphere);
        extract->ExtractBoundaryCellsOn();
        extract->Update();
        return static_cast<double>(extract->GetOutput()->GetNumberOfCells());
      });
  }

  void PrintLayers() const
  {
    for (const char* adjacency : { "Face", "Edge", "Vertex" })
    {
      this->Print(std::to_string(NumberOfLayers) + " layers over " + adjacency, camaron::Ours,
        [&]
        {
          vtkNew<vtkSelectElements> first, select;
          this->SetSeed(first);
          select->SetInputConnection(first->GetOutputPort());
          select->SetStrategy("Expand");
          select->SetAdjacency(adjacency);
          select->SetNumberOfLayers(NumberOfLayers);
          select->Update();
          return static_cast<double>(select->GetNumberOfSelectedElements());
        });
    }
    this->Print(std::to_string(NumberOfLayers) + " layers over Vertex", "vtkExtractSelection",
      [&]
      {
        vtkNew<vtkIdTypeArray> ids;
        ids->InsertNextValue(this->GetSeed());
        vtkNew<vtkSelectionNode> node;
        node->SetContentType(vtkSelectionNode::INDICES);
        node->SetFieldType(vtkSelectionNode::CELL);
        node->SetSelectionList(ids);
        node->GetProperties()->Set(vtkSelectionNode::CONNECTED_LAYERS(), NumberOfLayers);
        vtkNew<vtkSelection> selection;
        selection->AddNode(node);
        vtkNew<vtkExtractSelection> extract;
        extract->SetInputData(0, this->Mesh);
        extract->SetInputData(1, selection);
        extract->PreserveTopologyOn();
        extract->Update();
        double found = 0;
        auto* output = vtkDataSet::SafeDownCast(extract->GetOutput());
        vtkDataArray* inside = output->GetCellData()->GetArray("vtkInsidedness");
        for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
        {
          found += inside->GetComponent(i, 0);
        }
        return found;
      });
  }

  void PrintKinds() const
  {
    vtkNew<vtkSelectElements> cells;
    cells->SetInputData(this->Mesh);
    cells->SetStrategy("Shape");
    cells->SetShape(this->Sphere);
    vtkNew<vtkMeshElements> elements;
    elements->SetInputConnection(cells->GetOutputPort());
    elements->Update();
    this->Print("Cells to points, all", camaron::Ours,
      [&] { return this->Change(cells->GetOutputPort(), nullptr, "Points"); });
    this->Print("Cells to faces, all", camaron::Ours,
      [&] { return this->Change(elements->GetOutputPort(0), cells->GetOutputPort(), "Cells"); });
    this->Print("Cells to edges, all", camaron::Ours,
      [&] { return this->Change(elements->GetOutputPort(1), cells->GetOutputPort(), "Cells"); });
  }

private:
  vtkIdType GetSeed() const { return this->Mesh->GetNumberOfCells() / 2; }

  void SetSeed(vtkSelectElements* select) const
  {
    select->SetInputData(this->Mesh);
    select->SetStrategy("By id");
    select->SetIds(std::to_string(this->GetSeed()).c_str());
  }

  static double Change(vtkAlgorithmOutput* mesh, vtkAlgorithmOutput* from, const char* elementType)
  {
    vtkNew<vtkSelectElements> select;
    select->SetInputConnection(mesh);
    select->SetElementType(elementType);
    select->SetStrategy("Change element type");
    select->SetQuantifier("All");
    if (from)
    {
      select->SetElementsConnection(from);
    }
    select->Update();
    return static_cast<double>(select->GetNumberOfSelectedElements());
  }

  const char* Name;
  vtkUnstructuredGrid* Mesh;
  double Cells;
  vtkNew<vtkSphere> Sphere;
};

//------------------------------------------------------------------------------
void Run(const char* name, vtkUnstructuredGrid* mesh)
{
  const Bench bench(name, mesh);
  bench.PrintPlacements();
  bench.PrintLayers();
  bench.PrintKinds();
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const double tetrahedra = argc > 1 ? std::atof(argv[1]) : 3.5;
  const double polyhedra = argc > 2 ? std::atof(argv[2]) : 0.2;
  Run("tetrahedra", camaron::MakeTetrahedra(static_cast<vtkIdType>(1e6 * tetrahedra)));
  Run("polyhedra", camaron::MakeTruncatedOctahedra(static_cast<vtkIdType>(1e6 * polyhedra)));
  return 0;
}
