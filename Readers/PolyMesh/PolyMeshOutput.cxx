// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolyMeshOutput.h"

#include "Base/DisjointSets.h"
#include "Base/Number.h"
#include "Base/Parallel.h"
#include "Base/Text.h"
#include "Base/Vector.h"
#include "Intake/Fluent/FluentFaces.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <tuple>

namespace camaron
{
namespace
{
// As in Fluent's files, besides those of FluentBoundary.
constexpr int Symmetry = 7, PeriodicShadow = 8, Periodic = 12;
// The patch of faces without a zone, as OpenFOAM's own tools name it.
constexpr const char* DefaultPatch = "defaultFaces";

//------------------------------------------------------------------------------
// The type of a zone, if it is one of Fluent's and not the usual one of fluid cells or interior
// faces; it is a word in OpenFOAM, too.
std::string GetGroup(const std::string& type)
{
  return GetFluentBoundaryType(type) > FluentBoundary::Interior || type == "solid" ? type : "";
}

//------------------------------------------------------------------------------
// Replaces characters that end a word in OpenFOAM's dictionaries, or begin a macro; a word does not
// begin like a number.
std::string ToWord(std::string name)
{
  constexpr std::size_t Longest = 200; // of OpenFOAM's 1024, with room for a number
  name.resize(std::min(name.size(), Longest));
  for (char& c : name)
  {
    const bool isSpecial =
      static_cast<unsigned char>(c) <= ' ' || c == '\x7f' || std::strchr("\"'/;{}()#$\\", c);
    c = isSpecial ? '_' : c;
  }
  const bool isWord = !name.empty() && !std::strchr("+-.0123456789", name[0]);
  return isWord ? name : "zone_" + name;
}
}

//------------------------------------------------------------------------------
PolyMeshOutput::PolyMeshOutput(vtkDataSet* mesh, double scale)
  : Mesh(mesh, 3)
  , Scale(scale)
  , Facets(this->Mesh.GetFacets())
{
  this->Mesh.JoinInconsistentFaces();
}

//------------------------------------------------------------------------------
void PolyMeshOutput::GetFacePoints(const Face& face, std::vector<vtkIdType>& points) const
{
  this->Mesh.GetRing(face.Facet, points);
  if (face.IsReversed)
  {
    std::reverse(points.begin() + 1, points.end()); // the first point stays the first
  }
  for (vtkIdType& point : points)
  {
    point = this->UsedPoints.GetNumber(point);
  }
}

//------------------------------------------------------------------------------
// Finds the connected cells on whose orientation their faces agree, and the sums of their volumes.
void PolyMeshOutput::FindMirroredCells()
{
  const MeshView& mesh = this->Mesh.GetMesh();
  const vtkIdType size = mesh.GetNumberOfCells();
  std::vector<double> volumes(size, 0.0); // times six
  DisjointSets sets(size);
  for (vtkIdType cell = 0; cell < size; ++cell)
  {
    sets.Insert(cell);
  }
  std::vector<vtkIdType> ring;
  for (Index facet = 0; facet < this->Facets.GetNumberOfFacets(); ++facet)
  {
    this->Mesh.GetRing(facet, ring);
    const FacetTable::CellPair cells = this->Facets.GetCells(facet);
    const bool isShared = cells.Second >= 0 && this->Mesh.AreOpposite(facet);
    for (const Index cell : { cells.First, cells.Second })
    {
      const double sign = cell == cells.Second && isShared ? -1 : 1;
      for (std::size_t i = 1; cell >= 0 && i + 1 < ring.size(); ++i)
      {
        const Vector apex = mesh.GetPoint(mesh.GetCellPoints(cell)[0]);
        volumes[cell] += sign *
          Dot(mesh.GetPoint(ring[0]) - apex,
            Cross(mesh.GetPoint(ring[i]) - apex, mesh.GetPoint(ring[i + 1]) - apex));
      }
    }
    if (isShared)
    {
      sets.Join(cells.First, cells.Second);
    }
  }
  std::vector<double> sums(size, 0.0); // of the sets, for the cell that stands for them
  for (vtkIdType cell = 0; cell < size; ++cell)
  {
    sums[sets.Find(cell)] += volumes[cell];
  }
  this->IsMirrored.resize(size);
  for (vtkIdType cell = 0; cell < size; ++cell)
  {
    this->IsMirrored[cell] = sums[sets.Find(cell)] < 0;
  }
}

//------------------------------------------------------------------------------
void PolyMeshOutput::CollectFaces(Warnings& warnings)
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
          const auto cell = static_cast<Index>(this->GetMeshCell(owner));
          const bool isInward =
            cell != this->Facets.GetCells(face.Facet).First && this->Mesh.AreOpposite(face.Facet);
          this->Faces[at] = { face.Facet, owner, neighbor, face.Size, static_cast<int>(section),
            isInward != (this->IsMirrored[cell] != 0) };
        }
      });
  }
  // A face of OpenFOAM leaves one of its cells and enters the other: where neither is so for both,
  // one of them is open.
  Tally alike;
  for (const Face& face : this->Faces)
  {
    const FacetTable::CellPair cells = this->Facets.GetCells(face.Facet);
    if (face.Neighbor >= 0 && cells.Second >= 0 &&
      this->Mesh.AreOpposite(face.Facet) !=
        (this->IsMirrored[cells.First] == this->IsMirrored[cells.Second]))
    {
      alike.Add(cells.First);
    }
  }
  warnings.Add(alike, "face", "faces",
    "with the same orientation in both cells, one of which OpenFOAM finds open (identified by "
    "their cell)");
}

//------------------------------------------------------------------------------
void PolyMeshOutput::SortFaces()
{
  const auto interiorEnd = std::stable_partition(
    this->Faces.begin(), this->Faces.end(), [](const Face& face) { return face.Neighbor >= 0; });
  this->NumberOfInteriorFaces = interiorEnd - this->Faces.begin();
  vtkSMPTools::Sort(this->Faces.begin(), interiorEnd, [](const Face& a, const Face& b)
    { return std::tie(a.Owner, a.Neighbor, a.Facet) < std::tie(b.Owner, b.Neighbor, b.Facet); });
  // Sections of one zone are one patch.
  const auto getZone = [this](const Face& face)
  { return this->Mesh.GetFaceSections()[face.Zone].Zone; };
  std::stable_sort(interiorEnd, this->Faces.end(), [&](const Face& a, const Face& b)
    { return std::make_tuple(getZone(a), a.Owner) < std::make_tuple(getZone(b), b.Owner); });
}

//------------------------------------------------------------------------------
void PolyMeshOutput::NumberPoints(Warnings& warnings)
{
  this->UsedPoints = IdSet(this->Mesh.GetMesh().GetNumberOfPoints());
  const std::vector<FluentOutput::Face>& faces = this->Mesh.GetFaces();
  ParallelFor(static_cast<vtkIdType>(faces.size()), MediumGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<vtkIdType> points;
      IdSet::Adder used(this->UsedPoints);
      for (vtkIdType face = begin; face < end; ++face)
      {
        this->Mesh.GetRing(faces[face].Facet, points);
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
  const auto count = static_cast<vtkIdType>(this->Faces.size());
  for (vtkIdType begin = this->NumberOfInteriorFaces, end = begin; begin < count; begin = end)
  {
    const FluentOutput::Section& section = sections[this->Faces[begin].Zone];
    while (end < count && sections[this->Faces[end].Zone].Zone == section.Zone)
    {
      ++end;
    }
    const FluentZone& zone = *this->Mesh.FindZone(section.Zone);
    const std::string name = section.IsMade ? DefaultPatch : zone.Name;
    const int named = GetFluentBoundaryType(zone.Type); // some files number all faces as walls
    const int boundary = named > 0 ? named : section.Type;
    const std::string type = !section.IsTyped ? "patch"
      : boundary == FluentBoundary::Wall      ? "wall"
      : boundary == Symmetry                  ? "symmetry"
                                              : "patch";
    const std::string group = section.IsTyped ? GetGroup(zone.Type) : "";
    this->Patches.push_back({ this->MakeName(name, used), type, group, begin, end });
    if (boundary == Periodic || boundary == PeriodicShadow)
    {
      coupled += (coupled.empty() ? "" : ", ") + name;
    }
  }
  if (!coupled.empty())
  {
    warnings.Add("the periodic zones " + coupled + " become plain patches");
  }
}

//------------------------------------------------------------------------------
void PolyMeshOutput::FindZones(Warnings& warnings)
{
  std::map<int, std::vector<vtkIdType>> cells, faces;
  for (const FluentOutput::Section& section : this->Mesh.GetCellSections())
  {
    for (vtkIdType cell = section.Begin; cell < section.End && !section.IsMade; ++cell)
    {
      cells[section.Zone].push_back(cell);
    }
  }
  const auto& sections = this->Mesh.GetFaceSections();
  const auto isUnmarked = [](const FluentOutput::Section& section)
  { return section.Type == FluentBoundary::Interior && !section.IsMarked; };
  const bool isOnly = std::count_if(sections.begin(), sections.end(), isUnmarked) == 1;
  for (vtkIdType face = 0; face < this->NumberOfInteriorFaces; ++face)
  {
    const FluentOutput::Section& section = sections[this->Faces[face].Zone];
    if (!section.IsMade)
    {
      std::vector<vtkIdType>& zone = faces[section.Zone]; // which may stay empty
      if (!isOnly || !isUnmarked(section))
      {
        zone.push_back(face);
      }
    }
  }
  const auto name = [this](std::map<int, std::vector<vtkIdType>>& lists)
  {
    std::vector<Zone> zones;
    std::vector<std::string> used;
    for (auto& list : lists)
    {
      const FluentZone& zone = *this->Mesh.FindZone(list.first);
      zones.push_back(
        { this->MakeName(zone.Name, used), GetGroup(zone.Type), std::move(list.second) });
    }
    return zones;
  };
  this->CellZones = name(cells);
  this->FaceZones = name(faces);
  warnings.Add(this->Renamed, "zone", "zones", "renamed, as names are unique words in OpenFOAM");
}

//------------------------------------------------------------------------------
bool PolyMeshOutput::Build(
  bool refusesLost, Warnings& warnings, std::string& reason, const Progress& progress)
{
  if (!this->Mesh.Build(warnings, reason, progress.Part(0, 0.5)))
  {
    return false;
  }
  Tally own, collapsed, infinite;
  std::vector<int> sizes(static_cast<std::size_t>(this->GetNumberOfCells()), 0); // numbers of faces
  for (const FluentOutput::Face& face : this->Mesh.GetFaces())
  {
    if (face.Cells[0] == face.Cells[1])
    {
      own.Add(this->GetMeshCell(face.Cells[0]));
    }
    for (const std::int32_t cell : face.Cells)
    {
      sizes[std::max(cell, 0)] += cell >= 0;
    }
  }
  constexpr int LeastFaces = 4;
  for (vtkIdType cell = 0; cell < this->GetNumberOfCells(); ++cell)
  {
    if (sizes[cell] < LeastFaces)
    {
      collapsed.Add(this->GetMeshCell(cell));
    }
  }
  this->NumberPoints(warnings);
  for (vtkIdType point = 0; point < this->GetNumberOfPoints(); ++point)
  {
    double x[3];
    this->GetPoint(point, x);
    if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
    {
      infinite.Add(this->Points[point]);
    }
  }
  const struct
  {
    Tally Found;
    const char *Expected, *One, *Many;
    const char* Element = "cell ";
  } faults[] = { { refusesLost ? this->Mesh.GetLostCells() : Tally(),
                   "2D cells that are faces of 3D cells", "2D cell that is none",
                   "2D cells that are none" },
    { own, "faces between different cells", "face that a cell has twice",
      "faces that a cell has twice" },
    { this->Mesh.GetOrientation().GetOpenCells(),
      "closed cells whose edges belong to two faces each", "other cell", "other cells" },
    { collapsed, "cells of at least 4 faces", "collapsed one", "collapsed ones" },
    { infinite, "finite coordinates", "point with others", "points with others", "point " } };
  for (const auto& fault : faults)
  {
    if (fault.Found.Count > 0)
    {
      reason = std::string("expected ") + fault.Expected + ", found " +
        CountOf(fault.Found.Count, fault.One, fault.Many) +
        (fault.Found.Count > 1 ? ", the first is " : ": ") + fault.Element +
        std::to_string(fault.Found.First);
      return false;
    }
  }
  this->FindMirroredCells();
  this->CollectFaces(warnings);
  this->SortFaces();
  this->FindPatches(warnings);
  this->FindZones(warnings);
  return progress.Report(1);
}
}
