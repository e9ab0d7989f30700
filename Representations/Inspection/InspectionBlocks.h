// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InspectionBlocks.h
 * @brief The blocks of a mesh that is drawn as one grid, and their colors, opacities and
 * visibility.
 *
 * The cell array LeavesName of the grid is the index of the piece of a block to which a cell
 * belongs. The field arrays HiddenLeavesName and LeafLooksName describe how pieces look; they exist
 * only if a piece looks different from the mesh.
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
/// The pieces of a block that have cells: at most one, but any number for a vtkPartitionedDataSet.
using Block = std::vector<vtkUnstructuredGrid*>;

/// All blocks of a tree in its order, including empty ones, so that blocks have the same numbers on
/// all processes.
std::vector<Block> FindBlocks(vtkDataObjectTree* tree);

/**
 * Sets how the blocks of `grid` look: as the MultiBlock Inspector has set for their samples (see
 * vtkJoinedInspectionMesh), and by the array that `mapper` colors by. Blocks without that array get
 * the color `missing`; a field data array of a block colors the whole block.
 */
void SetLooks(vtkUnstructuredGrid* grid, vtkDataObjectTree* samples,
  vtkCompositeDataDisplayAttributes* attributes, vtkMapper* mapper, const double missing[3]);
}

#endif
