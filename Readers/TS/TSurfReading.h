// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TSurfReading.h
 * @brief Reads the TSurf objects of a GOCAD file into a grid.
 */
#ifndef camaron_TSurfReading_h
#define camaron_TSurfReading_h

#include "Scan/MappedFile.h"
#include "Scan/PieceRequest.h"
#include "TSurfObjects.h"

class vtkUnstructuredGrid;

namespace camaron
{
/// See ReadTS.
bool ReadTSurf(const MappedFile& file, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress, vtkIdType chunk);
}

#endif
