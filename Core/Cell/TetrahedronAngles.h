// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TetrahedronAngles
 * @brief The angles of two tetrahedra; see NondegenerateTetrahedra.
 *
 * Faces, edges and points come in the order in which CellGeometry takes them: of angles that are
 * the same but for rounding the first one counts.
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

  /// Before the others.
  void MeasureSides();
  AngleRangePair GetDihedralAngles() const;
  /// @param areSimple 1, or 0 where CellGeometry takes another way
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
