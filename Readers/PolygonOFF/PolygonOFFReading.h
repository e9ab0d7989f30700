// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonOFFReading.h
 * @brief Reads OFF files of Geomview and of other programs that use the format.
 *
 * See Readers/PolygonOFF/README.md for the format.
 */
#ifndef camaron_PolygonOFFReading_h
#define camaron_PolygonOFFReading_h

#include "Scan/PieceRequest.h"
#include "Scan/TextLines.h"

#include <string> // for paths

class vtkUnstructuredGrid;

namespace camaron
{
/// Whether the file begins like an OFF file. Reports no errors.
bool IsPolygonOFF(const std::string& path);

/**
 * Reads a piece of a file into @a grid, which is emptied first. The result does not depend on the
 * number of threads.
 * @param chunk bytes of text per task; shorter text than two chunks is read serially
 * @return false with the error in @a error, or without one if aborted; the grid is then empty
 */
bool ReadPolygonOFF(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress = Progress(),
  vtkIdType chunk = TextLines::DefaultChunk);
}

#endif
