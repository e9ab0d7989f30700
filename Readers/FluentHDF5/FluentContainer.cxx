// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentContainer.h"

#include "Base/Number.h"
#include "Intake/Fluent/FluentFaces.h"
#include "Intake/Fluent/FluentText.h"

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
bool FluentContainer::Open(const Progress& progress)
{
  const HDF5Object root = this->File.GetRoot();
  root.Check(root.Has("meshes"), ErrorKind::NotThisFormat, "a Fluent mesh in the group meshes",
    root.Has("results") ? "results only; the mesh is in the case file (.cas.h5)"
                        : "another content");
  const HDF5Object mesh = root.Open("meshes/1");
  this->ReadTotals(mesh);
  this->ReadTypeNames(root);
  if (this->DeclaredNodes.Count > 0)
  {
    this->OpenNodes(mesh.Open("nodes/coords"));
  }
  if (this->DeclaredCells.Count > 0)
  {
    this->OpenCells(mesh.Open("cells"));
  }
  if (this->DeclaredFaces.Count > 0)
  {
    this->OpenFaces(mesh.Open("faces"), progress);
  }
  this->FindUnused(root);
  return !progress.IsStopped();
}

//------------------------------------------------------------------------------
std::vector<std::string> FluentContainer::ListZones()
{
  const HDF5Object root = this->File.GetRoot(), mesh = root.Open("meshes/1");
  this->ReadTotals(mesh);
  this->ReadTypeNames(root);
  std::vector<std::string> names;
  const auto add = [&names](const std::string& name)
  {
    if (std::find(names.begin(), names.end(), name) == names.end())
    {
      names.push_back(name);
    }
  };
  const bool hasCells = this->DeclaredCells.Count > 0;
  for (const ZoneRow& zone : hasCells
      ? this->ReadZones(mesh.Open("cells"), "cells", this->DeclaredCells.Count, Fluid)
      : std::vector<ZoneRow>())
  {
    add(zone.Name);
  }
  const HDF5Object faces = mesh.Open("faces");
  this->OpenSides(faces);
  for (const ZoneRow& zone : this->ReadZones(faces, "faces", this->DeclaredFaces.Count, NoType))
  {
    const int type = this->GetBoundaryType(zone);
    if (!hasCells || (type != FluentBoundary::Interior && type != FluentBoundary::Parent))
    {
      add(zone.Name);
    }
  }
  return names;
}

//------------------------------------------------------------------------------
void FluentContainer::LeaveOut(const std::vector<std::string>& zones)
{
  const std::set<std::string> names(zones.begin(), zones.end());
  for (const FluentZone& zone : this->Zones)
  {
    if (names.count(zone.Name) > 0)
    {
      this->ZonesLeftOut.insert(zone.Id);
    }
  }
}

//------------------------------------------------------------------------------
void FluentContainer::ReadTotals(const HDF5Object& mesh)
{
  const std::int64_t dimension = mesh.GetNumber("dimension");
  mesh.Check(dimension == 2 || dimension == 3, ErrorKind::Syntax, "the dimension 2 or 3",
    std::to_string(dimension));
  this->Dimension = static_cast<int>(dimension);
  const auto read = [&mesh](const char* name)
  {
    const std::int64_t number = mesh.GetNumber(name);
    mesh.Check(number >= 0 && number <= INT32_MAX, ErrorKind::Count,
      std::string("the attribute ") + name + " from 0 to " + std::to_string(INT32_MAX),
      std::to_string(number));
    return number;
  };
  this->DeclaredNodes.Count = read("nodeCount");
  this->DeclaredCells.Count = read("cellCount");
  this->DeclaredFaces.Count = read("faceCount");
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
  table.CheckDeclared("nZones", static_cast<std::size_t>(count), "zones");
  const auto read = [&](const char* name) { return table.Open(name).ReadNumbers(count); };
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
  HDF5Column ranges;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    if (ids[i] < 1)
    {
      idData.FailAt(static_cast<std::int64_t>(i), ErrorKind::Index, "a positive zone id",
        std::to_string(ids[i]));
    }
    const HDF5Column::Section range{ firsts[i], lasts[i], "" };
    zones.push_back({ ids[i], range.First, range.IsEmpty() ? range.First - 1 : range.Last, types[i],
      names.empty() || names[i].empty() ? "zone-" + std::to_string(ids[i]) : names[i] });
    ranges.Add(range);
  }
  ranges.Finish(table, what, last, true);
  return zones;
}

//------------------------------------------------------------------------------
void FluentContainer::AddZone(const ZoneRow& zone, const std::string& usualType)
{
  const auto named = this->TypeNames.find(zone.Id);
  this->Zones.push_back(
    { zone.Id, named != this->TypeNames.end() ? named->second : usualType, zone.Name, 0 });
}

//------------------------------------------------------------------------------
void FluentContainer::OpenNodes(const HDF5Object& group)
{
  bool isSingle = true;
  this->Coordinates.Open(group, "nodes", this->DeclaredNodes.Count, true,
    [&](const HDF5Object& data, HDF5Column::Section& section)
    {
      section.SetData(data);
      data.Check(data.GetColumns() == this->Dimension, ErrorKind::Count,
        std::to_string(this->Dimension) + " coordinates per node",
        std::to_string(data.GetColumns()));
      isSingle = isSingle && data.GetValueSize() <= static_cast<int>(sizeof(float));
    });
  this->Nodes.push_back(FluentSection::MakeStored(
    FluentSection::NodesIndex, { 1, 1, this->DeclaredNodes.Count, 1, this->Dimension }));
  this->Nodes.back().RealSize = isSingle ? sizeof(float) : sizeof(double);
}

//------------------------------------------------------------------------------
void FluentContainer::OpenCells(const HDF5Object& cells)
{
  const std::vector<ZoneRow> zones =
    this->ReadZones(cells, "cells", this->DeclaredCells.Count, Fluid);
  const bool hasTypes = cells.Has("ctype");
  if (hasTypes)
  {
    this->Types.Open(cells.Open("ctype"), "cells", this->DeclaredCells.Count, true,
      [](const HDF5Object& part, HDF5Column::Section& section)
      {
        const std::int64_t element = part.GetNumber("elementType");
        part.Check(element >= 0 && element <= MaxElement, ErrorKind::Index,
          "an elementType from 0 to 7", std::to_string(element));
        section.Value = static_cast<std::int32_t>(element);
        if (element == 0)
        {
          section.SetData(part.Open("cell-types"));
        }
      });
  }
  for (const ZoneRow& zone : zones)
  {
    this->AddZone(zone, zone.Type == Solid ? "solid" : "fluid");
    if (zone.First <= zone.Last)
    {
      this->Cells.push_back(FluentSection::MakeStored(FluentSection::CellsIndex,
        { zone.Id, zone.First, zone.Last, zone.Type, hasTypes ? this->GetElement(zone) : 0 }));
      this->Cells.back().IsStored = hasTypes;
    }
  }
}

//------------------------------------------------------------------------------
// The type of all cells of a zone, 0 if they may differ.
std::int32_t FluentContainer::GetElement(const ZoneRow& zone) const
{
  std::int32_t element = -1;
  for (const HDF5Column::Section& section : this->Types.GetSections())
  {
    if (section.First <= zone.Last && section.Last >= zone.First)
    {
      element = element < 0 || element == section.Value ? section.Value : 0;
    }
  }
  return std::max(element, 0);
}

//------------------------------------------------------------------------------
void FluentContainer::FindUnused(const HDF5Object& root)
{
  const auto add = [&](const std::string& path, const std::set<std::string>& used)
  {
    const bool isGroup = root.Has(path) && !root.Open(path).IsData();
    for (const std::string& name :
      isGroup ? root.Open(path).GetNames() : std::vector<std::string>())
    {
      if (!used.count(name))
      {
        this->Unused.push_back(path + "/" + name);
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
      const auto ids = root.Has(path) ? root.Open(path).ReadNumbers(root.Open(path).GetCount())
                                      : std::vector<std::int32_t>();
      if (std::any_of(ids.begin(), ids.end(), [](std::int32_t id) { return id != 0; }))
      {
        this->Unused.push_back(path);
      }
    }
  }
  add("special", {});
}

//------------------------------------------------------------------------------
bool FluentContainer::LoadStored(const FluentSection& section, std::int64_t first,
  std::int64_t count, Buffer<std::int32_t>& values)
{
  const std::int64_t id = section.Header[1] + first;
  const auto size = static_cast<std::int32_t>(section.GetElement());
  section.Index == FluentSection::CellsIndex
    ? this->LoadTypes(id, count, values)
    : this->LoadFaces(id, count, size == FluentSection::Polygons ? 0 : size, values);
  return true;
}

//------------------------------------------------------------------------------
bool FluentContainer::LoadStored(
  const FluentSection&, std::int64_t first, std::int64_t count, Buffer<double>& values)
{
  const std::int64_t size = count * this->Dimension;
  values = values.size() < size ? Buffer<double>(size) : std::move(values);
  this->Coordinates.Read(this->File, 1 + first, count, values.data(), this->Dimension);
  return true;
}

//------------------------------------------------------------------------------
void FluentContainer::LoadTypes(std::int64_t id, std::int64_t count, Buffer<std::int32_t>& values)
{
  values = Buffer<std::int32_t>(count);
  this->Types.Read(this->File, id, count, values.data());
  for (std::int64_t i = 0; i < count; ++i)
  {
    if (values[i] < 0 || values[i] > MaxElement)
    {
      this->Types.FailAt(this->File, id + i, ErrorKind::Index,
        "the type of cell " + std::to_string(id + i) + " from 0 to 7", std::to_string(values[i]));
    }
  }
}
}
