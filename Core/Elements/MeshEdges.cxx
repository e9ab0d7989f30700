// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Elements/MeshEdges.h"

#include "Elements/ElementArrays.h"
#include "Mesh/CellFacets.h"
#include "Parallel.h"

#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <atomic>

namespace camaron
{
namespace
{
constexpr vtkIdType Grain = 1024;
constexpr double Pi = 3.141592653589793238462643383279502884;

//------------------------------------------------------------------------------
class EdgeFinder
{
public:
  explicit EdgeFinder(const EdgeList& edges)
    : Edges(edges)
  {
  }
  /// Number of the edge of two points, which must be one.
  vtkIdType Find(vtkIdType a, vtkIdType b) const
  {
    const std::array<Index, 2> edge = { { static_cast<Index>(std::min(a, b)),
      static_cast<Index>(std::max(a, b)) } };
    return std::lower_bound(this->Edges.begin(), this->Edges.end(), edge) - this->Edges.begin();
  }

private:
  const EdgeList& Edges;
};

//------------------------------------------------------------------------------
// Adds to numbers that several threads change.
class Counter
{
public:
  explicit Counter(std::size_t size)
    : Values(size)
  {
  }
  void Add(vtkIdType i) { this->Values[i].fetch_add(1, std::memory_order_relaxed); }
  vtkIdType operator[](vtkIdType i) const { return this->Values[i].load(std::memory_order_relaxed); }

private:
  std::vector<std::atomic<Index>> Values;
};

//------------------------------------------------------------------------------
// Cells that lines or vertices are made of: k ids each.
vtkSmartPointer<vtkCellArray> MakeCells(vtkIdType size, int points)
{
  vtkNew<vtkTypeInt64Array> offsets, connectivity;
  offsets->SetNumberOfValues(size + 1);
  for (vtkIdType i = 0; i <= size; ++i)
  {
    offsets->SetValue(i, points * i);
  }
  connectivity->SetNumberOfValues(points * size);
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}

//------------------------------------------------------------------------------
// Calls visit(cell, facets) for all cells in parallel.
template <typename Visit>
void ForCells(const MeshView& mesh, Visit&& visit)
{
  ParallelFor(mesh.GetNumberOfCells(), Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      CellFacets facets(mesh);
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        visit(cell, facets);
      }
    });
}

//------------------------------------------------------------------------------
// Calls visit(points, size, isBoundary) for every face of 3D cells once, and every 2D cell.
template <typename Visit>
void ForFaces(const MeshTopology& topology, vtkIdType cell, CellFacets& facets, Visit&& visit)
{
  const FacetTable& faces = topology.GetFaces();
  const int dimension = facets.GetDimension(cell);
  if (dimension == 3)
  {
    const FacetTable::Range uses = faces.GetCellFacets(cell);
    facets.ForEach(cell,
      [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
      {
        const Index facet = uses[static_cast<Index>(local)].Facet();
        if (faces.GetCells(facet).First == cell &&
          faces.GetOwnerLocalFacet(facet) == static_cast<Index>(local))
        {
          visit(points, size, faces.IsBoundary(facet));
        }
      });
  }
  else if (dimension == 2)
  {
    std::vector<vtkIdType> points;
    facets.GetPolygon(cell, points);
    visit(points.data(), static_cast<vtkIdType>(points.size()), false);
  }
}

//------------------------------------------------------------------------------
Vector GetVectorArea(const MeshView& mesh, const std::vector<vtkIdType>& polygon)
{
  const auto point = [&](vtkIdType id)
  {
    double x[3];
    mesh.GetPoint(id, x);
    return Vector{ x[0], x[1], x[2] };
  };
  Vector sum;
  const Vector origin = point(polygon[0]);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
  {
    sum += Cross(point(polygon[i]) - origin, point(polygon[i + 1]) - origin);
  }
  return 0.5 * sum;
}

//------------------------------------------------------------------------------
void SetDihedralAngles(const MeshTopology& topology, const EdgeFinder& finder,
  const EvaluationOptions& options, double* angles, vtkIdType numberOfEdges, unsigned char* inconsistent)
{
  const MeshView& mesh = topology.GetMesh();
  const FacetTable& table = topology.GetSurfaceEdges();
  std::fill_n(angles, numberOfEdges, Null(NullReason::NoNeighbor));
  ForCells(mesh,
    [&](vtkIdType cell, CellFacets& facets)
    {
      if (facets.GetDimension(cell) != 2)
      {
        return;
      }
      const FacetTable::Range uses = table.GetCellFacets(cell);
      std::vector<vtkIdType> own, other;
      facets.GetPolygon(cell, own);
      for (Index local = 0; local < uses.size(); ++local)
      {
        const Index facet = uses[local].Facet();
        const FacetTable::CellPair cells = table.GetCells(facet);
        if (cells.First != cell || cells.Second < 0 || cells.Second == cell)
        {
          continue;
        }
        const vtkIdType a = own[local],
                        b = own[local + 1 < uses.size() ? static_cast<std::size_t>(local) + 1 : 0];
        const vtkIdType edge = finder.Find(a, b);
        if (table.GetNumberOfCells(facet) > 2)
        {
          angles[edge] = Null(NullReason::InvalidTopology);
          continue;
        }
        bool reversed = false;
        for (const CellFacet use : table.GetCellFacets(cells.Second))
        {
          reversed = reversed || (use.Facet() == facet && use.IsReversed());
        }
        inconsistent[edge] = !reversed;
        facets.GetPolygon(cells.Second, other);
        const Vector n0 = Unit(GetVectorArea(mesh, own));
        const Vector n1 = (reversed ? 1.0 : -1.0) * Unit(GetVectorArea(mesh, other));
        double x[3], y[3];
        mesh.GetPoint(a, x);
        mesh.GetPoint(b, y);
        const Vector along = Unit({ y[0] - x[0], y[1] - x[1], y[2] - x[2] });
        if (Norm2(n0) == 0 || Norm2(n1) == 0 || Norm2(along) == 0)
        {
          angles[edge] = Null(NullReason::Degenerate);
          continue;
        }
        const double angle = Pi - std::atan2(Dot(along, Cross(n0, n1)), Dot(n0, n1));
        angles[edge] = options.Angles == AngleUnit::Degrees ? angle * 180 / Pi : angle;
      }
    });
}
}

//------------------------------------------------------------------------------
void MakeEdges(vtkDataSet* mesh, const MeshTopology& topology, const EvaluationOptions& options,
  vtkPolyData* edges)
{
  const MeshView& view = topology.GetMesh();
  const EdgeList& list = topology.GetEdges();
  const EdgeFinder finder(list);
  const auto size = static_cast<vtkIdType>(list.size());
  ElementArrays arrays(mesh, edges, options.Angles);
  arrays.SetSize(size);
  const auto lines = MakeCells(size, 2);
  auto* ids = vtkTypeInt64Array::SafeDownCast(lines->GetConnectivityArray())->GetPointer(0);
  double* lengths = arrays.AddReals("EdgeLength", Unit::Length);
  vtkIdType* cellCounts = arrays.AddIds("EdgeCellCount");
  vtkIdType* faceCounts = arrays.AddIds("EdgeFaceCount");
  unsigned char* boundary = arrays.AddFlags("IsBoundary");
  topology.GetFaces();

  Counter cells(list.size()), faces(list.size()), outer(list.size()), surface(list.size());
  std::vector<std::atomic<vtkIdType>> owners(arrays.GetInputGhosts() ? list.size() : 0);
  for (auto& owner : owners)
  {
    owner = VTK_ID_MAX;
  }
  ForCells(view,
    [&](vtkIdType cell, CellFacets& facets)
    {
      std::vector<vtkIdType> found;
      facets.ForEachEdge(cell,
        [&](vtkIdType a, vtkIdType b)
        {
          if (a != b)
          {
            found.push_back(finder.Find(a, b));
          }
        });
      std::sort(found.begin(), found.end());
      found.erase(std::unique(found.begin(), found.end()), found.end());
      const bool isPolygon = facets.GetDimension(cell) == 2;
      for (const vtkIdType edge : found)
      {
        cells.Add(edge);
        if (isPolygon)
        {
          surface.Add(edge);
        }
        if (!owners.empty())
        {
          // The smallest id among all cells, ghosts in the lowest bit.
          const vtkIdType mine =
            2 * arrays.GetGlobalCell(cell) + (arrays.GetInputGhosts()[cell] ? 1 : 0);
          vtkIdType known = owners[edge].load();
          while (mine < known && !owners[edge].compare_exchange_weak(known, mine))
          {
          }
        }
      }
      ForFaces(topology, cell, facets,
        [&](const vtkIdType* points, vtkIdType count, bool isBoundary)
        {
          for (vtkIdType i = 0; i < count; ++i)
          {
            const vtkIdType a = points[i], b = points[i + 1 < count ? i + 1 : 0];
            if (a != b)
            {
              const vtkIdType edge = finder.Find(a, b);
              faces.Add(edge);
              if (isBoundary)
              {
                outer.Add(edge);
              }
            }
          }
        });
    });
  ParallelFor(size, Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        double x[3], y[3];
        view.GetPoint(list[i][0], x);
        view.GetPoint(list[i][1], y);
        ids[2 * i] = list[i][0];
        ids[2 * i + 1] = list[i][1];
        lengths[i] = Norm({ x[0] - y[0], x[1] - y[1], x[2] - y[2] });
        cellCounts[i] = cells[i];
        faceCounts[i] = faces[i];
        boundary[i] = outer[i] > 0 || (surface[i] == 1 && cells[i] == 1);
      }
    });
  edges->SetLines(lines);
  if (!owners.empty())
  {
    unsigned char* ghosts = arrays.AddGhosts();
    for (vtkIdType i = 0; i < size; ++i)
    {
      ghosts[i] = owners[i] & 1 ? vtkDataSetAttributes::DUPLICATECELL : 0;
    }
  }
  if (topology.GetSurfaceEdges().GetNumberOfFacets() > 0)
  {
    double* angles = arrays.AddReals("EdgeDihedralAngle", Unit::Angle);
    unsigned char* inconsistent = arrays.AddFlags("InconsistentEdge");
    SetDihedralAngles(topology, finder, options, angles, size, inconsistent);
  }
}

//------------------------------------------------------------------------------
void MakeVertices(vtkDataSet* mesh, const MeshTopology& topology, const EvaluationOptions& options,
  vtkPolyData* vertices)
{
  const MeshView& view = topology.GetMesh();
  const vtkIdType size = view.GetNumberOfPoints();
  ElementArrays arrays(mesh, vertices, options.Angles);
  arrays.SetSize(size);
  const auto cells = MakeCells(size, 1);
  auto* ids = vtkTypeInt64Array::SafeDownCast(cells->GetConnectivityArray())->GetPointer(0);
  vtkIdType* cellCounts = arrays.AddIds("VertexCellCount");
  vtkIdType* faceCounts = arrays.AddIds("VertexFaceCount");
  vtkIdType* edgeCounts = arrays.AddIds("VertexEdgeCount");
  unsigned char* boundary = arrays.AddFlags("IsBoundary");
  unsigned char* unused = arrays.AddFlags("UnusedPoint");
  topology.GetFaces();
  const FacetTable& surface = topology.GetSurfaceEdges();

  Counter faces(static_cast<std::size_t>(size)), outer(static_cast<std::size_t>(size));
  ForCells(view,
    [&](vtkIdType cell, CellFacets& facets)
    {
      ForFaces(topology, cell, facets,
        [&](const vtkIdType* points, vtkIdType count, bool isBoundary)
        {
          for (vtkIdType i = 0; i < count; ++i)
          {
            faces.Add(points[i]);
            if (isBoundary)
            {
              outer.Add(points[i]);
            }
          }
        });
      if (facets.GetDimension(cell) == 2)
      {
        const FacetTable::Range uses = surface.GetCellFacets(cell);
        facets.ForEach(cell,
          [&](const vtkIdType* points, vtkIdType, vtkIdType local)
          {
            if (surface.IsBoundary(uses[static_cast<Index>(local)].Facet()))
            {
              outer.Add(points[0]);
              outer.Add(points[1]);
            }
          });
      }
    });
  for (const auto& edge : topology.GetEdges())
  {
    ++edgeCounts[edge[0]];
    ++edgeCounts[edge[1]];
  }
  const PointCells& around = topology.GetPointCells();
  ParallelFor(size, Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        ids[i] = i;
        cellCounts[i] = around.Offsets[i + 1] - around.Offsets[i];
        faceCounts[i] = faces[i];
        boundary[i] = outer[i] > 0;
        unused[i] = cellCounts[i] == 0;
      }
    });
  vertices->SetVerts(cells);
  if (vtkUnsignedCharArray* ghosts = mesh->GetPointGhostArray())
  {
    std::copy_n(ghosts->GetPointer(0), size, arrays.AddGhosts());
  }
}
}
