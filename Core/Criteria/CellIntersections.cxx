// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/CellIntersections.h"

#include "Criteria/CellGeometry.h"
#include "Geometry/BoxTree.h"
#include "Geometry/PolygonTriangulator.h"

#include "vtkBoundingBox.h"

#include <algorithm>
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
// Distance of the segments p + s u and q + t v, s and t from 0 to 1.
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
// Whether the segment from p to q crosses or touches the triangle, and where. One that lies in its plane does not.
bool Crosses(const CellGeometry& cell, const Vector& p, const Vector& q, const Vector& a, const Vector& b,
  const Vector& c, Vector& hit)
{
  const Vector normal = Cross(b - a, c - a);
  const double height = Dot(normal, p - a), depth = Dot(normal, q - a);
  const double zero = cell.GetZeroLength() * Norm(normal);
  if (height * depth > 0 || height == depth || (std::abs(height) <= zero && std::abs(depth) <= zero))
  {
    return false;
  }
  hit = p + (height / (height - depth)) * (q - p);
  constexpr double tolerance = 1e-12; // so that nothing passes between two triangles
  const double least = -tolerance * Norm2(normal);
  return Dot(normal, Cross(b - a, hit - a)) >= least && Dot(normal, Cross(c - b, hit - b)) >= least &&
    Dot(normal, Cross(a - c, hit - c)) >= least;
}

//------------------------------------------------------------------------------
bool HasPoint(const CellTopology& topology, int face, int point)
{
  const int* points = topology.GetFace(face);
  return std::find(points, points + topology.GetFaceSize(face), point) !=
    points + topology.GetFaceSize(face);
}

//------------------------------------------------------------------------------
// Whether a place lies on an edge of a face.
bool IsOnEdge(const CellGeometry& cell, int face, const Vector& place)
{
  const int* ring = cell.GetTopology().GetFace(face);
  const int size = cell.GetTopology().GetFaceSize(face);
  for (int i = 0; i < size; ++i)
  {
    const Vector& p = cell.GetPoint(ring[i]);
    const Vector side = cell.GetPoint(ring[i + 1 < size ? i + 1 : 0]) - p;
    if (cell.IsZeroLength(GetDistance(p, side, place, Vector())))
    {
      return true;
    }
  }
  return false;
}
}

namespace
{
//------------------------------------------------------------------------------
// The edges of a face.
class Ring
{
public:
  Ring(const CellGeometry& cell, int face)
    : Cell(cell)
    , Points(cell.GetTopology().GetFace(face))
    , Size(cell.GetTopology().GetFaceSize(face))
  {
  }
  int GetSize() const { return this->Size; }
  const Vector& GetBegin(int edge) const { return this->Cell.GetPoint(this->Points[edge]); }
  const Vector& GetEnd(int edge) const { return this->GetBegin(edge + 1 < this->Size ? edge + 1 : 0); }

  /// Whether two edges meet other than at their ends.
  bool Meet(int i, int j) const
  {
    const Vector &p = this->GetBegin(i), &pEnd = this->GetEnd(i), &q = this->GetBegin(j), &qEnd = this->GetEnd(j);
    const auto isAt = [&](const Vector& a, const Vector& b) { return this->Cell.IsZeroLength(Norm(a - b)); };
    return !isAt(p, q) && !isAt(p, qEnd) && !isAt(pEnd, q) && !isAt(pEnd, qEnd) &&
      this->Cell.IsZeroLength(GetDistance(p, pEnd - p, q, qEnd - q));
  }

private:
  const CellGeometry& Cell;
  const int* Points;
  int Size;
};

//------------------------------------------------------------------------------
// All in one plane: then what overlaps crosses, be it in a corner.
bool IsFlat(const CellGeometry& cell, int face)
{
  const Vector normal = Unit(cell.GetFaceVector(face));
  const Ring ring(cell, face);
  for (int i = 0; i < ring.GetSize(); ++i)
  {
    if (!cell.IsZeroLength(std::abs(Dot(normal, ring.GetBegin(i) - cell.GetFaceCenter(face)))))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool HasMeetingEdges(const CellGeometry& cell, int face)
{
  const Ring ring(cell, face);
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
        return j < i && ring.Meet(j, i);
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
// Triangles that all run as their face do not overlap. Others may lie above each other where the face is warped.
bool HasIntersectingEdges(const CellGeometry& cell)
{
  const CellTopology& topology = cell.GetTopology();
  thread_local std::vector<Vector> corners;
  thread_local PolygonTriangulator triangulator;
  for (int f = 0; f < topology.GetNumberOfFaces(); ++f)
  {
    const int size = topology.GetFaceSize(f);
    if (size <= 3)
    {
      continue;
    }
    corners.resize(size);
    for (int i = 0; i < size; ++i)
    {
      corners[i] = cell.GetPoint(topology.GetFace(f)[i]);
    }
    triangulator.Cut(corners.data(), size);
    if (!cell.IsZeroArea(triangulator.GetOverlap()) && (HasMeetingEdges(cell, f) || IsFlat(cell, f)))
    {
      return true;
    }
  }
  return false;
}

namespace
{
//------------------------------------------------------------------------------
// Whether an edge that comes to a place on a face ends there at an edge of the face, or passes a point of it. Faces of an
// open cell may do so because they do not share the points at which they meet.
bool Touches(const CellGeometry& cell, const int ends[2], int face, const Vector& place)
{
  const auto isAt = [&](int point) { return cell.IsZeroLength(Norm(cell.GetPoint(point) - place)); };
  const int* ring = cell.GetTopology().GetFace(face);
  return std::any_of(ring, ring + cell.GetTopology().GetFaceSize(face), isAt) ||
    ((isAt(ends[0]) || isAt(ends[1])) && IsOnEdge(cell, face, place));
}

//------------------------------------------------------------------------------
void Add(const Vector& point, vtkBoundingBox& box)
{
  box.AddPoint(point.X, point.Y, point.Z);
}

//------------------------------------------------------------------------------
// Around the triangles about their centres.
std::vector<vtkBoundingBox> GetBoxesOfFaces(const CellGeometry& cell)
{
  const CellTopology& topology = cell.GetTopology();
  std::vector<vtkBoundingBox> boxes(topology.GetNumberOfFaces());
  for (int f = 0; f < topology.GetNumberOfFaces(); ++f)
  {
    Add(cell.GetFaceCenter(f), boxes[f]);
    for (int i = 0; i < topology.GetFaceSize(f); ++i)
    {
      Add(cell.GetPoint(topology.GetFace(f)[i]), boxes[f]);
    }
  }
  return boxes;
}

//------------------------------------------------------------------------------
// A line on a face: an edge, or one from a corner to the centre, where Points are the corner twice.
struct Line
{
  int Points[2];
  Vector End;
};

//------------------------------------------------------------------------------
// Those from corners to centres find faces that cut each other between points that they share. They lie on their face if
// all triangles about the centre look to the same side.
std::vector<Line> GetLines(const CellGeometry& cell)
{
  const CellTopology& topology = cell.GetTopology();
  std::vector<Line> lines;
  lines.reserve(topology.Edges.size() + topology.FacePoints.size());
  for (const CellTopology::Edge& edge : topology.Edges)
  {
    lines.push_back({ { edge.Points[0], edge.Points[1] }, cell.GetPoint(edge.Points[1]) });
  }
  for (int f = 0; f < topology.GetNumberOfFaces(); ++f)
  {
    const int* ring = topology.GetFace(f);
    const int size = topology.GetFaceSize(f);
    const Vector& center = cell.GetFaceCenter(f);
    bool isStar = size > 3; // the lines of a triangle meet nothing that its edges do not
    for (int i = 0; i < size; ++i)
    {
      const Vector triangle = Cross(
        cell.GetPoint(ring[i]) - center, cell.GetPoint(ring[i + 1 < size ? i + 1 : 0]) - center);
      isStar = isStar && Dot(triangle, cell.GetFaceVector(f)) > 0;
    }
    for (int i = 0; isStar && i < size; ++i)
    {
      // A little further, as where faces cross their centres may lie on the others.
      constexpr double further = 1e-6;
      const Vector& corner = cell.GetPoint(ring[i]);
      lines.push_back({ { ring[i], ring[i] }, center + further * (center - corner) });
    }
  }
  return lines;
}
}

//------------------------------------------------------------------------------
bool HasIntersectingFaces(const CellGeometry& cell)
{
  const CellTopology& topology = cell.GetTopology();
  const bool isOpen = std::any_of(topology.Edges.begin(), topology.Edges.end(),
    [](const CellTopology::Edge& edge) { return edge.Uses == 1; });
  const std::vector<vtkBoundingBox> boxes = GetBoxesOfFaces(cell);
  for (const Line& line : GetLines(cell))
  {
    const Vector &p = cell.GetPoint(line.Points[0]), &q = line.End;
    vtkBoundingBox box;
    Add(p, box);
    Add(q, box);
    for (int f = 0; f < topology.GetNumberOfFaces(); ++f)
    {
      if (!box.Intersects(boxes[f]) || HasPoint(topology, f, line.Points[0]) || HasPoint(topology, f, line.Points[1]))
      {
        continue;
      }
      const int* ring = topology.GetFace(f);
      const int size = topology.GetFaceSize(f);
      for (int i = 0; i < size; ++i)
      {
        Vector hit;
        if (Crosses(cell, p, q, cell.GetPoint(ring[i]), cell.GetPoint(ring[i + 1 < size ? i + 1 : 0]),
              cell.GetFaceCenter(f), hit) &&
          !(isOpen && Touches(cell, line.Points, f, hit)))
        {
          return true;
        }
      }
    }
  }
  return false;
}
}
