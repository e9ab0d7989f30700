// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InspectionArrays.h
 * @brief Names of the arrays that accompany a mesh to where it is drawn.
 */
#ifndef camaron_InspectionArrays_h
#define camaron_InspectionArrays_h

namespace camaron
{
/// Cell array of Select Elements: not 0 for selected cells.
constexpr const char* SelectedArrayName = "Selected";

///@{
/// Origin of cells and points; vtkInspectionMesh adds these arrays where ids could get lost.
constexpr const char* CellIdsName = "InspectionCellIds";
constexpr const char* PointIdsName = "InspectionPointIds";
constexpr const char* ProcessIdsName = "InspectionProcesses";
/// See OuterFacets.h; exists where processes may exchange cells.
constexpr const char* OuterFacetsName = "InspectionOuterFacets";
constexpr const char* BlockIdsName = "InspectionBlocks";
///@}

///@{
/// Arrays of a grid that joins blocks, see InspectionBlocks.h.
constexpr const char* LeavesName = "InspectionLeaves";
constexpr const char* JoinedPointIdsName = "InspectionJoinedPoints";
constexpr const char* HiddenLeavesName = "InspectionHiddenLeaves"; ///< one byte per leaf
constexpr const char* LeafLooksName =
  "InspectionLeafLooks"; ///< color and opacity; below 0: not set
///@}
}

#endif
