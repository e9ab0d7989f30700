// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::NormalFan
 * @brief The normals of the many polygons at one edge in a tree of their directions, so that the
 * extreme angle of one to all others is found without trying all of them.
 *
 * n polygons take about n log n steps. The result is within 1e-12 of that of trying all, and does
 * not depend on the order of the polygons.
 */
#ifndef camaron_NormalFan_h
#define camaron_NormalFan_h

#include "Base/Vector.h"
#include "Geometry/BoxTree.h"
#include "Mesh/FacetTable.h"

#include <vector> // for the normals

namespace camaron
{
class NormalFan
{
public:
  static constexpr Index Unknown = -1; ///< a cell of another piece

  /// Adds the normal of a cell, of any length; one of length 0 has no direction and is left out.
  void Add(const Vector& normal, Index cell);
  /// Call it once, after all normals are there.
  void Sort();

  /// The extreme angle in radians, GetSmaller or GetLarger, to the normals of other cells than
  /// @a cell; negative if there are none.
  template <auto Choose>
  double Find(const Vector& normal, Index cell) const
  {
    return this->Search(normal, cell, Choose(0.0, 1.0) > 0);
  }

private:
  struct Entry
  {
    Vector Normal;
    Index Cell;
  };
  double Search(const Vector& normal, Index cell, bool isLargest) const;

  std::vector<Entry> Entries;
  BoxTree Directions; // of the entries, of length 1
};
}

#endif
