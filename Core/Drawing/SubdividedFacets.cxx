// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/SubdividedFacets.h"

#include "Curved/CollapsedShape.h"
#include "Curved/ParametricShape.h"
#include "Drawing/CollapsedCells.h"
#include "Drawing/CurvedFacets.h"
#include "Mesh/CellShape.h"
#include "Mesh/MeshTopology.h"

#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace camaron
{
namespace
{
// A point of a cell as a combination of its corners.
using MixedCorners = std::vector<std::pair<int, double>>;

//------------------------------------------------------------------------------
// The place of a point of the lattice of an edge, triangle or quadrilateral.
MixedCorners MixCorners(const std::vector<int>& of, double u, double v)
{
  switch (of.size())
  {
    case 2:
      return { { of[0], 1 - u }, { of[1], u } };
    case 3:
      return { { of[0], 1 - u - v }, { of[1], u }, { of[2], v } };
    default:
      return { { of[0], (1 - u) * (1 - v) }, { of[1], u * (1 - v) }, { of[2], u * v },
        { of[3], (1 - u) * v } };
  }
}
}

//------------------------------------------------------------------------------
bool HasHigherOrderCells(vtkUnstructuredGrid* grid)
{
  vtkUnsignedCharArray* types = grid ? grid->GetDistinctCellTypesArray() : nullptr;
  return types &&
    std::any_of(types->GetPointer(0), types->GetPointer(0) + types->GetNumberOfValues(),
      [](unsigned char type) { return GetCellShape(type).IsHigherOrder; });
}

//------------------------------------------------------------------------------
class SubdividedFacets::Builder
{
public:
  Builder(const MeshTopology& topology, int level, Extent extent)
    : Mesh(topology.GetMesh())
    , Topology(topology)
    , Made(std::make_shared<SubdividedFacets>())
    , Extents(extent)
    , Parts(1 << level)
    , ByNodes(topology.GetMesh())
    , Collapsed(topology.GetMesh())
  {
    this->Made->Level = level;
    this->Made->Layers = std::max(this->Parts / 2 - 1, 0);
  }

  /// False if there are too many new points or tetrahedra.
  bool Build()
  {
    if (this->Extents == Extent::Cells && this->CountTetrahedra() > MaxParts)
    {
      return false;
    }
    for (vtkIdType cell = 0; cell < this->Mesh.GetNumberOfCells(); ++cell)
    {
      const Form form = this->FindForm(cell);
      if (form.Shape)
      {
        this->AddCell(cell, form);
      }
      if (this->Made->GetNumberOfNewPoints() > MaxParts)
      {
        return false;
      }
    }
    return true;
  }
  std::shared_ptr<const SubdividedFacets> GetMade() const
  {
    return this->Made->First.empty() && !this->Made->AreStraight() ? nullptr : this->Made;
  }

private:
  // How a cell that is to be divided is mapped.
  struct Form
  {
    const ParametricShape* Shape = nullptr;    // nullptr for other cells
    const CollapsedShape* Collapsed = nullptr; // if this is what remains of the cell

    int GetCorner(int corner) const
    {
      return this->Collapsed ? this->Collapsed->GetCorners()[corner] : corner;
    }
    // Nodes of the cell, and their weights.
    MixedCorners GetWeights(const MixedCorners& corners) const
    {
      const MixedCorners weights = this->Shape->GetWeights(corners);
      if (!this->Collapsed)
      {
        return weights;
      }
      std::map<int, double> sums;
      for (const auto& [remaining, weight] : weights)
      {
        const ParametricShape::Row& row = this->Collapsed->GetNodes()[remaining];
        for (std::size_t i = 0; i < row.Places.size(); ++i)
        {
          sums[row.Places[i]] += weight * row.Weights[i];
        }
      }
      return { sums.begin(), sums.end() };
    }
  };

  vtkIdType CountTetrahedra()
  {
    const vtkIdType layers = 1 + 3 * vtkIdType(this->Made->Layers);
    vtkIdType count = 0;
    for (vtkIdType cell = 0; cell < this->Mesh.GetNumberOfCells(); ++cell)
    {
      const CellShape& type = GetCellShape(this->Mesh.GetCellType(cell));
      const bool isDivided = this->FindForm(cell).Shape;
      for (int face = 0; isDivided && face < type.NumberOfFaces; ++face)
      {
        const int corners = type.FaceOffsets[face + 1] - type.FaceOffsets[face];
        count += (corners - 2) * vtkIdType(this->Parts) * this->Parts * layers;
      }
    }
    return count;
  }

  Form FindForm(vtkIdType cell)
  {
    const unsigned char type = this->Mesh.GetCellType(cell);
    const bool isToDivide = GetCellShape(type).IsHigherOrder && this->Made->Level > 0 &&
      (this->Made->Level > 1 || this->Extents == Extent::Cells || !this->ByNodes.IsCurved(cell)) &&
      !this->Mesh.IsRational(cell);
    if (!isToDivide)
    {
      return {};
    }
    const auto key = std::make_tuple(
      type, static_cast<int>(this->Mesh.GetCellPoints(cell).Size), this->Mesh.GetDegrees(cell));
    if (key != this->LastKey)
    {
      this->LastShape = ParametricShape::Find(std::get<0>(key), std::get<1>(key), std::get<2>(key));
      this->LastKey = key;
    }
    const CollapsedShape* const collapsed = this->LastShape ? this->Collapsed.Find(cell) : nullptr;
    return { collapsed ? &collapsed->GetShape() : this->LastShape, collapsed };
  }

  // Of a collapsed cell without those that follow themselves around a face.
  void RemoveRepeated(const Form& form, std::vector<int>& corners) const
  {
    const auto isSame = [&](int a, int b) { return form.GetCorner(a) == form.GetCorner(b); };
    corners.erase(std::unique(corners.begin(), corners.end(), isSame), corners.end());
    if (corners.size() > 1 && isSame(corners.front(), corners.back()))
    {
      corners.pop_back();
    }
  }

  void AddCell(vtkIdType cell, const Form& form)
  {
    SubdividedFacets& made = *this->Made;
    made.First.resize(static_cast<std::size_t>(this->Mesh.GetNumberOfCells()), -1);
    made.First[cell] = static_cast<std::int64_t>(made.Facets.size());
    const CellShape& type = GetCellShape(this->Mesh.GetCellType(cell));
    std::vector<int> corners(static_cast<std::size_t>(type.NumberOfCorners));
    if (type.Dimension == 2)
    {
      for (int i = 0; i < type.NumberOfCorners; ++i)
      {
        corners[i] = i;
      }
      this->RemoveRepeated(form, corners);
      made.Facets.push_back(this->MakeFacet(cell, form, corners).Triangles);
      return;
    }
    const FacetTable& table = this->Topology.GetFaces();
    const FacetTable::Range uses = table.GetCellFacets(cell);
    this->Surface.clear();
    for (int local = 0; local < type.NumberOfFaces; ++local)
    {
      const CellFacet use = uses[local];
      if (this->Extents == Extent::Boundary && !table.IsBoundary(use.Facet()))
      {
        made.Facets.emplace_back();
        continue;
      }
      corners.assign(
        type.FacePoints + type.FaceOffsets[local], type.FacePoints + type.FaceOffsets[local + 1]);
      this->RemoveRepeated(form, corners);
      if (corners.size() < 3)
      {
        made.Facets.emplace_back();
        continue;
      }
      const auto [known, isNew] = this->Known.try_emplace(use.Facet());
      if (isNew)
      {
        known->second = this->MakeFacet(cell, form, corners);
        known->second.Triangles.IsReversed = use.IsReversed();
      }
      Facet facet = known->second.Triangles;
      facet.IsReversed = facet.IsReversed != use.IsReversed();
      made.Facets.push_back(facet);
      this->AddToSurface(cell, known->second);
    }
    if (this->Extents == Extent::Cells)
    {
      this->FillCell(cell, form);
    }
  }

  struct DividedFacet
  {
    Facet Triangles;
    std::vector<vtkIdType> Vertices;
    std::vector<vtkIdType> Lattice; // in rows of Parts + 1; -1 beyond a triangle
  };

  // A point of the lattice of a face of the current cell.
  struct SurfacePoint
  {
    vtkIdType Point;
    int Face, Place;
    bool operator<(const SurfacePoint& other) const { return this->Point < other.Point; }
    bool operator==(const SurfacePoint& other) const { return this->Point == other.Point; }
  };

  void AddToSurface(vtkIdType cell, const DividedFacet& facet)
  {
    if (this->Extents != Extent::Cells)
    {
      return;
    }
    // The corners of this cell in the order of the lattice, which may be of another cell.
    if (this->Surface.empty())
    {
      this->FacesOfSurface.clear();
    }
    const IndexRange nodes = this->Mesh.GetCellPoints(cell);
    std::vector<int> corners;
    for (const vtkIdType vertex : facet.Vertices)
    {
      int corner = 0;
      while (nodes[corner] != vertex)
      {
        ++corner;
      }
      corners.push_back(corner);
    }
    const auto face = static_cast<int>(this->FacesOfSurface.size());
    this->FacesOfSurface.push_back(corners);
    for (std::size_t i = 0; i < facet.Lattice.size(); ++i)
    {
      if (facet.Lattice[i] >= 0)
      {
        this->Surface.push_back({ facet.Lattice[i], face, static_cast<int>(i) });
      }
    }
  }

  // Adds the points inside of a cell whose faces are known.
  void FillCell(vtkIdType cell, const Form& form)
  {
    SubdividedFacets& made = *this->Made;
    made.Insides.resize(made.First.size(), -1);
    made.Insides[cell] = this->Mesh.GetNumberOfPoints() + made.GetNumberOfNewPoints();
    std::sort(this->Surface.begin(), this->Surface.end());
    this->Surface.erase(
      std::unique(this->Surface.begin(), this->Surface.end()), this->Surface.end());
    for (int layer = 1; layer <= made.Layers; ++layer)
    {
      for (const SurfacePoint& point : this->Surface)
      {
        const std::vector<int>& mixtures = this->GetMixtures(
          form, this->FacesOfSurface[static_cast<std::size_t>(point.Face)], layer);
        made.NewPoints.push_back({ cell, mixtures[static_cast<std::size_t>(point.Place)] });
      }
    }
    made.NewPoints.push_back({ cell, this->GetMixtures(form, { 0, 1 }, made.Layers + 1)[0] });
  }

  // The points of the lattice of an edge or face, moved toward the center to a layer.
  const std::vector<int>& GetMixtures(const Form& form, const std::vector<int>& corners, int layer)
  {
    std::vector<int>& mixtures = this->Mixtures[{ form.Shape, form.Collapsed, corners, layer }];
    std::vector<int> ofShape;
    for (const int corner : corners)
    {
      ofShape.push_back(form.GetCorner(corner));
    }
    const double inside = static_cast<double>(layer) / (this->Made->Layers + 1);
    const int rows = corners.size() == 2 ? 1 : this->Parts + 1;
    for (int j = mixtures.empty() ? 0 : rows; j < rows; ++j)
    {
      for (int i = 0; i <= this->Parts; ++i)
      {
        MixedCorners mixed = MixCorners(
          ofShape, static_cast<double>(i) / this->Parts, static_cast<double>(j) / this->Parts);
        for (auto& corner : mixed)
        {
          corner.second *= 1 - inside;
        }
        const int numberOfCorners = form.Shape->NumberOfCorners;
        for (int corner = 0; layer > 0 && corner < numberOfCorners; ++corner)
        {
          mixed.emplace_back(corner, inside / numberOfCorners);
        }
        mixtures.push_back(this->AddMixture(form.GetWeights(mixed)));
      }
    }
    return mixtures;
  }

  int AddMixture(const std::vector<std::pair<int, double>>& nodes)
  {
    SubdividedFacets& made = *this->Made;
    for (const auto& [node, weight] : nodes)
    {
      made.MixtureNodes.push_back(node);
      made.MixtureWeights.push_back(weight);
    }
    made.MixtureEnds.push_back(static_cast<int>(made.MixtureNodes.size()));
    return static_cast<int>(made.MixtureEnds.size()) - 1;
  }

  // A new point, or the node that is there.
  vtkIdType AddPoint(vtkIdType cell, int mixture)
  {
    SubdividedFacets& made = *this->Made;
    const int begin = mixture > 0 ? made.MixtureEnds[mixture - 1] : 0;
    if (made.MixtureEnds[mixture] == begin + 1)
    {
      return this->Mesh.GetCellPoints(cell)[made.MixtureNodes[begin]];
    }
    made.NewPoints.push_back({ cell, mixture });
    return this->Mesh.GetNumberOfPoints() + made.GetNumberOfNewPoints() - 1;
  }

  // The point after so many parts of an edge between two corners of a cell. Edges of several cells
  // are the same if they have the same ends and the same nodes between.
  vtkIdType GetOnEdge(vtkIdType cell, const Form& form, int from, int to, int part)
  {
    const IndexRange nodes = this->Mesh.GetCellPoints(cell);
    const vtkIdType ends[2] = { nodes[from], nodes[to] };
    if (part == 0 || part == this->Parts)
    {
      return ends[part == 0 ? 0 : 1];
    }
    if (ends[0] > ends[1])
    {
      return this->GetOnEdge(cell, form, to, from, this->Parts - part);
    }
    const std::vector<int>& mixtures = this->GetMixtures(form, { from, to }, 0);
    const int middle = mixtures[static_cast<std::size_t>(this->Parts / 2)];
    vtkIdType between = -1;
    for (int i = middle > 0 ? this->Made->MixtureEnds[middle - 1] : 0;
      i < this->Made->MixtureEnds[middle]; ++i)
    {
      const vtkIdType node = nodes[this->Made->MixtureNodes[i]];
      between = node == ends[0] || node == ends[1] ? between : std::max(between, node);
    }
    const auto [known, isNew] =
      this->EdgePoints.try_emplace(std::make_tuple(ends[0], ends[1], between));
    for (int i = 1; isNew && i < this->Parts; ++i)
    {
      known->second.push_back(this->AddPoint(cell, mixtures[static_cast<std::size_t>(i)]));
    }
    if (isNew)
    {
      const auto half = static_cast<std::size_t>(this->Parts / 2);
      this->Made->MiddleParts.push_back({ half > 1 ? known->second[half - 2] : ends[0],
        known->second[half - 1], ends[0], ends[1] });
    }
    return known->second[static_cast<std::size_t>(part - 1)];
  }

  DividedFacet MakeFacet(vtkIdType cell, const Form& form, const std::vector<int>& corners)
  {
    const int n = this->Parts;
    const bool isTriangle = corners.size() == 3;
    DividedFacet made;
    for (const int corner : corners)
    {
      made.Vertices.push_back(this->Mesh.GetCellPoints(cell)[corner]);
    }
    made.Lattice.assign(static_cast<std::size_t>((n + 1) * (n + 1)), -1);
    const auto get = [&](int i, int j) -> vtkIdType&
    { return made.Lattice[static_cast<std::size_t>(j * (n + 1) + i)]; };
    const auto getOnEdge = [&](std::size_t side, int part)
    {
      return this->GetOnEdge(cell, form, corners[side], corners[(side + 1) % corners.size()], part);
    };
    const std::vector<int>& mixtures = this->GetMixtures(form, corners, 0);
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= (isTriangle ? n - j : n); ++i)
      {
        get(i, j) = j == 0           ? getOnEdge(0, i)
          : isTriangle && i + j == n ? getOnEdge(1, j)
          : isTriangle && i == 0     ? getOnEdge(2, n - j)
          : !isTriangle && i == n    ? getOnEdge(1, j)
          : !isTriangle && j == n    ? getOnEdge(2, n - i)
          : i == 0                   ? getOnEdge(3, n - j)
                   : this->AddPoint(cell, mixtures[static_cast<std::size_t>(j * (n + 1) + i)]);
      }
    }
    SubdividedFacets& all = *this->Made;
    made.Triangles.First = static_cast<vtkIdType>(all.Edges.size());
    const auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c, unsigned edges)
    {
      all.Points.insert(all.Points.end(), { a, b, c });
      all.Edges.push_back(static_cast<unsigned char>(edges));
    };
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < (isTriangle ? n - j : n); ++i)
      {
        const unsigned low = j == 0 ? 1u : 0u, left = i == 0 ? 4u : 0u;
        if (isTriangle)
        {
          add(get(i, j), get(i + 1, j), get(i, j + 1), low | (i + j + 1 == n ? 2u : 0u) | left);
          if (i + j + 1 < n)
          {
            add(get(i + 1, j), get(i + 1, j + 1), get(i, j + 1), 0);
          }
          continue;
        }
        add(get(i, j), get(i + 1, j), get(i + 1, j + 1), low | (i + 1 == n ? 2u : 0u));
        add(get(i, j), get(i + 1, j + 1), get(i, j + 1), (j + 1 == n ? 2u : 0u) | left);
      }
    }
    made.Triangles.Count = static_cast<vtkIdType>(all.Edges.size()) - made.Triangles.First;
    return made;
  }

  const MeshView& Mesh;
  const MeshTopology& Topology;
  std::shared_ptr<SubdividedFacets> Made;
  Extent Extents;
  int Parts; // of an edge
  CurvedFacets ByNodes;
  std::tuple<unsigned char, int, CellDegrees> LastKey = {};
  const ParametricShape* LastShape = nullptr;
  std::unordered_map<Index, DividedFacet> Known;
  CollapsedCells Collapsed;
  std::map<std::tuple<const ParametricShape*, const CollapsedShape*, std::vector<int>, int>,
    std::vector<int>>
    Mixtures;
  std::map<std::tuple<vtkIdType, vtkIdType, vtkIdType>, std::vector<vtkIdType>> EdgePoints;
  std::vector<SurfacePoint> Surface;
  std::vector<std::vector<int>> FacesOfSurface;
};

//------------------------------------------------------------------------------
std::shared_ptr<const SubdividedFacets> SubdividedFacets::Make(
  const MeshTopology& topology, int level, Extent extent)
{
  level = std::clamp(level, 0, MaxLevel);
  for (;; --level)
  {
    Builder builder(topology, level, extent);
    const bool good = builder.Build();
    if (good || level <= 1)
    {
      return good ? builder.GetMade() : nullptr;
    }
  }
}

//------------------------------------------------------------------------------
SubdividedFacets::Triangles SubdividedFacets::Get(vtkIdType cell, vtkIdType local) const
{
  const Facet& facet = this->Facets[static_cast<std::size_t>(this->First[cell] + local)];
  return { this->Points.data() + 3 * facet.First, this->Edges.data() + facet.First, facet.Count,
    facet.IsReversed };
}

//------------------------------------------------------------------------------
SubdividedFacets::Stencil SubdividedFacets::GetStencil(vtkIdType newPoint) const
{
  const NewPoint& point = this->NewPoints[newPoint];
  const int begin = point.Mixture > 0 ? this->MixtureEnds[point.Mixture - 1] : 0;
  return { point.Cell, this->MixtureNodes.data() + begin, this->MixtureWeights.data() + begin,
    this->MixtureEnds[point.Mixture] - begin };
}
}
