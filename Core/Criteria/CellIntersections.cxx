// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/CellIntersections.h"

#include "Criteria/CellGeometry.h"

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

//------------------------------------------------------------------------------
// Edges that share a point are next to each other, also if edges of no length lie between them.
bool HasIntersectingEdges(const CellGeometry& cell)
{
  const CellTopology& topology = cell.GetTopology();
  for (int f = 0; f < topology.GetNumberOfFaces(); ++f)
  {
    const int* ring = topology.GetFace(f);
    const int size = topology.GetFaceSize(f);
    for (int i = 0; i + 2 < size; ++i)
    {
      const Vector &p = cell.GetPoint(ring[i]), &pEnd = cell.GetPoint(ring[i + 1]);
      const auto isAt = [&](const Vector& place, int from, int to)
      {
        return std::all_of(ring + from, ring + to,
          [&](int point) { return cell.IsZeroLength(Norm(cell.GetPoint(point) - place)); });
      };
      for (int j = i + 2; j < size; ++j)
      {
        const int a = ring[j], b = ring[j + 1 < size ? j + 1 : 0];
        if (a == ring[i] || a == ring[i + 1] || b == ring[i] || b == ring[i + 1])
        {
          continue;
        }
        const Vector& q = cell.GetPoint(a);
        const bool meet = cell.IsZeroLength(GetDistance(p, pEnd - p, q, cell.GetPoint(b) - q));
        if (meet && !isAt(pEnd, i + 2, j + 1) && !(isAt(p, j + 1, size) && isAt(p, 0, i)))
        {
          return true;
        }
      }
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
