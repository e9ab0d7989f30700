// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonOFFBinary.h
 * @brief Reads the part of a binary OFF file after the keyword.
 *
 * The format is big endian. A file whose numbers are only valid as little endian is read with a
 * warning, and so is one whose faces lack the number of their color components.
 */
#ifndef camaron_PolygonOFFBinary_h
#define camaron_PolygonOFFBinary_h

#include "PolygonOFFMesh.h"
#include "Scan/MappedFile.h"

namespace camaron
{
/// @param body first byte after the line of the keyword
bool ReadBinaryOFF(const MappedFile& file, const char* body, const OFFHeader& keyword,
  const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings, ScanError& error,
  const Progress& progress);
}

#endif
