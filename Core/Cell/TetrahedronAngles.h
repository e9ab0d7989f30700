// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TetrahedronAngles
 * @brief The angles of two tetrahedra; see NondegenerateTetrahedra.
 *
 * Visits faces, edges and points in the same order as CellGeometry, because the first of several
 * angles that differ only by roundoff counts.
 */
#ifndef camaron_TetrahedronAngles_h
#define camaron_TetrahedronAngles_h

#include "Cell/AngleRange.h"
#include "Cell/TetrahedronPair.h"
#include "Mesh/CellTopology.h"

namespace camaron
{
class TetrahedronAngles
{
public:
  explicit TetrahedronAngles(const TetrahedronPair& pair);

  AngleRangePair GetFaceAngles() const;

  /// Call this before the other methods.
  void MeasureSides();
  AngleRangePair GetDihedralAngles() const;
  /// @param areSimple set to 1, or 0 where CellGeometry uses another method
  AngleRangePair GetHalfSolidAngles(Pair& areSimple) const;

private:
  const CellTopology& Topology;
  const Pair Sign; // of the volume
  const VectorPair Places[4];
  VectorPair FaceVectors[4];
  Pair FaceAreas[4];
  VectorPair Edges[6];
  Pair Lengths[6];
};
}

#endif
