// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/InwardFaces.h"

#include "Geometry/ClosedShell.h"

namespace camaron
{
//------------------------------------------------------------------------------
void InwardFaces::Clear()
{
  this->Ids.clear();
  this->Offsets.assign(1, 0);
}

//------------------------------------------------------------------------------
void InwardFaces::AddFace(const vtkIdType* points, vtkIdType size)
{
  this->Ids.insert(this->Ids.end(), points, points + size);
  this->Offsets.push_back(static_cast<int>(this->Ids.size()));
}

//------------------------------------------------------------------------------
const std::vector<unsigned char>& InwardFaces::Find()
{
  const auto size = static_cast<int>(this->Ids.size()),
             numberOfFaces = static_cast<int>(this->Offsets.size()) - 1;
  this->AreInward.assign(numberOfFaces, 0);
  this->Numbers.resize(size);
  CellTopology& topology = this->Topology;
  topology.Clear();
  topology.NumberOfPoints =
    this->Numbering.Number(size, [this](int i) { return this->Ids[i]; }, this->Numbers.data());
  for (int face = 0; face < numberOfFaces; ++face)
  {
    topology.AddFace(
      this->Numbers.data() + this->Offsets[face], this->Offsets[face + 1] - this->Offsets[face]);
  }
  topology.Finish();
  topology.MakeConsistent();

  std::vector<ClosedShell> shells(topology.GetNumberOfShells());
  for (int face = 0; face < topology.GetNumberOfFaces(); ++face)
  {
    this->AddTriangles(face, shells[topology.GetShell(face)]);
  }
  const std::vector<unsigned char> areVoids = FindVoids(shells);
  for (int face = 0; face < topology.GetNumberOfFaces(); ++face)
  {
    const int shell = topology.GetShell(face);
    this->AreInward[topology.FaceNumbers[face]] = static_cast<unsigned char>(
      topology.IsReversed(face) ^ (shells[shell].GetVolume() < 0) ^ (areVoids[shell] != 0));
  }
  return this->AreInward;
}

//------------------------------------------------------------------------------
// Any triangulation of a face is sufficient for a volume.
void InwardFaces::AddTriangles(int face, ClosedShell& shell) const
{
  const int* const ring = this->Topology.GetFace(face);
  const auto place = [&](int number)
  {
    return this->Mesh.GetPoint(this->Ids[this->Numbering.GetFirsts()[number]]) -
      this->Mesh.GetPoint(this->Ids[0]);
  };
  const Vector first = place(ring[0]);
  Vector last = place(ring[1]);
  for (int i = 2; i < this->Topology.GetFaceSize(face); ++i)
  {
    const Vector next = place(ring[i]);
    shell.Add(first, last, next);
    last = next;
  }
}
}
