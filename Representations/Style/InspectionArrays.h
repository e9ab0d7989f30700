// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InspectionArrays.h
 * @brief Names of the arrays that go with a mesh to where it is drawn.
 */
#ifndef camaron_InspectionArrays_h
#define camaron_InspectionArrays_h

namespace camaron
{
/// Of the cells: made by Select Elements, not 0 for selected ones.
constexpr const char* SelectedArrayName = "Selected";

///@{
/// Where cells and points come from: made by vtkInspectionMesh where ids could get lost on the way.
constexpr const char* CellIdsName = "InspectionCellIds";
constexpr const char* PointIdsName = "InspectionPointIds";
constexpr const char* ProcessIdsName = "InspectionProcesses";
/// See OuterFacets.h; there where processes may exchange cells.
constexpr const char* OuterFacetsName = "InspectionOuterFacets";
constexpr const char* BlockIdsName = "InspectionBlocks";
///@}

///@{
/// Of a grid of blocks: see InspectionBlocks.h.
constexpr const char* LeavesName = "InspectionLeaves";
constexpr const char* JoinedPointIdsName = "InspectionJoinedPoints";
constexpr const char* HiddenLeavesName = "InspectionHiddenLeaves"; ///< a byte each
constexpr const char* LeafLooksName =
  "InspectionLeafLooks"; ///< color or below 0, opacity or below 0
///@}
}

#endif
