// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellShapes.h
 * @brief Shapes of cells, which decide whether an acceptable range applies to a cell.
 */
#ifndef camaron_CellShapes_h
#define camaron_CellShapes_h

#include "AcceptableRanges.h"
#include "ElementBlocks.h"

#include <cstdint>  // for shapes
#include <optional> // for ranges
#include <vector>   // for lists

namespace camaron
{
/**
 * Shapes (Criterion.h) of every cell; 0 for points and lines. Cells of a fixed VTK type have the
 * shape of their type, even if they are degenerate. Polygons and polyhedra have the shape of their
 * topology: a VTK_POLYHEDRON with the faces of a hexahedron is a hexahedron.
 */
std::vector<std::uint16_t> FindCellShapes(vtkDataSet* data);

/// Provides the shapes of all cells of a mesh. They are computed when a range that does not apply
/// to all cells is first used.
class BlockShapes
{
public:
  /// Stores a reference to @a blocks, which must outlive this object.
  explicit BlockShapes(const ElementBlocks& blocks)
    : Blocks(blocks)
  {
  }

  /// Sets in @a values to which cells the range applies, if that depends on their shapes, and
  /// returns whether it does. @a values borrows memory of this object.
  bool Judge(BlockValues& values, const std::optional<AcceptableRange>& range);

private:
  const ElementBlocks& Blocks;
  std::vector<std::vector<std::uint16_t>> Shapes; // one list per block
};
}

#endif
