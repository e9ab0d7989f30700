// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChangeElementType.h
 * @brief Changes a selection to another element type, for example from points to cells.
 */
#ifndef camaron_ChangeElementType_h
#define camaron_ChangeElementType_h

#include "Selection/KindChange.h"
#include "Strategies/Strategy.h"

namespace camaron
{
/**
 * Collective. Marks the elements of the task that belong to marked elements (@a others) of the
 * other type of the same mesh: the cells of marked points, or the points of marked cells. @a
 * quantifier: whether any or all of them must be marked.
 */
SelectionMarks ChangeElementTypeOf(
  const SelectionTask& task, const SelectionMarks& others, Quantifier quantifier);
}

#endif
