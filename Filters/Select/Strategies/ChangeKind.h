// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChangeKind.h
 * @brief Cells of selected points, and points of selected cells.
 */
#ifndef camaron_ChangeKind_h
#define camaron_ChangeKind_h

#include "Selection/KindChange.h"
#include "Strategies/Strategy.h"

namespace camaron
{
/// Collective. Of the elements of the task those that belong to the marked elements of the other
/// kind of the same mesh.
SelectionMarks ChangeKindOf(
  const SelectionTask& task, const SelectionMarks& others, Quantifier quantifier);
}

#endif
