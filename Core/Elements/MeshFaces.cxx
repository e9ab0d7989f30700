// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Elements/MeshFaces.h"

#include "Criteria/FacetMeasures.h"
#include "Elements/ElementArrays.h"
#include "Mesh/CellFacets.h"
#include "Parallel.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <numeric>

namespace camaron
{
namespace
{
constexpr vtkIdType Grain = 1024;

//------------------------------------------------------------------------------
// Calls visit(facet, local) for the facets that a cell is the first to have.
template <typename Visit>
void ForOwnFacets(const FacetTable& table, vtkIdType cell, Visit&& visit)
{
  const FacetTable::Range uses = table.GetCellFacets(cell);
  for (Index local = 0; local < uses.size(); ++local)
  {
    const Index facet = uses[local].Facet();
    if (table.GetCells(facet).First == cell && table.GetOwnerLocalFacet(facet) == local)
    {
      visit(facet, local);
    }
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCellArray> MakePolygons(const MeshView& mesh, const FacetTable& table)
{
  vtkNew<vtkTypeInt64Array> offsets, connectivity;
  offsets->SetNumberOfValues(table.GetNumberOfFacets() + 1);
  vtkTypeInt64* starts = offsets->GetPointer(0);
  starts[0] = 0;
  const auto forCells = [&](auto&& visit)
  {
    ParallelFor(mesh.GetNumberOfCells(), Grain,
      [&](vtkIdType begin, vtkIdType end)
      {
        CellFacets facets(mesh);
        for (vtkIdType cell = begin; cell < end; ++cell)
        {
          const FacetTable::Range uses = table.GetCellFacets(cell);
          if (uses.size() > 0)
          {
            facets.ForEach(cell,
              [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
              {
                const Index facet = uses[static_cast<Index>(local)].Facet();
                if (table.GetCells(facet).First == cell &&
                  table.GetOwnerLocalFacet(facet) == static_cast<Index>(local))
                {
                  visit(facet, points, size);
                }
              });
          }
        }
      });
  };
  forCells([&](Index facet, const vtkIdType*, vtkIdType size) { starts[facet + 1] = size; });
  std::partial_sum(starts, starts + table.GetNumberOfFacets() + 1, starts);
  connectivity->SetNumberOfValues(starts[table.GetNumberOfFacets()]);
  vtkTypeInt64* ids = connectivity->GetPointer(0);
  forCells([&](Index facet, const vtkIdType* points, vtkIdType size)
    { std::copy_n(points, size, ids + starts[facet]); });
  auto polygons = vtkSmartPointer<vtkCellArray>::New();
  polygons->SetData(offsets, connectivity);
  return polygons;
}

//------------------------------------------------------------------------------
// The measures of finite volumes, seen from the first cell of every face.
class FaceMeasures
{
public:
  FaceMeasures(const MeshTopology& topology, const EvaluationOptions& options, ElementArrays& arrays)
    : Topology(topology)
    , Options(options)
    , NonOrthogonality(arrays.AddReals("NonOrthogonality", Unit::Angle))
    , AtBoundary(arrays.AddReals("BoundaryNonOrthogonality", Unit::Angle))
    , Skewness(arrays.AddReals("FaceSkewness", Unit::None))
    , Weight(arrays.AddReals("FaceWeight", Unit::None))
    , VolumeRatio(arrays.AddReals("VolumeRatio", Unit::None))
    , PyramidVolume(arrays.AddReals("FacePyramidVolume", Unit::Volume))
  {
  }

  void Evaluate() const
  {
    const MeshView& mesh = this->Topology.GetMesh();
    const FacetTable& table = this->Topology.GetFaces();
    const CellCenters centers(mesh, this->Options);
    const CellNeighborhood prototype(this->Topology, centers, this->Options);
    ParallelFor(mesh.GetNumberOfCells(), Grain,
      [&](vtkIdType begin, vtkIdType end)
      {
        CellGeometry cell;
        CellNeighborhood neighborhood = prototype;
        for (vtkIdType id = begin; id < end; ++id)
        {
          ForOwnFacets(table, id, [&](Index facet, Index) { this->SetNull(facet); });
          cell.Load(mesh, id, this->Options);
          if (table.GetCellFacets(id).size() > 0 && cell.IsFinite())
          {
            cell.Compute(CellNeighborhood::BaseNeeds);
            neighborhood.Load(id, cell);
            for (const CellNeighborhood::Facet& facet : neighborhood.GetFacets())
            {
              const int local = cell.GetTopology().FaceNumbers[facet.Number];
              const Index number = table.GetCellFacets(id)[local].Facet();
              if (table.GetCells(number).First == id && table.GetOwnerLocalFacet(number) == local)
              {
                this->Set(number, neighborhood, facet);
              }
            }
          }
        }
      });
  }

private:
  using Side = CellNeighborhood::Side;

  void SetNull(Index face) const
  {
    for (double* values : { this->NonOrthogonality, this->AtBoundary, this->Skewness, this->Weight,
           this->VolumeRatio, this->PyramidVolume })
    {
      values[face] = Null(NullReason::Degenerate);
    }
  }

  void Set(
    Index face, const CellNeighborhood& cell, const CellNeighborhood::Facet& facet) const
  {
    const bool isInner = facet.Other == Side::Cell, isBoundary = facet.Other == Side::Boundary;
    const double none = Null(facet.Other == Side::Missing ? NullReason::MissingGhosts
        : isInner || isBoundary                           ? NullReason::NoNeighbor
                                                          : NullReason::InvalidTopology);
    const auto angle = [&](double radian)
    { return std::isnan(radian) ? radian : cell.GetGeometry().ToAngleUnit(radian); };
    this->NonOrthogonality[face] = isInner ? angle(GetNonOrthogonality(cell, facet)) : none;
    this->AtBoundary[face] = isBoundary ? angle(GetBoundaryNonOrthogonality(cell, facet))
                                        : Null(NullReason::NotApplicable);
    this->Skewness[face] = isInner || isBoundary ? GetFaceSkewness(cell, facet) : none;
    this->Weight[face] = isInner ? GetFaceWeight(cell, facet) : none;
    this->VolumeRatio[face] = isInner ? GetVolumeRatio(cell, facet) : none;
    this->PyramidVolume[face] =
      std::isnan(cell.GetSize()) ? cell.GetSize() : GetFacePyramidVolume(cell, facet);
  }

  const MeshTopology& Topology;
  const EvaluationOptions& Options;
  double *NonOrthogonality, *AtBoundary, *Skewness, *Weight, *VolumeRatio, *PyramidVolume;
};

//------------------------------------------------------------------------------
void TakePolygonCells(const MeshView& mesh, ElementArrays& arrays, vtkPolyData* faces)
{
  CellFacets facets(mesh);
  vtkNew<vtkCellArray> polygons;
  std::vector<vtkIdType> points, cells;
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    if (facets.GetDimension(cell) == 2)
    {
      facets.GetPolygon(cell, points);
      polygons->InsertNextCell(static_cast<vtkIdType>(points.size()), points.data());
      cells.push_back(cell);
    }
  }
  faces->SetPolys(polygons);
  arrays.SetSize(static_cast<vtkIdType>(cells.size()));
  vtkIdType* owners = arrays.AddIds("OwnerCell");
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    owners[i] = arrays.GetGlobalCell(cells[i]);
  }
  if (const unsigned char* ghosts = arrays.GetInputGhosts())
  {
    unsigned char* flags = arrays.AddGhosts();
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      flags[i] = ghosts[cells[i]];
    }
  }
}
}

//------------------------------------------------------------------------------
void MakeFaces(vtkDataSet* mesh, const MeshTopology& topology, const EvaluationOptions& options,
  bool measures, vtkPolyData* faces)
{
  const MeshView& view = topology.GetMesh();
  const FacetTable& table = topology.GetFaces();
  ElementArrays arrays(mesh, faces, options.Angles);
  if (table.GetNumberOfFacets() == 0)
  {
    TakePolygonCells(view, arrays, faces);
    return;
  }
  faces->SetPolys(MakePolygons(view, table));
  arrays.SetSize(table.GetNumberOfFacets());
  vtkIdType* owners = arrays.AddIds("OwnerCell");
  vtkIdType* neighbors = arrays.AddIds("NeighborCell");
  vtkIdType* counts = arrays.AddIds("FaceCellCount");
  unsigned char* boundary = arrays.AddFlags("IsBoundary");
  unsigned char* ghosts = arrays.GetInputGhosts() ? arrays.AddGhosts() : nullptr;
  ParallelFor(table.GetNumberOfFacets(), Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<Index> cells;
      for (vtkIdType f = begin; f < end; ++f)
      {
        const auto facet = static_cast<Index>(f);
        const FacetTable::CellPair pair = table.GetCells(facet);
        owners[f] = arrays.GetGlobalCell(pair.First);
        neighbors[f] = pair.Second < 0 ? -1 : arrays.GetGlobalCell(pair.Second);
        counts[f] = table.GetNumberOfCells(facet);
        boundary[f] = pair.Second < 0;
        if (ghosts)
        {
          table.GetCells(facet, cells);
          ghosts[f] = arrays.BelongsToGhost(cells.data(), cells.size());
        }
      }
    });
  if (measures)
  {
    FaceMeasures(topology, options, arrays).Evaluate();
  }
}
}
