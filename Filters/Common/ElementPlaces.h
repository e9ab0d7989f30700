// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ElementPlaces.h
 * @brief Where elements are, told to all processes.
 */
#ifndef camaron_ElementPlaces_h
#define camaron_ElementPlaces_h

#include "ElementBlocks.h"
#include "Statistics/Summary.h"

#include <array>  // for coordinates
#include <vector> // for places

namespace camaron
{
/// Mean of the points of a cell, the same in whatever order the cell has them; or the coordinates
/// of a point.
void GetPlace(const ElementBlock& block, vtkIdType element, double place[3]);

/// Collective. Places of elements of @a values that one process each has; NaN if none has it.
std::vector<std::array<double, 3>> FindPlaces(const std::vector<ElementPlace>& elements,
  const ElementBlocks& blocks, const BlockValues& values, Reducer& reducer);
}

#endif
