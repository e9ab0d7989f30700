// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The volume of CellGeometry, and the orientation of faces that it requires.
#include "Cell/CellGeometry.h"
#include "Cell/FaceRing.h"
#include "Geometry/ClosedShell.h"

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// The shells found by the topology, divided into triangles at the centers of faces.
std::vector<ClosedShell> GetShells(const CellGeometry& cell)
{
  const CellTopology& topology = cell.GetTopology();
  std::vector<ClosedShell> shells(topology.GetNumberOfShells());
  for (int f = 0; f < topology.GetNumberOfFaces(); ++f)
  {
    const FaceRing ring(cell, f);
    for (int i = 0; i < ring.GetSize(); ++i)
    {
      shells[topology.GetShell(f)].Add(cell.GetFaceCenter(f), ring.GetBegin(i), ring.GetEnd(i));
    }
  }
  return shells;
}
}

//------------------------------------------------------------------------------
double CellGeometry::SumVolume() const
{
  double sum = 0;
  for (int f = 0; f < this->Topology->GetNumberOfFaces(); ++f)
  {
    sum += Dot(this->FaceVectors[f], this->FaceCenters[f]);
  }
  return sum / 3;
}

//------------------------------------------------------------------------------
void CellGeometry::ComputeVolume()
{
  if (!this->Topology->IsClosed || this->Topology->GetNumberOfFaces() < 4)
  {
    this->Volume = Null(NullReason::InvalidTopology);
    return;
  }
  this->Volume = this->IsTetrahedronByNodes()
    ? Dot(this->Points[1], Cross(this->Points[2], this->Points[3])) / 6
    : this->SumVolume();
  if (this->IsToBeOriented())
  {
    this->OrientPolyhedron();
  }
  this->OrientationSign = this->Volume < 0 ? -1 : 1;
}

//------------------------------------------------------------------------------
void CellGeometry::OrientPolyhedron()
{
  const int numberOfShells = this->Topology->GetNumberOfShells();
  if (numberOfShells == 1 && !(this->Volume < 0))
  {
    return;
  }
  std::vector<unsigned char>& areReversed = this->ReversedShells;
  areReversed.assign(numberOfShells, 1);
  if (numberOfShells > 1)
  {
    const std::vector<ClosedShell> shells = GetShells(*this);
    const std::vector<unsigned char> areVoids = FindVoids(shells);
    for (int i = 0; i < numberOfShells; ++i)
    {
      // A shell without volume keeps its orientation.
      areReversed[i] = !this->IsZeroVolume(shells[i].GetVolume()) &&
        (shells[i].GetVolume() < 0) != (areVoids[i] != 0);
    }
  }
  this->OwnTopology->ReverseShells(areReversed);
  for (int f = 0; f < this->OwnTopology->GetNumberOfFaces(); ++f)
  {
    if (areReversed[this->OwnTopology->GetShell(f)])
    {
      this->FaceVectors[f] = -this->FaceVectors[f];
      if (!this->FaceMoments.empty())
      {
        this->FaceMoments[f] = -this->FaceMoments[f];
      }
    }
  }
  this->Volume = this->SumVolume();
}
}
