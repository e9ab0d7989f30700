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
    CellTopology& topology = this->Topologies[i];
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
  CellTopology& topology = this->Topologies[this->Last];
  topology.Take(numberOfPoints, this->FaceOffsets, this->FacePoints);
  wasRepeated = topology.Finish(edgesCanWait);
  return topology;
}
}
