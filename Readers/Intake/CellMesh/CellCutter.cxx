// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/CellMesh/CellCutter.h"

#include "Intake/FaceMesh/PrimitiveMatcher.h"

#include <algorithm>

namespace camaron
{
//------------------------------------------------------------------------------
CellCutter::CellCutter(const MeshView& mesh)
  : Mesh(mesh)
  , Facets(mesh)
{
}

//------------------------------------------------------------------------------
bool CellCutter::CutPolygon(const vtkIdType* points, vtkIdType size)
{
  this->Triangles.clear();
  this->Corners.resize(size);
  std::transform(points, points + size, this->Corners.begin(),
    [this](vtkIdType id) { return this->GetPlace(id); });
  this->Triangulator.Cut(this->Corners.data(), static_cast<int>(size));
  for (const PolygonTriangulator::Triangle& t : this->Triangulator.GetTriangles())
  {
    this->Triangles.push_back({ points[t[0]], points[t[1]], points[t[2]] });
  }
  constexpr double rounding = 1e-5; // for a polygon that touches itself, in single precision
  return size == 3 ||
    (this->Triangulator.GetArea() > 0 &&
      this->Triangulator.GetOverlap() <= rounding * this->Triangulator.GetArea());
}

//------------------------------------------------------------------------------
double CellCutter::GetVolume(const Tetrahedron& t) const
{
  const Vector origin = this->GetPlace(t[0]);
  return Dot(Cross(this->GetPlace(t[1]) - origin, this->GetPlace(t[2]) - origin),
    this->GetPlace(t[3]) - origin);
}

//------------------------------------------------------------------------------
// Consistent faces traverse every edge once in each direction; where parts of a cell meet, equally
// often.
bool CellCutter::IsConsistent()
{
  std::sort(this->Edges.begin(), this->Edges.end());
  if (std::adjacent_find(this->Edges.begin(), this->Edges.end()) == this->Edges.end())
  {
    return true;
  }
  std::vector<std::pair<vtkIdType, vtkIdType>> reversed;
  for (const auto& [a, b] : this->Edges)
  {
    reversed.emplace_back(b, a);
  }
  std::sort(reversed.begin(), reversed.end());
  return reversed == this->Edges;
}

//------------------------------------------------------------------------------
void CellCutter::CutCell(vtkIdType cell)
{
  this->Tetrahedra.clear();
  this->Triangulator.SetKeepsFans(true);
  vtkIdType apex = -1;
  const bool listsFaces = GetCellShape(this->Mesh.GetCellType(cell)).ListsFaces;
  this->Edges.clear();
  this->Facets.ForEach(cell,
    [&](const vtkIdType* points, vtkIdType size, vtkIdType)
    {
      const vtkIdType first = this->Mesh.FindFirstPoint(points, size);
      apex = apex < 0 || this->Mesh.IsBefore(first, apex) ? first : apex;
      for (vtkIdType i = 0; listsFaces && i < size; ++i)
      {
        this->Edges.emplace_back(points[i], points[i + 1 < size ? i + 1 : 0]);
      }
    });
  const bool consistent = this->IsConsistent();

  this->Facets.ForEach(cell,
    [&](const vtkIdType* points, vtkIdType size, vtkIdType)
    {
      this->Points.assign(points, points + size);
      this->Points.erase(std::unique(this->Points.begin(), this->Points.end()), this->Points.end());
      const auto& ids = this->Points;
      if (std::find(ids.begin(), ids.end(), apex) != ids.end())
      {
        return;
      }
      this->CutPolygon(ids.data(), static_cast<vtkIdType>(ids.size()));
      for (const Triangle& t : this->Triangles)
      {
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
        {
          this->Tetrahedra.push_back({ apex, t[0], t[1], t[2] });
        }
      }
    });
  this->Triangulator.SetKeepsFans(false);
  for (Tetrahedron& t : this->Tetrahedra)
  {
    if (!consistent && this->GetVolume(t) < 0)
    {
      std::swap(t[2], t[3]);
    }
  }
}

//------------------------------------------------------------------------------
unsigned char CellCutter::MatchPolyhedron(vtkIdType cell, vtkIdType nodes[8])
{
  constexpr vtkIdType MaxFaces = 6, MaxNodes = 8;
  const vtkIdType numberOfFaces = this->Facets.GetNumberOfFacets(cell);
  if (numberOfFaces < 4 || numberOfFaces > MaxFaces)
  {
    return VTK_POLYHEDRON;
  }
  // The matcher requires small ids and single-precision coordinates; relative ones are sufficient.
  std::int32_t faces[MaxFaces][4];
  IdList lists[MaxFaces];
  vtkIdType ids[MaxNodes];
  double places[3 * MaxNodes];
  std::int32_t numberOfNodes = 0;
  bool fits = true;
  this->Facets.ForEach(cell,
    [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
    {
      fits = fits && (size == 3 || size == 4);
      for (vtkIdType i = 0; fits && i < size; ++i)
      {
        std::int32_t node = 0;
        while (node < numberOfNodes && ids[node] != points[i])
        {
          ++node;
        }
        if (node == MaxNodes)
        {
          fits = false;
          break;
        }
        if (node == numberOfNodes)
        {
          ids[numberOfNodes++] = points[i];
          const Vector x = this->GetPlace(points[i]) - this->GetPlace(ids[0]);
          places[3 * node] = x.X;
          places[3 * node + 1] = x.Y;
          places[3 * node + 2] = x.Z;
        }
        faces[local][i] = node;
      }
      lists[local].Ids = reinterpret_cast<const char*>(faces[local]);
      lists[local].Size = static_cast<std::int32_t>(size);
    });
  if (!fits)
  {
    return VTK_POLYHEDRON;
  }
  const unsigned char type =
    PrimitiveMatcher::Guess(lists, static_cast<std::int32_t>(numberOfFaces));
  PrimitiveMatcher matcher(PointSource(reinterpret_cast<const char*>(places), numberOfNodes, true));
  if (type == VTK_POLYHEDRON || !matcher.Match(type, lists))
  {
    return VTK_POLYHEDRON;
  }

  // The matcher returns a positive cell. If all faces have the opposite orientation, it is the
  // mirror image.
  const CellShape& shape = GetCellShape(type);
  const std::int32_t* matched = matcher.GetNodes();
  bool inward = true;
  for (int f = 0; f < shape.NumberOfFaces; ++f)
  {
    const int* face = shape.FacePoints + shape.FaceOffsets[f];
    const IdList list = lists[matcher.GetFace(f)];
    for (std::int32_t i = 0; i < list.Size; ++i)
    {
      inward =
        inward && (list[i] != matched[face[0]] || list[(i + 1) % list.Size] != matched[face[1]]);
    }
  }
  static const int mirrors[4][MaxNodes] = { { 0, 2, 1, 3 }, { 0, 3, 2, 1, 4 }, { 0, 2, 1, 3, 5, 4 },
    { 0, 3, 2, 1, 4, 7, 6, 5 } };
  const int* mirror = type == VTK_TETRA ? mirrors[0]
    : type == VTK_PYRAMID               ? mirrors[1]
    : type == VTK_WEDGE                 ? mirrors[2]
                                        : mirrors[3];
  for (int i = 0; i < PrimitiveMatcher::GetNumberOfNodes(type); ++i)
  {
    nodes[i] = ids[matched[inward ? mirror[i] : i]];
  }
  return type;
}
}
