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
 * Collective. The elements of the Selection, whatever describes them (ids, values, places, queries,
 * expressions of these); where it is of the other kind, the cells with a selected point or the
 * points of the selected cells. Without a Selection the elements for which the array "Selected" of
 * the mesh is not 0, and none without that.
 *
 * No ghosts. Throws std::runtime_error when the selection cannot be evaluated.
 */
SelectionMarks FindCurrentSelection(const SelectionTask& task);

/// Collective. What the Selection, or without one the mesh, says of the elements of one kind,
/// ghosts included: of each block. Throws as above.
SelectionMarks FindSelected(const SelectionTask& task, ElementKind kind);

/// Which elements of a data set its array "Selected" marks; none without it.
void MarkSelected(vtkDataSet* data, ElementKind kind, std::vector<unsigned char>& marks);

/// The other one.
ElementKind GetOtherKind(ElementKind kind);

/**
 * Replaces @a marks by their combination with @a current: "Replace" (as they are), "Add",
 * "Subtract", "Intersect", "Toggle" (one of both, not both) or "Refine" (as Intersect). Throws
 * std::invalid_argument for any other.
 */
void CombineSelections(
  const std::string& combination, const SelectionMarks& current, SelectionMarks& marks);
}

#endif
