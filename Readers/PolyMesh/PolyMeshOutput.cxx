// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolyMeshOutput.h"

#include "Base/DisjointSets.h"
#include "Base/LocalNumbers.h"
#include "Base/Parallel.h"
#include "Base/Vector.h"
#include "Intake/Fluent/FluentFaces.h"
#include "Mesh/CellTopology.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <mutex>
#include <tuple>

namespace camaron
{
namespace
{
// As in Fluent's files, besides those of FluentBoundary.
constexpr int Symmetry = 7, PeriodicShadow = 8, Periodic = 12;
// The patch of faces without a zone, as OpenFOAM's own tools name it.
constexpr const char* DefaultPatch = "defaultFaces";
constexpr int LeastFaces = 4; // of a closed cell

//------------------------------------------------------------------------------
std::string GetPatchType(int boundary)
{
  return boundary == FluentBoundary::Wall ? "wall" : boundary == Symmetry ? "symmetry" : "patch";
}

//------------------------------------------------------------------------------
// Characters that end a word in OpenFOAM's dictionaries, or begin a macro.
std::string ToWord(std::string name)
{
  for (char& c : name)
  {
    const auto code = static_cast<unsigned char>(c);
    c =
      code <= ' ' || code == 0x7f || std::string_view("\"'/;{}()#$\\").find(c) != std::string::npos
      ? '_'
      : c;
  }
  return name.empty() ? "zone" : name;
}

//------------------------------------------------------------------------------
// The faces of one cell in local numbers, and the volume that they enclose.
class CellFaces
{
public:
  explicit CellFaces(const MeshView& mesh)
    : Mesh(mesh)
    , Facets(mesh)
  {
  }

  bool IsPolyhedron(vtkIdType cell) const { return this->Facets.ListsFacets(cell); }

  /// Loads a polyhedron and orients its faces consistently; false if it is not closed.
  bool Orient(vtkIdType cell)
  {
    this->Points.clear();
    this->Ends.clear();
    this->Facets.ForEach(cell,
      [&](const vtkIdType* points, vtkIdType size, vtkIdType)
      {
        this->Points.insert(this->Points.end(), points, points + size);
        this->Ends.push_back(static_cast<int>(this->Points.size()));
      });
    const auto size = static_cast<int>(this->Points.size());
    this->Local.resize(this->Points.size());
    this->Topology.Clear();
    this->Topology.NumberOfPoints = this->Numbers.Number(
      size, [&](int i) { return this->Points[static_cast<std::size_t>(i)]; }, this->Local.data());
    int begin = 0;
    for (const int end : this->Ends)
    {
      this->Topology.AddFace(this->Local.data() + begin, end - begin);
      begin = end;
    }
    this->Topology.Finish();
    if (!this->Topology.IsManifold)
    {
      return false;
    }
    this->WasConsistent = this->Topology.IsClosed;
    if (!this->WasConsistent)
    {
      this->Topology.MakeConsistent();
      this->Topology.FindEdges();
    }
    return this->Topology.IsClosed && this->Topology.GetNumberOfFaces() >= LeastFaces;
  }
  bool GetWasConsistent() const { return this->WasConsistent; }
  /// Of the faces that Orient loaded; those with fewer than three points are not reversed.
  template <typename Visit>
  void ForEachReversed(Visit&& visit) const
  {
    for (int face = 0; face < this->Topology.GetNumberOfFaces(); ++face)
    {
      if (this->Topology.IsReversed(face))
      {
        visit(static_cast<Index>(this->Topology.FaceNumbers[static_cast<std::size_t>(face)]));
      }
    }
  }

  /// Six times the volume; isReversed(local) for the faces.
  template <typename IsReversed>
  double GetVolume(vtkIdType cell, IsReversed&& isReversed)
  {
    double volume = 0;
    Vector apex;
    bool isFirst = true;
    this->Facets.ForEach(cell,
      [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
      {
        if (isFirst)
        {
          apex = this->GetPoint(points[0]);
          isFirst = false;
        }
        double sum = 0;
        for (vtkIdType i = 1; i + 1 < size; ++i)
        {
          sum += Dot(this->GetPoint(points[0]) - apex,
            Cross(this->GetPoint(points[i]) - apex, this->GetPoint(points[i + 1]) - apex));
        }
        volume += isReversed(static_cast<Index>(local)) ? -sum : sum;
      });
    return volume;
  }

private:
  Vector GetPoint(vtkIdType point) const
  {
    double x[3];
    this->Mesh.GetPoint(point, x);
    return { x[0], x[1], x[2] };
  }

  const MeshView& Mesh;
  CellFacets Facets;
  CellTopology Topology;
  LocalNumbers Numbers;
  std::vector<vtkIdType> Points;
  std::vector<int> Ends, Local;
  bool WasConsistent = true;
};
}

//------------------------------------------------------------------------------
PolyMeshOutput::PolyMeshOutput(vtkDataSet* mesh)
  : Mesh(mesh, 3)
  , Facets(this->Mesh.GetTopology().GetFaces())
{
  this->Mesh.JoinInconsistentFaces();
}

//------------------------------------------------------------------------------
void PolyMeshOutput::GetFacePoints(vtkIdType face, std::vector<vtkIdType>& points) const
{
  const Face& own = this->GetFace(face);
  this->Mesh.GetRing(own.Facet, points);
  if (own.IsReversed)
  {
    std::reverse(points.begin() + 1, points.end()); // the first point stays the first
  }
  for (vtkIdType& point : points)
  {
    point = this->UsedPoints.GetNumber(point);
  }
}

//------------------------------------------------------------------------------
// Orients the faces of polyhedra consistently, and outward if they were not consistent before;
// determines the volumes of all cells.
void PolyMeshOutput::OrientCells(Tally& open, const Progress& progress)
{
  const MeshView& mesh = this->Mesh.GetMesh();
  this->Volumes.assign(static_cast<std::size_t>(mesh.GetNumberOfCells()), 0);
  const auto facets = static_cast<std::size_t>(this->Facets.GetNumberOfFacets());
  this->ReversedInFirst.assign(facets, 0);
  this->ReversedInSecond.assign(facets, 0);
  std::mutex mutex;
  progress.For(this->GetNumberOfCells(),
    [&](vtkIdType begin, vtkIdType end)
    {
      CellFaces faces(mesh);
      std::vector<unsigned char> reversed; // by local face
      Tally found;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const vtkIdType meshCell = this->GetMeshCell(cell);
        const FacetTable::Range uses = this->Facets.GetCellFacets(meshCell);
        reversed.assign(static_cast<std::size_t>(uses.size()), 0);
        const bool isPolyhedron = faces.IsPolyhedron(meshCell);
        if (isPolyhedron && !faces.Orient(meshCell))
        {
          found.Add(meshCell);
          continue;
        }
        if (isPolyhedron)
        {
          faces.ForEachReversed([&](Index face) { reversed[static_cast<std::size_t>(face)] = 1; });
        }
        double volume = faces.GetVolume(
          meshCell, [&](Index face) { return reversed[static_cast<std::size_t>(face)] != 0; });
        if (isPolyhedron && !faces.GetWasConsistent() && volume < 0)
        {
          volume = -volume;
          for (unsigned char& flag : reversed)
          {
            flag ^= 1;
          }
        }
        this->Volumes[static_cast<std::size_t>(meshCell)] = volume;
        for (Index face = 0; isPolyhedron && face < uses.size(); ++face)
        {
          const Index facet = uses[face].Facet();
          auto& flags = this->Facets.GetCells(facet).First == meshCell ? this->ReversedInFirst
                                                                       : this->ReversedInSecond;
          flags[static_cast<std::size_t>(facet)] = reversed[static_cast<std::size_t>(face)];
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      open.Merge(found);
    });
}

//------------------------------------------------------------------------------
// Whether the ring of a facet, which is that of its first cell, is inward of a cell.
bool PolyMeshOutput::IsOutwardReversed(Index facet, vtkIdType meshCell) const
{
  const auto at = static_cast<std::size_t>(facet);
  bool isReversed = this->IsMirrored[static_cast<std::size_t>(meshCell)] != 0;
  if (this->Facets.GetCells(facet).First == meshCell)
  {
    return isReversed != (this->ReversedInFirst[at] != 0);
  }
  for (const CellFacet use : this->Facets.GetCellFacets(meshCell))
  {
    isReversed = isReversed != (use.Facet() == facet && use.IsReversed());
  }
  return isReversed != (this->ReversedInSecond[at] != 0);
}

//------------------------------------------------------------------------------
void PolyMeshOutput::FindMirroredCells()
{
  this->IsMirrored.assign(this->Volumes.size(), 0);
  if (std::none_of(this->Volumes.begin(), this->Volumes.end(), [](double v) { return v < 0; }))
  {
    return;
  }
  DisjointSets sets(this->Volumes.size());
  for (std::size_t cell = 0; cell < this->Volumes.size(); ++cell)
  {
    sets.Insert(static_cast<vtkIdType>(cell));
  }
  for (Index facet = 0; facet < this->Facets.GetNumberOfFacets(); ++facet)
  {
    const FacetTable::CellPair cells = this->Facets.GetCells(facet);
    if (cells.Second >= 0 &&
      this->IsOutwardReversed(facet, cells.First) != this->IsOutwardReversed(facet, cells.Second))
    {
      sets.Join(cells.First, cells.Second);
    }
  }
  std::vector<double> sums(this->Volumes.size(), 0.0);
  for (std::size_t cell = 0; cell < sums.size(); ++cell)
  {
    sums[static_cast<std::size_t>(sets.Find(static_cast<vtkIdType>(cell)))] += this->Volumes[cell];
  }
  for (std::size_t cell = 0; cell < sums.size(); ++cell)
  {
    this->IsMirrored[cell] =
      sums[static_cast<std::size_t>(sets.Find(static_cast<vtkIdType>(cell)))] < 0;
  }
}

//------------------------------------------------------------------------------
void PolyMeshOutput::CollectFaces()
{
  const std::vector<FluentOutput::Face>& faces = this->Mesh.GetFaces();
  const std::vector<FluentOutput::Section>& sections = this->Mesh.GetFaceSections();
  this->Faces.resize(faces.size());
  for (std::size_t section = 0; section < sections.size(); ++section)
  {
    ParallelFor(sections[section].End - sections[section].Begin, MediumGrain,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          const auto at = static_cast<std::size_t>(sections[section].Begin + i);
          const FluentOutput::Face& face = faces[at];
          const bool isSwapped = face.Cells[1] >= 0 && face.Cells[1] < face.Cells[0];
          const std::int32_t owner = face.Cells[isSwapped], neighbor = face.Cells[!isSwapped];
          this->Faces[at] = { face.Facet, owner, neighbor, face.Size, static_cast<int>(section),
            this->IsOutwardReversed(face.Facet, this->GetMeshCell(owner)) };
        }
      });
  }
}

//------------------------------------------------------------------------------
void PolyMeshOutput::SortFaces()
{
  const auto interiorEnd = std::stable_partition(
    this->Faces.begin(), this->Faces.end(), [](const Face& face) { return face.Neighbor >= 0; });
  this->NumberOfInteriorFaces = interiorEnd - this->Faces.begin();
  WithThreads(
    [&]
    {
      vtkSMPTools::Sort(this->Faces.begin(), interiorEnd,
        [](const Face& a, const Face& b)
        {
          return std::tie(a.Owner, a.Neighbor, a.Facet) < std::tie(b.Owner, b.Neighbor, b.Facet);
        });
    });
  // Sections of one zone are one patch.
  const auto getZone = [this](const Face& face)
  { return this->Mesh.GetFaceSections()[static_cast<std::size_t>(face.Zone)].Zone; };
  std::stable_sort(interiorEnd, this->Faces.end(), [&](const Face& a, const Face& b)
    { return std::make_tuple(getZone(a), a.Owner) < std::make_tuple(getZone(b), b.Owner); });
}

//------------------------------------------------------------------------------
void PolyMeshOutput::NumberPoints(Warnings& warnings)
{
  const vtkIdType size = this->Mesh.GetMesh().GetNumberOfPoints();
  this->UsedPoints = IdSet(size);
  ParallelFor(this->GetNumberOfFaces(), MediumGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<vtkIdType> points;
      IdSet::Adder used(this->UsedPoints);
      for (vtkIdType face = begin; face < end; ++face)
      {
        this->Mesh.GetRing(this->GetFace(face).Facet, points);
        for (const vtkIdType point : points)
        {
          used.Add(point);
        }
      }
    });
  this->UsedPoints.Number();
  this->Points = this->UsedPoints.GetMembers();
  Tally unused; // without those of 2D cells alone
  const vtkIdType lost = this->Mesh.GetNumberOfPoints() - this->GetNumberOfPoints();
  for (vtkIdType i = 0; unused.Count < lost; ++i)
  {
    if (!this->UsedPoints.Contains(this->Mesh.GetMeshPoint(i)))
    {
      unused.Add(this->Mesh.GetMeshPoint(i));
    }
  }
  warnings.Add(unused, "point", "points", "that no cell uses, omitted");
}

//------------------------------------------------------------------------------
// A word that is not used yet.
std::string PolyMeshOutput::MakeName(const std::string& name, std::vector<std::string>& used)
{
  const std::string word = ToWord(name);
  std::string free = word;
  for (int number = 2; std::find(used.begin(), used.end(), free) != used.end(); ++number)
  {
    free = word + "_" + std::to_string(number);
  }
  if (free != name)
  {
    this->Renamed.Add(static_cast<vtkIdType>(used.size()));
  }
  used.push_back(free);
  return free;
}

//------------------------------------------------------------------------------
void PolyMeshOutput::FindPatches(Warnings& warnings)
{
  const auto& sections = this->Mesh.GetFaceSections();
  std::vector<std::string> used;
  std::string coupled;
  for (vtkIdType begin = this->NumberOfInteriorFaces; begin < this->GetNumberOfFaces();)
  {
    const FluentOutput::Section& section =
      sections[static_cast<std::size_t>(this->GetFace(begin).Zone)];
    vtkIdType end = begin;
    while (end < this->GetNumberOfFaces() &&
      sections[static_cast<std::size_t>(this->GetFace(end).Zone)].Zone == section.Zone)
    {
      ++end;
    }
    const std::string name = section.IsMade ? DefaultPatch : this->GetZoneName(section.Zone);
    const std::string type = section.IsMade ? "patch" : GetPatchType(section.Type);
    this->Patches.push_back({ this->MakeName(name, used), type, begin, end });
    if (section.Type == Periodic || section.Type == PeriodicShadow)
    {
      coupled += (coupled.empty() ? "" : ", ") + name;
    }
    begin = end;
  }
  if (!coupled.empty())
  {
    warnings.Add("the periodic zones " + coupled + " become plain patches");
  }
}

//------------------------------------------------------------------------------
void PolyMeshOutput::FindZones(Warnings& warnings)
{
  const auto addTo = [this](std::vector<Zone>& zones, std::vector<std::string>& used,
                       std::map<int, std::size_t>& places, int id) -> std::vector<vtkIdType>&
  {
    const auto [place, isNew] = places.emplace(id, zones.size());
    if (isNew)
    {
      zones.push_back({ this->MakeName(this->GetZoneName(id), used), {} });
    }
    return zones[place->second].Ids;
  };
  std::vector<std::string> cellNames, faceNames;
  std::map<int, std::size_t> cellPlaces, facePlaces;
  for (const FluentOutput::Section& section : this->Mesh.GetCellSections())
  {
    if (!section.IsMade)
    {
      auto& ids = addTo(this->CellZones, cellNames, cellPlaces, section.Zone);
      for (vtkIdType cell = section.Begin; cell < section.End; ++cell)
      {
        ids.push_back(cell);
      }
    }
  }
  // Zones of interior faces that 2D cells mark; the zone of all others has no meaning here.
  for (vtkIdType face = 0; face < this->NumberOfInteriorFaces; ++face)
  {
    const FluentOutput::Section& section =
      this->Mesh.GetFaceSections()[static_cast<std::size_t>(this->GetFace(face).Zone)];
    if (section.IsMarked)
    {
      addTo(this->FaceZones, faceNames, facePlaces, section.Zone).push_back(face);
    }
  }
  warnings.Add(this->Renamed, "zone", "zones", "renamed, as names are unique words in OpenFOAM");
}

//------------------------------------------------------------------------------
std::string PolyMeshOutput::GetZoneName(int id) const
{
  const std::vector<FluentZone>& zones = this->Mesh.GetZones();
  const auto zone = std::find_if(
    zones.begin(), zones.end(), [id](const FluentZone& known) { return known.Id == id; });
  return zone != zones.end() ? zone->Name : "";
}

//------------------------------------------------------------------------------
bool PolyMeshOutput::Build(
  bool refusesLost, Warnings& warnings, std::string& reason, const Progress& progress)
{
  if (!this->Mesh.Build(warnings, reason, progress.Part(0, 0.5)))
  {
    return false;
  }
  const auto refuse = [&](const std::string& expected, const Tally& found, const std::string& what)
  {
    reason = "expected " + expected + ", found " + std::to_string(found.Count) + " " + what +
      ", the first is cell " + std::to_string(found.First);
    return false;
  };
  if (refusesLost && this->Mesh.GetLostCells().Count > 0)
  {
    return refuse("2D cells that are faces of 3D cells", this->Mesh.GetLostCells(), "others");
  }
  Tally open, own;
  for (const FluentOutput::Face& face : this->Mesh.GetFaces())
  {
    if (face.Cells[0] == face.Cells[1])
    {
      own.Add(this->GetMeshCell(face.Cells[0]));
    }
  }
  if (own.Count > 0)
  {
    return refuse("faces between different cells", own, "faces that a cell has twice");
  }
  this->OrientCells(open, progress.Part(0.5, 0.8));
  if (open.Count > 0)
  {
    return refuse("closed cells whose edges belong to two faces each", open, "others");
  }
  this->FindMirroredCells();
  this->CollectFaces();
  this->SortFaces();
  this->NumberPoints(warnings);
  this->FindPatches(warnings);
  this->FindZones(warnings);
  return progress.Report(1);
}
}
