// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::InspectionBlocks
 * @brief The blocks of a mesh as one grid to draw, and how each of them is to look.
 *
 * The grid has all arrays that any block has. Where a block lacks one it has NaN, 0 in arrays of bytes, which may be
 * colours or ghosts, and no text. The cell array LeavesName says which block a cell is of; field arrays say how the
 * blocks look, HiddenLeavesName and LeafLooksName, and are there only if one looks unlike the mesh.
 */
#ifndef camaron_InspectionBlocks_h
#define camaron_InspectionBlocks_h

#include "vtkSmartPointer.h" // for the grids
#include "vtkType.h"         // for vtkMTimeType

#include <vector> // for the blocks

class vtkCompositeDataDisplayAttributes;
class vtkDataObject;
class vtkMapper;
class vtkUnstructuredGrid;

namespace camaron
{
class InspectionBlocks
{
public:
  /// True when `data` are not the blocks that Join saw last.
  bool IsNew(vtkDataObject* data) const;

  /// The blocks of a tree of vtkUnstructuredGrid as one, made again when they change; a grid itself; else null.
  vtkUnstructuredGrid* Join(vtkDataObject* data);

  /**
   * How blocks look by what the MultiBlock Inspector says, and by the array that `mapper` colours by: blocks without it
   * have `missing` for a colour, and an array of the blocks themselves (field data) colours all of a block.
   */
  void SetLooks(
    vtkCompositeDataDisplayAttributes* attributes, vtkMapper* mapper, const double missing[3]);

private:
  vtkSmartPointer<vtkDataObject> Data;
  vtkMTimeType Time = 0;
  std::vector<vtkSmartPointer<vtkUnstructuredGrid>> Leaves;
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
};
}

#endif
