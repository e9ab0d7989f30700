// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Zones of cells and faces, from the arrays of the mesh.
#include "Intake/Fluent/FluentOutput.h"

#include "Base/Text.h"
#include "Intake/Fluent/FluentFaces.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace camaron
{
namespace
{
constexpr int FirstZone = 2; // as in most writers, after an interior zone 1

//------------------------------------------------------------------------------
// Fluent's number of a boundary type; 0 if unknown, or for non-conformal interfaces.
int ToBoundaryType(double number)
{
  constexpr double MaxType = 100;
  return number >= 1 && number < MaxType ? static_cast<int>(number) : 0;
}

//------------------------------------------------------------------------------
bool IsZone(double number)
{
  return number >= 1 && number <= INT32_MAX && number == std::floor(number);
}

//------------------------------------------------------------------------------
// Replaces characters that would end a name in a file. Letters beyond ASCII (UTF-8) are kept.
std::string Clean(std::string name)
{
  for (char& c : name)
  {
    const auto code = static_cast<unsigned char>(c);
    c = code <= ' ' || c == '(' || c == ')' || c == '"' || code == 0x7f ? '-' : c;
  }
  return name;
}

//------------------------------------------------------------------------------
// An array with a single number per row; nullptr otherwise.
vtkDataArray* GetNumbers(vtkFieldData* data, const char* name)
{
  vtkDataArray* const array = data->GetArray(name);
  return array && array->GetNumberOfComponents() == 1 ? array : nullptr;
}
}

//------------------------------------------------------------------------------
const FluentZone* FluentOutput::Find(const std::vector<FluentZone>& zones, int id)
{
  const auto zone = std::find_if(
    zones.begin(), zones.end(), [id](const FluentZone& candidate) { return candidate.Id == id; });
  return zone != zones.end() ? &*zone : nullptr;
}

//------------------------------------------------------------------------------
void FluentOutput::ReadZones()
{
  vtkFieldData* const data = this->DataSet->GetFieldData();
  this->InteriorZones.Load(data);
  this->ZoneArray = GetNumbers(this->DataSet->GetCellData(), "Zone");
  vtkDataArray* const ids = GetNumbers(data, "ZoneIds");
  vtkDataArray* const numbers = GetNumbers(data, "ZoneBoundaryTypes");
  const auto getText = [data](const char* name, vtkIdType i)
  {
    auto* const texts = vtkStringArray::SafeDownCast(data->GetAbstractArray(name));
    return texts && i < texts->GetNumberOfValues() ? texts->GetValue(i) : vtkStdString();
  };
  for (vtkIdType i = 0; ids && i < ids->GetNumberOfTuples(); ++i)
  {
    FluentZone zone;
    const double id = ids->GetTuple1(i);
    if (id < 1 || id > INT32_MAX)
    {
      continue;
    }
    zone.Id = static_cast<int>(id);
    zone.Name = Clean(getText("ZoneNames", i));
    zone.Type = Clean(getText("ZoneTypes", i));
    if (zone.Name != getText("ZoneNames", i))
    {
      this->Renamed.Add(zone.Id);
    }
    const FluentZone* const same = Find(this->KnownZones, zone.Id);
    if (same && same->Name != zone.Name)
    {
      this->Repeated.Add(zone.Id);
    }
    const bool hasNumber = numbers && i < numbers->GetNumberOfTuples();
    zone.BoundaryType = hasNumber ? ToBoundaryType(numbers->GetTuple1(i)) : 0;
    this->KnownZones.push_back(zone);
  }
}

//------------------------------------------------------------------------------
// The zone of a cell of the mesh; 0 if it has none.
int FluentOutput::GetZone(vtkIdType cell) const
{
  const double zone = this->ZoneArray ? this->ZoneArray->GetTuple1(cell) : 0;
  return IsZone(zone) ? static_cast<int>(zone) : 0;
}

//------------------------------------------------------------------------------
// Warns about names and numbers that are invalid in Fluent; 0 and NaN mean no zone.
void FluentOutput::WarnOfOddZones(Warnings& warnings) const
{
  Tally odd;
  const vtkIdType size = this->ZoneArray ? this->ZoneArray->GetNumberOfTuples() : 0;
  for (vtkIdType cell = 0; cell < size; ++cell)
  {
    const double zone = this->ZoneArray->GetTuple1(cell);
    if (zone != 0 && !std::isnan(zone) && !IsZone(zone))
    {
      odd.Add(cell);
    }
  }
  warnings.Add(this->Renamed, "zone", "zones",
    "with blanks, brackets or quotes in the name, written as \"-\"");
  warnings.Add(this->Repeated, "zone", "zones",
    "with an id that another name has as well, whose elements get the first name");
  for (const auto& [key, zone] : this->ZonesByType)
  {
    warnings.Add("faces of zone " + std::to_string(key.first) +
      " have another boundary type than its first one, and become a zone: " +
      QuoteWord(Find(this->KnownZones, zone)->Name));
  }
  warnings.Add(odd, "cell", "cells",
    "whose Zone is not an integer from 1 to 2147483647, treated as without zone");
}

//------------------------------------------------------------------------------
// Points of a cell of a lower dimension, with duplicates replaced by the originals.
std::vector<vtkIdType> FluentOutput::GetMarkNodes(std::int32_t mark) const
{
  const IndexRange points = this->Mesh.GetCellPoints(mark);
  std::vector<vtkIdType> nodes;
  for (vtkIdType i = 0; i < points.Size; ++i)
  {
    const auto original = this->Originals.find(points[i]);
    nodes.push_back(original != this->Originals.end() ? original->second : points[i]);
  }
  return nodes;
}

//------------------------------------------------------------------------------
// Whether a cell of a lower dimension is oriented as the reader shows a face of the first cell.
bool FluentOutput::IsOutward(std::int32_t mark, const Face& face) const
{
  const std::vector<vtkIdType> nodes = this->GetMarkNodes(mark);
  std::vector<vtkIdType> ring;
  this->GetNodes(face, ring);
  if (this->Dimension == 2)
  {
    return nodes == ring; // edges have the first cell on the left
  }
  const auto at = std::find(ring.begin(), ring.end(), nodes[0]) - ring.begin();
  const auto size = static_cast<std::ptrdiff_t>(ring.size());
  return nodes[1] == ring[static_cast<std::size_t>((at + size - 1) % size)];
}

//------------------------------------------------------------------------------
// An interior face with two marks, one for each side, becomes two. Returns the face, or both.
std::vector<std::size_t> FluentOutput::SplitFace(
  std::size_t face, const std::vector<std::int32_t>& marks)
{
  Face far = this->Faces[face];
  if (marks.size() != 2 || far.Cells[1] < 0 ||
    this->IsOutward(marks[0], far) == this->IsOutward(marks[1], far))
  {
    return { face };
  }
  far.Cells[0] = std::exchange(far.Cells[1], -1);
  this->Faces[face].Cells[1] = -1;
  this->Faces.push_back(far);
  return { face, this->Faces.size() - 1 };
}

//------------------------------------------------------------------------------
// Finds the faces that coincide with cells of a lower dimension.
void FluentOutput::FindMarks(Warnings& warnings)
{
  if (this->Marks.empty())
  {
    return;
  }
  struct Group
  {
    std::vector<std::size_t> Faces;
    std::vector<std::int32_t> Marks;
  };
  std::map<std::vector<vtkIdType>, Group> groups; // with the same nodes, sorted
  IdSet ofMarks(this->Mesh.GetNumberOfPoints());
  std::vector<vtkIdType> nodes;
  for (const std::int32_t mark : this->Marks)
  {
    nodes = this->GetMarkNodes(mark);
    std::for_each(nodes.begin(), nodes.end(), [&](vtkIdType node) { ofMarks.Add(node); });
    std::sort(nodes.begin(), nodes.end());
    groups[nodes].Marks.push_back(mark);
  }
  const std::size_t before = this->Faces.size();
  for (std::size_t face = 0; face < before; ++face)
  {
    this->GetNodes(this->Faces[face], nodes);
    if (std::all_of(
          nodes.begin(), nodes.end(), [&](vtkIdType node) { return ofMarks.Contains(node); }))
    {
      std::sort(nodes.begin(), nodes.end());
      const auto group = groups.find(nodes);
      if (group != groups.end())
      {
        group->second.Faces.push_back(face);
      }
    }
  }

  vtkDataArray* const types = GetNumbers(this->DataSet->GetCellData(), "BoundaryType");
  Tally repeated;
  for (auto& [key, group] : groups)
  {
    std::vector<std::int32_t>& marks = group.Marks;
    if (group.Faces.empty())
    {
      std::for_each(marks.begin(), marks.end(), [&](std::int32_t mark) { this->Lost.Add(mark); });
      continue;
    }
    marks.erase(std::remove_if(marks.begin(), marks.end(),
                  [this](std::int32_t mark) { return this->GetZone(mark) == 0; }),
      marks.end());
    if (marks.empty())
    {
      continue;
    }
    const std::vector<std::size_t> faces =
      group.Faces.size() == 1 ? this->SplitFace(group.Faces[0], marks) : group.Faces;
    for (const std::size_t face : faces)
    {
      // Of two marks, the one for this side.
      const Face& side = this->Faces[face];
      const auto mark = std::find_if(
        marks.begin(), marks.end(), [&](std::int32_t m) { return this->IsOutward(m, side); });
      const std::int32_t chosen = mark != marks.end() ? *mark : marks[0];
      const int type = types ? ToBoundaryType(types->GetTuple1(chosen)) : 0;
      const int zone = this->GetMarkedZone(this->GetZone(chosen), type);
      this->MarkedZones.emplace(std::make_pair(side.Facet, side.Cells[0]), zone);
    }
    for (std::size_t i = faces.size(); i < marks.size(); ++i)
    {
      repeated.Add(marks[i]);
    }
  }
  if (this->Faces.size() > before)
  {
    std::stable_sort(this->Faces.begin(), this->Faces.end(),
      [](const Face& a, const Face& b) { return a.Cells[0] < b.Cells[0]; });
    this->SortFacesOfCells();
  }
  warnings.Add(this->Lost, "cell", "cells",
    "of a lower dimension omitted, as they are not faces of other cells");
  warnings.Add(
    repeated, "cell", "cells", "of a lower dimension omitted, as others are the same face");
}

//------------------------------------------------------------------------------
// The zone for faces of a zone and boundary type: of several types, all but the first get zones of
// their own.
int FluentOutput::GetMarkedZone(int zone, int type)
{
  const auto marked = this->MarkedTypes.emplace(zone, type).first;
  if (type == 0 || marked->second == 0 || marked->second == type)
  {
    return zone;
  }
  int& own = this->ZonesByType[{ zone, type }];
  if (own == 0)
  {
    int greatest = 0;
    for (vtkIdType cell = 0; cell < this->ZoneArray->GetNumberOfTuples(); ++cell)
    {
      greatest = std::max(greatest, this->GetZone(cell));
    }
    own = this->GetFreeZone(greatest < INT32_MAX ? greatest + 1 : FirstZone);
    const std::string name = GetFluentBoundaryName(type);
    const std::string given = this->Describe(zone, GetFluentBoundaryName(marked->second)).Name;
    this->KnownZones.push_back(
      { own, name, given + "-" + (name.empty() ? std::to_string(type) : name), type });
    this->MarkedTypes.emplace(own, type);
  }
  return own;
}

//------------------------------------------------------------------------------
int FluentOutput::GetFreeZone(int least) const
{
  while (Find(this->KnownZones, least) || this->FindZone(least) || this->MarkedTypes.count(least))
  {
    ++least;
  }
  return least;
}

//------------------------------------------------------------------------------
// The zone for faces without one: the only known one of this type, unless it is used already; else
// nullptr.
const FluentZone* FluentOutput::FindOnlyZone(const std::string& type) const
{
  const FluentZone* only = nullptr;
  int count = 0;
  for (const FluentZone& zone : this->KnownZones)
  {
    const int boundary = GetFluentBoundaryType(zone.Type);
    const bool isInterior = boundary == FluentBoundary::Interior;
    if (boundary > 0 && isInterior == (type == "interior"))
    {
      ++count;
      only = zone.Type == type ? &zone : nullptr;
    }
  }
  const bool isFree =
    count == 1 && only && !this->MarkedTypes.count(only->Id) && !this->FindZone(only->Id);
  return isFree ? only : nullptr;
}

//------------------------------------------------------------------------------
FluentZone FluentOutput::Describe(int zone, const std::string& type) const
{
  const FluentZone* const known = Find(this->KnownZones, zone);
  FluentZone result = known ? *known : FluentZone();
  result.Id = zone;
  result.Type = result.Type.empty() ? type : result.Type;
  result.Name = result.Name.empty() ? result.Type + "-" + std::to_string(zone) : result.Name;
  return result;
}

//------------------------------------------------------------------------------
// Cells keep their order; consecutive ones of the same zone become a section.
void FluentOutput::FindCellSections()
{
  std::map<int, int> parts; // of every zone
  const vtkIdType size = this->GetNumberOfCells();
  for (vtkIdType cell = 0; cell < size; ++cell)
  {
    const int zone = this->GetZone(this->GetMeshCell(cell));
    const int element = this->GetElement(cell);
    if (cell == 0 || zone != this->CellSections.back().Zone)
    {
      ++parts[zone];
      this->CellSections.push_back({ zone, 0, cell, cell, element });
    }
    Section& section = this->CellSections.back();
    section.End = cell + 1;
    section.Element = element == section.Element ? element : 0;
  }
  for (const auto& part : parts)
  {
    if (part.first > 0)
    {
      this->Zones.push_back(this->Describe(part.first, "fluid"));
    }
    this->NumberOfSplitZones += part.second > 1;
  }
  if (parts.count(0))
  {
    const int zone = this->GetFreeZone(FirstZone);
    this->Zones.push_back(this->Describe(zone, "fluid"));
    for (Section& section : this->CellSections)
    {
      section.IsMade = section.Zone == 0;
      section.Zone = section.IsMade ? zone : section.Zone;
    }
  }
}

//------------------------------------------------------------------------------
// The zone of an interior face without mark; 0 if unknown.
int FluentOutput::GetInteriorZone(const Face& face) const
{
  const int zone = this->InteriorZones.GetZone(this->GetZone(this->GetMeshCell(face.Cells[0])),
    this->GetZone(this->GetMeshCell(face.Cells[1])), face.Size);
  const FluentZone* const known = zone > 0 ? Find(this->KnownZones, zone) : nullptr;
  return known && GetFluentBoundaryType(known->Type) == FluentBoundary::Interior ? zone : 0;
}

//------------------------------------------------------------------------------
// Sorts faces: interior ones first, then the others, both by zone.
void FluentOutput::SortFaces()
{
  using Key = std::pair<bool, int>; // whether outside, and the zone, 0 if unknown
  const FluentZone* const only = this->FindOnlyZone("interior");
  const int interior = only ? only->Id : 0; // of interior faces without mark
  const auto getKey = [this, interior](const Face& face)
  {
    const auto marked = this->MarkedZones.find({ face.Facet, face.Cells[0] });
    if (marked != this->MarkedZones.end())
    {
      return Key{ true, marked->second };
    }
    if (face.Cells[1] < 0)
    {
      return Key{ true, 0 };
    }
    const int zone = this->GetInteriorZone(face);
    return Key{ false, zone > 0 ? zone : interior };
  };
  std::map<Key, vtkIdType> ends; // of the faces of a key
  for (const Face& face : this->Faces)
  {
    ++ends[getKey(face)];
  }
  vtkIdType begin = 0;
  for (auto& [key, end] : ends)
  {
    begin += std::exchange(end, begin);
  }
  std::vector<Face> sorted(this->Faces.size());
  for (const Face& face : this->Faces)
  {
    sorted[static_cast<std::size_t>(ends[getKey(face)]++)] = face;
  }
  this->Faces = std::move(sorted);
  begin = 0;
  for (const auto& [key, end] : ends)
  {
    this->AddFaceSection(std::exchange(begin, end), end, key.second);
  }
}

//------------------------------------------------------------------------------
// Adds consecutive faces of a zone, 0 if unknown.
void FluentOutput::AddFaceSection(vtkIdType begin, vtkIdType end, int id)
{
  std::int32_t least = INT32_MAX, most = 0;
  bool hasInside = false;
  for (vtkIdType i = begin; i < end; ++i)
  {
    const Face& face = this->Faces[static_cast<std::size_t>(i)];
    least = std::min(least, face.Size);
    most = std::max(most, face.Size);
    hasInside = hasInside || face.Cells[1] >= 0;
  }
  const auto marked = this->MarkedTypes.find(id);
  const bool isMarked = marked != this->MarkedTypes.end();
  const std::string given = isMarked ? GetFluentBoundaryName(marked->second) : "";
  const std::string type = !given.empty() ? given : hasInside ? "interior" : "wall";
  const FluentZone* const only = id > 0 ? nullptr : this->FindOnlyZone(type);
  const int zoneId = id > 0 ? id : only ? only->Id : this->GetFreeZone(FirstZone + 1);
  const FluentZone zone = this->Describe(zoneId, type);
  const FluentZone* const known = Find(this->KnownZones, zone.Id);
  constexpr std::int32_t LargestSized = 4;
  Section section{ zone.Id, 0, begin, end };
  section.Element = most > LargestSized ? FluentSection::Polygons
    : least == most && most > 1         ? most
                                        : 0;
  section.IsMade = id == 0 && !known;
  section.IsMarked = isMarked;
  section.IsTyped = !given.empty() || (known && (known->BoundaryType > 0 || !known->Type.empty()));
  for (const int candidate : { isMarked ? marked->second : 0, zone.BoundaryType,
         id > 0 ? GetFluentBoundaryType(zone.Type) : 0,
         hasInside ? FluentBoundary::Interior : FluentBoundary::Wall })
  {
    section.Type = section.Type > 0 ? section.Type : candidate;
  }
  this->Zones.push_back(zone);
  this->FaceSections.push_back(section);
}

//------------------------------------------------------------------------------
// Warns about zones without elements; a mesh of cells alone does not contain its boundaries.
void FluentOutput::WarnOfLostZones(Warnings& warnings) const
{
  constexpr int MaxNames = 5;
  int count = 0;
  std::string list;
  for (const FluentZone& known : this->KnownZones)
  {
    if (!this->FindZone(known.Id) && ++count <= MaxNames)
    {
      list +=
        (count > 1 ? ", " : "") + (known.Name.empty() ? std::to_string(known.Id) : known.Name);
    }
  }
  if (count > 0)
  {
    warnings.Add(CountOf(count, "zone", "zones") +
      " without cells or faces in the mesh, omitted: " + list + (count > MaxNames ? ", ..." : "") +
      "; to keep boundaries, group both outputs of the reader");
  }
}
}
