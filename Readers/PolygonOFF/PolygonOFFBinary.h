// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonOFFBinary.h
 * @brief Reads what comes after the keyword of a binary OFF file.
 *
 * The format is big endian. A file whose numbers make no sense so, but do as little endian, is read
 * with a warning, and so is one whose faces do not say how many components their color has.
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
