// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurrentSelection.h
 * @brief What is selected before a strategy runs, and how its result is combined with that.
 */
#ifndef camaron_CurrentSelection_h
#define camaron_CurrentSelection_h

#include "Strategies/Strategy.h"

class vtkSelection;

namespace camaron
{
/**
 * The elements of @a selection, whatever describes them (ids, values, places, queries, expressions of
 * these); where it is of the other kind, the cells with a selected point or the points of the selected
 * cells. Without a selection the elements for which the array @a arrayName of the input is not 0, and
 * none without that.
 *
 * No ghosts. Throws std::invalid_argument when the selection cannot be evaluated.
 */
SelectionMarks FindCurrentSelection(vtkDataObject* input, vtkSelection* selection,
  const char* arrayName, int process, const ElementBlocks& blocks);

/**
 * Replaces @a marks by their combination with @a current: "Replace" (as they are), "Add", "Subtract",
 * "Intersect", "Toggle" (one of both, not both) or "Refine" (as Intersect). Throws
 * std::invalid_argument for any other.
 */
void CombineSelections(
  const std::string& combination, const SelectionMarks& current, SelectionMarks& marks);
}

#endif
