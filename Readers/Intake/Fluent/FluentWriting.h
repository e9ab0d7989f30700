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
#include "Intake/Write/OutputFile.h"

#include <string> // for paths
#include <vector> // for names of arrays

namespace camaron
{
/// The highest dimension of a mesh's cells.
int GetDimension(vtkDataSet* mesh);

/// Warns about arrays of a mesh that are neither zones nor @a more arrays of one number per cell.
void WarnOfLostArrays(vtkDataSet* mesh, const char* format, Warnings& warnings,
  const std::vector<std::string>& more = {});

/// Writes the file; false if aborted, or with an error of its own.
using FluentWrite = FunctionRef<bool(const FluentOutput&, OutputFile&, const Progress&)>;

/**
 * Calls @a write with what the file of @a mesh contains, and commits it; false with the reason in
 * @a error, or without one if aborted.
 */
bool WriteFluent(const std::string& path, vtkDataSet* mesh, UnsupportedCells others,
  Warnings& warnings, ScanError& error, const Progress& progress, FluentWrite write);
}

#endif
