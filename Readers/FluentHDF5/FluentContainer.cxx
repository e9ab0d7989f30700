// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentContainer.h"

#include "Base/Number.h"
#include "Base/Parallel.h"
#include "Intake/Fluent/FluentFaces.h"
#include "Intake/Fluent/FluentText.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <numeric>
#include <set>
#include <string_view>

namespace camaron
{
namespace
{
constexpr int MaxElement = 7; // of the types of cells
constexpr int NoType = -1;

//------------------------------------------------------------------------------
std::vector<std::int32_t> ReadNumbers(const HDF5Object& group, const char* name, std::int64_t count)
{
  const HDF5Object data = group.Open(name);
  data.Check(data.IsData() && data.GetCount() == count && data.GetColumns() == 1, ErrorKind::Count,
    std::to_string(count) + " entries", std::to_string(data.GetCount()));
  std::vector<std::int32_t> values(static_cast<std::size_t>(count));
  data.Read(0, count, values.data());
  return values;
}

//------------------------------------------------------------------------------
// Whether some entry of an optional column of a zone table is not zero.
bool HasEntries(const HDF5Object& table, const char* name)
{
  if (!table.Has(name))
  {
    return false;
  }
  const HDF5Object data = table.Open(name);
  const std::vector<std::int32_t> values = ReadNumbers(table, name, data.GetCount());
  return std::any_of(values.begin(), values.end(), [](std::int32_t value) { return value != 0; });
}

//------------------------------------------------------------------------------
std::vector<std::string> SplitNames(const std::string& text)
{
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin < text.size();)
  {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    names.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return names;
}
}

//------------------------------------------------------------------------------
FluentContainer::FluentContainer(const std::string& name, const char* begin, const char* end)
  : FluentFile(name, begin, end)
  , File(name, begin, end)
{
}

//------------------------------------------------------------------------------
bool FluentContainer::HasMesh(const char* begin, const char* end)
{
  try
  {
    HDF5File file("", begin, end);
    const HDF5Object root = file.GetRoot();
    return root.Has("meshes") && root.Open("meshes").Has("1");
  }
  catch (const HDF5Error&)
  {
    return false;
  }
}

//------------------------------------------------------------------------------
template <typename Function>
bool FluentContainer::Catch(Function&& function)
{
  try
  {
    function();
  }
  catch (const HDF5Error& error)
  {
    this->Error = this->HasFailed() ? this->Error : error.Error;
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool FluentContainer::Open(const Progress& progress)
{
  return this->Catch(
           [&]
           {
             const HDF5Object root = this->File.GetRoot();
             root.Check(root.Has("meshes"), ErrorKind::NotThisFormat,
               "a Fluent mesh in the group meshes",
               root.Has("results") ? "results only; the mesh is in the case file (.cas.h5)"
                                   : "another content");
             const HDF5Object mesh = root.Open("meshes").Open("1");
             this->ReadTotals(mesh);
             this->ReadTypeNames(root);
             if (this->NumberOfNodes > 0)
             {
               this->OpenNodes(mesh.Open("nodes"));
             }
             if (this->NumberOfCells > 0)
             {
               this->OpenCells(mesh.Open("cells"));
             }
             if (this->NumberOfFaces > 0)
             {
               this->OpenFaces(mesh.Open("faces"), progress);
             }
             this->FindUnused(root);
           }) &&
    !progress.IsStopped();
}

//------------------------------------------------------------------------------
void FluentContainer::ReadTotals(const HDF5Object& mesh)
{
  const std::int64_t dimension = mesh.GetNumber("dimension");
  mesh.Check(dimension == 2 || dimension == 3, ErrorKind::Syntax, "the dimension 2 or 3",
    std::to_string(dimension));
  this->Dimension = static_cast<int>(dimension);
  const auto read = [&mesh](const char* name, std::int64_t& number, FluentTotal& total)
  {
    number = total.Count = mesh.GetNumber(name);
    mesh.Check(number >= 0 && number <= INT32_MAX, ErrorKind::Count,
      std::string("the attribute ") + name + " from 0 to " + std::to_string(INT32_MAX),
      std::to_string(number));
  };
  read("nodeCount", this->NumberOfNodes, this->DeclaredNodes);
  read("cellCount", this->NumberOfCells, this->DeclaredCells);
  read("faceCount", this->NumberOfFaces, this->DeclaredFaces);
}

//------------------------------------------------------------------------------
// The zones in the settings are sections of a file in text, "(39 (id type name ...", which name
// types that share a number.
void FluentContainer::ReadTypeNames(const HDF5Object& root)
{
  if (!root.Has("settings"))
  {
    return;
  }
  const HDF5Object settings = root.Open("settings");
  if (!settings.Has("Thread Variables"))
  {
    return;
  }
  constexpr std::string_view Mark = "(39 (";
  const std::string text = settings.Open("Thread Variables").ReadText();
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
  const auto declared = table.FindNumber("nZones");
  table.Check(!declared || *declared == count, ErrorKind::Count,
    std::to_string(declared.value_or(0)) + " zones, as nZones says", std::to_string(count));
  const auto ids = ReadNumbers(table, "id", count);
  const auto firsts = ReadNumbers(table, "minId", count);
  const auto lasts = ReadNumbers(table, "maxId", count);
  const bool hasTypes = table.Has("zoneType");
  const auto types = hasTypes ? ReadNumbers(table, "zoneType", count) : std::vector<std::int32_t>();
  std::vector<std::string> names;
  if (table.Has("name"))
  {
    const HDF5Object data = table.Open("name");
    names = SplitNames(data.ReadText());
    data.Check(static_cast<std::int64_t>(names.size()) == count, ErrorKind::Count,
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
    zones.push_back({ ids[i], firsts[i], lasts[i], hasTypes ? types[i] : usualType,
      names.empty() ? "zone-" + std::to_string(ids[i]) : names[i] });
    if (firsts[i] <= lasts[i])
    {
      ranges.Add({ firsts[i], lasts[i], "" });
    }
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
void FluentContainer::OpenNodes(const HDF5Object& nodes)
{
  constexpr int SinglePrecision = 4, DoublePrecision = 8; // bytes
  const HDF5Object group = nodes.Open("coords");
  bool isSingle = true;
  for (const std::string& name : group.GetNames())
  {
    const HDF5Object data = group.Open(name);
    this->Coordinates.Add(data, data);
    data.Check(data.GetColumns() == this->Dimension, ErrorKind::Count,
      std::to_string(this->Dimension) + " coordinates per node", std::to_string(data.GetColumns()));
    isSingle = isSingle && data.GetValueSize() <= SinglePrecision;
  }
  this->Coordinates.Finish(group, "nodes", this->NumberOfNodes, true);
  FluentSection section;
  section.Index = FluentSection::NodesIndex;
  section.RealSize = isSingle ? SinglePrecision : DoublePrecision;
  section.IsStored = true;
  const std::int64_t header[] = { 1, 1, this->NumberOfNodes, 1, this->Dimension };
  std::copy(std::begin(header), std::end(header), section.Header);
  section.HeaderSize = static_cast<int>(std::size(header));
  this->Nodes.push_back(std::move(section));
}

//------------------------------------------------------------------------------
void FluentContainer::OpenCells(const HDF5Object& cells)
{
  constexpr int Fluid = 1, Solid = 17; // types of zones
  const std::vector<ZoneRow> zones = this->ReadZones(cells, "cells", this->NumberOfCells, Fluid);
  const bool hasTypes = cells.Has("ctype");
  if (hasTypes)
  {
    const HDF5Object group = cells.Open("ctype");
    for (const std::string& name : GetSectionNames(group))
    {
      const HDF5Object part = group.Open(name);
      HDF5Column::Section section;
      const bool hasIds = GetRange(part, section);
      const std::int64_t element = part.GetNumber("elementType");
      part.Check(element >= 0 && element <= MaxElement, ErrorKind::Index,
        "an elementType from 0 to 7", std::to_string(element));
      section.Value = static_cast<std::int32_t>(element);
      if (element == 0)
      {
        const HDF5Object data = part.Open("cell-types");
        CheckCount(data, section);
        section.Path = data.GetPath();
      }
      if (hasIds)
      {
        this->Types.Add(section);
      }
    }
    this->Types.Finish(group, "cells", this->NumberOfCells, true);
  }
  for (const ZoneRow& zone : zones)
  {
    this->AddZone(zone, zone.Type == Solid ? "solid" : "fluid");
    if (zone.First > zone.Last)
    {
      continue;
    }
    FluentSection section;
    section.Index = FluentSection::CellsIndex;
    section.RealSize = sizeof(double);
    section.IsStored = hasTypes;
    const std::int64_t header[] = { zone.Id, zone.First, zone.Last, zone.Type,
      hasTypes ? this->GetElement(zone) : 0 };
    std::copy(std::begin(header), std::end(header), section.Header);
    section.HeaderSize = static_cast<int>(std::size(header));
    this->Cells.push_back(std::move(section));
  }
}

//------------------------------------------------------------------------------
// The type of all cells of a zone, 0 if they may differ.
std::int32_t FluentContainer::GetElement(const ZoneRow& zone) const
{
  std::set<std::int32_t> elements;
  for (const HDF5Column::Section& section : this->Types.GetSections())
  {
    if (section.First <= zone.Last && section.Last >= zone.First)
    {
      elements.insert(section.Value);
    }
  }
  return elements.size() == 1 ? *elements.begin() : 0;
}

//------------------------------------------------------------------------------
void FluentContainer::OpenSides(
  const HDF5Object& faces, const char* name, HDF5Column& column, bool isComplete)
{
  if (!faces.Has(name) && !isComplete)
  {
    return;
  }
  const HDF5Object group = faces.Open(name);
  for (const std::string& part : GetSectionNames(group))
  {
    const HDF5Object data = group.Open(part);
    column.Add(data, data);
  }
  column.Finish(group, "faces", this->NumberOfFaces, isComplete);
}

//------------------------------------------------------------------------------
void FluentContainer::OpenFaces(const HDF5Object& faces, const Progress& progress)
{
  std::vector<ZoneRow> zones = this->ReadZones(faces, "faces", this->NumberOfFaces, NoType);
  const HDF5Object group = faces.Open("nodes");
  for (const std::string& name : GetSectionNames(group))
  {
    const HDF5Object part = group.Open(name);
    const HDF5Object sizes = part.Open("nnodes"), nodes = part.Open("nodes");
    this->Sizes.Add(part, sizes);
    nodes.Check(nodes.IsData() && nodes.GetColumns() == 1 && sizes.GetColumns() == 1,
      ErrorKind::Syntax, "a list of numbers", "something else");
  }
  this->Sizes.Finish(group, "faces", this->NumberOfFaces, true);
  this->OpenSides(faces, "c0", this->Sides[0], this->NumberOfCells > 0);
  this->OpenSides(faces, "c1", this->Sides[1], false);
  this->MeasureFaces(group, zones, progress);
  this->AddFaces(faces, zones);
  this->OpenTrees(faces);
  this->OpenInterfaces(faces);
}

//------------------------------------------------------------------------------
// Finds where the nodes of faces are, and the smallest and greatest number in each zone.
void FluentContainer::MeasureFaces(
  const HDF5Object& group, std::vector<ZoneRow>& zones, const Progress& progress)
{
  std::vector<ZoneRow*> sorted;
  for (ZoneRow& zone : zones)
  {
    if (zone.First <= zone.Last)
    {
      sorted.push_back(&zone);
    }
  }
  std::sort(sorted.begin(), sorted.end(),
    [](const ZoneRow* a, const ZoneRow* b) { return a->First < b->First; });
  auto zone = sorted.begin();
  std::int64_t total = 0, before = 0, id = 1;
  const std::int64_t batch = GetStoredBatch(this->NumberOfFaces);
  std::vector<std::int32_t> sizes(static_cast<std::size_t>(batch));
  for (const HDF5Column::Section& section : this->Sizes.GetSections())
  {
    for (; id <= section.Last && !progress.IsStopped();)
    {
      const std::int64_t count = std::min(batch, section.Last - id + 1);
      this->Sizes.Read(this->File, id, count, sizes.data());
      for (std::int64_t i = 0; i < count; ++i, ++id)
      {
        const std::int32_t size = sizes[static_cast<std::size_t>(i)];
        if (size < 0)
        {
          this->Sizes.FailAt(
            this->File, id, ErrorKind::Count, "a number of nodes", std::to_string(size));
        }
        if ((id - 1) % BlockSize == 0)
        {
          this->Offsets.push_back(total);
        }
        total += size;
        zone += id > (*zone)->Last ? 1 : 0;
        (*zone)->LeastSize = std::min((*zone)->LeastSize, size);
        (*zone)->MostSize = std::max((*zone)->MostSize, size);
      }
      progress.Report(static_cast<double>(id) / static_cast<double>(this->NumberOfFaces + 1));
    }
    // "nnodes" and "nodes" are in the same group.
    const std::string path = section.Path.substr(0, section.Path.rfind('/')) + "/nodes";
    const HDF5Object nodes = this->File.Reopen(path);
    nodes.Check(progress.IsStopped() || nodes.GetCount() == total - before, ErrorKind::Count,
      std::to_string(total - before) + " node ids, as nnodes says",
      std::to_string(nodes.GetCount()));
    if (total > before)
    {
      this->Lists.Add({ before + 1, total, path });
    }
    before = total;
  }
  this->Lists.Finish(group, "node ids", total, !progress.IsStopped());
}

//------------------------------------------------------------------------------
void FluentContainer::AddFaces(const HDF5Object& faces, const std::vector<ZoneRow>& zones)
{
  constexpr std::int32_t LargestSized = 4;
  for (const ZoneRow& zone : zones)
  {
    const auto named = this->TypeNames.find(zone.Id);
    int type = zone.Type;
    if (type == NoType && named != this->TypeNames.end())
    {
      type = GetFluentBoundaryType(named->second);
    }
    if (type == NoType || (type == 0 && zone.Type == NoType))
    {
      // Only faces with two cells are in the data sets of the second cell, or most of them.
      type = this->NumberOfCells > 0 && this->Sides[1].Contains(zone.First, zone.Last)
        ? FluentBoundary::Interior
        : FluentBoundary::Wall;
    }
    const std::string name = GetFluentBoundaryName(type % FluentBoundary::Nonconformal);
    this->AddZone(zone,
      type == FluentBoundary::Parent ? "parent-face"
        : name.empty()               ? "unknown"
                                     : name);
    if (zone.First > zone.Last)
    {
      continue;
    }
    faces.Check(this->NumberOfCells == 0 || type != FluentBoundary::Interior ||
        this->Sides[1].Contains(zone.First, zone.Last),
      ErrorKind::Truncated,
      "second cells (c1) of the interior faces " + std::to_string(zone.First) + " to " +
        std::to_string(zone.Last),
      "none for some of them");
    FluentSection section;
    section.Index = FluentSection::FacesIndex;
    section.RealSize = sizeof(double);
    section.IsStored = true;
    const bool isSized =
      zone.LeastSize == zone.MostSize && zone.MostSize >= 2 && zone.MostSize <= LargestSized;
    const std::int64_t header[] = { zone.Id, zone.First, zone.Last, type,
      isSized                          ? zone.MostSize
        : zone.MostSize > LargestSized ? FluentSection::Polygons
                                       : 0 };
    std::copy(std::begin(header), std::end(header), section.Header);
    section.HeaderSize = static_cast<int>(std::size(header));
    this->Faces.push_back(std::move(section));
  }
}

//------------------------------------------------------------------------------
// Split faces, in the form of binary sections: n child1 ... childn.
void FluentContainer::OpenTrees(const HDF5Object& faces)
{
  if (!faces.Has("tree"))
  {
    return;
  }
  const HDF5Object group = faces.Open("tree");
  for (const std::string& name : GetSectionNames(group))
  {
    const HDF5Object part = group.Open(name);
    HDF5Column::Section range;
    GetRange(part, range);
    const HDF5Object sizeData = part.Open("nkids"), kidData = part.Open("kids");
    CheckCount(sizeData, range);
    const auto sizes = ReadNumbers(part, "nkids", sizeData.GetCount());
    const auto kids = ReadNumbers(part, "kids", kidData.GetCount());
    Buffer<std::int32_t> words(static_cast<vtkIdType>(sizes.size() + kids.size()));
    std::int32_t* word = words.data();
    std::size_t next = 0;
    for (const std::int32_t size : sizes)
    {
      const bool fits = size >= 0 && static_cast<std::size_t>(size) <= kids.size() - next;
      kidData.Check(
        fits, ErrorKind::Count, "as many parts as nkids says", std::to_string(kids.size()));
      *word++ = size;
      word = std::copy_n(kids.data() + next, size, word);
      next += static_cast<std::size_t>(size);
    }
    FluentSection section;
    section.Index = FluentSection::FaceTreeIndex;
    section.RealSize = sizeof(double);
    section.Header[0] = range.First;
    section.Header[1] = range.Last;
    section.HeaderSize = 2;
    section.Begin = reinterpret_cast<const char*>(words.data());
    section.End = reinterpret_cast<const char*>(word);
    this->FaceTrees.push_back(std::move(section));
    this->Trees.push_back(std::move(words));
  }
}

//------------------------------------------------------------------------------
// Faces at nonconformal interfaces: a table with zone, first and last face.
void FluentContainer::OpenInterfaces(const HDF5Object& faces)
{
  if (!faces.Has("interface") || !faces.Open("interface").Has("nciTopology"))
  {
    return;
  }
  const HDF5Object table = faces.Open("interface").Open("nciTopology");
  const std::int64_t rowSize = faces.Open("interface").GetNumber("nData");
  const std::int64_t size = table.GetCount() * table.GetColumns();
  constexpr std::int64_t Least = 3;
  table.Check(rowSize >= Least && size % rowSize == 0, ErrorKind::Count,
    "rows with a zone, the first and the last face", std::to_string(rowSize) + " numbers");
  std::vector<std::int32_t> values(static_cast<std::size_t>(size));
  table.Read(0, table.GetCount(), values.data());
  for (std::size_t row = 0; row < values.size(); row += static_cast<std::size_t>(rowSize))
  {
    FluentSection section;
    section.Index = FluentSection::ParentsIndex;
    section.Header[0] = values[row + 1];
    section.Header[1] = values[row + 2];
    section.HeaderSize = 2;
    this->InterfaceFaces.push_back(std::move(section));
  }
}

//------------------------------------------------------------------------------
void FluentContainer::FindUnused(const HDF5Object& root)
{
  const auto add = [this](const HDF5Object& group, const std::set<std::string>& used)
  {
    for (const std::string& name : group.IsData() ? std::vector<std::string>() : group.GetNames())
    {
      if (!used.count(name))
      {
        this->Unused.push_back(group.GetPath() + "/" + name);
      }
    }
  };
  const HDF5Object meshes = root.Open("meshes"), mesh = meshes.Open("1");
  add(meshes, { "1" });
  add(mesh, { "nodes", "cells", "faces" });
  if (mesh.Has("nodes"))
  {
    add(mesh.Open("nodes"), { "coords", "zoneTopology" });
  }
  for (const char* name : { "cells", "faces" })
  {
    if (!mesh.Has(name))
    {
      continue;
    }
    const HDF5Object group = mesh.Open(name);
    add(group, { "nodes", "c0", "c1", "ctype", "zoneTopology", "tree", "interface" });
    for (const char* column : { "childZoneId", "shadowZoneId" })
    {
      if (group.Has("zoneTopology") && HasEntries(group.Open("zoneTopology"), column))
      {
        this->Unused.push_back(group.GetPath() + "/zoneTopology/" + column);
      }
    }
  }
  if (root.Has("special"))
  {
    add(root.Open("special"), {});
  }
}

//------------------------------------------------------------------------------
bool FluentContainer::LoadStored(const FluentSection& section, std::int64_t first,
  std::int64_t count, Buffer<std::int32_t>& values)
{
  const std::int64_t id = section.Header[1] + first;
  const std::int64_t element = section.GetElement();
  return this->Catch(
    [&]
    {
      section.Index == FluentSection::CellsIndex
        ? this->LoadTypes(id, count, values)
        : this->LoadFaces(id, count,
            element == FluentSection::Polygons ? 0 : static_cast<std::int32_t>(element), values);
    });
}

//------------------------------------------------------------------------------
bool FluentContainer::LoadStored(
  const FluentSection&, std::int64_t first, std::int64_t count, Buffer<double>& values)
{
  return this->Catch(
    [&]
    {
      values = values.size() < 3 * count ? Buffer<double>(3 * count) : std::move(values);
      this->Coordinates.Read(this->File, 1 + first, count, values.data());
    });
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

//------------------------------------------------------------------------------
// Loads faces as v1 ... vn c0 c1, or with n first if they have no common size.
void FluentContainer::LoadFaces(
  std::int64_t id, std::int64_t count, std::int32_t size, Buffer<std::int32_t>& values)
{
  const HDF5Object mesh = this->File.Reopen("meshes/1");
  const auto checkSame = [&mesh](bool good)
  { mesh.Check(good, ErrorKind::Changed, "the same faces in all passes", "different ones"); };
  const std::int64_t block = (id - 1) / BlockSize;
  const std::int64_t skipped = id - 1 - block * BlockSize; // faces of the block before these
  Buffer<std::int32_t> sizes(skipped + count);
  this->Sizes.Read(this->File, id - skipped, skipped + count, sizes.data());
  std::int64_t list = this->Offsets[static_cast<std::size_t>(block)];
  list = std::accumulate(sizes.data(), sizes.data() + skipped, list);
  const std::int32_t* const own = sizes.data() + skipped;

  std::vector<std::int64_t> begins(static_cast<std::size_t>(count) + 1, 0); // in the node ids
  for (std::int64_t i = 0; i < count; ++i)
  {
    checkSame(own[i] >= 0 && (size == 0 || own[i] == size));
    begins[static_cast<std::size_t>(i) + 1] = begins[static_cast<std::size_t>(i)] + own[i];
  }
  const std::int64_t total = begins.back();
  const std::int64_t most =
    this->Lists.GetSections().empty() ? 0 : this->Lists.GetSections().back().Last;
  checkSame(list + total <= most);

  Buffer<std::int32_t> nodes(total),
    sides[2] = { Buffer<std::int32_t>(count), Buffer<std::int32_t>(count) };
  this->Lists.Read(this->File, 1 + list, total, nodes.data());
  for (int side = 0; side < 2; ++side)
  {
    this->Sides[side].Read(this->File, id, count, sides[side].data());
  }
  const std::int32_t others = size == 0 ? 3 : 2; // numbers of a face besides its nodes
  values = Buffer<std::int32_t>(total + others * count);
  std::atomic<std::int64_t> bad{ count };
  ParallelFor(count, MediumGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const std::int64_t from = begins[static_cast<std::size_t>(i)];
        std::int32_t* word = values.data() + from + others * i;
        bool good = true;
        if (size == 0)
        {
          *word++ = own[i];
        }
        for (std::int32_t node = 0; node < own[i]; ++node)
        {
          const std::int32_t value = nodes[from + node];
          good &= value >= 1 && value <= this->NumberOfNodes;
          *word++ = value;
        }
        for (int side = 0; side < 2; ++side)
        {
          const std::int32_t value = sides[side][i];
          good &= value >= 0 && value <= this->NumberOfCells;
          *word++ = value;
        }
        if (!good)
        {
          LowerTo<std::int64_t>(bad, i);
        }
      }
    });
  if (bad < count)
  {
    this->FailAtFace(id + bad, nodes.data() + begins[static_cast<std::size_t>(bad)], own[bad],
      1 + list + begins[static_cast<std::size_t>(bad)]);
  }
}

//------------------------------------------------------------------------------
// Throws the error about a face with a node or cell that does not exist.
void FluentContainer::FailAtFace(
  std::int64_t id, const std::int32_t* nodes, std::int32_t size, std::int64_t list)
{
  const std::string face = " of face " + std::to_string(id) + " from ";
  for (std::int32_t i = 0; i < size; ++i)
  {
    if (nodes[i] < 1 || nodes[i] > this->NumberOfNodes)
    {
      this->Lists.FailAt(this->File, list + i, ErrorKind::Index,
        "a node" + face + "1 to " + std::to_string(this->NumberOfNodes), std::to_string(nodes[i]));
    }
  }
  for (HDF5Column& side : this->Sides)
  {
    std::int32_t cell = 0;
    side.Read(this->File, id, 1, &cell);
    if (cell < 0 || cell > this->NumberOfCells)
    {
      side.FailAt(this->File, id, ErrorKind::Index,
        "a cell" + face + "0 to " + std::to_string(this->NumberOfCells), std::to_string(cell));
    }
  }
  this->File.GetRoot().Fail(ErrorKind::Changed, "the same faces in all passes", "different ones");
}
}
