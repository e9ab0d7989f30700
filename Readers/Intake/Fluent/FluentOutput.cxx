// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentOutput.h"

#include "Base/Parallel.h"
#include "Intake/Fluent/FluentCells.h"

#include "vtkDataSet.h"

#include <algorithm>
#include <array>
#include <mutex>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Rotates a ring to its smallest rotation.
void StartAtLeast(std::vector<vtkIdType>& ring)
{
  const auto least = std::min_element(ring.begin(), ring.end());
  const vtkIdType node = *least;
  std::rotate(ring.begin(), least, ring.end());
  // A node may occur several times.
  const std::vector<vtkIdType> first =
    std::count(ring.begin(), ring.end(), node) > 1 ? ring : std::vector<vtkIdType>();
  for (std::size_t start = 1; start < first.size(); ++start)
  {
    if (first[start] == node)
    {
      std::vector<vtkIdType> turned = first;
      std::rotate(
        turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(start), turned.end());
      ring = std::min(ring, turned);
    }
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
  const auto getDimension = [this](vtkIdType cell)
  { return this->Shapes[this->Mesh.GetCellType(cell)].Dimension; };
  for (vtkIdType cell = 0; cell < size && this->AllCells; ++cell)
  {
    const int dimension = getDimension(cell);
    this->AllCells = dimension == this->Dimension || dimension < 0;
  }
  if (this->AllCells)
  {
    return;
  }
  this->FileCells.assign(static_cast<std::size_t>(size), -1);
  for (vtkIdType cell = 0; cell < size; ++cell)
  {
    const int dimension = getDimension(cell);
    if (dimension == this->Dimension || dimension < 0)
    {
      this->FileCells[static_cast<std::size_t>(cell)] =
        static_cast<std::int32_t>(this->Cells.size());
      this->Cells.push_back(static_cast<std::int32_t>(cell));
    }
    else if (dimension == this->Dimension - 1)
    {
      this->Marks.push_back(static_cast<std::int32_t>(cell));
    }
  }
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
  const auto size = static_cast<std::size_t>(this->Mesh.GetNumberOfPoints());
  enum : unsigned char
  {
    Free = 0,
    OfMark = 1,
    OfCell = 2
  };
  std::vector<unsigned char> use(size, Free);
  for (vtkIdType cell = 0; cell < this->Mesh.GetNumberOfCells(); ++cell)
  {
    const IndexRange points = this->Mesh.GetCellPoints(cell);
    const unsigned char kind =
      this->FileCells[static_cast<std::size_t>(cell)] >= 0 ? OfCell : OfMark;
    for (vtkIdType i = 0; i < points.Size; ++i)
    {
      unsigned char& known = use[static_cast<std::size_t>(points[i])];
      known = std::max(known, kind);
    }
  }
  using Place = std::array<double, 3>;
  const auto getPlace = [this](vtkIdType point)
  {
    Place place;
    this->Mesh.GetPoint(point, place.data());
    return place;
  };
  std::vector<std::pair<Place, vtkIdType>> copies;
  for (std::size_t point = 0; point < size; ++point)
  {
    if (use[point] == OfMark)
    {
      copies.emplace_back(getPlace(static_cast<vtkIdType>(point)), static_cast<vtkIdType>(point));
    }
  }
  if (copies.empty())
  {
    return;
  }
  std::sort(copies.begin(), copies.end());
  this->AllPoints = false;
  this->FilePoints.assign(size, -1);
  for (std::size_t point = 0; point < size; ++point)
  {
    if (use[point] == OfMark)
    {
      continue;
    }
    this->FilePoints[point] = static_cast<std::int32_t>(this->Points.size());
    this->Points.push_back(static_cast<std::int32_t>(point));
    if (use[point] == OfCell)
    {
      const Place place = getPlace(static_cast<vtkIdType>(point));
      for (auto copy =
             std::lower_bound(copies.begin(), copies.end(), std::make_pair(place, vtkIdType(-1)));
        copy != copies.end() && copy->first == place; ++copy)
      {
        this->Originals.emplace(copy->second, static_cast<vtkIdType>(point));
      }
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
  bool isReversed = false;
  if (second >= 0)
  {
    for (const CellFacet use : this->Facets.GetCellFacets(second))
    {
      isReversed = isReversed || (use.Facet() == facet && use.IsReversed());
    }
  }
  return isReversed;
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
void FluentOutput::GetRing(Index facet, std::vector<vtkIdType>& points) const
{
  this->Topology.GetFacePoints(facet, points);
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
  const IndexRange points = this->Mesh.GetCellPoints(this->Facets.GetCells(face.Facet).First);
  const vtkIdType local = this->Facets.GetOwnerLocalFacet(face.Facet);
  nodes = { points[local], points[local + 1 < points.Size ? local + 1 : 0] };
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
  std::vector<Face> more; // the other sides of faces with the same orientation in both cells
  const std::int32_t least = this->Dimension == 3 ? 3 : 2; // nodes of a valid face
  Tally crowded, alike, small;
  std::mutex mutex;
  const bool finished = progress.For((count + MediumGrain - 1) / MediumGrain,
    [&](vtkIdType first, vtkIdType last)
    {
      std::vector<vtkIdType> nodes;
      std::vector<Face> localMore;
      Tally localCrowded, localSmall;
      const auto end = static_cast<Index>(std::min<vtkIdType>(last * MediumGrain, count));
      for (auto facet = static_cast<Index>(first * MediumGrain); facet < end; ++facet)
      {
        const FacetTable::CellPair cells = this->Facets.GetCells(facet);
        Face face{ facet, { this->GetFileCell(cells.First), this->GetFileCell(cells.Second) }, 0,
          0 };
        this->GetNodes(face, nodes);
        face.Size = static_cast<std::int32_t>(nodes.size());
        if (face.Size < least)
        {
          localSmall.Add(cells.First);
          this->Faces[static_cast<std::size_t>(facet)] = face;
          continue;
        }
        face.Least = static_cast<std::int32_t>(*std::min_element(nodes.begin(), nodes.end()));
        if (cells.Second >= 0)
        {
          if (!this->JoinsInconsistent && !this->AreOpposite(facet))
          {
            localMore.push_back({ facet, { face.Cells[1], -1 }, face.Size, face.Least });
            face.Cells[1] = -1;
          }
          if (this->Facets.GetNumberOfCells(facet) > 2)
          {
            localCrowded.Add(cells.First);
          }
        }
        this->Faces[static_cast<std::size_t>(facet)] = face;
      }
      const std::lock_guard<std::mutex> lock(mutex);
      more.insert(more.end(), localMore.begin(), localMore.end());
      crowded.Merge(localCrowded);
      small.Merge(localSmall);
    });
  if (crowded.Count > 0)
  {
    reason = "expected faces with at most two cells, found " + std::to_string(crowded.Count) +
      " with more, the first belongs to cell " + std::to_string(crowded.First);
    return false;
  }
  this->Faces.erase(std::remove_if(this->Faces.begin(), this->Faces.end(),
                      [=](const Face& face) { return face.Size < least; }),
    this->Faces.end());
  this->SortFacesOfCells();
  for (const Face& face : more)
  {
    alike.Add(this->Facets.GetCells(face.Facet).First);
  }
  std::sort(
    more.begin(), more.end(), [](const Face& a, const Face& b) { return a.Facet < b.Facet; });
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
    auto end = begin;
    while (end != this->Faces.end() && end->Cells[0] == begin->Cells[0])
    {
      ++end;
    }
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
