// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CellTopology.h"

#include <algorithm>

namespace camaron
{
//------------------------------------------------------------------------------
void CellTopology::Clear()
{
  this->NumberOfPoints = 0;
  this->FaceOffsets.assign(1, 0);
  this->FacePoints.clear();
  this->Edges.clear();
  this->HasVertexFigures = false;
}

//------------------------------------------------------------------------------
bool CellTopology::AddFace(const int* points, int size)
{
  const int begin = this->FaceOffsets.back();
  for (int i = 0; i < size; ++i)
  {
    if (points[i] != points[i > 0 ? i - 1 : size - 1])
    {
      this->FacePoints.push_back(points[i]);
    }
  }
  const int end = static_cast<int>(this->FacePoints.size());
  if (end - begin < 3)
  {
    this->FacePoints.resize(begin);
    return true;
  }
  this->FaceOffsets.push_back(end);
  return end - begin < size;
}

//------------------------------------------------------------------------------
void CellTopology::FindEdges()
{
  this->Edges.clear();
  this->NextEdges.clear();
  this->FirstEdges.assign(this->NumberOfPoints, -1);
  // How often every edge is run along forwards less how often backwards; Consistent while building.
  bool manifold = true, closed = true;
  const int numberOfFaces = this->GetNumberOfFaces();
  for (int f = 0; f < numberOfFaces; ++f)
  {
    const int* points = this->GetFace(f);
    const int size = this->GetFaceSize(f);
    for (int i = 0; i < size; ++i)
    {
      const int a = points[i], b = points[i + 1 < size ? i + 1 : 0];
      const int low = std::min(a, b), high = std::max(a, b);
      int e = this->FirstEdges[low];
      while (e >= 0 && std::max(this->Edges[e].Points[0], this->Edges[e].Points[1]) != high)
      {
        e = this->NextEdges[e];
      }
      if (e < 0)
      {
        e = static_cast<int>(this->Edges.size());
        this->Edges.push_back({ { a, b }, { f, -1 }, 1, false });
        this->NextEdges.push_back(this->FirstEdges[low]);
        this->FirstEdges[low] = e;
        continue;
      }
      Edge& edge = this->Edges[e];
      if (++edge.Uses == 2)
      {
        edge.Faces[1] = f;
        edge.Consistent = edge.Points[0] == b;
      }
      else
      {
        manifold = false;
      }
    }
  }
  for (const Edge& edge : this->Edges)
  {
    manifold = manifold && edge.Uses == 2;
    closed = closed && edge.Uses == 2 && edge.Consistent;
  }
  if (!manifold)
  {
    // Rare: count the directions along every edge.
    closed = true;
    std::vector<int> balance(this->Edges.size(), 0);
    for (int f = 0; f < numberOfFaces; ++f)
    {
      const int* points = this->GetFace(f);
      const int size = this->GetFaceSize(f);
      for (int i = 0; i < size; ++i)
      {
        const int a = points[i], b = points[i + 1 < size ? i + 1 : 0];
        int e = this->FirstEdges[std::min(a, b)];
        while (std::max(this->Edges[e].Points[0], this->Edges[e].Points[1]) != std::max(a, b))
        {
          e = this->NextEdges[e];
        }
        balance[e] += a < b ? 1 : -1;
      }
    }
    for (const int difference : balance)
    {
      closed = closed && difference == 0;
    }
  }
  this->IsManifold = manifold && numberOfFaces > 0;
  this->IsClosed = closed && numberOfFaces > 0;
}

//------------------------------------------------------------------------------
void CellTopology::MakeConsistent()
{
  const int numberOfFaces = this->GetNumberOfFaces();
  this->Groups.assign(numberOfFaces, -1);
  this->NumberOfGroups = 0;
  // Edges by face, as a list per face through the edge table, would cost more than this: the loop runs
  // only for cells whose faces disagree.
  for (int first = 0; first < numberOfFaces; ++first)
  {
    if (this->Groups[first] >= 0)
    {
      continue;
    }
    const int group = this->NumberOfGroups++;
    this->Groups[first] = group;
    this->Stack.assign(1, first);
    while (!this->Stack.empty())
    {
      const int face = this->Stack.back();
      this->Stack.pop_back();
      for (Edge& edge : this->Edges)
      {
        if (edge.Uses != 2 || (edge.Faces[0] != face && edge.Faces[1] != face))
        {
          continue;
        }
        const int other = edge.Faces[0] == face ? edge.Faces[1] : edge.Faces[0];
        if (this->Groups[other] < 0)
        {
          if (!edge.Consistent)
          {
            this->ReverseFace(other);
            for (Edge& touched : this->Edges)
            {
              const bool first0 = touched.Faces[0] == other, second0 = touched.Faces[1] == other;
              if (touched.Uses == 2 && first0 != second0)
              {
                touched.Consistent = !touched.Consistent;
              }
            }
          }
          this->Groups[other] = group;
          this->Stack.push_back(other);
        }
      }
    }
  }
  this->FindEdges();
}

//------------------------------------------------------------------------------
void CellTopology::MakeOneGroup()
{
  this->Groups.assign(this->GetNumberOfFaces(), 0);
  this->NumberOfGroups = 1;
}

//------------------------------------------------------------------------------
void CellTopology::ReverseFace(int face)
{
  std::reverse(this->FacePoints.begin() + this->FaceOffsets[face],
    this->FacePoints.begin() + this->FaceOffsets[face + 1]);
}

//------------------------------------------------------------------------------
void CellTopology::ReverseFaces(int group)
{
  for (int f = 0; f < this->GetNumberOfFaces(); ++f)
  {
    if (this->Groups[f] == group)
    {
      this->ReverseFace(f);
    }
  }
  for (Edge& edge : this->Edges)
  {
    if (this->Groups[edge.Faces[0]] == group)
    {
      std::swap(edge.Points[0], edge.Points[1]);
    }
  }
}

//------------------------------------------------------------------------------
void CellTopology::MakeVertexFigures()
{
  this->FirstCorners.assign(this->NumberOfPoints, -1);
  this->Corners.clear();
  for (int f = 0; f < this->GetNumberOfFaces(); ++f)
  {
    const int* points = this->GetFace(f);
    const int size = this->GetFaceSize(f);
    for (int i = 0; i < size; ++i)
    {
      const int point = points[i];
      const int previous = points[i > 0 ? i - 1 : size - 1], next = points[i + 1 < size ? i + 1 : 0];
      this->Corners.push_back({ f, previous, next, this->FirstCorners[point] });
      this->FirstCorners[point] = static_cast<int>(this->Corners.size()) - 1;
    }
  }
  this->Spokes.clear();
  this->SpokeOffsets.assign(1, 0);
  this->HasVertexFigures = true;
  for (int point = 0; point < this->NumberOfPoints; ++point)
  {
    // The face that follows across the edge to `Next` runs along it backwards: it comes from there.
    int numberOfCorners = 0;
    for (int c = this->FirstCorners[point]; c >= 0; c = this->Corners[c].NextCorner)
    {
      ++numberOfCorners;
    }
    const int first = this->FirstCorners[point];
    int corner = first, steps = 0;
    while (corner >= 0 && steps < numberOfCorners)
    {
      this->Spokes.push_back({ this->Corners[corner].Previous, this->Corners[corner].Face });
      const int next = this->Corners[corner].Next;
      for (corner = first; corner >= 0 && this->Corners[corner].Previous != next;)
      {
        corner = this->Corners[corner].NextCorner;
      }
      ++steps;
      if (corner == first)
      {
        break;
      }
    }
    this->HasVertexFigures =
      this->HasVertexFigures && steps == numberOfCorners && (numberOfCorners == 0 || corner == first);
    this->SpokeOffsets.push_back(static_cast<int>(this->Spokes.size()));
  }
}
}
