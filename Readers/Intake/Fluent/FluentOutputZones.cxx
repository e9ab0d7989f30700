// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Zones of cells and faces, from the arrays of the mesh.
#include "Intake/Fluent/FluentOutput.h"

#include "Intake/Fluent/FluentFaces.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <tuple>
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
std::vector<FluentZone> ListZones(vtkFieldData* data, Tally& renamed)
{
  std::vector<FluentZone> zones;
  vtkDataArray* const ids = data->GetArray("ZoneIds");
  auto* const names = vtkStringArray::SafeDownCast(data->GetAbstractArray("ZoneNames"));
  auto* const types = vtkStringArray::SafeDownCast(data->GetAbstractArray("ZoneTypes"));
  vtkDataArray* const numbers = data->GetArray("ZoneBoundaryTypes");
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
    if (names && i < names->GetNumberOfValues())
    {
      zone.Name = Clean(names->GetValue(i));
      if (zone.Name != names->GetValue(i))
      {
        renamed.Add(zone.Id);
      }
    }
    zone.Type = types && i < types->GetNumberOfValues() ? Clean(types->GetValue(i)) : std::string();
    zone.BoundaryType =
      numbers && numbers->GetNumberOfComponents() == 1 && i < numbers->GetNumberOfTuples()
      ? ToBoundaryType(numbers->GetTuple1(i))
      : 0;
    zones.push_back(zone);
  }
  return zones;
}

//------------------------------------------------------------------------------
const FluentZone* FindZone(const std::vector<FluentZone>& zones, int id)
{
  const auto zone = std::find_if(
    zones.begin(), zones.end(), [id](const FluentZone& candidate) { return candidate.Id == id; });
  return zone != zones.end() ? &*zone : nullptr;
}

//------------------------------------------------------------------------------
// An array with a single number per cell; nullptr otherwise.
vtkDataArray* GetCellNumbers(vtkDataSet* mesh, const char* name)
{
  vtkDataArray* const array = mesh->GetCellData()->GetArray(name);
  return array && array->GetNumberOfComponents() == 1 ? array : nullptr;
}
}

//------------------------------------------------------------------------------
void FluentOutput::ReadZones()
{
  vtkFieldData* const data = this->DataSet->GetFieldData();
  this->KnownZones = ListZones(data, this->Renamed);
  this->InteriorZones.Load(data);
  this->ZoneArray = GetCellNumbers(this->DataSet, "Zone");
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
  using Nodes = std::vector<vtkIdType>;
  std::vector<Nodes> wanted;
  std::vector<bool> isOfMark(static_cast<std::size_t>(this->Mesh.GetNumberOfPoints()), false);
  for (const std::int32_t mark : this->Marks)
  {
    wanted.push_back(this->GetMarkNodes(mark));
    for (const vtkIdType point : wanted.back())
    {
      isOfMark[static_cast<std::size_t>(point)] = true;
    }
    std::sort(wanted.back().begin(), wanted.back().end());
  }

  std::vector<std::pair<Nodes, std::size_t>> candidates; // and the face
  Nodes nodes;
  for (std::size_t face = 0; face < this->Faces.size(); ++face)
  {
    this->GetNodes(this->Faces[face], nodes);
    if (std::all_of(nodes.begin(), nodes.end(),
          [&](vtkIdType node) { return isOfMark[static_cast<std::size_t>(node)]; }))
    {
      std::sort(nodes.begin(), nodes.end());
      candidates.emplace_back(nodes, face);
    }
  }
  std::sort(candidates.begin(), candidates.end());

  // For the first candidate with the same nodes, the marks that match it and have a zone.
  std::map<std::size_t, std::vector<std::int32_t>> found;
  Tally repeated;
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    const auto first = std::lower_bound(
      candidates.begin(), candidates.end(), std::make_pair(wanted[i], std::size_t(0)));
    if (first == candidates.end() || first->first != wanted[i])
    {
      this->Lost.Add(this->Marks[i]);
    }
    else if (this->GetZone(this->Marks[i]) > 0)
    {
      found[static_cast<std::size_t>(first - candidates.begin())].push_back(this->Marks[i]);
    }
  }

  vtkDataArray* const types = GetCellNumbers(this->DataSet, "BoundaryType");
  const std::size_t before = this->Faces.size();
  for (const auto& entry : found)
  {
    const std::vector<std::int32_t>& marks = entry.second;
    std::vector<std::size_t> faces;
    for (std::size_t i = entry.first;
      i < candidates.size() && candidates[i].first == candidates[entry.first].first; ++i)
    {
      faces.push_back(candidates[i].second);
    }
    faces = faces.size() == 1 ? this->SplitFace(faces[0], marks) : faces;
    for (const std::size_t face : faces)
    {
      // Of two marks, the one for this side.
      const Face& side = this->Faces[face];
      const auto mark = std::find_if(
        marks.begin(), marks.end(), [&](std::int32_t m) { return this->IsOutward(m, side); });
      const std::int32_t chosen = mark != marks.end() ? *mark : marks[0];
      const int zone = this->GetZone(chosen);
      this->MarkedZones.emplace(std::make_pair(side.Facet, side.Cells[0]), zone);
      this->MarkedTypes.emplace(zone, types ? ToBoundaryType(types->GetTuple1(chosen)) : 0);
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
int FluentOutput::GetFreeZone(int least) const
{
  std::set<int> taken;
  for (const auto* zones : { &this->KnownZones, &this->Zones })
  {
    for (const FluentZone& zone : *zones)
    {
      taken.insert(zone.Id);
    }
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
    count == 1 && only && !this->MarkedTypes.count(only->Id) && !FindZone(this->Zones, only->Id);
  return isFree ? only : nullptr;
}

//------------------------------------------------------------------------------
FluentZone FluentOutput::MakeZone(const std::string& type, int least) const
{
  const FluentZone* const only = this->FindOnlyZone(type);
  return this->Describe(only ? only->Id : this->GetFreeZone(least), type);
}

//------------------------------------------------------------------------------
FluentZone FluentOutput::Describe(int zone, const std::string& type) const
{
  const FluentZone* const known = FindZone(this->KnownZones, zone);
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
  std::set<int> parts;
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
    parts.insert(section.Zone);
    this->CellSections.push_back(section);
    begin = end;
  }
  for (const int part : parts)
  {
    if (part > 0)
    {
      this->Zones.push_back(this->Describe(part, "fluid"));
    }
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
void FluentOutput::WarnOfSplitZones(Warnings& warnings) const
{
  std::map<int, int> parts;
  for (const Section& section : this->CellSections)
  {
    ++parts[section.Zone];
  }
  const auto split = std::count_if(parts.begin(), parts.end(),
    [](const std::pair<const int, int>& part) { return part.second > 1; });
  if (split > 0)
  {
    warnings.Add(std::to_string(split) + (split == 1 ? " zone with cells" : " zones with cells") +
      " that are not consecutive, written as several sections");
  }
}

//------------------------------------------------------------------------------
// The zone of an interior face without mark; 0 if unknown.
int FluentOutput::GetInteriorZone(const Face& face) const
{
  const int zone = this->InteriorZones.GetZone(this->GetZone(this->GetMeshCell(face.Cells[0])),
    this->GetZone(this->GetMeshCell(face.Cells[1])), face.Size);
  const bool isKnown = zone > 0 &&
    std::any_of(this->KnownZones.begin(), this->KnownZones.end(),
      [zone](const FluentZone& known)
      {
        return known.Id == zone && GetFluentBoundaryType(known.Type) == FluentBoundary::Interior;
      });
  return isKnown ? zone : 0;
}

//------------------------------------------------------------------------------
// Sorts faces: interior ones first, then the others, both by zone.
void FluentOutput::SortFaces()
{
  struct Key
  {
    bool IsOutside;
    int Zone; // 0 if unknown
    bool operator<(const Key& other) const
    {
      return std::tie(this->IsOutside, this->Zone) < std::tie(other.IsOutside, other.Zone);
    }
  };
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
  for (auto& key : ends)
  {
    begin += std::exchange(key.second, begin);
  }
  std::vector<Face> sorted(this->Faces.size());
  for (const Face& face : this->Faces)
  {
    sorted[static_cast<std::size_t>(ends[getKey(face)]++)] = face;
  }
  this->Faces = std::move(sorted);
  begin = 0;
  for (const auto& key : ends)
  {
    this->AddFaceSection(begin, key.second, key.first.Zone);
    begin = key.second;
  }
}

//------------------------------------------------------------------------------
// Adds consecutive faces of a zone, 0 if unknown.
void FluentOutput::AddFaceSection(vtkIdType begin, vtkIdType end, int id)
{
  Section section;
  section.Begin = begin;
  section.End = end;
  const std::int32_t size = this->Faces[static_cast<std::size_t>(begin)].Size;
  bool same = true, large = false, hasInside = false;
  for (vtkIdType i = begin; i < end; ++i)
  {
    const Face& face = this->Faces[static_cast<std::size_t>(i)];
    constexpr std::int32_t LargestSized = 4;
    same = same && face.Size == size;
    large = large || face.Size > LargestSized;
    hasInside = hasInside || face.Cells[1] >= 0;
  }
  constexpr int Polygons = 5;
  section.Element = large ? Polygons : same && size > 1 ? size : 0;
  const auto marked = this->MarkedTypes.find(id);
  section.Type = marked != this->MarkedTypes.end() ? marked->second : 0;
  const std::string given = GetFluentBoundaryName(section.Type);
  const std::string type = !given.empty() ? given : hasInside ? "interior" : "wall";
  const FluentZone zone = id > 0 ? this->Describe(id, type) : this->MakeZone(type, FirstZone + 1);
  section.Type = section.Type > 0 ? section.Type : zone.BoundaryType;
  section.Type = section.Type > 0 || id == 0 ? section.Type : GetFluentBoundaryType(zone.Type);
  section.Type = section.Type > 0 ? section.Type
    : hasInside                   ? FluentBoundary::Interior
                                  : FluentBoundary::Wall;
  section.Zone = zone.Id;
  const FluentZone* const known = FindZone(this->KnownZones, zone.Id);
  section.IsTyped = !given.empty() || (known && (known->BoundaryType > 0 || !known->Type.empty()));
  section.IsMarked = marked != this->MarkedTypes.end();
  section.IsMade = id == 0 && !known;
  this->Zones.push_back(zone);
  this->FaceSections.push_back(section);
}

//------------------------------------------------------------------------------
// Warns about zones without elements; a mesh of cells alone does not contain its boundaries.
void FluentOutput::WarnOfLostZones(Warnings& warnings) const
{
  std::vector<std::string> names;
  for (const FluentZone& known : this->KnownZones)
  {
    if (!FindZone(this->Zones, known.Id))
    {
      names.push_back(known.Name.empty() ? std::to_string(known.Id) : known.Name);
    }
  }
  if (names.empty())
  {
    return;
  }
  constexpr std::size_t MaxNames = 5;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), MaxNames); ++i)
  {
    list += (i > 0 ? ", " : "") + names[i];
  }
  warnings.Add(std::to_string(names.size()) +
    (names.size() == 1 ? " zone without cells or faces in the mesh, omitted: "
                       : " zones without cells or faces in the mesh, omitted: ") +
    list + (names.size() > MaxNames ? ", ..." : "") +
    "; to keep boundaries, group both outputs of the reader");
}
}
