// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/CellTetrahedra.h"

#include "Base/Hash.h"
#include "Base/Parallel.h"
#include "Base/Vector.h"
#include "Drawing/CurvedFacets.h"
#include "Drawing/InwardFaces.h"
#include "Drawing/PolygonTriangles.h"
#include "Geometry/BoxTree.h"
#include "Mesh/MeshView.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <utility>

namespace camaron
{
namespace
{
constexpr vtkIdType BlocksPerGrain = 64;
/// Sine of the angle between a line of sight and a face below which the face is seen edge-on,
/// considering the roundoff of graphics cards.
constexpr double SmallestSine = 1e-6;

vtkIdType GetNumberOfBlocks(const MeshView& mesh)
{
  return (mesh.GetNumberOfCells() + CellTetrahedra::CellsPerBlock - 1) /
    CellTetrahedra::CellsPerBlock;
}

//------------------------------------------------------------------------------
// Calls visit(a, b, c, d, walls, findEdges) for the tetrahedra of a cell.
class TetrahedraOfCell
{
public:
  explicit TetrahedraOfCell(const MeshView& mesh, const SubdividedFacets* subdivided = nullptr)
    : Mesh(mesh)
    , Subdivided(subdivided)
    , Facets(mesh, subdivided)
    , Triangles(mesh)
    , Inward(mesh)
  {
    this->Triangles.SetKeepsFans(true);
  }

  vtkIdType Count(vtkIdType cell)
  {
    if (GetCellShape(this->Mesh.GetCellType(cell)).Dimension != 3 ||
      this->Mesh.GetCellType(cell) == VTK_TETRA)
    {
      return this->Mesh.GetCellType(cell) == VTK_TETRA ? 1 : 0;
    }
    if (this->HasInside(cell))
    {
      vtkIdType triangles = 0;
      this->Facets.ForEachPart(cell, [&](const vtkIdType*, vtkIdType) { ++triangles; });
      return triangles * (1 + 3 * this->Subdivided->GetInside(cell).Layers);
    }
    const vtkIdType apex = this->FindApex(cell);
    vtkIdType count = 0;
    this->Facets.ForEachPart(cell, [&](const vtkIdType* points, vtkIdType size)
      { count += Has(points, size, apex) ? 0 : std::max<vtkIdType>(size - 2, 0); });
    return count;
  }

  template <typename Visitor>
  void ForEach(vtkIdType cell, Visitor&& visit)
  {
    if (GetCellShape(this->Mesh.GetCellType(cell)).Dimension != 3)
    {
      return;
    }
    if (this->Mesh.GetCellType(cell) == VTK_TETRA)
    {
      const IndexRange points = this->Mesh.GetCellPoints(cell);
      visit(points[0], points[1], points[2], points[3], AllWalls, [] { return AllEdges; });
      return;
    }
    if (this->FindSurface(cell))
    {
      this->ForEachInside(cell, visit);
      return;
    }
    const vtkIdType apex = this->FindApex(cell);
    this->FindEdgesAround(cell, apex);
    this->Facets.ForEachPart(cell,
      [&](const vtkIdType* points, vtkIdType size)
      {
        if (Has(points, size, apex))
        {
          return;
        }
        this->Triangles.ForEach({ points, size, PolygonTriangles::Form::Straight },
          [&](const PolygonTriangles::Triangle& triangle)
          {
            const vtkIdType a = points[triangle.Corners[0]], b = points[triangle.Corners[1]],
                            c = points[triangle.Corners[2]];
            const unsigned int edges = triangle.Edges;
            const std::uint32_t walls = 1 | ((edges & 2) && this->IsAround(b, c)) << 1 |
              ((edges & 4) && this->IsAround(c, a)) << 2 |
              ((edges & 1) && this->IsAround(a, b)) << 3;
            const vtkIdType tetrahedron[4] = { apex, a, b, c };
            visit(apex, a, b, c, walls, [&] { return this->FindEdges(cell, tetrahedron, edges); });
          });
      });
  }

  // Moves the negative tetrahedra of [begin, end), which are all of a cell, to begin; false if
  // there are none.
  bool PutNegativesFirst(
    vtkIdType cell, CellTetrahedra& made, std::uint32_t begin, std::uint32_t end)
  {
    if (this->HasInside(cell))
    {
      return false;
    }
    const std::uint32_t size = end - begin;
    this->Signs.resize(size);
    bool has[2] = { false, false };
    for (std::uint32_t i = 0; i < size; ++i)
    {
      const int sign = this->FindSign(made.Points[begin + i]);
      this->Signs[i] = static_cast<signed char>(sign);
      has[0] |= sign < 0;
      has[1] |= sign > 0;
    }
    if ((!has[0] || !has[1]) && this->RunsConsistently(cell))
    {
      return false; // as for nearly all cells
    }
    this->TurnOutward(cell);
    const auto [least, largest] = std::minmax_element(this->Signs.begin(), this->Signs.end());
    if (*least >= 0 || *largest <= 0)
    {
      return false;
    }
    std::vector<Part> parts;
    for (std::uint32_t i = 0; i < size; ++i)
    {
      parts.push_back({ made.Points[begin + i], made.Cells[begin + i], made.Edges[begin + i] });
    }
    std::vector<std::uint32_t> negatives, order;
    std::vector<Bounds> boxes;
    for (std::uint32_t i = 0; i < size; ++i)
    {
      if (this->Signs[i] < 0)
      {
        negatives.push_back(i);
        boxes.push_back(this->GetBox(parts[i]));
      }
    }
    this->Tree.Build(boxes);
    for (const std::size_t place : this->Tree.GetOrder())
    {
      order.push_back(negatives[place]);
      parts[order.back()].Edges |= CellTetrahedra::Negative;
    }
    for (std::uint32_t i = 0; i < size; ++i)
    {
      if (this->Signs[i] >= 0)
      {
        order.push_back(i);
      }
    }
    for (std::uint32_t i = 0; i < size; ++i)
    {
      made.Points[begin + i] = parts[order[i]].Points;
      made.Cells[begin + i] = parts[order[i]].Cell;
      made.Edges[begin + i] = parts[order[i]].Edges;
    }
    return true;
  }
  /// Whether points inside subdivide a cell.
  bool HasInside(vtkIdType cell) const
  {
    return this->Subdivided && this->Subdivided->Has(cell) &&
      this->Subdivided->GetInside(cell).First >= 0;
  }
  /// The points of the faces of such a cell in the order of their numbers; else a null pointer.
  const std::vector<vtkIdType>* FindSurface(vtkIdType cell)
  {
    if (!this->HasInside(cell))
    {
      return nullptr;
    }
    this->Surface.clear();
    this->Facets.ForEachPart(cell, [this](const vtkIdType* points, vtkIdType size)
      { this->Surface.insert(this->Surface.end(), points, points + size); });
    std::sort(this->Surface.begin(), this->Surface.end());
    this->Surface.erase(
      std::unique(this->Surface.begin(), this->Surface.end()), this->Surface.end());
    return &this->Surface;
  }
  /// Of the last cell with negative tetrahedra.
  const BoxTree& GetTreeOfNegatives() const { return this->Tree; }

private:
  struct Part
  {
    std::array<std::uint32_t, 4> Points;
    std::uint32_t Cell;
    std::uint8_t Edges;
  };
  static constexpr std::uint32_t AllWalls = 15;
  static constexpr std::uint32_t AllEdges = 63;

  static bool Has(const vtkIdType* points, vtkIdType size, vtkIdType point)
  {
    return std::find(points, points + size, point) != points + size;
  }

  // Prisms below the triangles of the faces, layer by layer, then tetrahedra to the center. Prisms
  // are cut by the order of their points, so that those of neighbors match.
  template <typename Visitor>
  void ForEachInside(vtkIdType cell, Visitor&& visit)
  {
    this->FindCurvedEdges(cell);
    const SubdividedFacets::Inside inside = this->Subdivided->GetInside(cell);
    const auto size = static_cast<vtkIdType>(this->Surface.size());
    const vtkIdType center = inside.First + inside.Layers * size;
    const auto get = [&](vtkIdType point, int layer)
    {
      const auto found = std::lower_bound(this->Surface.begin(), this->Surface.end(), point);
      return layer == 0 ? point
                        : inside.First + (layer - 1) * size + (found - this->Surface.begin());
    };
    this->Facets.ForEachPart(cell,
      [&](const vtkIdType* points, vtkIdType)
      {
        vtkIdType s[3] = { points[0], points[1], points[2] };
        const bool isTurned = (s[0] > s[1]) != ((s[0] > s[2]) != (s[1] > s[2]));
        std::sort(s, s + 3);
        const auto pass =
          [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d, int layer, bool isWall)
        {
          // Positive also if sorting has turned the triangle.
          const vtkIdType of[4] = { a, b, isTurned ? d : c, isTurned ? c : d };
          visit(of[0], of[1], of[2], of[3], isWall ? 1u : 0u,
            [&] { return layer == 0 ? this->FindCurvedEdgesOf(of) : 0u; });
        };
        for (int layer = 0; layer < inside.Layers; ++layer)
        {
          vtkIdType out[3], in[3];
          for (int i = 0; i < 3; ++i)
          {
            out[i] = get(s[i], layer);
            in[i] = get(s[i], layer + 1);
          }
          pass(in[2], out[0], out[1], out[2], layer, layer == 0);
          pass(in[2], out[1], out[0], in[1], layer, false);
          pass(out[0], in[1], in[0], in[2], layer, false);
        }
        pass(center, get(s[0], inside.Layers), get(s[1], inside.Layers), get(s[2], inside.Layers),
          inside.Layers, inside.Layers == 0);
      });
  }

  // Bits of the lines between four points that are edges of the cell.
  std::uint32_t FindCurvedEdgesOf(const vtkIdType points[4]) const
  {
    std::uint32_t edges = 0;
    int bit = 0;
    for (int i = 0; i < 4; ++i)
    {
      for (int k = i + 1; k < 4; ++k, ++bit)
      {
        const std::pair<vtkIdType, vtkIdType> edge = std::minmax(points[i], points[k]);
        const bool isEdge = std::find(this->CurvedEdges.begin(), this->CurvedEdges.end(), edge) !=
          this->CurvedEdges.end();
        edges |= std::uint32_t(isEdge) << bit;
      }
    }
    return edges;
  }

  vtkIdType FindApex(vtkIdType cell)
  {
    vtkIdType apex = -1;
    this->Facets.ForEachPart(cell,
      [&](const vtkIdType* points, vtkIdType size)
      {
        const vtkIdType first = size > 0 ? this->Mesh.FindFirstPoint(points, size) : apex;
        apex = apex < 0 || this->Mesh.IsBefore(first, apex) ? first : apex;
      });
    return apex;
  }

  // A triangle from the apex to an edge is part of a face of the cell if that face contains both,
  // and the triangle has the orientation of the face.
  void FindEdgesAround(vtkIdType cell, vtkIdType apex)
  {
    this->Around.clear();
    this->Spokes.clear();
    this->Facets.ForEachPart(cell,
      [&](const vtkIdType* points, vtkIdType size)
      {
        const bool hasApex = Has(points, size, apex);
        const Vector area = hasApex && size > 3 ? this->FindArea(points, size, apex) : Vector();
        for (vtkIdType at = 0; hasApex && at < size; ++at)
        {
          const vtkIdType next = points[at + 1 < size ? at + 1 : 0];
          if (size == 3 || Dot(this->FindArea(points[at], next, apex), area) > 0)
          {
            this->Around.emplace_back(std::minmax(points[at], next));
          }
          if (points[at] == apex || next == apex)
          {
            this->Spokes.push_back(points[at] == apex ? next : points[at]);
          }
        }
      });
    std::sort(this->Around.begin(), this->Around.end());
    this->FindCurvedEdges(cell);
  }
  Vector FindArea(vtkIdType a, vtkIdType b, vtkIdType apex) const
  {
    const Vector origin = this->Mesh.GetPoint(apex);
    return Cross(this->Mesh.GetPoint(a) - origin, this->Mesh.GetPoint(b) - origin);
  }
  Vector FindArea(const vtkIdType* points, vtkIdType size, vtkIdType apex) const
  {
    Vector sum;
    for (vtkIdType i = 0; i < size; ++i)
    {
      sum += this->FindArea(points[i], points[i + 1 < size ? i + 1 : 0], apex);
    }
    return sum;
  }
  bool IsAround(vtkIdType a, vtkIdType b) const
  {
    const std::pair<vtkIdType, vtkIdType> edge = std::minmax(a, b);
    return std::binary_search(this->Around.begin(), this->Around.end(), edge);
  }

  // In a curved cell, some sides of the parts of facets are not edges.
  void FindCurvedEdges(vtkIdType cell)
  {
    this->CurvedEdges.clear();
    if (!this->Facets.IsCurved(cell))
    {
      return;
    }
    const int size = GetCellShape(this->Mesh.GetCellType(cell)).NumberOfFaces;
    for (int facet = 0; facet < size; ++facet)
    {
      const PolygonTriangles::Outline outline = this->Facets.GetOutline(cell, facet);
      this->Triangles.ForEach(outline,
        [&](const PolygonTriangles::Triangle& triangle)
        {
          for (int i = 0; i < 3; ++i)
          {
            if (triangle.Edges & 1u << i)
            {
              this->CurvedEdges.emplace_back(std::minmax(outline.Points[triangle.Corners[i]],
                outline.Points[triangle.Corners[(i + 1) % 3]]));
            }
          }
        });
    }
  }

  // See NegativeBoxes.
  Bounds GetBox(const Part& part) const
  {
    const bool hasSides = (part.Cell & (AllWalls - 1)) != 0;
    Bounds box;
    for (int i = hasSides ? 0 : 1; i < 4; ++i)
    {
      box.Add(this->Mesh.GetPoint(part.Points[i]));
    }
    return box;
  }

  // Sign of the volume for the given order of points; 0 if the apex is in the plane of the others.
  int FindSign(const std::array<std::uint32_t, 4>& points) const
  {
    const Vector apex = this->Mesh.GetPoint(points[0]);
    const Vector a = this->Mesh.GetPoint(points[1]) - apex,
                 b = this->Mesh.GetPoint(points[2]) - apex,
                 c = this->Mesh.GetPoint(points[3]) - apex;
    const Vector normal = Cross(b - a, c - a);
    const double height = Dot(a, normal),
                 least = SmallestSine * std::sqrt(Norm2(a) * Norm2(normal));
    return height > least ? 1 : height < -least ? -1 : 0;
  }

  // Whether faces traverse every edge once in each direction; true results are almost certain.
  bool RunsConsistently(vtkIdType cell)
  {
    if (this->Mesh.GetCellType(cell) != VTK_POLYHEDRON)
    {
      return true;
    }
    std::uint64_t sum = 0;
    this->Facets.ForEachPart(cell,
      [&](const vtkIdType* points, vtkIdType size)
      {
        vtkIdType last = size > 0 ? points[size - 1] : 0;
        for (vtkIdType i = 0; i < size; ++i)
        {
          const vtkIdType ends[2] = { std::min(last, points[i]), std::max(last, points[i]) };
          const std::uint64_t edge = MixHash(MixHash(MixHash(1, ends[0]), ends[1]), 1);
          sum += last < points[i] ? edge : last > points[i] ? 0 - edge : 0;
          last = points[i];
        }
      });
    return sum == 0;
  }

  // Sets the signs that the tetrahedra have if faces are oriented outward.
  void TurnOutward(vtkIdType cell)
  {
    const vtkIdType apex = this->FindApex(cell);
    this->Inward.Clear();
    this->Facets.ForEachPart(
      cell, [&](const vtkIdType* points, vtkIdType size) { this->Inward.AddFace(points, size); });
    const std::vector<unsigned char>& areInward = this->Inward.Find();
    std::size_t face = 0, next = 0;
    this->Facets.ForEachPart(cell,
      [&](const vtkIdType* points, vtkIdType size)
      {
        const bool isInward = areInward[face++] != 0;
        for (vtkIdType i = Has(points, size, apex) ? size : 2; i < size; ++i, ++next)
        {
          this->Signs[next] =
            static_cast<signed char>(isInward ? -this->Signs[next] : this->Signs[next]);
        }
      });
  }

  // Takes the apex and three vertices of a facet; returns which edges of it are between them.
  std::uint32_t FindEdges(vtkIdType cell, const vtkIdType points[4], unsigned int ofFacet) const
  {
    const auto isSpoke = [&](vtkIdType point)
    { return std::find(this->Spokes.begin(), this->Spokes.end(), point) != this->Spokes.end(); };
    std::uint32_t edges = isSpoke(points[1]) | isSpoke(points[2]) << 1 | isSpoke(points[3]) << 2 |
      (ofFacet & 1) << 3 | (ofFacet & 4) << 2 | (ofFacet & 2) << 4;
    return this->Facets.IsCurved(cell) ? edges & this->FindCurvedEdgesOf(points) : edges;
  }

  const MeshView& Mesh;
  const SubdividedFacets* Subdivided;
  CurvedFacets Facets;
  PolygonTriangles Triangles;
  std::vector<std::pair<vtkIdType, vtkIdType>> Around;
  std::vector<std::pair<vtkIdType, vtkIdType>> CurvedEdges;
  std::vector<vtkIdType> Spokes; ///< where edges from the apex end
  std::vector<vtkIdType> Surface;
  InwardFaces Inward;
  std::vector<signed char> Signs; ///< of the tetrahedra of a cell
  BoxTree Tree;
};

//------------------------------------------------------------------------------
// Calls perBlock(tetrahedra, block, firstCell, endOfCells) in parallel.
template <typename Function>
void ForEachBlock(
  const MeshView& mesh, Function&& perBlock, const SubdividedFacets* subdivided = nullptr)
{
  ParallelFor(GetNumberOfBlocks(mesh), BlocksPerGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      TetrahedraOfCell tetrahedra(mesh, subdivided);
      for (vtkIdType block = begin; block < end; ++block)
      {
        const vtkIdType first = block * CellTetrahedra::CellsPerBlock;
        perBlock(tetrahedra, block, first,
          std::min(mesh.GetNumberOfCells(), first + CellTetrahedra::CellsPerBlock));
      }
    });
}

//------------------------------------------------------------------------------
// Calls visit(block, point) for the points of the cells of all blocks, in parallel, including those
// that subdivide them.
template <typename Visit>
void ForEachPoint(const MeshView& mesh, const SubdividedFacets* subdivided, Visit&& visit)
{
  ForEachBlock(
    mesh,
    [&](TetrahedraOfCell& tetrahedra, vtkIdType block, vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        if (const std::vector<vtkIdType>* const surface = tetrahedra.FindSurface(cell))
        {
          const SubdividedFacets::Inside inside = subdivided->GetInside(cell);
          const vtkIdType size =
            inside.Layers * static_cast<vtkIdType>(surface->size()) + 1; // and the center
          for (vtkIdType point = inside.First; point < inside.First + size; ++point)
          {
            visit(block, point);
          }
          for (const vtkIdType point : *surface)
          {
            visit(block, point);
          }
        }
        const IndexRange points = mesh.GetCellPoints(cell);
        for (vtkIdType i = 0; i < points.Size; ++i)
        {
          visit(block, points[i]);
        }
      }
    },
    subdivided);
}
}

//------------------------------------------------------------------------------
CellTetrahedra MakeCellTetrahedra(const MeshView& mesh, const SubdividedFacets* subdivided)
{
  if (mesh.GetNumberOfCells() >= vtkIdType(1) << (32 - CellTetrahedra::OuterFaceBits))
  {
    throw std::length_error("Cells can only be cut open in pieces of up to 2^28 cells.");
  }
  std::vector<vtkIdType> counts(GetNumberOfBlocks(mesh), 0);
  ForEachBlock(
    mesh,
    [&](TetrahedraOfCell& tetrahedra, vtkIdType block, vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        counts[block] += tetrahedra.Count(cell);
      }
    },
    subdivided);
  CellTetrahedra made;
  made.Blocks.reserve(counts.size() + 1);
  vtkIdType total = 0;
  for (const vtkIdType count : counts)
  {
    made.Blocks.push_back(static_cast<std::uint32_t>(total));
    total += count;
    if (total > vtkIdType(std::numeric_limits<std::uint32_t>::max()))
    {
      throw std::length_error("Isosurfaces can only be drawn in pieces of up to 2^32 tetrahedra.");
    }
  }
  made.Blocks.push_back(static_cast<std::uint32_t>(total));
  made.Points.resize(total);
  made.Cells.resize(total);
  made.Edges.resize(total);
  std::mutex access;
  ForEachBlock(
    mesh,
    [&](TetrahedraOfCell& tetrahedra, vtkIdType block, vtkIdType begin, vtkIdType end)
    {
      std::uint32_t next = made.Blocks[block];
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const std::uint32_t first = next;
        tetrahedra.ForEach(cell,
          [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d, std::uint32_t walls,
            const auto& findEdges)
          {
            made.Points[next] = { { static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
              static_cast<std::uint32_t>(c), static_cast<std::uint32_t>(d) } };
            made.Cells[next] =
              static_cast<std::uint32_t>(cell) << CellTetrahedra::OuterFaceBits | walls;
            made.Edges[next] = static_cast<std::uint8_t>(findEdges());
            ++next;
          });
        if (next - first > 1 && tetrahedra.PutNegativesFirst(cell, made, first, next))
        {
          const std::lock_guard<std::mutex> lock(access);
          made.FirstNegatives.resize(
            mesh.GetNumberOfCells(), { { CellTetrahedra::None, CellTetrahedra::None } });
          made.FirstNegatives[cell] = { { first,
            static_cast<std::uint32_t>(made.NegativeBoxes.size()) } };
          for (const BoxTree::Node& node : tetrahedra.GetTreeOfNegatives().GetNodes())
          {
            made.NegativeBoxes.push_back({ node.Box, static_cast<std::uint32_t>(node.Next),
              static_cast<std::uint32_t>(node.Last) });
          }
        }
      }
    },
    subdivided);
  return made;
}

//------------------------------------------------------------------------------
std::vector<std::array<float, 2>> FindBlockRanges(
  const MeshView& mesh, const std::vector<float>& pointValues, const SubdividedFacets* subdivided)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  std::vector<std::array<float, 2>> ranges(
    GetNumberOfBlocks(mesh), std::array<float, 2>{ { infinity, -infinity } });
  ForEachPoint(mesh, subdivided,
    [&](vtkIdType block, vtkIdType point)
    {
      const float value = pointValues[point];
      std::array<float, 2>& range = ranges[block];
      range[0] = value < range[0] ? value : range[0];
      range[1] = value > range[1] ? value : range[1];
    });
  return ranges;
}

//------------------------------------------------------------------------------
std::vector<std::array<double, 6>> FindBlockBounds(
  const MeshView& mesh, const SubdividedFacets* subdivided)
{
  std::vector<Bounds> boxes(GetNumberOfBlocks(mesh));
  ForEachPoint(mesh, subdivided,
    [&](vtkIdType block, vtkIdType point) { boxes[block].Add(mesh.GetPoint(point)); });
  std::vector<std::array<double, 6>> bounds;
  for (const Bounds& box : boxes)
  {
    const Vector &low = box.Low, &high = box.High;
    const bool isValid = low.X <= high.X && low.Y <= high.Y && low.Z <= high.Z;
    bounds.push_back(isValid
        ? std::array<double, 6>{ { low.X, high.X, low.Y, high.Y, low.Z, high.Z } }
        : std::array<double, 6>{ { 1, -1, 1, -1, 1, -1 } });
  }
  return bounds;
}
}
