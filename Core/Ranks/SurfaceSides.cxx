// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/SurfaceSides.h"

#include "Base/DisjointSets.h"
#include "Cell/CellNeighborhood.h"
#include "Geometry/Bounds.h"
#include "Ranks/LinkedComponents.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camaron
{
namespace
{
// A fraction with 90 bits in parts of 30 bits, which allow 2^32 additions without rounding.
struct FixedSum
{
  static constexpr int NumberOfParts = 3;
  static constexpr int Bits = 30;
  std::int64_t Parts[NumberOfParts] = {};

  /// |@a value| is at most 1.
  void Add(double value)
  {
    for (std::int64_t& part : this->Parts)
    {
      value = std::ldexp(value, Bits);
      const double whole = std::trunc(value);
      part += static_cast<std::int64_t>(whole);
      value -= whole;
    }
  }
  void Add(const FixedSum& other)
  {
    for (int i = 0; i < NumberOfParts; ++i)
    {
      this->Parts[i] += other.Parts[i];
    }
  }
  bool IsNegative() const
  {
    std::int64_t carry = 0;
    for (int i = NumberOfParts - 1; i > 0; --i)
    {
      carry = (this->Parts[i] + carry) >> Bits; // rounds down
    }
    return this->Parts[0] + carry < 0;
  }
};

// A connected component within one piece.
struct Component
{
  FixedSum Volume;
  bool IsOpen = false;
  bool IsUnknown = false;
};

//------------------------------------------------------------------------------
class SideFinder
{
public:
  SideFinder(const std::vector<LinkedPiece>& pieces, camaron::Reducer& reducer)
    : Pieces(pieces)
    , Reducer(reducer)
  {
  }

  std::vector<SurfaceSides> Find()
  {
    this->FindBox();
    for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
    {
      this->Components.emplace_back();
      if (HasCellsOfDimension(this->Pieces[piece].Topology->GetMesh(), 2))
      {
        this->FindComponents(this->Pieces[piece], this->Components.back());
      }
    }
    const LinkedComponents linked(
      this->Pieces, this->Components, static_cast<Index>(this->All.size()), this->Reducer);
    const std::vector<SurfaceSide> sides = this->Decide(linked);
    std::vector<SurfaceSides> result;
    for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
    {
      result.emplace_back();
      const vtkIdType size = this->Pieces[piece].Topology->GetMesh().GetNumberOfCells();
      result.back().OfCells.assign(size, SurfaceSide::None);
      for (vtkIdType cell = 0; cell < static_cast<vtkIdType>(this->Components[piece].size());
        ++cell)
      {
        const Index component = this->Components[piece][cell];
        result.back().OfCells[cell] = component >= 0 ? sides[component]
          : component == Copy                        ? SurfaceSide::Unknown
                                                     : SurfaceSide::None;
      }
    }
    return result;
  }

private:
  static constexpr Index NoPolygon = -1;
  static constexpr Index Copy = -2;

  //----------------------------------------------------------------------------
  // The corner that volumes are relative to, and a power of two above all of them.
  void FindBox()
  {
    std::vector<Bounds> boxes(1);
    const auto finite = [](double x)
    { return std::isfinite(x) ? x : std::numeric_limits<double>::quiet_NaN(); }; // adds nothing
    for (const LinkedPiece& piece : this->Pieces)
    {
      const MeshView& mesh = piece.Topology->GetMesh();
      for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
      {
        if (piece.IsCopy(cell) || GetCellShape(mesh.GetCellType(cell)).Dimension != 2)
        {
          continue;
        }
        for (const vtkIdType point : mesh.GetCellPoints(cell))
        {
          const Vector x = mesh.GetPoint(point);
          boxes[0].Add(Vector{ finite(x.X), finite(x.Y), finite(x.Z) });
        }
      }
    }
    Bounds whole;
    for (const Bounds& box : this->Reducer.GatherItems(boxes))
    {
      whole.Add(box);
    }
    this->Corner = whole.Low;
    const Vector size = whole.High - whole.Low;
    const double length = std::max({ size.X, size.Y, size.Z });
    int exponent = 0;
    std::frexp(length > 0 && std::isfinite(length) ? length : 1.0, &exponent);
    this->Exponent = exponent + 1;
  }

  //----------------------------------------------------------------------------
  // The volume of the cone from the corner to a polygon, as a fraction of that of the box.
  double GetShare(const CellGeometry& cell) const
  {
    const int ofCell = cell.GetLengthExponent() - this->Exponent;
    const Vector to = TimesPowerOfTwo(cell.GetOrigin() - this->Corner, -this->Exponent) +
      TimesPowerOfTwo(cell.GetFaceCenter(0), ofCell);
    const Vector area = TimesPowerOfTwo(cell.GetFaceVector(0), 2 * ofCell);
    const double share = Dot(to, area) / 3;
    return std::abs(share) <= 1 ? share : 0;
  }

  //----------------------------------------------------------------------------
  // Sets the component of every cell; numbers continue those of previous pieces.
  void FindComponents(const LinkedPiece& piece, std::vector<Index>& components)
  {
    const MeshView& mesh = piece.Topology->GetMesh();
    const FacetTable& edges = piece.Topology->GetSurfaceEdges();
    const FacetLinks* links = piece.Options.Links ? &piece.Options.Links->Edges : nullptr;
    const auto numberOfCells = static_cast<Index>(mesh.GetNumberOfCells());
    DisjointSets surfaces(static_cast<std::size_t>(numberOfCells));
    std::vector<unsigned char> isOpen(numberOfCells), isUnknown(numberOfCells);
    std::vector<Index> cells;
    for (Index cell = 0; cell < numberOfCells; ++cell)
    {
      if (piece.IsCopy(cell))
      {
        continue;
      }
      surfaces.Insert(cell);
      for (const CellFacet edge : edges.GetCellFacets(cell))
      {
        edges.GetCells(edge.Facet(), cells);
        int others = -1, copies = 0; // the first is the cell itself
        bool isOpposite = true;
        for (const Index other : cells)
        {
          if (piece.IsCopy(other))
          {
            ++copies;
            continue;
          }
          ++others;
          if (other != cell)
          {
            surfaces.Insert(other);
            surfaces.Join(cell, other);
            for (const CellFacet theirs : edges.GetCellFacets(other))
            {
              isOpposite = isOpposite &&
                (theirs.Facet() != edge.Facet() || theirs.IsReversed() != edge.IsReversed());
            }
          }
        }
        if (links)
        {
          links->ForEach(edge.Facet(),
            [&](const LinkedCell&, bool isReversed)
            {
              ++others;
              isOpposite = isOpposite && isReversed != edge.IsReversed();
            });
        }
        const bool mayHaveOther = copies > 0 || piece.Options.IsPieceWithoutGhosts;
        isUnknown[cell] |= others == 0 && mayHaveOther;
        isOpen[cell] |= (others == 0 && !mayHaveOther) || others > 1 || !isOpposite;
      }
    }

    components.assign(numberOfCells, NoPolygon);
    CellGeometry geometry;
    for (Index cell = 0; cell < numberOfCells; ++cell)
    {
      if (edges.GetCellFacets(cell).size() == 0)
      {
        continue;
      }
      if (piece.IsCopy(cell))
      {
        components[cell] = Copy;
        continue;
      }
      const vtkIdType first = surfaces.Find(cell);
      if (first == cell)
      {
        components[cell] = static_cast<Index>(this->All.size());
        this->All.emplace_back();
      }
      components[cell] = components[first];
      Component& component = this->All[components[cell]];
      component.IsOpen = component.IsOpen || isOpen[cell];
      component.IsUnknown = component.IsUnknown || isUnknown[cell];
      geometry.Load(mesh, cell, piece.Options);
      geometry.Normalize();
      if (geometry.IsFinite() && geometry.GetTopology().GetNumberOfFaces() > 0)
      {
        geometry.Compute(NeedsFaces);
        component.Volume.Add(this->GetShare(geometry));
      }
    }
  }

  //----------------------------------------------------------------------------
  // The side of every component.
  std::vector<SurfaceSide> Decide(const LinkedComponents& linked)
  {
    const auto add = [](Component& surface, const Component& part)
    {
      surface.Volume.Add(part.Volume);
      surface.IsOpen = surface.IsOpen || part.IsOpen;
      surface.IsUnknown = surface.IsUnknown || part.IsUnknown;
    };
    std::vector<SurfaceSide> sides;
    for (const Component& surface : linked.Combine(this->All, add))
    {
      sides.push_back(surface.IsOpen    ? SurfaceSide::None
          : surface.IsUnknown           ? SurfaceSide::Unknown
          : surface.Volume.IsNegative() ? SurfaceSide::Inward
                                        : SurfaceSide::Outward);
    }
    return sides;
  }

  const std::vector<LinkedPiece>& Pieces;
  camaron::Reducer& Reducer;
  Vector Corner;
  int Exponent = 0;
  std::vector<std::vector<Index>> Components; // for the cells of each piece, indices into All
  std::vector<Component> All;                 // of all pieces of this rank
};
}

//------------------------------------------------------------------------------
std::vector<SurfaceSides> FindSurfaceSides(const std::vector<LinkedPiece>& pieces, Reducer& reducer)
{
  return SideFinder(pieces, reducer).Find();
}
}
