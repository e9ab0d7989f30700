// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MAPDLReading.h
 * @brief Reads meshes from decks of Ansys Mechanical APDL commands (.cdb, .dat, .inp).
 *
 * See Readers/MAPDL/README.md for the supported commands.
 */
#ifndef camaron_MAPDLReading_h
#define camaron_MAPDLReading_h

#include "Base/Progress.h"
#include "Intake/Pieces/PieceRequest.h"
#include "Intake/Rows/TextLines.h"
#include "Scan/ScanError.h"

#include <string> // for paths

class vtkUnstructuredGrid;

namespace camaron
{
struct MAPDLOptions
{
  /// Whether to create linear cells only; mid-side nodes are then points without cells.
  bool Linear = false;
  /// Whether to keep surface elements for contact and loads.
  bool SurfaceEffects = true;
};

/// Whether the file begins like a deck with nodes. Reads its first part and reports no errors.
bool IsMAPDL(const std::string& path);

/**
 * Reads a piece of a file into @a grid, which is emptied first. The result does not depend on the
 * number of threads.
 * @param chunk bytes of text per task
 * @return false with the error in @a error, or without one if aborted; the grid is then empty
 */
bool ReadMAPDL(const std::string& path, const MAPDLOptions& options, const PieceRequest& request,
  vtkUnstructuredGrid* grid, Warnings& warnings, ScanError& error,
  const Progress& progress = Progress(), vtkIdType chunk = TextLines::DefaultChunk);
}

#endif
