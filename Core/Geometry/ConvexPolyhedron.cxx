// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/ConvexPolyhedron.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

namespace camaron
{
namespace
{
constexpr std::size_t NumberOfReports = 100;
constexpr std::size_t MaxInOrder = 1000; // for fewer half-spaces, any order is fast enough
}

//------------------------------------------------------------------------------
void ConvexPolyhedron::Clear()
{
  this->Points.clear();
  this->Faces.clear();
  this->Corners.clear();
  this->Neighbors.clear();
}

//------------------------------------------------------------------------------
void ConvexPolyhedron::SetBox(const Vector& low, const Vector& high)
{
  this->Clear();
  for (int corner = 0; corner < 8; ++corner)
  {
    this->Points.push_back(
      { corner & 1 ? high.X : low.X, corner & 2 ? high.Y : low.Y, corner & 4 ? high.Z : low.Z });
  }
  for (int face = 0; face < 6; ++face)
  {
    this->Faces.push_back({ 4 * face, 4, -1, 0, -1 });
  }
  this->Corners = { 0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6 };
  this->Neighbors = { 2, 5, 3, 4, 4, 3, 5, 2, 4, 1, 5, 0, 0, 5, 1, 4, 0, 3, 1, 2, 2, 1, 3, 0 };
}

//------------------------------------------------------------------------------
bool ConvexPolyhedron::Clip(const std::vector<HalfSpace>& halfSpaces, double tolerance,
  const std::function<bool(double)>& goesOn)
{
  this->HalfSpaces = &halfSpaces;
  this->Tolerance = tolerance;
  this->Step = 0;
  this->Marks.assign(this->Points.size(), Mark{ -1, 0, -1 });
  this->Shuffle(halfSpaces.size());
  this->StartConflicts();
  const std::size_t size = halfSpaces.size(), part = size / NumberOfReports + 1;
  for (std::size_t i = 0; i < size && !this->IsEmpty(); ++i)
  {
    if (i % part == 0 && !goesOn(static_cast<double>(i) / size))
    {
      return false;
    }
    if (this->Conflicts[this->Order[i]] >= 0)
    {
      this->CutOff(this->Order[i]);
    }
  }
  this->DropUnused();
  return true;
}

//------------------------------------------------------------------------------
void ConvexPolyhedron::Shuffle(std::size_t size)
{
  this->Order.resize(size);
  std::iota(this->Order.begin(), this->Order.end(), 0);
  std::uint64_t random = 1;
  for (std::size_t i = size > MaxInOrder ? size : 0; i-- > 1;)
  {
    random = random * 6364136223846793005u + 1442695040888963407u; // Knuth, MMIX
    std::swap(this->Order[i], this->Order[(random >> 33) % (i + 1)]);
  }
}

//------------------------------------------------------------------------------
void ConvexPolyhedron::StartConflicts()
{
  for (Face& face : this->Faces)
  {
    face.FirstConflict = -1;
    face.Step = 0;
    face.HalfSpace = -1;
  }
  const std::size_t size = this->HalfSpaces->size();
  this->Conflicts.assign(size, -1);
  this->NextConflicts.resize(size);
  for (std::size_t h = 0; h < size; ++h)
  {
    for (int face = 0; face < this->GetNumberOfFaces(); ++face)
    {
      if (this->AddConflict(face, static_cast<int>(h)))
      {
        break;
      }
    }
  }
}

//------------------------------------------------------------------------------
// Returns false if the face has no point outside of the half-space.
bool ConvexPolyhedron::AddConflict(int face, int halfSpace)
{
  Face& of = this->Faces[face];
  const HalfSpace& plane = (*this->HalfSpaces)[halfSpace];
  const int* points = this->Corners.data() + of.Begin;
  if (std::none_of(points, points + of.Size,
        [&](int p) { return plane.GetDistance(this->Points[p]) > this->Tolerance; }))
  {
    return false;
  }
  this->NextConflicts[halfSpace] = of.FirstConflict;
  of.FirstConflict = halfSpace;
  this->Conflicts[halfSpace] = face;
  return true;
}

//------------------------------------------------------------------------------
void ConvexPolyhedron::CutOff(int halfSpace)
{
  ++this->Step;
  if (!this->FindFacesToCut(halfSpace))
  {
    this->Clear();
    return;
  }
  this->Cuts.clear();
  this->Rim.clear();
  for (const int face : this->Affected)
  {
    this->ClipFace(face);
  }
  const int firstNewFace = this->GetNumberOfFaces();
  this->CloseHole(halfSpace);
  this->MoveConflicts(halfSpace, firstNewFace);
}

//------------------------------------------------------------------------------
// From the conflict of the half-space on, across all edges that are not inside of it. Returns false
// if no point is inside.
bool ConvexPolyhedron::FindFacesToCut(int halfSpace)
{
  const HalfSpace& plane = (*this->HalfSpaces)[halfSpace];
  bool hasInside = false;
  const auto isInside = [&](int point)
  {
    Mark& mark = this->Marks[point];
    if (mark.Step != this->Step)
    {
      mark = { this->Step, plane.GetDistance(this->Points[point]), -1 };
    }
    return mark.Distance < -this->Tolerance;
  };
  this->Affected.assign(1, this->Conflicts[halfSpace]);
  this->Faces[this->Affected[0]].Step = this->Step;
  for (std::size_t i = 0; i < this->Affected.size(); ++i)
  {
    const Face& face = this->Faces[this->Affected[i]];
    bool wasInside = isInside(this->Corners[face.Begin + face.Size - 1]);
    for (int corner = face.Begin; corner < face.Begin + face.Size; ++corner)
    {
      const bool isNowInside = isInside(this->Corners[corner]);
      const int neighbor =
        this->Neighbors[corner > face.Begin ? corner - 1 : face.Begin + face.Size - 1];
      if (!(wasInside && isNowInside) && this->Faces[neighbor].Step != this->Step)
      {
        this->Faces[neighbor].Step = this->Step;
        this->Affected.push_back(neighbor);
      }
      hasInside = hasInside || isNowInside;
      wasInside = isNowInside;
    }
  }
  return hasInside;
}

//------------------------------------------------------------------------------
// Faces without a point inside are removed: they are in the plane, where the new face comes, or
// outside of it.
void ConvexPolyhedron::ClipFace(int id)
{
  Face& face = this->Faces[id];
  const int* points = this->Corners.data() + face.Begin;
  const int* neighbors = this->Neighbors.data() + face.Begin;
  if (std::none_of(points, points + face.Size,
        [&](int p) { return this->Marks[p].Distance < -this->Tolerance; }))
  {
    face.Size = 0;
    return;
  }
  this->Ring.clear();
  this->RingNeighbors.clear();
  for (int i = 0; i < face.Size; ++i)
  {
    const int here = points[i], there = points[i + 1 < face.Size ? i + 1 : 0];
    const double distance = this->Marks[here].Distance, next = this->Marks[there].Distance;
    if (distance <= this->Tolerance)
    {
      this->Ring.push_back(here);
      this->RingNeighbors.push_back(neighbors[i]);
    }
    if ((distance < -this->Tolerance && next > this->Tolerance) ||
      (distance > this->Tolerance && next < -this->Tolerance))
    {
      this->Ring.push_back(distance < next ? this->AddCut(here, there) : this->AddCut(there, here));
      this->RingNeighbors.push_back(neighbors[i]);
    }
  }
  const int size = static_cast<int>(this->Ring.size());
  if (size > face.Size)
  {
    face.Begin = static_cast<int>(this->Corners.size());
    this->Corners.resize(face.Begin + size);
    this->Neighbors.resize(face.Begin + size);
  }
  face.Size = size;
  std::copy(this->Ring.begin(), this->Ring.end(), this->Corners.begin() + face.Begin);
  std::copy(
    this->RingNeighbors.begin(), this->RingNeighbors.end(), this->Neighbors.begin() + face.Begin);
  const auto isOn = [&](int p) { return this->Marks[p].Distance >= -this->Tolerance; };
  for (int i = 0; i < size; ++i)
  {
    const int here = this->Ring[i], there = this->Ring[i + 1 < size ? i + 1 : 0];
    if (isOn(here) && isOn(there))
    {
      this->Rim.push_back({ there, here, id, face.Begin + i });
    }
  }
}

//------------------------------------------------------------------------------
int ConvexPolyhedron::AddCut(int inside, int outside)
{
  for (int cut = this->Marks[outside].FirstCut; cut >= 0; cut = this->Cuts[cut].Next)
  {
    if (this->Cuts[cut].Inside == inside)
    {
      return this->Cuts[cut].Point;
    }
  }
  const double low = this->Marks[inside].Distance, high = this->Marks[outside].Distance;
  const int id = static_cast<int>(this->Points.size());
  this->Points.push_back(
    this->Points[inside] + (low / (low - high)) * (this->Points[outside] - this->Points[inside]));
  this->Marks.push_back({ this->Step, 0, -1 });
  this->Cuts.push_back({ inside, id, this->Marks[outside].FirstCut });
  this->Marks[outside].FirstCut = static_cast<int>(this->Cuts.size()) - 1;
  return id;
}

//------------------------------------------------------------------------------
// The remaining faces end along the rim, except for edges that two of them share. The rest of the
// rim is closed because the surface was: every point has the same number of incoming and outgoing
// edges.
void ConvexPolyhedron::CloseHole(int halfSpace)
{
  std::sort(this->Rim.begin(), this->Rim.end());
  std::vector<RimEdge>& open = this->OpenRim;
  open.clear();
  for (const RimEdge& edge : this->Rim)
  {
    const RimEdge reversed = { edge.To, edge.From, 0, 0 };
    const auto other = std::lower_bound(this->Rim.begin(), this->Rim.end(), reversed);
    if (other == this->Rim.end() || reversed < *other)
    {
      open.push_back(edge);
    }
    else
    {
      this->Neighbors[edge.Corner] = other->Face;
    }
  }
  this->Used.assign(open.size(), 0);
  for (std::size_t first = 0; first < open.size(); ++first)
  {
    if (this->Used[first])
    {
      continue;
    }
    const int id = this->GetNumberOfFaces();
    const int begin = static_cast<int>(this->Corners.size());
    for (std::size_t edge = first; edge < open.size();)
    {
      this->Used[edge] = 1;
      this->Corners.push_back(open[edge].From);
      this->Neighbors.push_back(open[edge].Face);
      this->Neighbors[open[edge].Corner] = id;
      const int end = open[edge].To;
      if (end == open[first].From)
      {
        break;
      }
      edge = static_cast<std::size_t>(
        std::lower_bound(open.begin(), open.end(), RimEdge{ end, 0, 0, 0 }) - open.begin());
      while (edge < open.size() && open[edge].From == end && this->Used[edge])
      {
        ++edge;
      }
      if (edge < open.size() && open[edge].From != end)
      {
        break;
      }
    }
    this->Faces.push_back(
      { begin, static_cast<int>(this->Corners.size()) - begin, -1, this->Step, halfSpace });
  }
}

//------------------------------------------------------------------------------
// If a cut face has lost all points outside of a half-space, there are others on the new face, or
// none at all: the points outside of a plane are connected.
void ConvexPolyhedron::MoveConflicts(int halfSpace, int firstNewFace)
{
  for (const int face : this->Affected)
  {
    for (int h = std::exchange(this->Faces[face].FirstConflict, -1); h >= 0;)
    {
      const int next = this->NextConflicts[h];
      this->Conflicts[h] = -1;
      bool isPlaced = h == halfSpace || this->AddConflict(face, h);
      for (int f = firstNewFace; !isPlaced && f < this->GetNumberOfFaces(); ++f)
      {
        isPlaced = this->AddConflict(f, h);
      }
      h = next;
    }
  }
}

//------------------------------------------------------------------------------
template <typename Visit>
void ConvexPolyhedron::ForCorners(Visit&& visit)
{
  for (const Face& face : this->Faces)
  {
    for (int corner = face.Begin; corner < face.Begin + face.Size; ++corner)
    {
      visit(corner);
    }
  }
}

//------------------------------------------------------------------------------
void ConvexPolyhedron::DropUnused()
{
  this->NewIds.resize(this->Faces.size());
  int faces = 0;
  for (std::size_t f = 0; f < this->Faces.size(); ++f)
  {
    this->NewIds[f] = faces;
    if (this->Faces[f].Size > 0)
    {
      this->Faces[faces++] = this->Faces[f];
    }
  }
  this->Faces.resize(faces);
  this->ForCorners(
    [this](int corner) { this->Neighbors[corner] = this->NewIds[this->Neighbors[corner]]; });
  this->NewIds.assign(this->Points.size(), -1);
  this->ForCorners([this](int corner) { this->NewIds[this->Corners[corner]] = 0; });
  int points = 0;
  for (std::size_t p = 0; p < this->Points.size(); ++p)
  {
    if (this->NewIds[p] == 0)
    {
      this->Points[points] = this->Points[p];
      this->NewIds[p] = points++;
    }
  }
  this->Points.resize(points);
  this->ForCorners(
    [this](int corner) { this->Corners[corner] = this->NewIds[this->Corners[corner]]; });
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

//------------------------------------------------------------------------------
void ConvexPolygon::SetBox(const Vector& low, const Vector& high)
{
  this->Points = { { low.X, low.Y, 0 }, { high.X, low.Y, 0 }, { high.X, high.Y, 0 },
    { low.X, high.Y, 0 } };
}

//------------------------------------------------------------------------------
void ConvexPolygon::Clip(const HalfSpace& halfPlane, double tolerance)
{
  this->Distances.clear();
  for (const Vector& point : this->Points)
  {
    this->Distances.push_back(halfPlane.GetDistance(point));
  }
  const auto [low, high] = std::minmax_element(this->Distances.begin(), this->Distances.end());
  if (this->Points.empty() || *high <= tolerance)
  {
    return;
  }
  if (*low >= -tolerance)
  {
    this->Points.clear();
    return;
  }
  this->Kept.clear();
  const std::size_t size = this->Points.size();
  for (std::size_t i = 0; i < size; ++i)
  {
    const std::size_t next = i + 1 < size ? i + 1 : 0;
    const double here = this->Distances[i], there = this->Distances[next];
    if (here <= tolerance)
    {
      this->Kept.push_back(this->Points[i]);
    }
    if ((here < -tolerance && there > tolerance) || (here > tolerance && there < -tolerance))
    {
      this->Kept.push_back(
        this->Points[i] + (here / (here - there)) * (this->Points[next] - this->Points[i]));
    }
  }
  std::swap(this->Points, this->Kept);
}

//------------------------------------------------------------------------------
double ConvexPolygon::GetArea() const
{
  double sum = 0;
  for (std::size_t i = 2; i < this->Points.size(); ++i)
  {
    sum += Cross(this->Points[i - 1] - this->Points[0], this->Points[i] - this->Points[0]).Z;
  }
  return 0.5 * sum;
}
}
