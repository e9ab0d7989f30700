// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Faces: their sections, and loading them.
#include "Base/Parallel.h"
#include "FluentContainer.h"
#include "Intake/Fluent/FluentFaces.h"

#include <algorithm>
#include <atomic>
#include <numeric>

namespace camaron
{
//------------------------------------------------------------------------------
void FluentContainer::OpenFaces(const HDF5Object& faces, const Progress& progress, bool zonesOnly)
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

//------------------------------------------------------------------------------
// Finds where the nodes of faces are, and the smallest and greatest number in each zone.
void FluentContainer::MeasureFaces(std::vector<ZoneRow>& zones, const Progress& progress)
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
      progress.Report(static_cast<double>(id) / static_cast<double>(this->DeclaredFaces.Count + 1));
    }
    const HDF5Object nodes = this->File.GetRoot().Open(section.GetPathOf("nodes"));
    nodes.Check(progress.IsStopped() || nodes.GetCount() == total - before, ErrorKind::Count,
      std::to_string(total - before) + " node ids, as nnodes says",
      std::to_string(nodes.GetCount()));
    this->Lists.Add({ before + 1, total, nodes.GetPath() });
  }
}

//------------------------------------------------------------------------------
void FluentContainer::AddFaces(const HDF5Object& faces, const ZoneRow& zone)
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
  this->Zones.push_back(
    { zone.Id, zone.TypeName.empty() ? GetFluentZoneType(type) : zone.TypeName, zone.Name, type });
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

//------------------------------------------------------------------------------
// Split faces, in the form of binary sections: n child1 ... childn.
void FluentContainer::OpenTrees(const HDF5Object& faces)
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

//------------------------------------------------------------------------------
// Faces at nonconformal interfaces: a table with zone, first and last face.
void FluentContainer::OpenInterfaces(const HDF5Object& faces)
{
  if (!faces.Has("interface/nciTopology"))
  {
    return;
  }
  const HDF5Object table = faces.Open("interface/nciTopology");
  const std::int64_t rowSize = faces.Open("interface").GetNumber("nData", 3, INT32_MAX);
  std::vector<std::int32_t> values(static_cast<std::size_t>(table.GetCount() * table.GetColumns()));
  table.Read(0, table.GetCount(), values.data());
  table.Check(static_cast<std::int64_t>(values.size()) % rowSize == 0, ErrorKind::Count,
    "rows with a zone, the first and the last face", std::to_string(rowSize) + " numbers");
  for (std::size_t row = 0; row < values.size(); row += static_cast<std::size_t>(rowSize))
  {
    this->InterfaceFaces.push_back(FluentSection::MakeStored(
      FluentSection::InterfaceIndex, { values[row + 1], values[row + 2] }));
  }
}

//------------------------------------------------------------------------------
// Loads faces as v1 ... vn c0 c1, or with n first if they have no common size.
void FluentContainer::LoadFaces(
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
}
