// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentOutput.h"

#include "FluentCells.h"
#include "FluentFaces.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <set>

namespace camaron
{
namespace
{
constexpr vtkIdType Grain = 4096;
constexpr int FirstZone = 2; // as most writers count, after an interior zone 1

//------------------------------------------------------------------------------
// Fluent's number of a kind of boundary; 0 for what is none.
int GetBoundaryType(const std::string& name)
{
  static const std::map<std::string, int> types = { { "interior", 2 }, { "wall", 3 },
    { "pressure-inlet", 4 }, { "inlet-vent", 4 }, { "intake-fan", 4 }, { "pressure-outlet", 5 },
    { "exhaust-fan", 5 }, { "outlet-vent", 5 }, { "symmetry", 7 }, { "shadow", 8 },
    { "pressure-far-field", 9 }, { "velocity-inlet", 10 }, { "periodic", 12 }, { "fan", 14 },
    { "porous-jump", 14 }, { "radiator", 14 }, { "mass-flow-inlet", 20 }, { "interface", 24 },
    { "overset", 25 }, { "outflow", 36 }, { "axis", 37 } };
  const auto type = types.find(name);
  return type != types.end() ? type->second : 0;
}

//------------------------------------------------------------------------------
// A name without what ends one in a file.
std::string Clean(std::string name)
{
  for (char& c : name)
  {
    c = c <= ' ' || c == '(' || c == ')' || c == '"' || c == '\x7f' ? '-' : c;
  }
  return name;
}

//------------------------------------------------------------------------------
// Turns a ring so that it is the least of all that it can be turned to.
void StartAtLeast(std::vector<vtkIdType>& ring)
{
  const auto least = std::min_element(ring.begin(), ring.end());
  const vtkIdType node = *least;
  std::rotate(ring.begin(), least, ring.end());
  // A node may be there more than once.
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
std::vector<FluentZone> ReadZones(vtkFieldData* data)
{
  std::vector<FluentZone> zones;
  vtkDataArray* const ids = data->GetArray("ZoneIds");
  auto* const names = vtkStringArray::SafeDownCast(data->GetAbstractArray("ZoneNames"));
  auto* const types = vtkStringArray::SafeDownCast(data->GetAbstractArray("ZoneTypes"));
  if (!ids || ids->GetNumberOfComponents() != 1)
  {
    return zones;
  }
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    FluentZone zone;
    const double id = ids->GetTuple1(i);
    if (id < 1 || id > INT32_MAX)
    {
      continue;
    }
    zone.Id = static_cast<int>(id);
    zone.Name = names && i < names->GetNumberOfValues() ? Clean(names->GetValue(i)) : std::string();
    zone.Type = types && i < types->GetNumberOfValues() ? Clean(types->GetValue(i)) : std::string();
    zones.push_back(zone);
  }
  return zones;
}

//------------------------------------------------------------------------------
// A single number per cell; nullptr for anything else.
vtkDataArray* GetCellNumbers(vtkDataSet* mesh, const char* name)
{
  vtkDataArray* const array = mesh->GetCellData()->GetArray(name);
  return array && array->GetNumberOfComponents() == 1 ? array : nullptr;
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
  , KnownZones(ReadZones(mesh->GetFieldData()))
  , ZoneArray(GetCellNumbers(mesh, "Zone"))
{
}

//------------------------------------------------------------------------------
int FluentOutput::GetElement(vtkIdType cell) const
{
  switch (this->Mesh.GetCellType(this->GetMeshCell(cell)))
  {
    case VTK_TRIANGLE:
      return static_cast<int>(FluentElement::Triangle);
    case VTK_QUAD:
      return static_cast<int>(FluentElement::Quadrilateral);
    case VTK_TETRA:
      return static_cast<int>(FluentElement::Tetrahedron);
    case VTK_HEXAHEDRON:
      return static_cast<int>(FluentElement::Hexahedron);
    case VTK_PYRAMID:
      return static_cast<int>(FluentElement::Pyramid);
    case VTK_WEDGE:
      return static_cast<int>(FluentElement::Wedge);
    default:
      return static_cast<int>(FluentElement::Polyhedron);
  }
}

//------------------------------------------------------------------------------
// The zone of a cell of the mesh; 0 if it has none.
int FluentOutput::GetZone(vtkIdType cell) const
{
  const double zone = this->ZoneArray ? this->ZoneArray->GetTuple1(cell) : 0;
  return zone >= 1 && zone <= INT32_MAX ? static_cast<int>(zone) : 0;
}

//------------------------------------------------------------------------------
// Which cells are cells of the file, and which may be marks of faces.
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
// Points that only cells of a lower dimension use are left out; if they are at the place of a point
// of the others, they are taken for it.
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
void FluentOutput::GetNodes(const Face& face, std::vector<vtkIdType>& nodes) const
{
  if (this->Dimension == 3)
  {
    // Outward of the first cell, into which the normal has to point.
    this->Topology.GetFacePoints(face.Facet, nodes);
    std::reverse(nodes.begin(), nodes.end());
    StartAtLeast(nodes);
    return;
  }
  const IndexRange points = this->Mesh.GetCellPoints(this->Facets.GetCells(face.Facet).First);
  const vtkIdType local = this->Facets.GetOwnerLocalFacet(face.Facet);
  nodes = { points[local], points[local + 1 < points.Size ? local + 1 : 0] };
}

//------------------------------------------------------------------------------
bool FluentOutput::FindFaces(Warnings& warnings, std::string& reason, const Progress& progress)
{
  const Index count = this->Facets.GetNumberOfFacets();
  this->Faces.resize(static_cast<std::size_t>(count));
  const auto getFileCell = [this](Index cell)
  { return cell < 0 || this->AllCells ? cell : this->FileCells[static_cast<std::size_t>(cell)]; };
  std::vector<Face> more; // the other sides of faces that two cells run around alike
  Tally crowded, alike;
  std::mutex mutex;
  const bool finished = progress.For((count + Grain - 1) / Grain,
    [&](vtkIdType first, vtkIdType last)
    {
      std::vector<vtkIdType> nodes;
      std::vector<Face> localMore;
      Tally localCrowded;
      const auto end = static_cast<Index>(std::min<vtkIdType>(last * Grain, count));
      for (auto facet = static_cast<Index>(first * Grain); facet < end; ++facet)
      {
        const FacetTable::CellPair cells = this->Facets.GetCells(facet);
        Face face{ facet, { getFileCell(cells.First), getFileCell(cells.Second) }, 0, 0 };
        this->GetNodes(face, nodes);
        face.Size = static_cast<std::int32_t>(nodes.size());
        face.Least = static_cast<std::int32_t>(*std::min_element(nodes.begin(), nodes.end()));
        if (cells.Second >= 0)
        {
          bool isReversed = false;
          for (const CellFacet use : this->Facets.GetCellFacets(cells.Second))
          {
            isReversed = isReversed || (use.Facet() == facet && use.IsReversed());
          }
          if (!isReversed)
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
    });
  if (crowded.Count > 0)
  {
    reason = "expected faces of at most two cells, found " + std::to_string(crowded.Count) +
      " of more, the first is of cell " + std::to_string(crowded.First);
    return false;
  }
  this->SortFacesOfCells();
  for (const Face& face : more)
  {
    alike.Add(this->Facets.GetCells(face.Facet).First);
  }
  std::sort(
    more.begin(), more.end(), [](const Face& a, const Face& b) { return a.Facet < b.Facet; });
  this->Faces.insert(this->Faces.end(), more.begin(), more.end());
  warnings.Add(alike, "face", "faces",
    "around which both cells run in the same direction, written once for each (first by its cell)");
  return finished;
}

//------------------------------------------------------------------------------
// Facets come by their first cell; now also by the second, and by their nodes.
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
// Finds the facets that cells of a lower dimension are.
void FluentOutput::FindMarks(Warnings& warnings)
{
  if (this->Marks.empty())
  {
    return;
  }
  const auto getPoint = [this](vtkIdType point)
  {
    const auto original = this->Originals.find(point);
    return original != this->Originals.end() ? original->second : point;
  };
  std::vector<std::vector<vtkIdType>> wanted;
  std::vector<bool> isOfMark(static_cast<std::size_t>(this->Mesh.GetNumberOfPoints()), false);
  for (const std::int32_t mark : this->Marks)
  {
    const IndexRange points = this->Mesh.GetCellPoints(mark);
    wanted.emplace_back();
    for (vtkIdType i = 0; i < points.Size; ++i)
    {
      const vtkIdType point = getPoint(points[i]);
      wanted.back().push_back(point);
      isOfMark[static_cast<std::size_t>(point)] = true;
    }
    std::sort(wanted.back().begin(), wanted.back().end());
  }

  std::vector<std::pair<std::vector<vtkIdType>, Index>> facets;
  std::vector<vtkIdType> nodes;
  for (const Face& face : this->Faces)
  {
    this->GetNodes(face, nodes);
    if (std::all_of(nodes.begin(), nodes.end(),
          [&](vtkIdType node) { return isOfMark[static_cast<std::size_t>(node)]; }))
    {
      std::sort(nodes.begin(), nodes.end());
      facets.emplace_back(nodes, face.Facet);
    }
  }
  std::sort(facets.begin(), facets.end());

  vtkDataArray* const types = GetCellNumbers(this->DataSet, "BoundaryType");
  Tally lost;
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    const auto facet =
      std::lower_bound(facets.begin(), facets.end(), std::make_pair(wanted[i], Index(-1)));
    if (facet == facets.end() || facet->first != wanted[i])
    {
      lost.Add(this->Marks[i]);
      continue;
    }
    const int zone = this->GetZone(this->Marks[i]);
    if (zone > 0)
    {
      this->MarkedZones.emplace(facet->second, zone);
      const double type = types ? types->GetTuple1(this->Marks[i]) : 0;
      constexpr double MaxType = 100;
      this->MarkedTypes.emplace(zone, type >= 1 && type < MaxType ? static_cast<int>(type) : 0);
    }
  }
  warnings.Add(
    lost, "cell", "cells", "of a lower dimension, which are no faces of others, left out");
}

//------------------------------------------------------------------------------
int FluentOutput::GetFreeZone(int least) const
{
  std::set<int> taken;
  for (const FluentZone& zone : this->KnownZones)
  {
    taken.insert(zone.Id);
  }
  for (const FluentZone& zone : this->Zones)
  {
    taken.insert(zone.Id);
  }
  for (const auto& marked : this->MarkedTypes)
  {
    taken.insert(marked.first);
  }
  while (taken.count(least))
  {
    ++least;
  }
  return least;
}

//------------------------------------------------------------------------------
// A zone for faces that are in none: the only known one of this type, or a new one.
FluentZone FluentOutput::MakeZone(const std::string& type, int least) const
{
  const FluentZone* only = nullptr;
  int count = 0;
  for (const FluentZone& zone : this->KnownZones)
  {
    const int boundary = GetBoundaryType(zone.Type);
    const bool isInterior = boundary == FluentBoundary::Interior;
    if (boundary > 0 && isInterior == (type == "interior"))
    {
      ++count;
      only = zone.Type == type ? &zone : nullptr;
    }
  }
  const bool isFree = count == 1 && only && !this->MarkedTypes.count(only->Id) &&
    std::none_of(this->Zones.begin(), this->Zones.end(),
      [&](const FluentZone& zone) { return zone.Id == only->Id; });
  return this->Describe(isFree ? only->Id : this->GetFreeZone(least), type);
}

//------------------------------------------------------------------------------
FluentZone FluentOutput::Describe(int zone, const std::string& type) const
{
  const auto known = std::find_if(this->KnownZones.begin(), this->KnownZones.end(),
    [zone](const FluentZone& candidate) { return candidate.Id == zone; });
  FluentZone result;
  result.Id = zone;
  result.Type = known != this->KnownZones.end() && !known->Type.empty() ? known->Type : type;
  result.Name = known != this->KnownZones.end() && !known->Name.empty()
    ? known->Name
    : result.Type + "-" + std::to_string(zone);
  return result;
}

//------------------------------------------------------------------------------
// Cells stay in their order; consecutive ones of the same zone make a section.
void FluentOutput::FindCellSections(Warnings& warnings)
{
  std::map<int, int> parts;
  const vtkIdType size = this->GetNumberOfCells();
  for (vtkIdType begin = 0; begin < size;)
  {
    Section section;
    section.Zone = this->GetZone(this->GetMeshCell(begin));
    section.Element = this->GetElement(begin);
    section.Begin = begin;
    vtkIdType end = begin;
    for (; end < size && this->GetZone(this->GetMeshCell(end)) == section.Zone; ++end)
    {
      section.Element = this->GetElement(end) == section.Element ? section.Element : 0;
    }
    section.End = end;
    ++parts[section.Zone];
    this->CellSections.push_back(section);
    begin = end;
  }
  for (const auto& part : parts)
  {
    if (part.first > 0)
    {
      this->Zones.push_back(this->Describe(part.first, "fluid"));
    }
  }
  if (parts.count(0))
  {
    const int zone = this->GetFreeZone(FirstZone);
    this->Zones.push_back(this->Describe(zone, "fluid"));
    for (Section& section : this->CellSections)
    {
      section.Zone = section.Zone > 0 ? section.Zone : zone;
    }
  }
  const auto split = std::count_if(parts.begin(), parts.end(),
    [](const std::pair<const int, int>& part) { return part.second > 1; });
  if (split > 0)
  {
    warnings.Add(std::to_string(split) +
      (split == 1 ? " zone whose cells do" : " zones whose cells do") +
      " not follow each other, written as several sections");
  }
}

//------------------------------------------------------------------------------
// Faces between cells first, then the others by zone.
void FluentOutput::SortFaces()
{
  constexpr int Inside = -2, Outside = -1; // of no zone
  const auto getKey = [this](const Face& face)
  {
    const auto marked = this->MarkedZones.find(face.Facet);
    return marked != this->MarkedZones.end() ? marked->second
      : face.Cells[1] >= 0                   ? Inside
                                             : Outside;
  };
  if (this->MarkedZones.empty())
  {
    std::stable_partition(
      this->Faces.begin(), this->Faces.end(), [](const Face& face) { return face.Cells[1] >= 0; });
  }
  else
  {
    std::stable_sort(this->Faces.begin(), this->Faces.end(),
      [&](const Face& a, const Face& b) { return getKey(a) < getKey(b); });
  }
  const auto size = static_cast<vtkIdType>(this->Faces.size());
  for (vtkIdType begin = 0; begin < size;)
  {
    const int key = getKey(this->Faces[static_cast<std::size_t>(begin)]);
    Section section;
    section.Begin = begin;
    bool same = true, large = false, hasInside = false;
    const std::int32_t faceSize = this->Faces[static_cast<std::size_t>(begin)].Size;
    vtkIdType end = begin;
    for (; end < size && getKey(this->Faces[static_cast<std::size_t>(end)]) == key; ++end)
    {
      const Face& face = this->Faces[static_cast<std::size_t>(end)];
      constexpr std::int32_t LargestSized = 4;
      same = same && face.Size == faceSize;
      large = large || face.Size > LargestSized;
      hasInside = hasInside || face.Cells[1] >= 0;
    }
    section.End = end;
    constexpr int Polygons = 5;
    section.Element = large ? Polygons : same && faceSize > 1 ? faceSize : 0;
    FluentZone zone;
    if (key > 0)
    {
      const int type = this->MarkedTypes[key];
      zone = this->Describe(key, hasInside ? "interior" : "wall");
      section.Type = type > 0 ? type : GetBoundaryType(zone.Type);
    }
    else
    {
      zone = this->MakeZone(key == Inside ? "interior" : "wall", FirstZone + 1);
    }
    section.Type = section.Type > 0 ? section.Type
      : hasInside                   ? FluentBoundary::Interior
                                    : FluentBoundary::Wall;
    section.Zone = zone.Id;
    this->Zones.push_back(zone);
    this->FaceSections.push_back(section);
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
  this->FindCellSections(warnings);
  this->SortFaces();
  return true;
}
}
