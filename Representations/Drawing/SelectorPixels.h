// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SelectorPixels.h
 * @brief Converts the numbers that shaders write in a hardware selection to ids of the input.
 */
#ifndef camaron_SelectorPixels_h
#define camaron_SelectorPixels_h

#include "vtkType.h" // for vtkIdType

#include <vector> // for offsets of pixels

class vtkDataArray;
class vtkHardwareSelector;

namespace camaron
{
/// The largest id in a selection: that in @a ids or, without ids, the last of @a size elements.
vtkIdType GetLargestId(vtkDataArray* ids, vtkIdType size);

/// Replaces the numbers of the selector's current pass, @a lowPass or @a highPass, by the values of
/// @a ids at these numbers. Does nothing without @a ids.
void MapSelectorPixels(vtkHardwareSelector* selector, const std::vector<unsigned int>& pixelOffsets,
  int lowPass, int highPass, vtkDataArray* ids);
}

#endif
