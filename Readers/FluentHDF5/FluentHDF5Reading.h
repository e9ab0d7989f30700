// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FluentHDF5Reading.h
 * @brief Reads mesh, case and data files of Ansys Fluent in HDF5. See Readers/FluentHDF5/README.md.
 */
#ifndef camaron_FluentHDF5Reading_h
#define camaron_FluentHDF5Reading_h

#include "Intake/Fluent/FluentFile.h"

#include <string> // for paths
#include <vector> // for names

namespace camaron
{
/**
 * Fields of cells from a data file (.dat.h5). Their names are those in the file; of phases after
 * the first, which is the mixture, "-phase_1" and so on is appended, as by ParaView's reader.
 */
struct FluentFieldRequest
{
  std::string Path;       ///< of the data file; may be empty
  bool IsRequired = true; ///< whether it is an error if there is none
  std::vector<std::string> Names;

  /// Whether the data file must be opened.
  bool IsAny() const { return this->IsRequired || !this->Names.empty(); }
};

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

/// The data file that belongs to a case file, "mesh.dat.h5" to "mesh.cas.h5", or "mesh.dat.h5.gz"
/// if there is only this; both also to "mesh.cas.h5.gz". Empty for others.
std::string GetFluentDataPath(const std::string& path);

/// Names of the fields of cells in a data file; none if it cannot be read.
std::vector<std::string> ListFluentFields(const std::string& path);

/**
 * Adds fields to the cells of a piece, with NaN where the file has no value.
 * @param cells number of ids of cells in the case file
 * @return false with the error, or without one if aborted
 */
bool ReadFluentFields(const FluentFieldRequest& request, std::int64_t cells,
  vtkUnstructuredGrid* grid, Warnings& warnings, ScanError& error, const Progress& progress);
}

#endif
