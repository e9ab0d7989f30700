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
void FluentContainer::OpenFaces(const HDF5Object& faces, const Progress& progress)
{
  std::vector<ZoneRow> zones = this->ReadZones(faces, "faces", this->DeclaredFaces.Count, NoType);
  const HDF5Object group = faces.Open("nodes");
  this->Sizes.Open(group, "faces", this->DeclaredFaces.Count, true,
    [](const HDF5Object& part, HDF5Column::Section& section)
    {
      const HDF5Object sizes = part.Open("nnodes"), nodes = part.Open("nodes");
      section.SetData(sizes);
      nodes.Check(nodes.IsData() && nodes.GetColumns() == 1 && sizes.GetColumns() == 1,
        ErrorKind::Syntax, "a list of numbers", "something else");
    });
  this->OpenSides(faces);
  this->MeasureFaces(group, zones, progress);
  for (const ZoneRow& zone : zones)
  {
    this->AddFaces(faces, zone);
  }
  this->OpenTrees(faces);
  this->OpenInterfaces(faces);
}

//------------------------------------------------------------------------------
void FluentContainer::OpenSides(const HDF5Object& faces)
{
  for (int side = 0; side < 2; ++side)
  {
    const std::string name = "c" + std::to_string(side);
    const bool isComplete = side == 0 && this->DeclaredCells.Count > 0;
    if (isComplete || faces.Has(name))
    {
      this->Sides[side].Open(faces.Open(name), "faces", this->DeclaredFaces.Count, isComplete,
        [](const HDF5Object& data, HDF5Column::Section& section) { section.SetData(data); });
    }
  }
}

//------------------------------------------------------------------------------
// Finds where the nodes of faces are, and the smallest and greatest number in each zone.
void FluentContainer::MeasureFaces(
  const HDF5Object& group, std::vector<ZoneRow>& zones, const Progress& progress)
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
    // "nnodes" and "nodes" are in the same group.
    const std::string path = section.Path.substr(0, section.Path.rfind('/')) + "/nodes";
    const HDF5Object nodes = this->File.GetRoot().Open(path);
    nodes.Check(progress.IsStopped() || nodes.GetCount() == total - before, ErrorKind::Count,
      std::to_string(total - before) + " node ids, as nnodes says",
      std::to_string(nodes.GetCount()));
    this->Lists.Add({ before + 1, total, path });
  }
  this->Lists.Finish(group, "node ids", total, !progress.IsStopped());
}

//------------------------------------------------------------------------------
// Without a type in the table, the settings name it; else faces with two cells are interior.
int FluentContainer::GetBoundaryType(const ZoneRow& zone) const
{
  const auto named = this->TypeNames.find(zone.Id);
  const int type = named != this->TypeNames.end() ? GetFluentBoundaryType(named->second) : 0;
  if (type != 0 || zone.Type != NoType)
  {
    return zone.Type != NoType ? zone.Type : type;
  }
  // Only faces with two cells are in the data sets of the second cell, or most of them.
  return this->DeclaredCells.Count > 0 && this->Sides[1].Contains(zone.First, zone.Last)
    ? FluentBoundary::Interior
    : FluentBoundary::Wall;
}

//------------------------------------------------------------------------------
void FluentContainer::AddFaces(const HDF5Object& faces, const ZoneRow& zone)
{
  const int type = this->GetBoundaryType(zone);
  this->AddZone(zone, GetFluentZoneType(type));
  if (zone.First > zone.Last)
  {
    return;
  }
  faces.Check(this->DeclaredCells.Count == 0 || type != FluentBoundary::Interior ||
      this->Sides[1].Contains(zone.First, zone.Last),
    ErrorKind::Truncated,
    "second cells (c1) of the interior faces " + std::to_string(zone.First) + " to " +
      std::to_string(zone.Last),
    "none for some of them");
  constexpr std::int32_t LargestSized = 4;
  const bool isSized =
    zone.LeastSize == zone.MostSize && zone.MostSize >= 2 && zone.MostSize <= LargestSized;
  this->Faces.push_back(FluentSection::MakeStored(FluentSection::FacesIndex,
    { zone.Id, zone.First, zone.Last, type,
      isSized                          ? zone.MostSize
        : zone.MostSize > LargestSized ? FluentSection::Polygons
                                       : 0 }));
}

//------------------------------------------------------------------------------
// Split faces, in the form of binary sections: n child1 ... childn.
void FluentContainer::OpenTrees(const HDF5Object& faces)
{
  HDF5Column trees;
  const auto read = [this](const HDF5Object& part, HDF5Column::Section& range)
  {
    const HDF5Object sizeData = part.Open("nkids"), kidData = part.Open("kids");
    range.SetData(sizeData);
    const auto sizes = sizeData.ReadNumbers(sizeData.GetCount());
    const auto kids = kidData.ReadNumbers(kidData.GetCount());
    std::vector<std::int32_t> words;
    for (std::size_t i = 0; i < kids.size(); ++i)
    {
      if (kids[i] < 1 || kids[i] > this->DeclaredFaces.Count)
      {
        kidData.FailAt(static_cast<std::int64_t>(i), ErrorKind::Index,
          "a part from 1 to " + std::to_string(this->DeclaredFaces.Count), std::to_string(kids[i]));
      }
    }
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
  };
  if (faces.Has("tree"))
  {
    trees.Open(faces.Open("tree"), "faces", this->DeclaredFaces.Count, false, read);
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
  const std::int64_t rowSize = faces.Open("interface").GetNumber("nData");
  const std::int64_t size = table.GetCount() * table.GetColumns();
  constexpr std::int64_t Least = 3;
  table.Check(rowSize >= Least && size % rowSize == 0, ErrorKind::Count,
    "rows with a zone, the first and the last face", std::to_string(rowSize) + " numbers");
  std::vector<std::int32_t> values(static_cast<std::size_t>(size));
  table.Read(0, table.GetCount(), values.data());
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
  this->Sizes.Read(this->File, id - skipped, sizes.size(), sizes.data());
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
  this->File.GetRoot().Check(good && list + total <= this->Lists.GetLast(), ErrorKind::Changed,
    "the same faces in all passes", "different ones");

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
    const std::int32_t cells[2] = { sides[0][bad], sides[1][bad] };
    this->FailAtFace(id + bad, nodes.data() + begins[bad],
      static_cast<std::int32_t>(begins[bad + 1] - begins[bad]), 1 + list + begins[bad], cells);
  }
}

//------------------------------------------------------------------------------
std::string FluentContainer::LocateCell(std::int64_t face, int side) const
{
  const std::string place = this->Sides[side].Locate(face);
  return place.empty() ? "" : " (" + place + ")";
}

//------------------------------------------------------------------------------
// Throws the error about a face with a node or cell that does not exist.
void FluentContainer::FailAtFace(std::int64_t id, const std::int32_t* nodes, std::int32_t size,
  std::int64_t list, const std::int32_t* cells)
{
  const std::string face = " of face " + std::to_string(id) + " from ";
  for (std::int32_t i = 0; i < size; ++i)
  {
    if (nodes[i] < 1 || nodes[i] > this->DeclaredNodes.Count)
    {
      this->Lists.FailAt(this->File, list + i, ErrorKind::Index,
        "a node" + face + "1 to " + std::to_string(this->DeclaredNodes.Count),
        std::to_string(nodes[i]));
    }
  }
  const int side = cells[0] < 0 || cells[0] > this->DeclaredCells.Count ? 0 : 1;
  this->Sides[side].FailAt(this->File, id, ErrorKind::Index,
    "a cell" + face + "0 to " + std::to_string(this->DeclaredCells.Count),
    std::to_string(cells[side]));
}
}
