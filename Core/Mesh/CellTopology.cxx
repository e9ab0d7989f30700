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
  this->FaceNumbers.clear();
  this->Reversed.clear();
  this->NumberOfAddedFaces = 0;
  this->Edges.clear();
  this->HasVertexFigures = false;
}

//------------------------------------------------------------------------------
bool CellTopology::AddFace(const int* points, int size)
{
  const int begin = this->FaceOffsets.back();
  const int number = this->NumberOfAddedFaces++;
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
  this->FaceNumbers.push_back(number);
  this->Reversed.push_back(0);
  return end - begin < size;
}

//------------------------------------------------------------------------------
void CellTopology::FindEdges()
{
  this->Edges.clear();
  this->NextEdges.clear();
  this->FirstEdges.assign(this->NumberOfPoints, -1);
  this->FaceEdges.resize(this->FacePoints.size());
  bool manifold = true, consistent = true;
  const int numberOfFaces = this->GetNumberOfFaces();
  for (int f = 0; f < numberOfFaces; ++f)
  {
    const int begin = this->FaceOffsets[f], end = this->FaceOffsets[f + 1];
    for (int i = begin; i < end; ++i)
    {
      const int a = this->FacePoints[i], b = this->FacePoints[i + 1 < end ? i + 1 : begin];
      // Edges are listed by their smaller point; a low list is short.
      const int low = std::min(a, b), sum = a + b;
      int e = this->FirstEdges[low];
      while (e >= 0 && this->Edges[e].Points[0] + this->Edges[e].Points[1] != sum)
      {
        e = this->NextEdges[e];
      }
      if (e < 0)
      {
        e = static_cast<int>(this->Edges.size());
        this->Edges.push_back({ { a, b }, { f, -1 }, 1, false });
        this->NextEdges.push_back(this->FirstEdges[low]);
        this->FirstEdges[low] = e;
      }
      else
      {
        Edge& edge = this->Edges[e];
        if (++edge.Uses == 2)
        {
          edge.Faces[1] = f;
          edge.Consistent = edge.Points[0] == b;
        }
      }
      this->FaceEdges[i] = e;
    }
  }
  for (const Edge& edge : this->Edges)
  {
    manifold = manifold && edge.Uses == 2;
    consistent = consistent && edge.Consistent;
  }
  this->IsManifold = manifold && numberOfFaces > 0;
  this->IsClosed = numberOfFaces > 0 && (manifold ? consistent : this->IsBalanced());
}

//------------------------------------------------------------------------------
// Whether every edge is run along as often forwards as backwards. Only for the rare non-manifold cell.
bool CellTopology::IsBalanced() const
{
  std::vector<int> balance(this->Edges.size(), 0);
  for (std::size_t i = 0; i < this->FacePoints.size(); ++i)
  {
    const int e = this->FaceEdges[i];
    balance[e] += this->FacePoints[i] == this->Edges[e].Points[0] ? 1 : -1;
  }
  return std::all_of(balance.begin(), balance.end(), [](int difference) { return difference == 0; });
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
  const auto begin = this->FaceOffsets[face], end = this->FaceOffsets[face + 1];
  std::reverse(this->FacePoints.begin() + begin, this->FacePoints.begin() + end);
  // The last edge joins the last point with the first one also when the others run backwards.
  std::reverse(this->FaceEdges.begin() + begin, this->FaceEdges.begin() + end - 1);
  this->Reversed[face] ^= 1;
}

//------------------------------------------------------------------------------
int CellTopology::GetNumberOfReversedFaces() const
{
  return static_cast<int>(std::count(this->Reversed.begin(), this->Reversed.end(), 1));
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
    const int begin = this->FaceOffsets[f], end = this->FaceOffsets[f + 1];
    int previous = this->FaceEdges[end - 1];
    for (int i = begin; i < end; ++i)
    {
      int& first = this->FirstCorners[this->FacePoints[i]];
      this->Corners.push_back({ f, previous, this->FaceEdges[i], first });
      first = static_cast<int>(this->Corners.size()) - 1;
      previous = this->FaceEdges[i];
    }
  }
  this->Spokes.clear();
  this->SpokeOffsets.assign(1, 0);
  this->HasVertexFigures = true;
  for (int point = 0; point < this->NumberOfPoints; ++point)
  {
    const int first = this->FirstCorners[point];
    int numberOfCorners = 0;
    for (int c = first; c >= 0; c = this->Corners[c].NextCorner)
    {
      ++numberOfCorners;
    }
    // The next face comes to the point along the edge on which this one leaves it.
    int corner = first, steps = 0;
    while (corner >= 0 && steps < numberOfCorners)
    {
      this->Spokes.push_back({ this->Corners[corner].PreviousEdge, this->Corners[corner].Face });
      ++steps;
      const int edge = this->Corners[corner].NextEdge;
      for (corner = first; corner >= 0 && this->Corners[corner].PreviousEdge != edge;)
      {
        corner = this->Corners[corner].NextCorner;
      }
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
