// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FluentReading.h
 * @brief Creates the mesh and the boundaries of a Fluent file from its sections.
 */
#ifndef camaron_FluentReading_h
#define camaron_FluentReading_h

#include "Intake/Fluent/FluentFile.h"
#include "Intake/Pieces/PieceRequest.h"

class vtkMultiBlockDataSet;
class vtkUnstructuredGrid;

namespace camaron
{
/**
 * Reads a piece of a file whose sections have been found.
 * @param boundaries if given, gets one block per face zone, except interior ones
 * @return false with the error in @a error, or without one if aborted; the outputs are then
 * incomplete
 */
bool ReadFluent(FluentFile& file, const PieceRequest& request, vtkUnstructuredGrid* grid,
  vtkMultiBlockDataSet* boundaries, Warnings& warnings, ScanError& error, const Progress& progress);
}

#endif
