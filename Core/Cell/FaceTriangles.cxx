// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cell/FaceTriangles.h"

#include "Cell/FaceRing.h"

#include <cmath>

namespace camaron
{
//------------------------------------------------------------------------------
void FaceTriangles::Load(const CellGeometry& cell)
{
  const CellTopology& topology = cell.GetTopology();
  this->Triangles.clear();
  this->Lines.clear();
  for (const CellTopology::Edge& edge : topology.Edges)
  {
    this->Lines.push_back({ { edge.Points[0], edge.Points[1] }, cell.GetPoint(edge.Points[1]) });
  }
  this->Faces.resize(topology.GetNumberOfFaces());
  this->Boxes.assign(topology.GetNumberOfFaces(), Bounds());
  for (int f = 0; f < topology.GetNumberOfFaces(); ++f)
  {
    this->AddFace(cell, f);
  }
  this->Tree.Build(this->Boxes);
  this->FindFacesOfPoints(topology);
}

//------------------------------------------------------------------------------
void FaceTriangles::AddFace(const CellGeometry& cell, int f)
{
  Face& face = this->Faces[f];
  face.First = this->Triangles.size();
  if (!this->AddStar(cell, f))
  {
    this->AddCut(cell, f);
  }
  face.Last = this->Triangles.size();
  face.IsLarge = face.Last - face.First > FewTriangles;
  this->BoxesOfFace.clear();
  for (std::size_t i = face.First; i < face.Last; ++i)
  {
    this->BoxesOfFace.emplace_back();
    for (const Vector& corner : this->Triangles[i])
    {
      this->BoxesOfFace.back().Add(corner);
    }
    this->Boxes[f].Add(this->BoxesOfFace.back());
  }
  if (face.IsLarge)
  {
    face.Tree.Build(this->BoxesOfFace);
  }
}

//------------------------------------------------------------------------------
// Slightly extended, because the centers of intersecting faces may lie on each other.
void FaceTriangles::AddLine(int corner, const Vector& from, const Vector& middle)
{
  constexpr double further = 1e-6;
  this->Lines.push_back({ { corner, corner }, middle + further * (middle - from) });
}

//------------------------------------------------------------------------------
// Lines from vertices to centers find faces that intersect between shared points; for triangles,
// edges are enough.
bool FaceTriangles::AddStar(const CellGeometry& cell, int face)
{
  const FaceRing ring(cell, face);
  const Vector& center = cell.GetFaceCenter(face);
  const std::size_t first = this->Triangles.size();
  for (int i = 0; i < ring.GetSize(); ++i)
  {
    const Vector triangle = Cross(ring.GetBegin(i) - center, ring.GetEnd(i) - center);
    if (ring.GetSize() > 3 && !(Dot(triangle, cell.GetFaceVector(face)) > 0))
    {
      this->Triangles.resize(first);
      return false;
    }
    this->Triangles.push_back({ { ring.GetBegin(i), ring.GetEnd(i), center } });
  }
  for (int i = 0; ring.GetSize() > 3 && i < ring.GetSize(); ++i)
  {
    this->AddLine(cell.GetTopology().GetFace(face)[i], ring.GetBegin(i), center);
  }
  return true;
}

//------------------------------------------------------------------------------
// In a warped or self-intersecting face, lines between its vertices are not on it.
void FaceTriangles::AddCut(const CellGeometry& cell, int face)
{
  const FaceRing ring(cell, face);
  ring.GetCorners(this->Corners);
  this->Triangulator.Cut(this->Corners.data(), ring.GetSize());
  const bool hasLines = cell.IsZeroArea(this->Triangulator.GetOverlap()) && ring.IsFlat();
  for (const PolygonTriangulator::Triangle& t : this->Triangulator.GetTriangles())
  {
    const Vector &a = this->Corners[t[0]], &b = this->Corners[t[1]], &c = this->Corners[t[2]];
    this->Triangles.push_back({ { a, b, c } });
    const double longest = std::sqrt(std::max({ Norm2(b - a), Norm2(c - b), Norm2(a - c) }));
    if (hasLines && !cell.IsZeroLength(Norm(Cross(b - a, c - a)) / longest))
    {
      for (const int corner : t)
      {
        this->AddLine(
          cell.GetTopology().GetFace(face)[corner], this->Corners[corner], (1.0 / 3) * (a + b + c));
      }
    }
  }
}

//------------------------------------------------------------------------------
void FaceTriangles::FindFacesOfPoints(const CellTopology& topology)
{
  this->FirstFaces.assign(topology.NumberOfPoints + 2, 0);
  for (const int point : topology.FacePoints)
  {
    ++this->FirstFaces[point + 2];
  }
  for (std::size_t point = 2; point < this->FirstFaces.size(); ++point)
  {
    this->FirstFaces[point] += this->FirstFaces[point - 1];
  }
  this->FacesOfPoints.resize(topology.FacePoints.size());
  for (int f = 0; f < topology.GetNumberOfFaces(); ++f)
  {
    for (int i = 0; i < topology.GetFaceSize(f); ++i)
    {
      this->FacesOfPoints[this->FirstFaces[topology.GetFace(f)[i] + 1]++] = f;
    }
  }
}
}
