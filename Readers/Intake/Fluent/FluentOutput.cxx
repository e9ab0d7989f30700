// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentOutput.h"

#include "Base/Parallel.h"
#include "Intake/Fluent/FluentCells.h"

#include "vtkDataSet.h"

#include <algorithm>
#include <array>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Rotates a ring to its smallest rotation; a node may occur several times.
void StartAtLeast(std::vector<vtkIdType>& ring)
{
  const vtkIdType least = *std::min_element(ring.begin(), ring.end());
  std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), least), ring.end());
  std::ptrdiff_t more = std::count(ring.begin(), ring.end(), least) - 1;
  for (auto turned = more > 0 ? ring : std::vector<vtkIdType>(); more > 0; --more)
  {
    std::rotate(turned.begin(), std::find(turned.begin() + 1, turned.end(), least), turned.end());
    ring = std::min(ring, turned);
  }
}

//------------------------------------------------------------------------------
// Removes consecutive duplicates around a face, as Fluent requires.
void DropRepeated(std::vector<vtkIdType>& ring)
{
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.front() == ring.back())
  {
    ring.pop_back();
  }
}
}

//------------------------------------------------------------------------------
FluentOutput::FluentOutput(vtkDataSet* mesh, int dimension)
  : DataSet(mesh)
  , Dimension(dimension)
  , Topology(mesh)
  , Mesh(this->Topology.GetMesh())
  , Facets(dimension == 3 ? this->Topology.GetFaces() : this->Topology.GetSurfaceEdges())
  , Shapes(&GetCellShape(0))
{
  if (dimension == 3)
  {
    this->Orientation = std::make_unique<FaceOrientation>(this->Topology);
  }
  this->ReadZones();
}

//------------------------------------------------------------------------------
// Number of points of a cell that differ from the previous one: of all its points, or around a
// polygon.
int FluentOutput::CountCorners(vtkIdType meshCell) const
{
  const IndexRange points = this->Mesh.GetCellPoints(meshCell);
  int count = 0;
  for (vtkIdType i = 0; i < points.Size; ++i)
  {
    bool isNew = points[i] != points[i > 0 ? i - 1 : points.Size - 1];
    for (vtkIdType j = 0; j < i && this->Dimension == 3; ++j)
    {
      isNew = isNew && points[i] != points[j];
    }
    count += isNew;
  }
  return count;
}

//------------------------------------------------------------------------------
// A collapsed cell has other faces than its type.
int FluentOutput::GetElement(vtkIdType cell) const
{
  const vtkIdType meshCell = this->GetMeshCell(cell);
  unsigned char type = this->Mesh.GetCellType(meshCell);
  const int expected = this->Shapes[type].NumberOfCorners; // 0 if it may have any
  const int corners = expected > 0 ? this->CountCorners(meshCell) : 0;
  if (corners != expected)
  {
    type = this->Dimension == 2 && corners == 3 ? VTK_TRIANGLE : VTK_POLYHEDRON;
  }
  int element = 1;
  constexpr int Polyhedron = static_cast<int>(FluentElement::Polyhedron);
  while (element < Polyhedron &&
    GetFluentShape(static_cast<FluentElement>(element), this->Dimension).Type != type)
  {
    ++element;
  }
  return element;
}

//------------------------------------------------------------------------------
// Determines the cells of the file, and the cells that may be marks of faces.
void FluentOutput::FindCells()
{
  const vtkIdType size = this->Mesh.GetNumberOfCells();
  this->FileCells = IdSet(size);
  for (vtkIdType cell = 0; cell < size; ++cell)
  {
    const int dimension = this->Shapes[this->Mesh.GetCellType(cell)].Dimension;
    if (dimension == this->Dimension || dimension < 0)
    {
      this->FileCells.Add(cell);
    }
    else if (dimension == this->Dimension - 1)
    {
      this->Marks.push_back(static_cast<std::int32_t>(cell));
    }
  }
  this->AllCells = this->FileCells.Number() == size;
  this->Cells = this->AllCells ? std::vector<std::int32_t>() : this->FileCells.GetMembers();
}

//------------------------------------------------------------------------------
// Drops points that only cells of a lower dimension use; if they coincide with a point of other
// cells, they are duplicates of it.
void FluentOutput::MergeCopies()
{
  if (this->AllCells)
  {
    return;
  }
  const vtkIdType size = this->Mesh.GetNumberOfPoints();
  IdSet ofCells(size), ofMarks(size);
  for (vtkIdType cell = 0; cell < this->Mesh.GetNumberOfCells(); ++cell)
  {
    const IndexRange points = this->Mesh.GetCellPoints(cell);
    for (vtkIdType i = 0; i < points.Size; ++i)
    {
      (this->FileCells.Contains(cell) ? ofCells : ofMarks).Add(points[i]);
    }
  }
  using Copy = std::pair<std::array<double, 3>, vtkIdType>; // coordinates and point
  const auto locate = [this](vtkIdType point)
  {
    Copy copy({}, point);
    this->Mesh.GetPoint(point, copy.first.data());
    return copy;
  };
  std::vector<Copy> copies;
  this->FilePoints = IdSet(size);
  for (vtkIdType point = 0; point < size; ++point)
  {
    if (ofMarks.Contains(point) && !ofCells.Contains(point))
    {
      copies.push_back(locate(point));
    }
    else
    {
      this->FilePoints.Add(point);
    }
  }
  this->AllPoints = copies.empty();
  if (this->AllPoints)
  {
    return;
  }
  this->FilePoints.Number();
  this->Points = this->FilePoints.GetMembers();
  std::sort(copies.begin(), copies.end());
  ofCells.Number();
  for (const std::int32_t point : ofCells.GetMembers())
  {
    const Copy least(locate(point).first, -1);
    for (auto copy = std::lower_bound(copies.begin(), copies.end(), least);
      copy != copies.end() && copy->first == least.first; ++copy)
    {
      this->Originals.emplace(copy->second, point);
    }
  }
}

//------------------------------------------------------------------------------
// Whether the second cell of a facet has the opposite orientation of the first.
bool FluentOutput::AreOpposite(Index facet) const
{
  const Index first = this->Facets.GetCells(facet).First;
  const Index second = this->Facets.GetCells(facet).Second;
  if (this->Orientation)
  {
    return second >= 0 &&
      this->Orientation->IsReversed(facet, first) != this->Orientation->IsReversed(facet, second);
  }
  const auto uses = this->Facets.GetCellFacets(std::max<Index>(second, 0));
  return second >= 0 &&
    std::any_of(uses.begin(), uses.end(),
      [facet](CellFacet use) { return use.Facet() == facet && use.IsReversed(); });
}

//------------------------------------------------------------------------------
// Whether this is the side of a facet's second cell only, where the other side exists as well.
bool FluentOutput::IsFarSide(const Face& face) const
{
  if (face.Cells[1] >= 0)
  {
    return false;
  }
  const FacetTable::CellPair cells = this->Facets.GetCells(face.Facet);
  return cells.Second >= 0 && cells.Second != cells.First &&
    face.Cells[0] == this->GetFileCell(cells.Second) && this->AreOpposite(face.Facet);
}

//------------------------------------------------------------------------------
// Points of a facet, as its first cell traverses it.
void FluentOutput::GetPoints(Index facet, std::vector<vtkIdType>& points) const
{
  if (this->Dimension == 3)
  {
    this->Topology.GetFacePoints(facet, points);
    return;
  }
  const IndexRange ring = this->Mesh.GetCellPoints(this->Facets.GetCells(facet).First);
  const vtkIdType local = this->Facets.GetOwnerLocalFacet(facet);
  points = { ring[local], ring[local + 1 < ring.Size ? local + 1 : 0] };
}

//------------------------------------------------------------------------------
void FluentOutput::GetRing(Index facet, std::vector<vtkIdType>& points) const
{
  this->GetPoints(facet, points);
  if (this->Orientation->IsReversed(facet, this->Facets.GetCells(facet).First))
  {
    std::reverse(points.begin(), points.end());
  }
  DropRepeated(points);
}

//------------------------------------------------------------------------------
void FluentOutput::GetNodes(const Face& face, std::vector<vtkIdType>& nodes) const
{
  if (this->Dimension == 3)
  {
    // The normal must point into the first cell of the face.
    this->GetRing(face.Facet, nodes);
    if (!this->IsFarSide(face))
    {
      std::reverse(nodes.begin(), nodes.end());
    }
    if (!nodes.empty())
    {
      StartAtLeast(nodes);
    }
    return;
  }
  this->GetPoints(face.Facet, nodes);
  if (this->IsFarSide(face))
  {
    std::swap(nodes[0], nodes[1]);
  }
  DropRepeated(nodes);
}

//------------------------------------------------------------------------------
bool FluentOutput::FindFaces(Warnings& warnings, std::string& reason, const Progress& progress)
{
  const Index count = this->Facets.GetNumberOfFacets();
  this->Faces.resize(static_cast<std::size_t>(count));
  const bool finished = progress.ForBlocks(count, MediumGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<vtkIdType> nodes;
      for (auto facet = static_cast<Index>(begin); facet < end; ++facet)
      {
        const FacetTable::CellPair cells = this->Facets.GetCells(facet);
        Face face{ facet, { this->GetFileCell(cells.First), this->GetFileCell(cells.Second) }, 0,
          0 };
        this->GetPoints(facet, nodes);
        DropRepeated(nodes);
        face.Size = static_cast<std::int32_t>(nodes.size());
        face.Least = static_cast<std::int32_t>(
          nodes.empty() ? 0 : *std::min_element(nodes.begin(), nodes.end()));
        const bool isShared = this->JoinsInconsistent || this->AreOpposite(facet);
        face.Cells[1] = isShared ? face.Cells[1] : -1;
        this->Faces[static_cast<std::size_t>(facet)] = face;
      }
    });
  std::vector<Face> more; // the other sides of faces with the same orientation in both cells
  const std::int32_t least = this->Dimension == 3 ? 3 : 2; // nodes of a valid face
  Tally crowded, alike, small;
  std::size_t valid = 0;
  for (const Face& face : this->Faces)
  {
    const FacetTable::CellPair cells = this->Facets.GetCells(face.Facet);
    if (face.Size < least)
    {
      small.Add(cells.First);
      continue;
    }
    if (this->Facets.HasMoreThanTwoCells(face.Facet))
    {
      crowded.Add(cells.First);
    }
    if (cells.Second >= 0 && face.Cells[1] < 0)
    {
      alike.Add(cells.First);
      more.push_back(
        { face.Facet, { this->GetFileCell(cells.Second), -1 }, face.Size, face.Least });
    }
    this->Faces[valid++] = face;
  }
  if (crowded.Count > 0)
  {
    reason = "expected faces with at most two cells, found " + std::to_string(crowded.Count) +
      " with more, the first belongs to cell " + std::to_string(crowded.First);
    return false;
  }
  this->Faces.resize(valid);
  this->SortFacesOfCells();
  this->Faces.insert(this->Faces.end(), more.begin(), more.end());
  this->Dimension == 3
    ? warnings.Add(
        small, "face", "faces", "with fewer than 3 points, omitted (identified by their cell)")
    : warnings.Add(small, "edge", "edges", "with one point, omitted (identified by their cell)");
  warnings.Add(alike, "face", "faces",
    "with the same orientation in both cells, written once for each (identified by their cell)");
  return finished;
}

//------------------------------------------------------------------------------
// Facets are sorted by their first cell; sorts them by the second cell and by nodes as well.
void FluentOutput::SortFacesOfCells()
{
  std::vector<vtkIdType> a, b;
  const auto isLess = [&](const Face& x, const Face& y)
  {
    if (x.Cells[1] != y.Cells[1] || x.Least != y.Least)
    {
      return x.Cells[1] != y.Cells[1] ? x.Cells[1] < y.Cells[1] : x.Least < y.Least;
    }
    this->GetNodes(x, a);
    this->GetNodes(y, b);
    return a < b;
  };
  for (auto begin = this->Faces.begin(); begin != this->Faces.end();)
  {
    const auto end = std::find_if(begin, this->Faces.end(),
      [begin](const Face& face) { return face.Cells[0] != begin->Cells[0]; });
    std::sort(begin, end, isLess);
    begin = end;
  }
}

//------------------------------------------------------------------------------
bool FluentOutput::Build(Warnings& warnings, std::string& reason, const Progress& progress)
{
  this->FindCells();
  this->MergeCopies();
  if (!this->FindFaces(warnings, reason, progress))
  {
    return false;
  }
  this->FindMarks(warnings);
  this->FindCellSections();
  this->SortFaces();
  this->WarnOfOddZones(warnings);
  this->WarnOfLostZones(warnings);
  return true;
}
}
