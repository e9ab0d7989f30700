// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CollapsedShape
 * @brief What remains of a cell of higher order that lists corners more than once: a tetrahedron,
 * pyramid or wedge of a hexahedron, a triangle of a quadrilateral, and so on.
 *
 * Finite element programs write such cells, and mean the cell that remains, with all its nodes. The
 * map of the collapsed cell itself is another one, with a determinant of zero at its collapsed
 * edges.
 */
#ifndef camaron_CollapsedShape_h
#define camaron_CollapsedShape_h

#include "Base/Vector.h"
#include "Curved/ParametricShape.h"

#include <array>  // for corners
#include <memory> // for what is made
#include <vector> // for nodes

namespace camaron
{
class CollapsedShape
{
public:
  static constexpr int MaxCorners = 8;
  /// For each corner of a cell, the corner of what remains of it.
  using Corners = std::array<signed char, MaxCorners>;

  /**
   * What remains of @a shape, which has the form @a remaining. Its corners are in the order of
   * VTK's types; those of a wedge are an extrusion. nullptr if no type of cells has nodes at the
   * places that remain. Thread-safe; keep the result.
   */
  static const CollapsedShape* Find(
    const ParametricShape& shape, ParametricShape::Domain remaining, const Corners& corners);

  const ParametricShape& GetShape() const { return *this->Remaining; }
  /// VTK's type of cells of that shape.
  unsigned char GetType() const { return this->Type; }
  /// For each corner of the cell, the corner of that shape.
  const Corners& GetCorners() const { return this->InOrder; }
  /// For each node of that shape, the node of the cell, or a combination of several.
  const std::vector<ParametricShape::Row>& GetNodes() const { return this->Nodes; }

  /// Finds the nodes of what remains; false if some nodes of the cell are farther than @a tolerance
  /// from the places that these give them.
  bool Convert(
    const std::vector<Vector>& nodes, double tolerance, std::vector<Vector>& remaining) const;

private:
  static std::unique_ptr<CollapsedShape> Make(
    const ParametricShape& shape, ParametricShape::Domain remaining, const Corners& corners);
  bool SetUp(const ParametricShape& shape);

  const ParametricShape* Remaining = nullptr;
  unsigned char Type = 0;
  Corners InOrder = {};
  std::vector<ParametricShape::Row> Nodes;
  /// Places of the cell where both maps are the same, in nodes of the cell and of what remains.
  std::vector<ParametricShape::Row> Given, Expected;
};
}

#endif
