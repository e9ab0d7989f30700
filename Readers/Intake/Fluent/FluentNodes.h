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

#include "vtkSmartPointer.h"

class vtkDataArray;

namespace camaron
{
/// Number of nodes, after checking that the sections define all of them; -1 with the error in
/// @a file.
vtkIdType CountFluentNodes(FluentFile& file);

/// Passes all nodes to @a space, to which all faces have been added; false with the error in
/// @a file, or if aborted.
bool FindFluentSpace(
  FluentFile& file, vtkIdType chunk, const Progress& progress, PieceOfSpace& space);

/**
 * Coordinates: float if all sections are binary in single precision, else double. nullptr with the
 * error in @a file, or if aborted.
 * @param some the nodes to read, numbered; nullptr for all
 */
vtkSmartPointer<vtkDataArray> ReadFluentNodes(
  FluentFile& file, vtkIdType nodes, const IdSet* some, vtkIdType chunk, const Progress& progress);
}

#endif
