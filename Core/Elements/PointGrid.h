// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PointGrid
 * @brief Which places coincide, and cubes of space to look them up by.
 *
 * Cubes are known by a hash: two cubes may share one, so that distances are compared in any case.
 */
#ifndef camaron_PointGrid_h
#define camaron_PointGrid_h

#include "Base/Vector.h"

#include <cstdint> // for hashes

namespace camaron
{
class PointGrid
{
public:
  /**
   * @param tolerance a length; 0 for 8 rounding units of the larger one of the coordinates that are
   * compared
   * @param hasFloats whether these are units of float, not double
   * @param largest of the coordinates of all places
   */
  PointGrid(double tolerance, bool hasFloats, double largest);

  /// The largest coordinate without its sign; infinite or NaN if one of them is.
  static double GetSize(const Vector& place);

  /// Up to which distance places may coincide.
  double GetReach() const { return this->Reach; }
  bool AreNear(const Vector& a, const Vector& b) const;
  /// That of the cube around a place with finite coordinates.
  std::uint64_t GetHash(const Vector& place) const { return Hash(this->GetCube(place)); }
  /// Calls @a visit(hash) for all cubes within reach of a place, some of them perhaps twice.
  template <typename Visit>
  void ForNear(const Vector& place, Visit&& visit) const
  {
    const Vector reach = { this->Reach, this->Reach, this->Reach };
    const Vector low = this->GetCube(place - reach), high = this->GetCube(place + reach);
    for (double x = low.X; x <= high.X; ++x)
    {
      for (double y = low.Y; y <= high.Y; ++y)
      {
        for (double z = low.Z; z <= high.Z; ++z)
        {
          visit(Hash({ x, y, z }));
        }
      }
    }
  }

private:
  Vector GetCube(const Vector& place) const;
  static std::uint64_t Hash(const Vector& cube);

  double Tolerance, Rounding, Reach, Cube;
};
}

#endif
