// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/CellMesh/RoundingMargin.h"

#include "Base/Number.h"

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Whether all cells of a type have the same edges, between vertices in the order of CellShape.
bool IsStandard(const CellShape& shape, unsigned char type)
{
  return shape.Dimension >= 2 && shape.NumberOfCorners > 0 && type != VTK_PIXEL;
}
}

//------------------------------------------------------------------------------
// Sizes of two cells, from the rings of points around their faces, or from their edges. Lengths
// that are NaN are ignored, volumes are not.
class RoundingMargin::Extent
{
public:
  /// @param at(point) the position of a point relative to a point of the cell
  template <typename At, typename Point>
  void AddRing(At&& at, const Point* ring, vtkIdType size)
  {
    const VectorPair first = at(ring[0]);
    VectorPair last = first;
    this->Farthest2 = Max(Norm2(first), this->Farthest2);
    for (vtkIdType i = 1; i < size; ++i)
    {
      const VectorPair next = at(ring[i]);
      this->Shortest2 = Min(Norm2(next - last), this->Shortest2);
      this->Farthest2 = Max(Norm2(next), this->Farthest2);
      if (i > 1)
      {
        this->Volume = this->Volume + Dot(first, Cross(last, next));
        ++this->NumberOfTriangles;
      }
      last = next;
    }
    this->Shortest2 = Min(Norm2(first - last), this->Shortest2);
  }

  /**
   * Whether both cells are safe. Their points move by at most s, so that the length of an edge
   * changes by at most 2 s. A triangle whose points are at most D away from the origin contributes
   * to six times the volume the determinant of their positions, each of which changes by at most
   * 2 s: (D + 2 s)^3 - D^3, which is little more than 6 s D^2, because edges, and so D, are a
   * hundred times as long as s. Twice as much, and the volumes that are regarded as zero, leave
   * room for this and for rounding here.
   * @param origins of the positions
   */
  bool IsSafe(const VectorPair& origins, int dimension, const Limits& least) const
  {
    constexpr double Flat = 4e-12; // relative to the cube of the size
    const Pair farthest = Sqrt(this->Farthest2), greatest = Norm(origins) + farthest;
    const Pair shift = least.Shift.Relative * greatest + least.Shift.Absolute;
    const Pair edge = least.ShiftsPerEdge * shift;
    auto areSafe = (this->Shortest2 > edge * edge) & (greatest < least.Shift.Greatest + Pair{});
    if (dimension == 3)
    {
      areSafe &= Abs(this->Volume) >
        this->Farthest2 * (12. * this->NumberOfTriangles * shift + Flat * farthest);
    }
    return (areSafe[0] & areSafe[1]) != 0;
  }

private:
  Pair Shortest2 = MakePair(Infinity, Infinity); ///< squared length of the shortest edge
  Pair Farthest2 = {};                           ///< squared distance of the farthest point
  Pair Volume = {};                              ///< six times the volume inside the rings
  int NumberOfTriangles = 0;
};

//------------------------------------------------------------------------------
RoundingMargin::RoundingMargin(const MeshView& mesh, const Rounding& rounding, double maxChange)
  : Mesh(mesh)
  , Facets(mesh)
  , Shapes(&GetCellShape(0))
{
  this->Least.Shift = rounding;
  this->Least.Shift.Absolute *= std::sqrt(3.); // of all coordinates
  constexpr double Room = 1.01;                // for rounding in criteria
  this->Least.ShiftsPerEdge = 2 * Room / maxChange;
}

//------------------------------------------------------------------------------
bool RoundingMargin::AreSafe(vtkIdType begin, vtkIdType end)
{
  bool areSafe = true;
  for (vtkIdType cell = begin; cell < end && areSafe;)
  {
    const unsigned char type = this->Mesh.GetCellType(cell);
    if (!IsStandard(this->Shapes[type], type))
    {
      areSafe = this->IsOtherSafe(cell);
      ++cell;
      continue;
    }
    const bool isPair = cell + 1 < end && this->Mesh.GetCellType(cell + 1) == type;
    areSafe = this->ArePairSafe(this->Shapes[type], this->Mesh.GetCellPoints(cell),
      this->Mesh.GetCellPoints(isPair ? cell + 1 : cell));
    cell += isPair ? 2 : 1;
  }
  return areSafe;
}

//------------------------------------------------------------------------------
// For two standard cells of the same type.
bool RoundingMargin::ArePairSafe(
  const CellShape& shape, const IndexRange& first, const IndexRange& second)
{
  const Vector a = this->Mesh.GetPoint(first[0]), b = this->Mesh.GetPoint(second[0]);
  for (int i = 0; i < shape.NumberOfCorners; ++i)
  {
    this->Corners[i] =
      VectorPair(this->Mesh.GetPoint(first[i]) - a, this->Mesh.GetPoint(second[i]) - b);
  }
  const auto at = [this](int corner) { return this->Corners[corner]; };
  Extent extent;
  for (int f = 0; f < shape.NumberOfFaces; ++f)
  {
    extent.AddRing(
      at, shape.FacePoints + shape.FaceOffsets[f], shape.FaceOffsets[f + 1] - shape.FaceOffsets[f]);
  }
  if (shape.Dimension == 2)
  {
    constexpr int ring[] = { 0, 1, 2, 3 };
    extent.AddRing(at, ring, shape.NumberOfCorners);
  }
  return extent.IsSafe(VectorPair(a, b), shape.Dimension, this->Least);
}

//------------------------------------------------------------------------------
// For a cell with edges of its own, in both halves of a pair.
bool RoundingMargin::IsOtherSafe(vtkIdType cell)
{
  const IndexRange points = this->Mesh.GetCellPoints(cell);
  const int dimension = this->Facets.GetDimension(cell);
  Vector origin;
  const auto at = [&](vtkIdType point)
  {
    const Vector place = this->Mesh.GetPoint(point) - origin;
    return VectorPair(place, place);
  };
  Extent extent;
  const auto add = [&](const vtkIdType* ring, vtkIdType size, vtkIdType local)
  {
    origin = local == 0 ? this->Mesh.GetPoint(ring[0]) : origin;
    extent.AddRing(at, ring, size);
  };
  this->Facets.ForEach(cell, add);
  for (vtkIdType i = 0; dimension == 1 && i + 1 < points.Size; ++i)
  {
    const vtkIdType edge[2] = { points[i], points[i + 1] };
    add(edge, 2, i);
  }
  return extent.IsSafe(VectorPair(origin, origin), dimension, this->Least);
}
}
