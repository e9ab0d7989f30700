// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/FaceMesh/FaceOrientation.h"

#include "Base/LocalNumbers.h"
#include "Base/Progress.h"
#include "Base/Vector.h"
#include "Mesh/CellFacets.h"
#include "Mesh/RecentTopologies.h"

#include <algorithm>
#include <mutex>

namespace camaron
{
namespace
{
constexpr int LeastFaces = 4; // of a closed cell

//------------------------------------------------------------------------------
// The faces of a polyhedron in local numbers; holds memory for the next one.
class Polyhedron
{
public:
  explicit Polyhedron(const MeshView& mesh)
    : Mesh(mesh)
    , Facets(mesh)
  {
  }

  bool Is(vtkIdType cell) const { return this->Facets.ListsFacets(cell); }

  /// Loads a polyhedron; false if it is not closed.
  bool Load(vtkIdType cell)
  {
    std::vector<int>&offsets = this->Topologies.FaceOffsets, &numbers = this->Topologies.FacePoints;
    this->Points.clear();
    offsets.assign(1, 0);
    this->Facets.ForEach(cell,
      [&](const vtkIdType* points, vtkIdType size, vtkIdType)
      {
        this->Points.insert(this->Points.end(), points, points + size);
        offsets.push_back(static_cast<int>(this->Points.size()));
      });
    if (RecentTopologies::Recent* const recent = this->Topologies.Recognize(this->Points.data()))
    {
      this->Topology = &recent->Topology;
      this->Firsts = recent->PointCorners.data();
    }
    else
    {
      const auto size = static_cast<int>(this->Points.size());
      numbers.resize(this->Points.size());
      const int count = this->Numbers.Number(
        size, [&](int i) { return this->Points[static_cast<std::size_t>(i)]; }, numbers.data());
      const bool edgesCanWait = true; // most cells are closed
      bool wasRepeated = false;
      this->Topology = &this->Topologies.Find(count, edgesCanWait, wasRepeated);
      this->Topology->CheckClosed();
      this->Firsts = this->Numbers.GetFirsts();
    }
    return this->Topology->IsManifold && this->Topology->GetNumberOfFaces() >= LeastFaces;
  }
  bool IsConsistent() const { return this->Topology->IsClosed; }

  /// Orients the faces consistently and outward; calls visit(face) for those that are reversed.
  template <typename Visit>
  void Orient(Visit&& visit)
  {
    this->Topology->MakeConsistent();
    const bool isInward = this->GetVolume() < 0;
    for (int face = 0; face < this->Topology->GetNumberOfFaces(); ++face)
    {
      if (this->Topology->IsReversed(face) != isInward)
      {
        visit(static_cast<Index>(this->Topology->FaceNumbers[static_cast<std::size_t>(face)]));
      }
    }
  }

private:
  Vector GetPoint(int local) const
  {
    return this->Mesh.GetPoint(this->Points[static_cast<std::size_t>(this->Firsts[local])]);
  }

  /// Six times the volume inside the faces as they are now.
  double GetVolume() const
  {
    const Vector apex = this->GetPoint(0);
    double volume = 0;
    for (int face = 0; face < this->Topology->GetNumberOfFaces(); ++face)
    {
      const int* const points = this->Topology->GetFace(face);
      const Vector first = this->GetPoint(points[0]) - apex;
      for (int i = 1; i + 1 < this->Topology->GetFaceSize(face); ++i)
      {
        volume +=
          Dot(first, Cross(this->GetPoint(points[i]) - apex, this->GetPoint(points[i + 1]) - apex));
      }
    }
    return volume;
  }

  const MeshView& Mesh;
  CellFacets Facets;
  RecentTopologies Topologies;
  LocalNumbers Numbers;
  std::vector<vtkIdType> Points; // of all faces
  CellTopology* Topology = nullptr;
  const int* Firsts = nullptr; // positions in Points
};
}

//------------------------------------------------------------------------------
FaceOrientation::FaceOrientation(const MeshTopology& topology)
  : Faces(topology.GetFaces())
{
  struct Use
  {
    vtkIdType Cell;
    Index Face;
  };
  std::vector<Use> reversed;
  std::mutex mutex;
  Progress().For(topology.GetMesh().GetNumberOfCells(),
    [&](vtkIdType begin, vtkIdType end)
    {
      Polyhedron polyhedron(topology.GetMesh());
      std::vector<Use> own;
      Tally open;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        if (!polyhedron.Is(cell))
        {
          continue;
        }
        if (!polyhedron.Load(cell))
        {
          open.Add(cell);
        }
        else if (!polyhedron.IsConsistent())
        {
          polyhedron.Orient([&](Index local)
            { own.push_back({ cell, this->Faces.GetCellFacets(cell)[local].Facet() }); });
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      reversed.insert(reversed.end(), own.begin(), own.end());
      this->Open.Merge(open);
    });
  if (!reversed.empty())
  {
    const auto size = static_cast<std::size_t>(this->Faces.GetNumberOfFacets());
    this->ReversedInFirst.resize(size, 0);
    this->ReversedInSecond.resize(size, 0);
  }
  for (const Use& use : reversed)
  {
    const bool isFirst = this->Faces.GetCells(use.Face).First == use.Cell;
    (isFirst ? this->ReversedInFirst : this->ReversedInSecond)[static_cast<std::size_t>(use.Face)] =
      1;
  }
}

//------------------------------------------------------------------------------
bool FaceOrientation::IsReversed(Index face, vtkIdType cell) const
{
  const bool isFirst = this->Faces.GetCells(face).First == cell;
  const FacetTable::Range uses = this->Faces.GetCellFacets(cell);
  const bool isReversed = !isFirst &&
    std::any_of(uses.begin(), uses.end(),
      [face](CellFacet use) { return use.Facet() == face && use.IsReversed(); });
  const auto& flags = isFirst ? this->ReversedInFirst : this->ReversedInSecond;
  return isReversed != (!flags.empty() && flags[static_cast<std::size_t>(face)]);
}
}
