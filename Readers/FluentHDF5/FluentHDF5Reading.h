// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FluentHDF5Reading.h
 * @brief Reads mesh and case files of Ansys Fluent in HDF5. See Readers/FluentHDF5/README.md.
 */
#ifndef camaron_FluentHDF5Reading_h
#define camaron_FluentHDF5Reading_h

#include "Intake/Fluent/FluentReading.h"

#include <string> // for paths
#include <vector> // for names

namespace camaron
{
struct FluentFieldRequest;

/// Whether a file is HDF5 with a mesh of Fluent.
bool IsFluentHDF5(const std::string& path);

/// Names of the zones of a file, without interior ones; none if it cannot be read.
std::vector<std::string> ListFluentZones(const std::string& path);

/**
 * Reads a piece of a file.
 * @param boundaries if given, gets one block per face zone, except interior ones
 * @param zones names of the zones to read, with their points; nullptr: all
 * @param fields results that become cell arrays
 * @return false with the error in @a error, or without one if aborted; @a grid is then empty
 */
bool ReadFluentHDF5(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  vtkMultiBlockDataSet* boundaries, const std::vector<std::string>* zones,
  const FluentFieldRequest& fields, Warnings& warnings, ScanError& error, const Progress& progress);
}

#endif
