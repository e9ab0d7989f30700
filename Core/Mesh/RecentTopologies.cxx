// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/RecentTopologies.h"

namespace camaron
{
//------------------------------------------------------------------------------
CellTopology& RecentTopologies::Find(int numberOfPoints, bool edgesCanWait, bool& wasRepeated)
{
  for (const int i : { this->Last, 1 - this->Last })
  {
    CellTopology& topology = this->Recents[i].Topology;
    if (topology.Knows(numberOfPoints, this->FaceOffsets, this->FacePoints))
    {
      this->Last = i;
      wasRepeated = false;
      if (!edgesCanWait)
      {
        topology.FindEdges();
      }
      return topology;
    }
  }
  this->Last = 1 - this->Last;
  CellTopology& topology = this->Recents[this->Last].Topology;
  this->Recents[this->Last].HasCorners = false;
  topology.Take(numberOfPoints, this->FaceOffsets, this->FacePoints);
  wasRepeated = topology.Finish(edgesCanWait);
  return topology;
}

//------------------------------------------------------------------------------
// Local numbers are in order if they are assigned by first occurrence, which is not the case for
// collapsed standard cells.
void RecentTopologies::FindCorners(Recent& recent)
{
  const std::vector<int>& numbers = recent.Topology.FacePoints;
  recent.HasCorners = true;
  recent.PointCorners.clear();
  recent.Repetitions.clear();
  for (int corner = 0; corner < static_cast<int>(numbers.size()); ++corner)
  {
    const int next = static_cast<int>(recent.PointCorners.size());
    recent.IsInOrder = numbers[corner] <= next;
    if (!recent.IsInOrder)
    {
      return;
    }
    if (numbers[corner] == next)
    {
      recent.PointCorners.push_back(corner);
    }
    else
    {
      recent.Repetitions.push_back({ corner, recent.PointCorners[numbers[corner]] });
    }
  }
  recent.IsInOrder = static_cast<int>(recent.PointCorners.size()) == recent.Topology.NumberOfPoints;
}
}
