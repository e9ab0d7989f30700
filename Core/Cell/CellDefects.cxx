// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cell/CellDefects.h"

#include "Base/DisjointSets.h"
#include "Base/Number.h"
#include "Cell/CellGeometry.h"
#include "Cell/FaceRing.h"
#include "Cell/FaceTriangles.h"
#include "Geometry/BoxTree.h"
#include "Geometry/PolygonTriangulator.h"
#include "Mesh/CellTopology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
double Clamp(double value)
{
  return std::min(1.0, std::max(0.0, value));
}

//------------------------------------------------------------------------------
// Distance of the segments p + s u and q + t v, with s and t from 0 to 1.
double GetDistance(const Vector& p, const Vector& u, const Vector& q, const Vector& v)
{
  const Vector w = p - q;
  const double a = Norm2(u), b = Dot(u, v), c = Norm2(v), d = Dot(u, w), e = Dot(v, w);
  const double determinant = a * c - b * b;
  double s = determinant > 0 ? Clamp((b * e - c * d) / determinant) : 0;
  const double t = c > 0 ? Clamp((b * s + e) / c) : 0;
  s = a > 0 ? Clamp((b * t - d) / a) : 0;
  return Norm(w + s * u - t * v);
}

//------------------------------------------------------------------------------
// Whether the segment from p to q crosses or touches the triangle, and where. A segment in the
// plane of the triangle does not.
bool Crosses(const CellGeometry& cell, const Vector& p, const Vector& q, const Vector& a,
  const Vector& b, const Vector& c, Vector& hit)
{
  const Vector normal = Cross(b - a, c - a);
  const double height = Dot(normal, p - a), depth = Dot(normal, q - a);
  const double zero = cell.GetZeroLength() * Norm(normal);
  if (height * depth > 0 || height == depth ||
    (std::abs(height) <= zero && std::abs(depth) <= zero))
  {
    return false;
  }
  hit = p + (height / (height - depth)) * (q - p);
  constexpr double tolerance = 1e-12; // so that no segment passes between two triangles
  const double least = -tolerance * Norm2(normal);
  return Dot(normal, Cross(b - a, hit - a)) >= least &&
    Dot(normal, Cross(c - b, hit - b)) >= least && Dot(normal, Cross(a - c, hit - c)) >= least;
}

//------------------------------------------------------------------------------
// Whether a position is on an edge of a face.
bool IsOnEdge(const CellGeometry& cell, int face, const Vector& place)
{
  const FaceRing ring(cell, face);
  for (int i = 0; i < ring.GetSize(); ++i)
  {
    const Vector side = ring.GetEnd(i) - ring.GetBegin(i);
    if (cell.IsZeroLength(GetDistance(ring.GetBegin(i), side, place, Vector())))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// Whether two edges intersect other than at their ends.
bool Meet(const CellGeometry& cell, const FaceRing& ring, int i, int j)
{
  const Vector &p = ring.GetBegin(i), &pEnd = ring.GetEnd(i), &q = ring.GetBegin(j),
               &qEnd = ring.GetEnd(j);
  const auto isAt = [&](const Vector& a, const Vector& b)
  { return cell.IsZeroLength(Norm(a - b)); };
  return !isAt(p, q) && !isAt(p, qEnd) && !isAt(pEnd, q) && !isAt(pEnd, qEnd) &&
    cell.IsZeroLength(GetDistance(p, pEnd - p, q, qEnd - q));
}

//------------------------------------------------------------------------------
bool HasMeetingEdges(const CellGeometry& cell, const FaceRing& ring)
{
  const int size = ring.GetSize();
  std::vector<Bounds> boxes(size);
  for (int i = 0; i < size; ++i)
  {
    boxes[i].Add(ring.GetBegin(i));
    boxes[i].Add(ring.GetEnd(i));
    boxes[i].Grow(cell.GetZeroLength());
  }
  BoxTree tree;
  tree.Build(boxes);
  for (int i = 0; i < size; ++i)
  {
    const bool meets = tree.FindAny([&](const Bounds& box) { return box.Meets(boxes[i]); },
      [&](std::size_t place)
      {
        const auto j = static_cast<int>(tree.GetOrder()[place]);
        return j < i && Meet(cell, ring, j, i);
      });
    if (meets)
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
// Triangles with the orientation of their face do not overlap. Others may overlap if the face is
// warped.
bool HasIntersectingEdges(const CellGeometry& cell)
{
  const CellTopology& topology = cell.GetTopology();
  thread_local std::vector<Vector> corners;
  thread_local PolygonTriangulator triangulator;
  for (int f = 0; f < topology.GetNumberOfFaces(); ++f)
  {
    const FaceRing ring(cell, f);
    if (ring.GetSize() <= 3)
    {
      continue;
    }
    ring.GetCorners(corners);
    triangulator.Cut(corners.data(), ring.GetSize());
    if (!cell.IsZeroArea(triangulator.GetOverlap()) &&
      (HasMeetingEdges(cell, ring) || ring.IsFlat()))
    {
      return true;
    }
  }
  return false;
}

namespace
{
//------------------------------------------------------------------------------
// Whether an edge that meets a face at a position ends there at an edge of the face, or passes one
// of its points. This is allowed for faces of an open cell that do not share the points where they
// meet.
bool Touches(const CellGeometry& cell, const int ends[2], int face, const Vector& place)
{
  const auto isAt = [&](int point)
  { return cell.IsZeroLength(Norm(cell.GetPoint(point) - place)); };
  const int* ring = cell.GetTopology().GetFace(face);
  return std::any_of(ring, ring + cell.GetTopology().GetFaceSize(face), isAt) ||
    ((isAt(ends[0]) || isAt(ends[1])) && IsOnEdge(cell, face, place));
}
}

//------------------------------------------------------------------------------
bool HasIntersectingFaces(const CellGeometry& cell)
{
  const CellTopology& topology = cell.GetTopology();
  const bool isOpen = std::any_of(topology.Edges.begin(), topology.Edges.end(),
    [](const CellTopology::Edge& edge) { return edge.Uses == 1; });
  thread_local FaceTriangles faces;
  faces.Load(cell);
  return std::any_of(faces.GetLines().begin(), faces.GetLines().end(),
    [&](const FaceLine& line)
    {
      return faces.FindAny(cell, line,
        [&](int face, const FaceTriangles::Triangle& triangle)
        {
          Vector hit;
          return Crosses(cell, cell.GetPoint(line.Points[0]), line.End, triangle[0], triangle[1],
                   triangle[2], hit) &&
            !(isOpen && Touches(cell, line.Points, face, hit));
        });
    });
}

//------------------------------------------------------------------------------
// Corners of faces are connected if they are at the same end of an edge.
bool HasPinchedPoints(const CellTopology& topology)
{
  const std::size_t size = topology.FacePoints.size();
  DisjointSets groups(size);
  std::vector<std::array<int, 2>> firstCorners(topology.Edges.size(), { -1, -1 }); // at both ends
  const auto join = [&](int edge, int corner)
  {
    int& first =
      firstCorners[edge][topology.FacePoints[corner] == topology.Edges[edge].Points[0] ? 0 : 1];
    first = first < 0 ? corner : first;
    groups.Join(first, corner);
  };
  for (std::size_t corner = 0; corner < size; ++corner)
  {
    groups.Insert(static_cast<vtkIdType>(corner));
  }
  for (int face = 0; face < topology.GetNumberOfFaces(); ++face)
  {
    const int begin = topology.FaceOffsets[face], end = topology.FaceOffsets[face + 1];
    for (int corner = begin; corner < end; ++corner)
    {
      join(topology.FaceEdges[corner], corner);
      join(topology.FaceEdges[corner], corner + 1 < end ? corner + 1 : begin);
    }
  }
  std::vector<vtkIdType> groupsOfPoints(topology.NumberOfPoints, -1);
  for (std::size_t corner = 0; corner < size; ++corner)
  {
    const vtkIdType group = groups.Find(static_cast<vtkIdType>(corner));
    vtkIdType& known = groupsOfPoints[topology.FacePoints[corner]];
    if (known >= 0 && known != group)
    {
      return true;
    }
    known = group;
  }
  return false;
}

//------------------------------------------------------------------------------
double GetFaceFlatness(const CellGeometry& cell, int face)
{
  // The triangles of a self-intersecting face may have a negative sum.
  const double fan = cell.GetFanArea(face);
  return fan > 0 ? std::min(1.0, cell.GetFaceArea(face) / fan) : 0;
}

//------------------------------------------------------------------------------
double GetFaceWarpage(const CellGeometry& cell, int face)
{
  const CellTopology& topology = cell.GetTopology();
  if (topology.GetFaceSize(face) == 3)
  {
    return 0;
  }
  const Vector normal = Unit(cell.GetFaceVector(face));
  double height = 0, radius = 0;
  for (int i = 0; i < topology.GetFaceSize(face); ++i)
  {
    const Vector offset = cell.GetPoint(topology.GetFace(face)[i]) - cell.GetFaceCenter(face);
    height = std::max(height, std::abs(Dot(normal, offset)));
    radius = std::max(radius, Norm2(offset));
  }
  return height / std::sqrt(radius);
}

//------------------------------------------------------------------------------
double GetFaceConcavity(const CellGeometry& cell, int face)
{
  const AngleRange& angles = cell.GetFaceAngles(face);
  return angles.IsEmpty() ? angles.GetMax() : std::max(0.0, angles.GetMax() - Pi);
}
}
