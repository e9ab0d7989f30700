// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/FaceMesh/FaceOrientation.h"

#include "Base/LocalNumbers.h"
#include "Base/Progress.h"
#include "Base/Vector.h"
#include "Mesh/CellFacets.h"
#include "Mesh/CellTopology.h"

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
    this->Points.clear();
    this->Ends.clear();
    this->Facets.ForEach(cell,
      [&](const vtkIdType* points, vtkIdType size, vtkIdType)
      {
        this->Points.insert(this->Points.end(), points, points + size);
        this->Ends.push_back(static_cast<int>(this->Points.size()));
      });
    this->Local.resize(this->Points.size());
    this->Topology.Clear();
    this->Topology.NumberOfPoints = this->Numbers.Number(
      static_cast<int>(this->Points.size()),
      [&](int i) { return this->Points[static_cast<std::size_t>(i)]; }, this->Local.data());
    int begin = 0;
    for (const int end : this->Ends)
    {
      this->Topology.AddFace(this->Local.data() + begin, end - begin);
      begin = end;
    }
    this->Topology.Finish();
    return this->Topology.IsManifold && this->Topology.GetNumberOfFaces() >= LeastFaces;
  }
  bool IsConsistent() const { return this->Topology.IsClosed; }

  /// Orients the faces consistently and outward; calls visit(face) for those that are reversed.
  template <typename Visit>
  void Orient(Visit&& visit)
  {
    this->Topology.MakeConsistent();
    const bool isInward = this->GetVolume() < 0;
    for (int face = 0; face < this->Topology.GetNumberOfFaces(); ++face)
    {
      if (this->Topology.IsReversed(face) != isInward)
      {
        visit(static_cast<Index>(this->Topology.FaceNumbers[static_cast<std::size_t>(face)]));
      }
    }
  }

private:
  Vector GetPoint(int local) const
  {
    double x[3];
    const int first = this->Numbers.GetFirsts()[local];
    this->Mesh.GetPoint(this->Points[static_cast<std::size_t>(first)], x);
    return { x[0], x[1], x[2] };
  }

  /// Six times the volume inside the faces as they are now.
  double GetVolume() const
  {
    const Vector apex = this->GetPoint(0);
    double volume = 0;
    for (int face = 0; face < this->Topology.GetNumberOfFaces(); ++face)
    {
      const int* const points = this->Topology.GetFace(face);
      const Vector first = this->GetPoint(points[0]) - apex;
      for (int i = 1; i + 1 < this->Topology.GetFaceSize(face); ++i)
      {
        volume +=
          Dot(first, Cross(this->GetPoint(points[i]) - apex, this->GetPoint(points[i + 1]) - apex));
      }
    }
    return volume;
  }

  const MeshView& Mesh;
  CellFacets Facets;
  CellTopology Topology;
  LocalNumbers Numbers;
  std::vector<vtkIdType> Points;
  std::vector<int> Ends, Local;
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
  bool isReversed = false;
  for (const CellFacet use : this->Faces.GetCellFacets(cell))
  {
    isReversed = isReversed || (!isFirst && use.Facet() == face && use.IsReversed());
  }
  const auto& flags = isFirst ? this->ReversedInFirst : this->ReversedInSecond;
  return isReversed != (!flags.empty() && flags[static_cast<std::size_t>(face)]);
}
}
