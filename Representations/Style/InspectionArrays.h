// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InspectionArrays.h
 * @brief Arrays that accompany a mesh to where it is drawn.
 */
#ifndef camaron_InspectionArrays_h
#define camaron_InspectionArrays_h

#include "vtkDataSetAttributes.h" // for the arrays
#include "vtkIdTypeArray.h"       // for ids
#include "vtkNew.h"               // for ids

#include <numeric> // for std::iota

namespace camaron
{
/// Cell array of Select Elements: not 0 for selected cells.
constexpr const char* SelectedArrayName = "Selected";

///@{
/// Origin of cells and points; vtkInspectionMesh adds these arrays where ids could get lost.
constexpr const char* CellIdsName = "InspectionCellIds";
constexpr const char* PointIdsName = "InspectionPointIds";
constexpr const char* ProcessIdsName = "InspectionProcesses";
/// See FindOuterFacets; exists where processes may exchange cells.
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

/// Adds an array of the numbers 0, 1, ... of elements unless it exists.
inline void AddIds(vtkDataSetAttributes* attributes, const char* name, vtkIdType size)
{
  if (!attributes->HasArray(name))
  {
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName(name);
    ids->SetNumberOfValues(size);
    std::iota(ids->GetPointer(0), ids->GetPointer(0) + size, vtkIdType(0));
    attributes->AddArray(ids);
  }
}
}

#endif
