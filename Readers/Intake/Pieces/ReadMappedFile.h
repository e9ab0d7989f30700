// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReadMappedFile.h
 * @brief The frame of a reader: opens the file, provides threads, converts exceptions to errors.
 */
#ifndef camaron_ReadMappedFile_h
#define camaron_ReadMappedFile_h

#include "Base/FunctionRef.h" // for what reads
#include "Base/Progress.h"
#include "Intake/Pieces/PieceRequest.h"
#include "Scan/MappedFile.h"

class vtkUnstructuredGrid;

namespace camaron
{
using MappedFileReading = FunctionRef<bool(const MappedFile&, const Progress&)>;

/// Returns the result of @a read, or false with the reason in @a error, for example that the file
/// was changed while reading.
bool ReadMappedFile(
  const std::string& path, ScanError& error, const Progress& progress, MappedFileReading read);

/// The same for a reader that fills @a grid, which is emptied first, and also, like @a warnings, if
/// reading fails.
bool ReadMappedFile(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress, MappedFileReading read);
}

#endif
