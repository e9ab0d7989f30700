// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurrentSelection.h
 * @brief The current selection, before a strategy runs, and its combination with the result.
 */
#ifndef camaron_CurrentSelection_h
#define camaron_CurrentSelection_h

#include "Strategies/Strategy.h"

class vtkSelection;

namespace camaron
{
/**
 * Collective. The elements of the Selection, however it describes them (ids, values, locations,
 * queries, or expressions of these). If it describes elements of the other type, the cells with a
 * selected point, or the points of the selected cells. Without a Selection, the elements for which
 * the array "Selected" of the mesh is not 0; without this array, none.
 *
 * Ghosts are never selected. Throws std::runtime_error on all processes if the selection cannot be
 * evaluated.
 */
SelectionMarks FindCurrentSelection(const SelectionTask& task);

/// Collective. For each block the elements of one type that the Selection, or without one the mesh,
/// describes, including ghosts. Throws as above.
SelectionMarks FindSelected(const SelectionTask& task, ElementKind kind);

/// Marks the elements of a data set for which the array "Selected" is not 0; none without the
/// array.
void MarkSelected(vtkDataSet* data, ElementKind kind, std::vector<unsigned char>& marks);

/// Points for cells, cells for points.
ElementKind GetOtherKind(ElementKind kind);

/**
 * Replaces @a marks by its combination with @a current: "Replace" (unchanged), "Add", "Subtract",
 * "Intersect", "Toggle" (in exactly one of both) or "Refine" (as Intersect). Throws
 * std::invalid_argument for any other name.
 */
void CombineSelections(
  const std::string& combination, const SelectionMarks& current, SelectionMarks& marks);
}

#endif
