// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FluentFields.h
 * @brief Reads fields of cells from data files of Ansys Fluent in HDF5 (.dat.h5).
 *
 * Their names are those in the file; of phases after the first, which is the mixture, "-phase_1"
 * and so on is appended, as by ParaView's reader.
 */
#ifndef camaron_FluentFields_h
#define camaron_FluentFields_h

#include <cstdint> // for counts
#include <string>  // for paths
#include <vector>  // for names

class vtkUnstructuredGrid;

namespace camaron
{
class Progress;
class Warnings;
struct ScanError;

struct FluentFieldRequest
{
  std::string Path;       ///< of the data file; may be empty
  bool IsRequired = true; ///< whether it is an error if there is none
  std::vector<std::string> Names;

  /// Whether the data file must be opened.
  bool IsAny() const { return this->IsRequired || !this->Names.empty(); }
};

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
