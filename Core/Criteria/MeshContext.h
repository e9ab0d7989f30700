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
#include "Mesh/MeshTopology.h"

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
  /// For every cell, the lowest id of all cells with the same points, or -1 if it has no duplicate.
  const std::vector<double>& GetDuplicateIds() const;

private:
  mutable std::once_flag CellVectorsOnce, DuplicateIdsOnce;
  mutable std::vector<Vector> CellVectors;
  mutable std::vector<double> DuplicateIds;
};
}

#endif
