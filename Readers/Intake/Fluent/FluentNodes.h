// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FluentNodes.h
 * @brief Reads the coordinates of a Fluent file.
 */
#ifndef camaron_FluentNodes_h
#define camaron_FluentNodes_h

#include "Intake/Fluent/FluentFile.h"
#include "Intake/Ids/IdSet.h"
#include "Intake/Pieces/PieceOfSpace.h"

#include "vtkSmartPointer.h" // for coordinates

class vtkDataArray;

namespace camaron
{
/// Number of nodes, after checking that the sections define all of them; -1 with the error in the
/// file.
vtkIdType CountFluentNodes(FluentFile& file);

/// Passes all nodes, from any thread; false with the error in the file, or if aborted.
bool ForEachFluentNode(
  FluentFile& file, const PieceOfSpace::Visit& visit, const Progress& progress);

/**
 * Coordinates: float if all sections are binary in single precision, else double. nullptr with the
 * error in the file, or if aborted.
 * @param nodes their number
 * @param some the nodes to read, numbered; nullptr for all
 */
vtkSmartPointer<vtkDataArray> ReadFluentNodes(
  FluentFile& file, vtkIdType nodes, const IdSet* some, const Progress& progress);
}

#endif
