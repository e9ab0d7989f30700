// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ClosedShell
 * @brief A closed triangulated surface, one of several that bound a cell; determines which of them
 * are inside others.
 */
#ifndef camaron_ClosedShell_h
#define camaron_ClosedShell_h

#include "Geometry/Bounds.h"

#include <array>  // for triangles
#include <vector> // for triangles

namespace camaron
{
class ClosedShell
{
public:
  void Add(const Vector& a, const Vector& b, const Vector& c);

  /// Negative if the triangles are oriented inward.
  double GetVolume() const { return this->Volume; }
  /// Whether another shell contains this one. Shells may touch, but must not intersect.
  bool IsInside(const ClosedShell& outer) const;

private:
  double GetWinding(const Vector& point) const;

  std::vector<std::array<Vector, 3>> Triangles;
  Bounds Box;
  double Volume = 0;
};

/// For every shell, whether it bounds a void, which means that an odd number of other shells
/// contains it.
std::vector<unsigned char> FindVoids(const std::vector<ClosedShell>& shells);
}

#endif
