// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReadMappedFile.h
 * @brief The frame of a reader: opens the file, provides threads, converts exceptions to errors.
 */
#ifndef camaron_ReadMappedFile_h
#define camaron_ReadMappedFile_h

#include "Base/Parallel.h"
#include "Base/Progress.h"
#include "Scan/MappedFile.h"
#include "Intake/Pieces/PieceRequest.h"

#include "vtkUnstructuredGrid.h" // to empty it

#include <new>       // for std::bad_alloc
#include <stdexcept> // for std::length_error

namespace camaron
{
/**
 * Returns the result of @a read(const MappedFile&, const Progress&), or false with the reason in
 * @a error, for example that the file was changed while reading.
 */
template <typename Read>
bool ReadMappedFile(
  const std::string& path, ScanError& error, const Progress& progress, Read&& read)
{
  bool good = false;
  const auto fail = [&]
  { error = { ErrorKind::Memory, GetFileName(path) + ": not enough memory for the mesh" }; };
  try
  {
    WithThreads(
      [&]
      {
        MappedFile file;
        constexpr double inflation = 0.4; // of the whole time
        if (file.Open(path, error, progress.Part(0, inflation)))
        {
          try
          {
            good = read(static_cast<const MappedFile&>(file),
              file.IsCompressed() ? progress.Part(inflation, 1) : progress);
          }
          catch (...)
          {
            if (file.IsUnchanged(error))
            {
              throw;
            }
          }
          // If the file was changed, this error replaces all others.
          good = file.IsUnchanged(error) && good;
        }
      });
  }
  catch (const std::bad_alloc&)
  {
    fail();
  }
  catch (const std::length_error&)
  {
    fail();
  }
  return good && !error;
}

/// The same for a reader that fills @a grid, which is emptied first, and also, like @a warnings, if
/// reading fails.
template <typename Read>
bool ReadMappedFile(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress, Read&& read)
{
  grid->Initialize();
  bool hasTrailingData = false;
  const bool good = ReadMappedFile(path, error, progress,
    [&](const MappedFile& file, const Progress& part)
    {
      hasTrailingData = file.HasTrailingData();
      return read(file, part);
    });
  if (!good)
  {
    grid->Initialize();
    warnings = Warnings();
  }
  else if (hasTrailingData && request.Piece == 0)
  {
    warnings.Add("data after the compressed data is ignored");
  }
  return good;
}
}

#endif
