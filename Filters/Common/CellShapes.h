// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellShapes.h
 * @brief Which cells an acceptable range is for, told by their shapes.
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
 * Shapes (Criterion.h) of every cell, 0 for points and lines. Those of a fixed type are what their
 * type says, even if they are collapsed; polygons and polyhedra what their topology says, whatever
 * their type.
 */
std::vector<std::uint16_t> FindCellShapes(vtkDataSet* data);

/// The shapes of all cells, found when a range is first not for all of them.
class BlockShapes
{
public:
  /// Keeps a reference to @a blocks.
  explicit BlockShapes(const ElementBlocks& blocks)
    : Blocks(blocks)
  {
  }

  /// Says in @a values which cells the range is for. They borrow from this.
  void Judge(BlockValues& values, const std::optional<AcceptableRange>& range);

private:
  const ElementBlocks& Blocks;
  std::vector<std::vector<std::uint16_t>> Shapes; // of each block
};
}

#endif
