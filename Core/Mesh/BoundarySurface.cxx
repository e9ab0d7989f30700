// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/BoundarySurface.h"

#include "Base/Buffer.h"
#include "Base/Parallel.h"
#include "Mesh/CellFacets.h"
#include "Mesh/FacetLinks.h"
#include "Mesh/MeshTopology.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <vector>

namespace camaron
{
namespace
{
// vtkPolyData stores its cells by type, in this order.
enum Kind
{
  Vertices,
  Lines,
  Polygons,
  NumberOfKinds
};

struct Counts
{
  vtkIdType Cells = 0;
  vtkIdType Points = 0;
};

//------------------------------------------------------------------------------
// Calls visit(kind, points, numberOfPoints) for the parts of a cell in the surface.
class SurfaceParts
{
public:
  SurfaceParts(const MeshTopology& topology, const unsigned char* ghosts, const FacetLinks* links)
    : Mesh(topology.GetMesh())
    , Faces(topology.GetFaces())
    , Ghosts(ghosts)
    , Links(links)
    , Facets(this->Mesh)
  {
  }

  template <typename Visitor>
  void ForEach(vtkIdType cell, Visitor&& visit)
  {
    constexpr int hidden = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
    if (this->Ghosts && (this->Ghosts[cell] & hidden))
    {
      return;
    }
    switch (this->Facets.GetDimension(cell))
    {
      case 3:
      {
        const FacetTable::Range uses = this->Faces.GetCellFacets(cell);
        bool any = false;
        for (const CellFacet use : uses)
        {
          any = any || this->IsOutside(use.Facet());
        }
        if (any)
        {
          this->Facets.ForEach(cell,
            [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
            {
              if (this->IsOutside(uses[static_cast<Index>(local)].Facet()))
              {
                visit(Polygons, points, size);
              }
            });
        }
        break;
      }
      case 2:
        this->Facets.GetPolygon(cell, this->Points);
        visit(Polygons, this->Points.data(), static_cast<vtkIdType>(this->Points.size()));
        break;
      case 1:
      case 0:
      {
        const IndexRange points = this->Mesh.GetCellPoints(cell);
        const CellShape& shape = GetCellShape(this->Mesh.GetCellType(cell));
        const vtkIdType size = shape.NumberOfCorners ? shape.NumberOfCorners : points.Size;
        this->Points.resize(size);
        for (vtkIdType i = 0; i < size; ++i)
        {
          this->Points[i] = points[i];
        }
        visit(shape.Dimension == 1 ? Lines : Vertices, this->Points.data(), size);
        break;
      }
      default:
        break;
    }
  }

private:
  bool IsOutside(Index face) const
  {
    return this->Faces.IsBoundary(face) && !(this->Links && this->Links->Has(face));
  }

  const MeshView& Mesh;
  const FacetTable& Faces;
  const unsigned char* Ghosts;
  const FacetLinks* Links;
  CellFacets Facets;
  std::vector<vtkIdType> Points;
};

//------------------------------------------------------------------------------
void CopyAttributes(
  vtkDataSetAttributes* from, vtkDataSetAttributes* to, vtkIdTypeArray* ids, const char* idsName)
{
  to->CopyGlobalIdsOn();
  to->CopyAllocate(from, ids->GetNumberOfValues());
  vtkNew<vtkIdList> list;
  list->SetNumberOfIds(ids->GetNumberOfValues());
  std::copy_n(ids->GetPointer(0), ids->GetNumberOfValues(), list->GetPointer(0));
  to->CopyData(from, list, vtkIdType(0));
  ids->SetName(idsName);
  to->AddArray(ids);
  to->RemoveArray(vtkDataSetAttributes::GhostArrayName());
}
}

//------------------------------------------------------------------------------
void MakeBoundarySurface(vtkDataSet* mesh, vtkPolyData* surface, const FacetLinks* links)
{
  const MeshTopology topology(mesh);
  const MeshView& view = topology.GetMesh();
  const vtkIdType numberOfCells = view.GetNumberOfCells();
  vtkUnsignedCharArray* ghostArray = mesh->GetCellGhostArray();
  const unsigned char* ghosts = ghostArray ? ghostArray->GetPointer(0) : nullptr;
  topology.GetFaces();

  // Count in chunks first, so that the second pass knows where to write.
  const vtkIdType numberOfChunks = (numberOfCells + MediumGrain - 1) / MediumGrain;
  std::vector<Counts> starts(NumberOfKinds * (numberOfChunks + 1));
  const auto start = [&](int kind, vtkIdType chunk) -> Counts&
  { return starts[kind * (numberOfChunks + 1) + chunk]; };
  const auto forEachChunk = [&](auto&& perChunk)
  {
    ParallelFor(numberOfChunks, 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        SurfaceParts parts(topology, ghosts, links);
        for (vtkIdType chunk = begin; chunk < end; ++chunk)
        {
          perChunk(
            parts, chunk, chunk * MediumGrain, std::min(numberOfCells, (chunk + 1) * MediumGrain));
        }
      });
  };
  forEachChunk(
    [&](SurfaceParts& parts, vtkIdType chunk, vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        parts.ForEach(cell,
          [&](Kind kind, const vtkIdType*, vtkIdType size)
          {
            Counts& counts = start(kind, chunk + 1);
            ++counts.Cells;
            counts.Points += size;
          });
      }
    });
  Counts total;
  for (int kind = 0; kind < NumberOfKinds; ++kind)
  {
    for (vtkIdType chunk = 0; chunk < numberOfChunks; ++chunk)
    {
      start(kind, chunk + 1).Cells += start(kind, chunk).Cells;
      start(kind, chunk + 1).Points += start(kind, chunk).Points;
    }
    total.Cells += start(kind, numberOfChunks).Cells;
  }

  const auto cellIds = MakeLargeArray<vtkIdTypeArray>(total.Cells);
  vtkSmartPointer<vtkTypeInt64Array> offsets[NumberOfKinds], connectivity[NumberOfKinds];
  vtkIdType firstCell[NumberOfKinds];
  total.Cells = 0;
  for (int kind = 0; kind < NumberOfKinds; ++kind)
  {
    const Counts& counts = start(kind, numberOfChunks);
    firstCell[kind] = total.Cells;
    total.Cells += counts.Cells;
    offsets[kind] = MakeLargeArray<vtkTypeInt64Array>(counts.Cells + 1);
    offsets[kind]->SetValue(counts.Cells, counts.Points);
    connectivity[kind] = MakeLargeArray<vtkTypeInt64Array>(counts.Points);
  }
  forEachChunk(
    [&](SurfaceParts& parts, vtkIdType chunk, vtkIdType begin, vtkIdType end)
    {
      Counts next[NumberOfKinds];
      for (int kind = 0; kind < NumberOfKinds; ++kind)
      {
        next[kind] = start(kind, chunk);
      }
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        parts.ForEach(cell,
          [&](Kind kind, const vtkIdType* points, vtkIdType size)
          {
            Counts& to = next[kind];
            cellIds->SetValue(firstCell[kind] + to.Cells, cell);
            offsets[kind]->SetValue(to.Cells, to.Points);
            std::copy_n(points, size, connectivity[kind]->GetPointer(to.Points));
            ++to.Cells;
            to.Points += size;
          });
      }
    });

  // Only the used points, in their original order.
  LargeVector<Index> newIds(view.GetNumberOfPoints(), -1);
  for (auto& values : connectivity)
  {
    for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
    {
      newIds[values->GetValue(i)] = 0;
    }
  }
  vtkIdType numberOfPoints = 0;
  for (Index& id : newIds)
  {
    id = id < 0 ? -1 : static_cast<Index>(numberOfPoints++);
  }
  const auto pointIds = MakeLargeArray<vtkIdTypeArray>(numberOfPoints);
  vtkNew<vtkPoints> points;
  points->SetDataType(view.HasFloatPoints() ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(numberOfPoints);
  for (vtkIdType id = 0; id < view.GetNumberOfPoints(); ++id)
  {
    if (newIds[id] >= 0)
    {
      double x[3];
      view.GetPoint(id, x);
      points->SetPoint(newIds[id], x);
      pointIds->SetValue(newIds[id], id);
    }
  }
  for (int kind = 0; kind < NumberOfKinds; ++kind)
  {
    vtkTypeInt64* values = connectivity[kind]->GetPointer(0);
    ParallelFor(connectivity[kind]->GetNumberOfValues(), MediumGrain,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          values[i] = newIds[values[i]];
        }
      });
    vtkNew<vtkCellArray> cells;
    cells->SetData(offsets[kind], connectivity[kind]);
    kind == Vertices  ? surface->SetVerts(cells)
      : kind == Lines ? surface->SetLines(cells)
                      : surface->SetPolys(cells);
  }
  surface->SetPoints(points);
  CopyAttributes(mesh->GetCellData(), surface->GetCellData(), cellIds, "vtkOriginalCellIds");
  CopyAttributes(mesh->GetPointData(), surface->GetPointData(), pointIds, "vtkOriginalPointIds");
  surface->GetFieldData()->PassData(mesh->GetFieldData());
}
}
