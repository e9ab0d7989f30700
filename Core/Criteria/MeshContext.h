// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::MeshContext
 * @brief Mesh-wide tables for criteria with neighbors.
 *
 * Tables are built on first use. Calling a criterion for an empty range of cells only builds its
 * tables, with all threads.
 */
#ifndef camaron_MeshContext_h
#define camaron_MeshContext_h

#include "Cell/CellGeometry.h"
#include "Criteria/NormalFan.h"
#include "Mesh/MeshTopology.h"

#include <map>    // for the fans
#include <mutex>  // for std::once_flag
#include <vector> // for the tables

namespace camaron
{
class MeshContext
{
public:
  MeshContext(const MeshTopology& topology, const EvaluationOptions& options)
    : Topology(topology)
    , Options(options)
  {
  }

  const MeshTopology& Topology;
  const EvaluationOptions& Options;

  /// The global id of a cell, or its index in the mesh without global ids.
  double GetId(vtkIdType cell) const;
  /// Vector areas of the 2D cells; zero for other cells.
  const std::vector<Vector>& GetCellVectors() const;
  /// For the edges with so many polygons that trying all pairs would take long: the normals of
  /// those that the evaluated cells see, each as if it traversed the edge against its owner.
  const std::map<Index, NormalFan>& GetNormalFans() const;
  /// For every cell, the lowest id of all cells with the same points, or -1 if it has no duplicate.
  const std::vector<double>& GetDuplicateIds() const;

private:
  NormalFan GatherNormals(Index edge) const;

  mutable std::once_flag CellVectorsOnce, NormalFansOnce, DuplicateIdsOnce;
  mutable std::vector<Vector> CellVectors;
  mutable std::map<Index, NormalFan> NormalFans;
  mutable std::vector<double> DuplicateIds;
};
}

#endif
