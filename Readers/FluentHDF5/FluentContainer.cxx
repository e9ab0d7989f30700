// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentContainer.h"

#include "Base/Number.h"
#include "Intake/Fluent/FluentFaces.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <string_view>

namespace camaron
{
namespace
{
constexpr int MaxElement = 7; // of the types of cells
}

//------------------------------------------------------------------------------
bool FluentContainer::Open(const Progress& progress, bool zonesOnly)
{
  const HDF5Object root = this->File.GetRoot();
  root.Check(root.Has("meshes"), ErrorKind::NotThisFormat, "a Fluent mesh in the group meshes",
    root.Has("results") ? "results only; the mesh is in the case file (.cas.h5)"
                        : "another content");
  const HDF5Object mesh = root.Open("meshes/1");
  this->Dimension = static_cast<int>(mesh.GetNumber("dimension", 2, 3));
  this->DeclaredNodes.Count = mesh.GetNumber("nodeCount", 0, INT32_MAX);
  this->DeclaredCells.Count = mesh.GetNumber("cellCount", 0, INT32_MAX);
  this->DeclaredFaces.Count = mesh.GetNumber("faceCount", 0, INT32_MAX);
  this->ReadTypeNames(root);
  const std::int64_t nodes = this->DeclaredNodes.Count;
  if (nodes > 0)
  {
    this->Coordinates.Open(mesh.Open("nodes/coords"), "nodes", nodes, true, this->Dimension);
    this->Nodes.push_back(
      FluentSection::MakeStored(FluentSection::NodesIndex, { 1, 1, nodes, 1, this->Dimension }));
    this->Nodes.back().RealSize = this->Coordinates.IsSingle() ? sizeof(float) : sizeof(double);
  }
  if (this->DeclaredCells.Count > 0)
  {
    this->OpenCells(mesh.Open("cells"));
  }
  if (this->DeclaredFaces.Count > 0)
  {
    this->OpenFaces(mesh.Open("faces"), progress, zonesOnly);
  }
  return !progress.IsStopped();
}

//------------------------------------------------------------------------------
std::vector<std::string> FluentContainer::GetZoneNames() const
{
  std::vector<std::string> names;
  for (const FluentZone& zone : this->Zones)
  {
    const bool isHidden = this->DeclaredCells.Count > 0 &&
      (zone.BoundaryType == FluentBoundary::Interior ||
        zone.BoundaryType == FluentBoundary::Parent);
    if (!isHidden && std::find(names.begin(), names.end(), zone.Name) == names.end())
    {
      names.push_back(zone.Name);
    }
  }
  return names;
}

//------------------------------------------------------------------------------
void FluentContainer::Choose(const std::vector<std::string>& zones, Warnings& warnings)
{
  std::set<std::string> chosen(zones.begin(), zones.end()), unknown = chosen;
  for (const FluentZone& zone : this->Zones)
  {
    unknown.erase(zone.Name);
    if (chosen.count(zone.Name) == 0)
    {
      this->ZonesLeftOut.insert(zone.Id);
    }
  }
  for (const std::string& name : unknown)
  {
    warnings.Add("there is no zone " + QuoteWord(name));
  }
}

//------------------------------------------------------------------------------
// The zones in the settings are sections of a file in text, "(39 (id type name ...", which name
// types that share a number.
void FluentContainer::ReadTypeNames(const HDF5Object& root)
{
  constexpr const char* Path = "settings/Thread Variables";
  constexpr std::string_view Mark = "(39 (";
  const std::string text = root.Has(Path) ? root.Open(Path).ReadText() : std::string();
  for (std::size_t at = text.find(Mark); at != std::string::npos; at = text.find(Mark, at + 1))
  {
    std::int64_t id = 0;
    const char* const end = text.data() + text.size();
    const char* word = ParseInteger(text.data() + at + Mark.size(), end, id);
    if (word && id > 0 && id <= INT32_MAX)
    {
      word = SkipSpaceFrom(word, end);
      const char* const last =
        std::find_if(word, end, [](char c) { return IsSpace(c) || c == '(' || c == ')'; });
      this->TypeNames.emplace(static_cast<int>(id), std::string(word, last));
    }
  }
}

//------------------------------------------------------------------------------
// The zones in the order of the file, which together have all ids from 1 to the last.
std::vector<FluentContainer::ZoneRow> FluentContainer::ReadZones(
  const HDF5Object& group, const char* what, std::int64_t last, int usualType)
{
  const HDF5Object table = group.Open("zoneTopology");
  const HDF5Object idData = table.Open("id");
  const std::int64_t count = idData.GetCount();
  table.CheckDeclared("nZones", count, "zones");
  const auto read = [&](const char* name)
  {
    const HDF5Object data = table.Open(name);
    data.Check(data.GetCount() == count, ErrorKind::Count, std::to_string(count) + " entries",
      std::to_string(data.GetCount()));
    return data.ReadNumbers();
  };
  const auto ids = read("id"), firsts = read("minId"), lasts = read("maxId");
  const auto types = table.Has("zoneType") ? read("zoneType") : std::vector(ids.size(), usualType);
  std::vector<std::string> names;
  if (table.Has("name"))
  {
    const HDF5Object data = table.Open("name");
    std::istringstream text(data.ReadText() + ";"); // so that the last name may be empty, too
    for (std::string name; std::getline(text, name, ';');)
    {
      names.push_back(name);
    }
    if (names.size() == ids.size() + 1 && names.back().empty())
    {
      names.pop_back(); // after a separator at the end
    }
    data.Check(names.size() == ids.size(), ErrorKind::Count,
      std::to_string(count) + " names of zones", std::to_string(names.size()));
  }
  std::vector<ZoneRow> zones;
  HDF5Column ranges(this->File);
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    this->File.CheckRange(idData.GetPath() + "[" + std::to_string(i) + "]", ids[i], 1,
      INT32_MAX - 1, "a zone id"); // larger ones are INT32_MAX
    const HDF5Column::Section range{ firsts[i], lasts[i], "" };
    const auto type = this->TypeNames.find(ids[i]);
    zones.push_back({ ids[i], range.First, range.IsEmpty() ? range.First - 1 : range.Last, types[i],
      names.empty() || names[i].empty() ? "zone-" + std::to_string(ids[i]) : names[i],
      type != this->TypeNames.end() ? type->second : "" });
    ranges.Add(range);
  }
  ranges.Finish(table, what, last, true);
  return zones;
}

//------------------------------------------------------------------------------
void FluentContainer::OpenCells(const HDF5Object& cells)
{
  const std::vector<ZoneRow> zones =
    this->ReadZones(cells, "cells", this->DeclaredCells.Count, Fluid);
  const bool hasTypes = cells.Has("ctype");
  if (hasTypes)
  {
    this->Types.Open(cells.Open("ctype"), "cells", this->DeclaredCells.Count, true, 1, "cell-types",
      [](const HDF5Object& part) { return part.GetNumber("elementType", 0, MaxElement); });
  }
  else
  {
    this->Types.Add({ 1, this->DeclaredCells.Count, "" });
  }
  for (const ZoneRow& zone : zones)
  {
    const std::string usual = zone.Type == Solid ? "solid" : "fluid";
    this->Zones.push_back({ zone.Id, zone.TypeName.empty() ? usual : zone.TypeName, zone.Name });
    for (const HDF5Column::Section& part : this->Types.GetSections())
    {
      const std::int64_t first = std::max(zone.First, part.First);
      const std::int64_t last = std::min(zone.Last, part.Last);
      if (first <= last)
      {
        this->Cells.push_back(FluentSection::MakeStored(
          FluentSection::CellsIndex, { zone.Id, first, last, zone.Type, part.Value }));
        this->Cells.back().IsStored = hasTypes;
      }
    }
  }
}

//------------------------------------------------------------------------------
void FluentContainer::WarnOfUnused(Warnings& warnings) const
{
  const HDF5Object root = this->File.GetRoot();
  constexpr int MaxNames = 8;
  std::string list;
  int count = 0;
  const auto note = [&](const std::string& path)
  {
    list += count == 0 ? path : count < MaxNames ? ", " + path : count == MaxNames ? ", ..." : "";
    ++count;
  };
  const auto add = [&](const std::string& path, const std::set<std::string>& used)
  {
    const bool isGroup = root.Has(path) && !root.Open(path).IsData();
    for (const std::string& name :
      isGroup ? root.Open(path).GetNames() : std::vector<std::string>())
    {
      if (!used.count(name))
      {
        note(path + "/" + name);
      }
    }
  };
  add("meshes", { "1" });
  add("meshes/1", { "nodes", "cells", "faces" });
  add("meshes/1/nodes", { "coords", "zoneTopology" });
  for (const std::string group : { "meshes/1/cells", "meshes/1/faces" })
  {
    add(group, { "nodes", "c0", "c1", "ctype", "zoneTopology", "tree", "interface" });
    for (const char* column : { "/zoneTopology/childZoneId", "/zoneTopology/shadowZoneId" })
    {
      const std::string path = group + column;
      const auto ids = root.Has(path) ? root.Open(path).ReadNumbers() : std::vector<std::int32_t>();
      if (std::any_of(ids.begin(), ids.end(), [](std::int32_t id) { return id != 0; }))
      {
        note(path);
      }
    }
  }
  add("special", {});
  if (count > 0)
  {
    warnings.Add("the file has data that are not used: " + list);
  }
}

//------------------------------------------------------------------------------
void FluentContainer::LoadStored(const FluentSection& section, std::int64_t first,
  std::int64_t count, Buffer<std::int32_t>& values)
{
  const std::int64_t id = section.Header[1] + first;
  if (section.Index == FluentSection::FacesIndex)
  {
    this->LoadFaces(id, count, static_cast<std::int32_t>(section.GetElement()), values);
    return;
  }
  values = Buffer<std::int32_t>(count);
  this->Types.Read(id, count, values.data());
  for (std::int64_t i = 0; i < count; ++i)
  {
    if (values[i] < 0 || values[i] > MaxElement)
    {
      this->File.CheckRange(this->Types.Locate(id + i), values[i], 0, MaxElement,
        "the type of cell " + std::to_string(id + i));
    }
  }
}

//------------------------------------------------------------------------------
void FluentContainer::LoadStored(
  const FluentSection&, std::int64_t first, std::int64_t count, Buffer<double>& values)
{
  const std::int64_t size = count * this->Dimension;
  values = values.size() < size ? Buffer<double>(size) : std::move(values);
  this->Coordinates.Read(1 + first, count, values.data());
}
}
