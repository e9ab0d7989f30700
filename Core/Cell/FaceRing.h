// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FaceRing
 * @brief The edges of a face of a cell.
 */
#ifndef camaron_FaceRing_h
#define camaron_FaceRing_h

#include "Cell/CellGeometry.h"

#include <cmath>  // for heights
#include <vector> // for corners

namespace camaron
{
class FaceRing
{
public:
  FaceRing(const CellGeometry& cell, int face)
    : Cell(cell)
    , Face(face)
    , Points(cell.GetTopology().GetFace(face))
    , Size(cell.GetTopology().GetFaceSize(face))
  {
  }
  int GetSize() const { return this->Size; }
  const Vector& GetBegin(int edge) const { return this->Cell.GetPoint(this->Points[edge]); }
  const Vector& GetEnd(int edge) const
  {
    return this->GetBegin(edge + 1 < this->Size ? edge + 1 : 0);
  }

  void GetCorners(std::vector<Vector>& corners) const
  {
    corners.clear();
    for (int i = 0; i < this->Size; ++i)
    {
      corners.push_back(this->GetBegin(i));
    }
  }

  /// Whether all vertices are in one plane.
  bool IsFlat() const
  {
    const Vector normal = Unit(this->Cell.GetFaceVector(this->Face));
    for (int i = 0; i < this->Size; ++i)
    {
      const Vector offset = this->GetBegin(i) - this->Cell.GetFaceCenter(this->Face);
      if (!this->Cell.IsZeroLength(std::abs(Dot(normal, offset))))
      {
        return false;
      }
    }
    return true;
  }

private:
  const CellGeometry& Cell;
  int Face;
  const int* Points;
  int Size;
};
}

#endif
