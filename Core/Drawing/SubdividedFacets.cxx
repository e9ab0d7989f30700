// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/SubdividedFacets.h"

#include "Curved/CellMap.h"
#include "Drawing/CurvedFacets.h"
#include "Mesh/CellShape.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace camaron
{
namespace
{
// A point of a facet as a combination of its vertices.
using Mixture = std::vector<std::pair<int, double>>;

//------------------------------------------------------------------------------
// The place of a point of the lattice of a triangle or quadrilateral.
Mixture MixVertices(const std::vector<int>& vertices, double u, double v)
{
  if (vertices.size() == 3)
  {
    return { { vertices[0], 1 - u - v }, { vertices[1], u }, { vertices[2], v } };
  }
  return { { vertices[0], (1 - u) * (1 - v) }, { vertices[1], u * (1 - v) }, { vertices[2], u * v },
    { vertices[3], (1 - u) * v } };
}
}

//------------------------------------------------------------------------------
class SubdividedFacets::Builder
{
public:
  Builder(const MeshTopology& topology, int level)
    : Mesh(topology.GetMesh())
    , Topology(topology)
    , Made(std::make_shared<SubdividedFacets>())
    , Parts(1 << level)
    , ByNodes(topology.GetMesh())
  {
    this->Made->Level = level;
  }

  std::shared_ptr<const SubdividedFacets> Build()
  {
    CellMap map;
    for (vtkIdType cell = 0; cell < this->Mesh.GetNumberOfCells(); ++cell)
    {
      if (this->IsToDivide(cell) && map.Load(this->Mesh, cell, 0) && map.IsCurved())
      {
        this->AddCell(cell, map.GetShape());
      }
    }
    return this->Made->First.empty() && !this->Made->AreStraight() ? nullptr : this->Made;
  }

private:
  bool IsToDivide(vtkIdType cell) const
  {
    return GetCellShape(this->Mesh.GetCellType(cell)).IsHigherOrder && this->Made->Level > 0 &&
      (this->Made->Level > 1 || !this->ByNodes.IsCurved(cell));
  }

  void AddCell(vtkIdType cell, const ParametricShape& shape)
  {
    SubdividedFacets& made = *this->Made;
    made.First.resize(static_cast<std::size_t>(this->Mesh.GetNumberOfCells()), -1);
    made.Centers.resize(made.First.size(), -1);
    made.First[cell] = static_cast<std::int64_t>(made.Facets.size());
    const CellShape& type = GetCellShape(this->Mesh.GetCellType(cell));
    const IndexRange nodes = this->Mesh.GetCellPoints(cell);
    std::vector<int> vertices(static_cast<std::size_t>(type.NumberOfCorners));
    if (type.Dimension == 2)
    {
      for (int i = 0; i < type.NumberOfCorners; ++i)
      {
        vertices[i] = i;
      }
      made.Facets.push_back(this->MakeFacet(shape, nodes, vertices));
      return;
    }
    made.Centers[cell] = this->AddPoint(nodes, this->GetCenter(shape));
    const FacetTable::Range uses = this->Topology.GetFaces().GetCellFacets(cell);
    for (int local = 0; local < type.NumberOfFaces; ++local)
    {
      vertices.assign(
        type.FacePoints + type.FaceOffsets[local], type.FacePoints + type.FaceOffsets[local + 1]);
      const CellFacet use = uses[local];
      const auto [known, isNew] = this->Known.try_emplace(use.Facet());
      if (isNew)
      {
        known->second = this->MakeFacet(shape, nodes, vertices);
        known->second.IsReversed = use.IsReversed();
      }
      Facet facet = known->second;
      facet.IsReversed = facet.IsReversed != use.IsReversed();
      made.Facets.push_back(facet);
    }
  }

  const Mixture& GetCenter(const ParametricShape& shape)
  {
    Mixture& center = this->Centers[&shape];
    if (center.empty())
    {
      Mixture corners;
      for (int corner = 0; corner < shape.NumberOfCorners; ++corner)
      {
        corners.emplace_back(corner, 1.0 / shape.NumberOfCorners);
      }
      center = shape.GetWeights(corners);
    }
    return center;
  }

  // A new point, or the node that is there.
  vtkIdType AddPoint(const IndexRange& nodes, const Mixture& ofNodes)
  {
    SubdividedFacets& made = *this->Made;
    if (ofNodes.size() == 1)
    {
      return nodes[ofNodes[0].first];
    }
    for (const auto& [node, weight] : ofNodes)
    {
      made.StencilPoints.push_back(nodes[node]);
      made.StencilWeights.push_back(weight);
    }
    made.StencilEnds.push_back(static_cast<vtkIdType>(made.StencilPoints.size()));
    return this->Mesh.GetNumberOfPoints() + made.GetNumberOfNewPoints() - 1;
  }

  // The nodes of the points of the lattice of an edge or face, which many cells have.
  const std::vector<Mixture>& GetLattice(
    const ParametricShape& shape, const std::vector<int>& vertices)
  {
    std::vector<Mixture>& lattice = this->Lattices[{ &shape, vertices }];
    const bool isEdge = vertices.size() == 2;
    for (int j = 0; lattice.empty() && j <= (isEdge ? 0 : this->Parts); ++j)
    {
      for (int i = 0; i <= this->Parts; ++i)
      {
        const double u = static_cast<double>(i) / this->Parts;
        const double v = static_cast<double>(j) / this->Parts;
        this->Scratch.push_back(
          shape.GetWeights(isEdge ? Mixture{ { vertices[0], 1 - u }, { vertices[1], u } }
                                  : MixVertices(vertices, u, v)));
      }
    }
    if (lattice.empty())
    {
      lattice.swap(this->Scratch);
    }
    return lattice;
  }

  // The point after so many parts of an edge between two vertices of a cell. Edges of several cells
  // are the same if they have the same ends and the same nodes between.
  vtkIdType GetOnEdge(
    const ParametricShape& shape, const IndexRange& nodes, int from, int to, int part)
  {
    const vtkIdType ends[2] = { nodes[from], nodes[to] };
    if (ends[0] > ends[1])
    {
      return this->GetOnEdge(shape, nodes, to, from, this->Parts - part);
    }
    const std::vector<Mixture>& lattice = this->GetLattice(shape, { from, to });
    vtkIdType middle = -1;
    for (const auto& [node, weight] : lattice[static_cast<std::size_t>(this->Parts / 2)])
    {
      const bool isBetween = node != from && node != to;
      middle = isBetween ? std::max<vtkIdType>(middle, nodes[node]) : middle;
    }
    const auto [known, isNew] =
      this->EdgePoints.try_emplace(std::make_tuple(ends[0], ends[1], middle));
    for (int i = 1; isNew && i < this->Parts; ++i)
    {
      known->second.push_back(this->AddPoint(nodes, lattice[static_cast<std::size_t>(i)]));
    }
    return known->second[static_cast<std::size_t>(part - 1)];
  }

  Facet MakeFacet(
    const ParametricShape& shape, const IndexRange& nodes, const std::vector<int>& vertices)
  {
    const int n = this->Parts;
    const std::vector<Mixture>& inside = this->GetLattice(shape, vertices);
    const bool isTriangle = vertices.size() == 3;
    std::vector<vtkIdType> lattice(static_cast<std::size_t>((n + 1) * (n + 1)), -1);
    const auto get = [&](int i, int j) -> vtkIdType& { return lattice[j * (n + 1) + i]; };
    const auto getOnEdge = [&](int side, int part)
    {
      const int from = vertices[side], to = vertices[(side + 1) % vertices.size()];
      return part == 0 ? nodes[from]
        : part == n    ? nodes[to]
                       : this->GetOnEdge(shape, nodes, from, to, part);
    };
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
                                     : this->AddPoint(nodes, inside[j * (n + 1) + i]);
      }
    }
    SubdividedFacets& made = *this->Made;
    Facet facet;
    facet.First = static_cast<vtkIdType>(made.Edges.size());
    const auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c, unsigned edges)
    {
      made.Points.insert(made.Points.end(), { a, b, c });
      made.Edges.push_back(static_cast<unsigned char>(edges));
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
    facet.Count = static_cast<vtkIdType>(made.Edges.size()) - facet.First;
    return facet;
  }

  const MeshView& Mesh;
  const MeshTopology& Topology;
  std::shared_ptr<SubdividedFacets> Made;
  int Parts; // of an edge
  CurvedFacets ByNodes;
  std::unordered_map<Index, Facet> Known;
  std::map<std::pair<const ParametricShape*, std::vector<int>>, std::vector<Mixture>> Lattices;
  std::vector<Mixture> Scratch;
  std::map<const ParametricShape*, Mixture> Centers;
  std::map<std::tuple<vtkIdType, vtkIdType, vtkIdType>, std::vector<vtkIdType>> EdgePoints;
};

//------------------------------------------------------------------------------
std::shared_ptr<const SubdividedFacets> SubdividedFacets::Make(
  const MeshTopology& topology, int level)
{
  return Builder(topology, std::clamp(level, 0, MaxLevel)).Build();
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
  const vtkIdType begin = newPoint > 0 ? this->StencilEnds[newPoint - 1] : 0;
  return { this->StencilPoints.data() + begin, this->StencilWeights.data() + begin,
    this->StencilEnds[newPoint] - begin };
}
}
