// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentHDF5Reading.h"

#include "Base/Number.h"
#include "Base/Parallel.h"
#include "HDF5Column.h"
#include "Intake/Fluent/FluentFaces.h"
#include "Intake/Pieces/ReadMappedFile.h"

#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <string_view>

namespace camaron
{
namespace
{
constexpr int MaxElement = 7; // of the types of cells

//------------------------------------------------------------------------------
/**
 * The sections of a file, one per zone.
 *
 * Data sets stay compressed in the file. Faces, types of cells and coordinates are loaded batch by
 * batch, whenever they are visited, in the form of a binary Fluent file, and all ids are checked.
 * Functions throw ScanError. See Readers/FluentHDF5/README.md for the layout.
 */
class FluentContainer : public FluentFile
{
public:
  /// @a file remains open.
  explicit FluentContainer(HDF5File& file)
    : FluentFile(file.GetName(), nullptr, nullptr)
    , File(file)
  {
  }

  /// Finds the sections, or only the zones; false if aborted.
  bool Open(const Progress& progress, bool zonesOnly = false)
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

  /// The names of all zones except interior ones, each once.
  std::vector<std::string> GetZoneNames() const
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

  /// Leaves out all zones with other names than these, after Open; warns about names of none.
  void Choose(const std::vector<std::string>& zones, Warnings& warnings)
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

  /// Warns about what is in the file and is not used.
  void WarnOfUnused(Warnings& warnings) const
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
        const auto ids =
          root.Has(path) ? root.Open(path).ReadNumbers() : std::vector<std::int32_t>();
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

  void LoadStored(const FluentSection& section, std::int64_t first, std::int64_t count,
    Buffer<std::int32_t>& values) override
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

  void LoadStored(
    const FluentSection&, std::int64_t first, std::int64_t count, Buffer<double>& values) override
  {
    const std::int64_t size = count * this->Dimension;
    values = values.size() < size ? Buffer<double>(size) : std::move(values);
    this->Coordinates.Read(1 + first, count, values.data());
  }

private:
  static constexpr int NoType = -1, Fluid = 1, Solid = 17; // types of zones
  struct ZoneRow
  {
    int Id;
    std::int64_t First, Last;
    int Type; ///< Fluent's number, or NoType
    std::string Name;
    std::string TypeName;                             ///< in the settings; empty if unknown
    std::int32_t LeastSize = INT32_MAX, MostSize = 0; ///< numbers of nodes of faces
  };

  std::string Locate(const char*) const override { return this->Name + ": meshes/1"; }
  std::string LocateCell(std::int64_t face, int side) const override
  {
    const std::string place = this->Sides[side].Locate(face);
    return place.empty() ? "" : " (" + place + ")";
  }

  /// The zones in the settings are sections of a file in text, "(39 (id type name ...", which name
  /// types that share a number.
  void ReadTypeNames(const HDF5Object& root)
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

  /// The zones in the order of the file, which together have all ids from 1 to the last.
  std::vector<ZoneRow> ReadZones(
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
    const auto types =
      table.Has("zoneType") ? read("zoneType") : std::vector(ids.size(), usualType);
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
      zones.push_back({ ids[i], range.First, range.IsEmpty() ? range.First - 1 : range.Last,
        types[i], names.empty() || names[i].empty() ? "zone-" + std::to_string(ids[i]) : names[i],
        type != this->TypeNames.end() ? type->second : "" });
      ranges.Add(range);
    }
    ranges.Finish(table, what, last, true);
    return zones;
  }

  void OpenCells(const HDF5Object& cells)
  {
    const std::vector<ZoneRow> zones =
      this->ReadZones(cells, "cells", this->DeclaredCells.Count, Fluid);
    const bool hasTypes = cells.Has("ctype");
    if (hasTypes)
    {
      this->Types.Open(cells.Open("ctype"), "cells", this->DeclaredCells.Count, true, 1,
        "cell-types",
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

  void OpenFaces(const HDF5Object& faces, const Progress& progress, bool zonesOnly)
  {
    std::vector<ZoneRow> zones = this->ReadZones(faces, "faces", this->DeclaredFaces.Count, NoType);
    this->Sizes.Open(faces.Open("nodes"), "faces", this->DeclaredFaces.Count, true, 1, "nnodes");
    for (int side = 0; side < 2; ++side)
    {
      const std::string name = "c" + std::to_string(side);
      const bool isComplete = side == 0 && this->DeclaredCells.Count > 0;
      if (isComplete || faces.Has(name))
      {
        this->Sides[side].Open(faces.Open(name), "faces", this->DeclaredFaces.Count, isComplete);
      }
    }
    if (!zonesOnly)
    {
      this->MeasureFaces(zones, progress);
    }
    for (const ZoneRow& zone : zones)
    {
      this->AddFaces(faces, zone);
    }
    if (!zonesOnly)
    {
      this->OpenTrees(faces);
      this->OpenInterfaces(faces);
    }
  }

  /// Finds where the nodes of faces are, and the smallest and greatest number in each zone.
  void MeasureFaces(std::vector<ZoneRow>& zones, const Progress& progress)
  {
    auto zone = zones.begin();
    std::int64_t total = 0, id = 1;
    const std::int64_t batch = GetStoredBatch(this->DeclaredFaces.Count);
    std::vector<std::int32_t> sizes(static_cast<std::size_t>(batch));
    for (const HDF5Column::Section& section : this->Sizes.GetSections())
    {
      const std::int64_t before = total;
      while (id <= section.Last && !progress.IsStopped())
      {
        const std::int64_t count = std::min(batch, section.Last - id + 1);
        this->Sizes.Read(id, count, sizes.data());
        for (std::int64_t i = 0; i < count; ++i, ++id)
        {
          const std::int32_t size = sizes[static_cast<std::size_t>(i)];
          if (size < 0)
          {
            this->File.Fail(
              this->Sizes.Locate(id), ErrorKind::Count, "a number of nodes", std::to_string(size));
          }
          if ((id - 1) % BlockSize == 0)
          {
            this->Offsets.push_back(total);
          }
          total += size;
          if (id < zone->First || id > zone->Last)
          {
            zone = std::find_if(zones.begin(), zones.end(),
              [id](const ZoneRow& row) { return row.First <= id && id <= row.Last; });
          }
          zone->LeastSize = std::min(zone->LeastSize, size);
          zone->MostSize = std::max(zone->MostSize, size);
        }
        progress.Report(
          static_cast<double>(id) / static_cast<double>(this->DeclaredFaces.Count + 1));
      }
      const HDF5Object nodes = this->File.GetRoot().Open(section.GetPathOf("nodes"));
      nodes.Check(progress.IsStopped() || nodes.GetCount() == total - before, ErrorKind::Count,
        std::to_string(total - before) + " node ids, as nnodes says",
        std::to_string(nodes.GetCount()));
      this->Lists.Add({ before + 1, total, nodes.GetPath() });
    }
  }

  void AddFaces(const HDF5Object& faces, const ZoneRow& zone)
  {
    // Only faces with two cells are in the data sets of the second cell, or most of them.
    const bool hasCells = this->DeclaredCells.Count > 0;
    const bool hasBoth = hasCells && this->Sides[1].Contains(zone.First, zone.Last);
    int type = zone.Type;
    if (type == NoType)
    {
      const int named = GetFluentBoundaryType(zone.TypeName); // in the settings
      type = named != 0 ? named : hasBoth ? FluentBoundary::Interior : FluentBoundary::Wall;
    }
    this->Zones.push_back({ zone.Id,
      zone.TypeName.empty() ? GetFluentZoneType(type) : zone.TypeName, zone.Name, type });
    if (zone.First > zone.Last)
    {
      return;
    }
    faces.Check(!hasCells || hasBoth || type != FluentBoundary::Interior, ErrorKind::Truncated,
      "second cells (c1) of the interior faces " + std::to_string(zone.First) + " to " +
        std::to_string(zone.Last),
      "none for some of them");
    const bool isSized = zone.LeastSize == zone.MostSize && zone.MostSize >= 2 &&
      zone.MostSize < FluentSection::Polygons;
    this->Faces.push_back(FluentSection::MakeStored(FluentSection::FacesIndex,
      { zone.Id, zone.First, zone.Last, type, isSized ? zone.MostSize : 0 }));
  }

  /// Split faces, in the form of binary sections: n child1 ... childn.
  void OpenTrees(const HDF5Object& faces)
  {
    if (!faces.Has("tree"))
    {
      return;
    }
    HDF5Column trees(this->File);
    trees.Open(faces.Open("tree"), "faces", this->DeclaredFaces.Count, false, 1, "nkids");
    for (const HDF5Column::Section& range : trees.GetSections())
    {
      const HDF5Object kidData = this->File.GetRoot().Open(range.GetPathOf("kids"));
      const auto sizes = this->File.GetRoot().Open(range.Path).ReadNumbers();
      const auto kids = kidData.ReadNumbers();
      for (std::size_t i = 0; i < kids.size(); ++i)
      {
        this->File.CheckRange(kidData.GetPath() + "[" + std::to_string(i) + "]", kids[i], 1,
          this->DeclaredFaces.Count, "a part");
      }
      std::vector<std::int32_t> words;
      auto kid = kids.begin();
      for (const std::int32_t size : sizes)
      {
        kidData.Check(size >= 0 && size <= kids.end() - kid, ErrorKind::Count,
          "as many parts as nkids says", std::to_string(kids.size()));
        words.push_back(size);
        words.insert(words.end(), kid, kid + size);
        kid += size;
      }
      FluentSection section =
        FluentSection::MakeStored(FluentSection::FaceTreeIndex, { range.First, range.Last });
      section.Begin = reinterpret_cast<const char*>(words.data());
      section.End = reinterpret_cast<const char*>(words.data() + words.size());
      this->FaceTrees.push_back(std::move(section));
      this->Trees.push_back(std::move(words));
    }
  }

  /// Faces at nonconformal interfaces: a table with zone, first and last face.
  void OpenInterfaces(const HDF5Object& faces)
  {
    if (!faces.Has("interface/nciTopology"))
    {
      return;
    }
    const HDF5Object table = faces.Open("interface/nciTopology");
    const std::int64_t rowSize = faces.Open("interface").GetNumber("nData", 3, INT32_MAX);
    std::vector<std::int32_t> values(
      static_cast<std::size_t>(table.GetCount() * table.GetColumns()));
    table.Read(0, table.GetCount(), values.data());
    table.Check(static_cast<std::int64_t>(values.size()) % rowSize == 0, ErrorKind::Count,
      "rows with a zone, the first and the last face", std::to_string(rowSize) + " numbers");
    for (std::size_t row = 0; row < values.size(); row += static_cast<std::size_t>(rowSize))
    {
      this->InterfaceFaces.push_back(FluentSection::MakeStored(
        FluentSection::InterfaceIndex, { values[row + 1], values[row + 2] }));
    }
  }

  /// Loads faces as v1 ... vn c0 c1, or with n first if they have no common size.
  void LoadFaces(
    std::int64_t id, std::int64_t count, std::int32_t size, Buffer<std::int32_t>& values)
  {
    const std::int64_t block = (id - 1) / BlockSize;
    const std::int64_t skipped = id - 1 - block * BlockSize; // faces of the block before these
    // Sizes that are the same need not be read.
    Buffer<std::int32_t> sizes(skipped + (size == 0 ? count : 0));
    this->Sizes.Read(id - skipped, sizes.size(), sizes.data());
    const std::int64_t list = std::accumulate(
      sizes.data(), sizes.data() + skipped, this->Offsets[static_cast<std::size_t>(block)]);
    Buffer<std::int64_t> begins(count + 1); // in the node ids
    begins[0] = 0;
    bool good = true;
    for (std::int64_t i = 0; i < count; ++i)
    {
      const std::int32_t own = size == 0 ? sizes[skipped + i] : size;
      good &= own >= 0;
      begins[i + 1] = begins[i] + own;
    }
    const std::int64_t total = begins[count];
    this->File.GetRoot().Check(good && this->Lists.Contains(1 + list, list + total),
      ErrorKind::Changed, "the same faces in all passes", "different ones");

    Buffer<std::int32_t> nodes(total),
      sides[2] = { Buffer<std::int32_t>(count), Buffer<std::int32_t>(count) };
    this->Lists.Read(1 + list, total, nodes.data());
    for (int side = 0; side < 2; ++side)
    {
      this->Sides[side].Read(id, count, sides[side].data());
    }
    const std::int32_t others = size == 0 ? 3 : 2; // numbers of a face besides its nodes
    values = Buffer<std::int32_t>(total + others * count);
    std::atomic<std::int64_t> bad{ count };
    ParallelFor(count, MediumGrain,
      [&](vtkIdType begin, vtkIdType end)
      {
        const auto mostNode = static_cast<std::uint32_t>(this->DeclaredNodes.Count);
        const auto mostCell = static_cast<std::uint32_t>(this->DeclaredCells.Count);
        for (vtkIdType i = begin; i < end; ++i)
        {
          std::int32_t* word = values.data() + begins[i] + others * i;
          bool isGood = true;
          if (size == 0)
          {
            *word++ = static_cast<std::int32_t>(begins[i + 1] - begins[i]);
          }
          for (std::int64_t node = begins[i]; node < begins[i + 1]; ++node)
          {
            isGood &= static_cast<std::uint32_t>(nodes[node]) - 1 < mostNode;
            *word++ = nodes[node];
          }
          for (const Buffer<std::int32_t>& side : sides)
          {
            isGood &= static_cast<std::uint32_t>(side[i]) <= mostCell;
            *word++ = side[i];
          }
          if (!isGood)
          {
            LowerTo<std::int64_t>(bad, i);
          }
        }
      });
    if (bad < count)
    {
      const std::string face = " of face " + std::to_string(id + bad);
      for (std::int64_t node = begins[bad]; node < begins[bad + 1]; ++node)
      {
        this->File.CheckRange(this->Lists.Locate(1 + list + node), nodes[node], 1,
          this->DeclaredNodes.Count, "a node" + face);
      }
      for (int side = 0; side < 2; ++side)
      {
        this->File.CheckRange(this->Sides[side].Locate(id + bad), sides[side][bad], 0,
          this->DeclaredCells.Count, "a cell" + face);
      }
    }
  }

  HDF5File& File;
  HDF5Column Coordinates{ this->File }, Types{ this->File }, Sizes{ this->File },
    Lists{ this->File }, Sides[2] = { this->File, this->File };
  std::vector<std::int64_t> Offsets;            ///< node ids before every 1024th face
  std::map<int, std::string> TypeNames;         ///< of zones
  std::vector<std::vector<std::int32_t>> Trees; ///< words of the sections of split faces
};
}

//------------------------------------------------------------------------------
bool IsFluentHDF5(const std::string& path)
{
  const MappedFile file(path); // if compressed, only its beginning
  ScanError ignored;
  return HDF5File::IsHDF5(file.begin(), file.end()) &&
    (file.IsCompressed() ||
      UseHDF5(
        file, 0, ignored, [](HDF5File& content) { return content.GetRoot().Has("meshes/1"); }));
}

//------------------------------------------------------------------------------
std::vector<std::string> ListFluentZones(const std::string& path)
{
  std::vector<std::string> names;
  ScanError ignored; // reading reports it
  ReadMappedFile(path, ignored, Progress(),
    [&](const MappedFile& mapped, const Progress&)
    {
      return UseHDF5(mapped, 0, ignored,
        [&](HDF5File& file)
        {
          FluentContainer container(file);
          container.Open(Progress(), true);
          names = container.GetZoneNames();
          return true;
        });
    });
  return names;
}

//------------------------------------------------------------------------------
bool ReadFluentHDF5(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  vtkMultiBlockDataSet* boundaries, const std::vector<std::string>* zones,
  const FluentFieldRequest& fields, Warnings& warnings, ScanError& error, const Progress& progress)
{
  PieceExchange exchange(FindProcesses(request));    // also if this process fails before it is used
  constexpr double MeshShare = 0.8, OpenShare = 0.1; // of the progress
  const bool hasFields = fields.IsAny();
  Warnings unheard;
  Warnings& heard = request.Piece == 0 ? warnings : unheard; // of the file, not of the piece
  std::int64_t cells = 0;
  bool good = ReadMappedFile(path, request, grid, warnings, error,
    hasFields ? progress.Part(0, MeshShare) : progress,
    [&](const MappedFile& mapped, const Progress& part)
    {
      return UseHDF5(mapped, 0, error,
        [&](HDF5File& file)
        {
          FluentContainer container(file);
          if (!container.Open(part.Part(0, OpenShare)))
          {
            return false;
          }
          container.WarnOfUnused(heard);
          if (zones)
          {
            container.Choose(*zones, heard);
          }
          cells = container.DeclaredCells.Count;
          container.Exchange = &exchange;
          return ReadFluent(
            container, request, grid, boundaries, warnings, error, part.Part(OpenShare, 1));
        });
    });
  exchange.Close();
  if (good && hasFields)
  {
    good = ReadFluentFields(fields, cells, grid, heard, error, progress.Part(MeshShare, 1));
  }
  if (!good)
  {
    grid->Initialize();
  }
  return good;
}
}
