// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshInputCheck.h"

#include "Mesh/GhostArrays.h"
#include "Mesh/MeshCheck.h"
#include "RunTogether.h"

namespace camaron
{
//------------------------------------------------------------------------------
void CheckMeshes(const std::vector<DataSetLeaf>& leaves, Reducer& reducer)
{
  PolyhedronFaces faces;
  RunTogether(reducer,
    [&]
    {
      for (const DataSetLeaf& leaf : leaves)
      {
        CheckGhosts(leaf.Data);
        CheckPointIds(leaf.Data);
        faces.Add(leaf.Data);
      }
    });
  reducer.Sum(&faces.NumberWithFaces, 1);
  reducer.Sum(&faces.NumberOfPolyhedra, 1);
  faces.Check();
}
}
