// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TRIBinary.h
 * @brief Reads the binary files of Cart3D: unformatted Fortran records.
 */
#ifndef camaron_TRIBinary_h
#define camaron_TRIBinary_h

#include "Base/Progress.h"
#include "Scan/MappedFile.h"
#include "Scan/PieceRequest.h"

class vtkUnstructuredGrid;

namespace camaron
{
/// Whether the file begins with a record of two or three counts.
bool IsBinaryTRI(const MappedFile& file);

/// Reads a piece of such a file; false with the error in @a error, or without one if aborted.
bool ReadBinaryTRI(const MappedFile& file, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress);
}

#endif
