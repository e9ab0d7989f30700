// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FluentMeshReading.h
 * @brief Reads mesh and case files of Ansys Fluent. See Readers/FluentMesh/README.md.
 */
#ifndef camaron_FluentMeshReading_h
#define camaron_FluentMeshReading_h

#include "Intake/Fluent/FluentFile.h"

#include <string> // for paths

namespace camaron
{
/// Whether the first bytes of a file, also of a compressed one, are those of a Fluent mesh.
bool IsFluentMesh(const std::string& path);

/**
 * Reads a piece of a file.
 * @param boundaries if given, gets one block per face zone, except interior ones
 * @return false with the error in @a error, or without one if aborted; @a grid is then empty
 */
bool ReadFluentMesh(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  vtkMultiBlockDataSet* boundaries, Warnings& warnings, ScanError& error, const Progress& progress);
}

#endif
