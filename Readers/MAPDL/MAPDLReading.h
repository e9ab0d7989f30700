// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MAPDLReading.h
 * @brief Reads meshes from decks of Ansys Mechanical APDL commands (.cdb, .dat, .inp).
 *
 * See Readers/MAPDL/README.md for what is read.
 */
#ifndef camaron_MAPDLReading_h
#define camaron_MAPDLReading_h

#include "Base/Progress.h"
#include "Scan/PieceRequest.h"
#include "Scan/ScanError.h"
#include "Scan/TextLines.h"

#include <string> // for paths

class vtkUnstructuredGrid;

namespace camaron
{
struct MAPDLOptions
{
  /// Makes all cells linear; mid-side nodes are points without cells then.
  bool Linear = false;
  /// Keeps elements on surfaces for contact and loads.
  bool SurfaceEffects = true;
  /// Makes elements that are no cells, such as matrices, sets of points; else they are left out.
  bool UnknownAsPoints = false;
};

/// Whether the file begins like a deck with nodes. Reads its first part, reports nothing.
bool IsMAPDL(const std::string& path);

/**
 * Reads a piece of a file into @a grid, which is emptied first. Any number of threads gives the
 * same grid.
 * @param chunk bytes of text read as one piece of work
 * @return false with the error in @a error, or without one if stopped; the grid is empty then
 */
bool ReadMAPDL(const std::string& path, const MAPDLOptions& options, const PieceRequest& request,
  vtkUnstructuredGrid* grid, Warnings& warnings, ScanError& error,
  const Progress& progress = Progress(), vtkIdType chunk = TextLines::DefaultChunk);
}

#endif
