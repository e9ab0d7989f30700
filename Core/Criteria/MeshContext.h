// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshContext.h
 * @brief What a criterion with neighbours reads.
 */
#ifndef camaron_MeshContext_h
#define camaron_MeshContext_h

#include "Criteria/CellGeometry.h"
#include "Mesh/MeshTopology.h"

#include <vector> // for the normals

namespace camaron
{
struct MeshContext
{
  const MeshTopology& Topology;
  const EvaluationOptions& Options;
  /// Vector areas of the 2D cells; zero for other cells.
  std::vector<Vector> CellVectors;
};
}

#endif
