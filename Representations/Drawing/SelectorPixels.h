// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SelectorPixels.h
 * @brief From the ids that the shaders paint in a hardware selection to those of the input.
 */
#ifndef camaron_SelectorPixels_h
#define camaron_SelectorPixels_h

#include "vtkType.h" // for vtkIdType

#include <vector> // for the places of pixels

class vtkDataArray;
class vtkHardwareSelector;

namespace camaron
{
/// The largest id that a selection can meet: of @a ids, or the last of @a size elements without.
vtkIdType GetLargestId(vtkDataArray* ids, vtkIdType size);

/**
 * Replaces the painted numbers of the selector's current pass, which is @a lowPass or @a highPass,
 * by the ids that @a ids has for them. Nothing to do without @a ids.
 */
void MapSelectorPixels(vtkHardwareSelector* selector, const std::vector<unsigned int>& pixelOffsets,
  int lowPass, int highPass, vtkDataArray* ids);
}

#endif
