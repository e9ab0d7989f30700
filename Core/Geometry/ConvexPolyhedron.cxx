// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/ConvexPolyhedron.h"

#include <algorithm>

namespace camaron
{
//------------------------------------------------------------------------------
void ConvexPolyhedron::Clear()
{
  this->Points.clear();
  this->FaceOffsets.assign(1, 0);
  this->FacePoints.clear();
}

//------------------------------------------------------------------------------
void ConvexPolyhedron::SetBox(const Vector& low, const Vector& high)
{
  this->Points.clear();
  for (int corner = 0; corner < 8; ++corner)
  {
    this->Points.push_back(
      { corner & 1 ? high.X : low.X, corner & 2 ? high.Y : low.Y, corner & 4 ? high.Z : low.Z });
  }
  this->FaceOffsets = { 0, 4, 8, 12, 16, 20, 24 };
  this->FacePoints = { 0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6 };
}

//------------------------------------------------------------------------------
void ConvexPolyhedron::Clip(const HalfSpace& halfSpace, double tolerance)
{
  this->Distances.clear();
  double low = 0, high = 0;
  for (const Vector& point : this->Points)
  {
    const double distance = halfSpace.GetDistance(point);
    this->Distances.push_back(distance);
    low = std::min(low, distance);
    high = std::max(high, distance);
  }
  if (high <= tolerance)
  {
    return;
  }
  if (low >= -tolerance)
  {
    this->Clear();
    return;
  }
  this->Cuts.clear();
  this->FirstCuts.assign(this->Points.size(), -1);
  this->Rim.clear();
  std::swap(this->FaceOffsets, this->OldOffsets);
  std::swap(this->FacePoints, this->OldFaces);
  this->FaceOffsets.assign(1, 0);
  this->FacePoints.clear();
  const int numberOfFaces = static_cast<int>(this->OldOffsets.size()) - 1;
  for (int face = 0; face < numberOfFaces; ++face)
  {
    this->ClipFace(face, tolerance);
  }
  this->CloseHole();
  this->DropUnusedPoints();
}

//------------------------------------------------------------------------------
// Faces without a point inside go: they lie in the plane or outside of it, where the new face
// comes.
void ConvexPolyhedron::ClipFace(int face, double tolerance)
{
  const int* points = this->OldFaces.data() + this->OldOffsets[face];
  const int size = this->OldOffsets[face + 1] - this->OldOffsets[face];
  if (std::none_of(points, points + size, [&](int p) { return this->Distances[p] < -tolerance; }))
  {
    return;
  }
  const auto isOn = [&](int p)
  {
    // Points that this clipping has made lie on the plane and have no distance.
    return p >= static_cast<int>(this->Distances.size()) || this->Distances[p] >= -tolerance;
  };
  const std::size_t begin = this->FacePoints.size();
  for (int i = 0; i < size; ++i)
  {
    const int here = points[i], there = points[i + 1 < size ? i + 1 : 0];
    const double distance = this->Distances[here], next = this->Distances[there];
    if (distance <= tolerance)
    {
      this->FacePoints.push_back(here);
    }
    if (distance < -tolerance && next > tolerance)
    {
      this->FacePoints.push_back(this->AddCut(here, there));
    }
    else if (distance > tolerance && next < -tolerance)
    {
      this->FacePoints.push_back(this->AddCut(there, here));
    }
  }
  const std::size_t end = this->FacePoints.size();
  this->FaceOffsets.push_back(static_cast<int>(end));
  for (std::size_t i = begin; i < end; ++i)
  {
    const int here = this->FacePoints[i], there = this->FacePoints[i + 1 < end ? i + 1 : begin];
    if (isOn(here) && isOn(there))
    {
      this->Rim.emplace_back(here, there);
    }
  }
}

//------------------------------------------------------------------------------
int ConvexPolyhedron::AddCut(int inside, int outside)
{
  for (int cut = this->FirstCuts[outside]; cut >= 0; cut = this->Cuts[cut].Next)
  {
    if (this->Cuts[cut].Inside == inside)
    {
      return this->Cuts[cut].Point;
    }
  }
  const double low = this->Distances[inside], high = this->Distances[outside];
  const Vector point =
    this->Points[inside] + (low / (low - high)) * (this->Points[outside] - this->Points[inside]);
  const int id = static_cast<int>(this->Points.size());
  this->Points.push_back(point);
  this->Cuts.push_back({ inside, id, this->FirstCuts[outside] });
  this->FirstCuts[outside] = static_cast<int>(this->Cuts.size()) - 1;
  return id;
}

//------------------------------------------------------------------------------
// The faces that were kept end along the rim, but for those of its edges that two of them share.
// What is left of the rim is closed, since the surface was: every point has as many edges out of it
// as into it.
void ConvexPolyhedron::CloseHole()
{
  for (auto& edge : this->Rim)
  {
    std::swap(edge.first, edge.second);
  }
  std::sort(this->Rim.begin(), this->Rim.end());
  const auto find = [&](int from, int to)
  { return std::binary_search(this->Rim.begin(), this->Rim.end(), std::make_pair(from, to)); };
  std::vector<std::pair<int, int>>& open = this->OpenRim;
  open.clear();
  for (const auto& edge : this->Rim)
  {
    if (!find(edge.second, edge.first))
    {
      open.push_back(edge);
    }
  }
  this->Used.assign(open.size(), 0);
  for (std::size_t first = 0; first < open.size(); ++first)
  {
    if (this->Used[first])
    {
      continue;
    }
    for (std::size_t edge = first; edge < open.size();)
    {
      this->Used[edge] = 1;
      this->FacePoints.push_back(open[edge].first);
      const int end = open[edge].second;
      if (end == open[first].first)
      {
        break;
      }
      edge = static_cast<std::size_t>(
        std::lower_bound(open.begin(), open.end(), std::make_pair(end, 0)) - open.begin());
      while (edge < open.size() && open[edge].first == end && this->Used[edge])
      {
        ++edge;
      }
      if (edge < open.size() && open[edge].first != end)
      {
        break;
      }
    }
    this->FaceOffsets.push_back(static_cast<int>(this->FacePoints.size()));
  }
}

//------------------------------------------------------------------------------
void ConvexPolyhedron::DropUnusedPoints()
{
  this->NewIds.assign(this->Points.size(), -1);
  for (const int point : this->FacePoints)
  {
    this->NewIds[point] = 0;
  }
  int kept = 0;
  for (std::size_t p = 0; p < this->Points.size(); ++p)
  {
    if (this->NewIds[p] == 0)
    {
      this->Points[kept] = this->Points[p];
      this->NewIds[p] = kept++;
    }
  }
  this->Points.resize(kept);
  for (int& point : this->FacePoints)
  {
    point = this->NewIds[point];
  }
}

//------------------------------------------------------------------------------
double ConvexPolyhedron::GetVolume() const
{
  double sum = 0;
  for (int face = 0; face < this->GetNumberOfFaces(); ++face)
  {
    const int* points = this->GetFace(face);
    const Vector apex = this->Points[points[0]] - this->Points[0];
    for (int i = 2; i < this->GetFaceSize(face); ++i)
    {
      sum += Dot(apex,
        Cross(this->Points[points[i - 1]] - this->Points[0],
          this->Points[points[i]] - this->Points[0]));
    }
  }
  return sum / 6;
}
}
