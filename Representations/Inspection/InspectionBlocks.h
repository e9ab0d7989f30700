// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InspectionBlocks.h
 * @brief The blocks of a mesh that is drawn as one grid, and how each of them is to look.
 *
 * The cell array LeavesName of the grid says which piece of a block a cell is of; field arrays say
 * how the pieces look, HiddenLeavesName and LeafLooksName, and are there only if one looks unlike
 * the mesh.
 */
#ifndef camaron_InspectionBlocks_h
#define camaron_InspectionBlocks_h

#include <vector> // for the blocks

class vtkCompositeDataDisplayAttributes;
class vtkDataObjectTree;
class vtkMapper;
class vtkUnstructuredGrid;

namespace camaron
{
/// Its pieces that have cells: one or none, but of a vtkPartitionedDataSet any number.
using Block = std::vector<vtkUnstructuredGrid*>;

/// All blocks of a tree in its order, empty ones too, so that a block has the same number in all
/// processes.
std::vector<Block> FindBlocks(vtkDataObjectTree* tree);

/**
 * How the blocks of `grid` look by what the MultiBlock Inspector says of their samples, and by the
 * array that `mapper` colors by: blocks without it have `missing` for a color, and an array of
 * the blocks themselves (field data) colors all of a block. For the samples see
 * vtkJoinedInspectionMesh.
 */
void SetLooks(vtkUnstructuredGrid* grid, vtkDataObjectTree* samples,
  vtkCompositeDataDisplayAttributes* attributes, vtkMapper* mapper, const double missing[3]);
}

#endif
