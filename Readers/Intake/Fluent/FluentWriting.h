// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FluentWriting.h
 * @brief The frame of the writers of Fluent files: converts the cells, finds faces and zones.
 */
#ifndef camaron_FluentWriting_h
#define camaron_FluentWriting_h

#include "Base/FunctionRef.h" // for what writes
#include "Base/Progress.h"
#include "Intake/CellMesh/CellConversion.h"
#include "Intake/Fluent/FluentOutput.h"

#include <string> // for paths

namespace camaron
{
/// Writes the file; false if aborted, or with an error of its own.
using FluentWrite = FunctionRef<bool(const FluentOutput&, const Progress&)>;

/**
 * Calls @a write with what a file of @a mesh contains; false with the reason in @a error, or
 * without one if aborted.
 * @param path for messages
 */
bool WriteFluent(const std::string& path, vtkDataSet* mesh, UnsupportedCells others,
  Warnings& warnings, ScanError& error, const Progress& progress, FluentWrite write);
}

#endif
