// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ClosedShell
 * @brief A closed surface of triangles, one of several that bound a cell; and which of these lie
 * inside of which.
 */
#ifndef camaron_ClosedShell_h
#define camaron_ClosedShell_h

#include "Base/Vector.h"

#include <array>  // for triangles
#include <vector> // for triangles

namespace camaron
{
class ClosedShell
{
public:
  void Add(const Vector& a, const Vector& b, const Vector& c);

  /// Negative if the triangles run inward.
  double GetVolume() const { return this->Volume; }
  /// Whether another one surrounds this one. Shells may touch, but do not cut through each other.
  bool IsInside(const ClosedShell& outer) const;

private:
  double GetWinding(const Vector& point) const;

  std::vector<std::array<Vector, 3>> Triangles;
  Vector Low, High; // the box
  double Volume = 0;
};

/// Of every shell whether it bounds a void: an odd number of others contains it.
std::vector<unsigned char> FindVoids(const std::vector<ClosedShell>& shells);
}

#endif
